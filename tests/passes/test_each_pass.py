"""What each pass is for."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
from hypothesis import given, settings

from ir.programs import EXACT, Point, programs, results
from passes.programs import CHOICES, check_straight, ops
from robodyn import load
from robodyn.counts import count
from robodyn.dynamics.functions import by_default
from robodyn.ir import Graph, Input, Label, Operation, Program
from robodyn.ir.lowering import lower
from robodyn.optimize.programs import Choice, build
from robodyn.passes import FRESH, cse, dce, factor, fold, negate, order, run
from robodyn_testing.by_hand import by_hand

A, B, C, X, Y = (Input(name, None) for name in "abcxy")


def expression(build_: Callable[..., list[Any]], names: str = "abcxy", fold_: bool = True) -> Program:
    """The program of what ``build_`` makes of the nodes called ``names``."""
    graph = Graph(fold=fold_)
    values = build_(*(graph.input(name) for name in names))
    return lower(graph, [("t", values)])


# --- what each is for -------------------------------------------------------------------------------------


@settings(deadline=None, max_examples=60)
@given(programs(EXACT))
def test_nothing_dead_is_left_and_nothing_else_gone(made: Program) -> None:
    after = dce(made)
    assert 0 not in after.uses()
    assert [op.op for op in dce(after).operations] == [op.op for op in after.operations]
    assert not Counter(op.label for op in after.operations) - Counter(op.label for op in made.operations)


def test_equal_operations_merge_up_to_order_and_sign() -> None:
    made = by_hand("mul x y, mul y x, sub x y, sub y x, neg %3, add %0 %2, add %4 %1, mul %5 %6")
    assert ops(cse(made)) == {"mul": 2, "sub": 1, "add": 1}


def test_merging_does_no_algebra() -> None:
    made = by_hand("add x x, mul 2 %0, mul 3 %1, add %2 %0")
    assert ops(cse(made)) == {"add": 2, "mul": 2}
    assert fold(made).operations == (Operation("mul", (Fraction(14), X)),)


FACTORED: dict[str, tuple[Callable[..., list[Any]], dict[str, int]]] = {
    "a x + b x": (lambda a, b, c, x, y: [a * x + b * x], {"mul": 1, "add": 1}),
    "a x - b x": (lambda a, b, c, x, y: [a * x - b * x], {"mul": 1, "sub": 1}),
    "b x - a x": (lambda a, b, c, x, y: [b * x - a * x], {"mul": 1, "sub": 1}),
    "a x + b x + c x": (lambda a, b, c, x, y: [a * x + b * x + c * x], {"mul": 1, "add": 2}),
    "x a + y + b x": (lambda a, b, c, x, y: [x * a + y + b * x], {"mul": 1, "add": 2}),
    "2 x + 2 y": (lambda a, b, c, x, y: [2 * x + 2 * y], {"mul": 1, "add": 1}),
    "2 x - 2 y": (lambda a, b, c, x, y: [2 * x - 2 * y], {"mul": 1, "sub": 1}),
    "x x + a x": (lambda a, b, c, x, y: [x * x + a * x], {"mul": 1, "add": 1}),
    "x + a x": (lambda a, b, c, x, y: [x + a * x], {"mul": 1, "add": 1}),
    "two pairs": (lambda a, b, c, x, y: [a * x + b * x, c * y - b * y], {"mul": 2, "add": 1, "sub": 1}),
    "the most common": (lambda a, b, c, x, y: [a * x + b * x + c * x + a * y], {"mul": 2, "add": 3}),
    "shared": (lambda a, b, c, x, y: [a * x + b * x, a * x], {"mul": 2, "add": 1}),
    "shared both": (lambda a, b, c, x, y: [a * x + b * x, a * x, b * x], {"mul": 2, "add": 1}),
    "shared and not": (
        lambda a, b, c, x, y: [a * x + b * x + c * x + c * y, a * x, b * x],
        {"mul": 3, "add": 3},
    ),
    "nothing": (lambda a, b, c, x, y: [a * x + b * y], {"mul": 2, "add": 1}),
    "twice": (lambda a, b, c, x, y: [(a * x + b * x) * y + (a * x + b * x) * c], {"mul": 2, "add": 2}),
}  # fmt: skip


@pytest.mark.parametrize("pattern", FACTORED)
def test_sums_of_products_are_factored(pattern: str) -> None:
    build_, expected = FACTORED[pattern]
    after = factor(expression(build_))
    assert {op: number for op, number in ops(after).items() if op != "neg"} == expected
    assert results(after, Point(1)) == results(expression(build_), Point(1))


@pytest.mark.parametrize("function", by_default())
def test_choosing_signs_leaves_fewer_minuses(function: str) -> None:
    """Than where every value is computed with the sign that it happens to have, a named quantity that stands
    with its sign reversed counting for a third of a minus."""

    def cost(made: Program) -> int:
        return 3 * count(made).neg + sum(op.label is not None and op.label.negative for op in made.operations)

    before = after = 0
    for name in ("puma560", "stanford", "ur5", "stanford_3dof"):
        made = factor(build(load(name, warn=lambda _: None), function, Choice()))
        before, after = before + cost(made), after + cost(negate(made))
    assert after < before


def test_minuses_go_into_subtractions_and_constants() -> None:
    patterns: tuple[Callable[..., list[Any]], ...] = (
        lambda a, b, c, x, y: [-(a - b)],
        lambda a, b, c, x, y: [-(2 * x)],
        lambda a, b, c, x, y: [-(a * x) - -(b * y)],
        lambda a, b, c, x, y: [a - (-x) * y],
        lambda a, b, c, x, y: [a - 2 * (-x) * b, y - (-x)],
        lambda a, b, c, x, y: [-(a - b) * x],
    )
    for build_ in patterns:
        made = expression(build_, fold_=False)
        after = negate(made)
        assert ops(after)["neg"] == 0, made.dump()
        assert results(after, Point(1)) == results(made, Point(1))


def test_a_quantity_keeps_the_sign_of_its_name_where_that_is_free() -> None:
    graph = Graph()
    a, b, x = (graph.input(name) for name in "abx")
    difference = graph.label(b - a, Label(1, "w", "x"))  # the position is that of a - b
    after = negate(lower(graph, [("t", [difference * x])]))
    assert [op.label for op in after.operations if op.label] == [Label(1, "w", "x")]
    assert after.operations[0].op == "sub"
    assert after.operations[0].args == (B, A)


@settings(deadline=None, max_examples=60)
@given(programs(EXACT))
def test_order_keeps_operations_and_the_row_of_names(made: Program) -> None:
    after = order(made)
    check_straight(after)
    live = dce(made)
    kept = [op.label for op in made.operations if op.label is not None]
    assert [op.label for op in after.operations if op.label is not None] == kept
    assert Counter(op.op for op in live.operations) - ops(after) == Counter()
    used = [i for i, op in enumerate(after.operations) if op.label is None and after.uses()[i] == 0]
    assert used == []


def test_steps_stand_before_the_quantity_that_first_needs_them() -> None:
    first, second = Label(1, "w", "x"), Label(2, "w", "x")
    made = Program(
        (
            Operation("mul", (X, X)),
            Operation("mul", (Y, Y)),
            Operation("mul", (A, A)),
            Operation("add", (1, B), first),
            Operation("add", (0, 2), second),
        ),
        (("t", (4, 3)),),
    )
    assert [(op.args[0], op.label) for op in order(made).operations] == [
        (Y, None),
        (0, first),
        (X, None),
        (A, None),
        (2, second),
    ]


def test_real_programs_read_like_the_recursion() -> None:
    """After all passes the links come in order: velocities base to tip, moments tip to base.

    Where parallel joints turn as one, the sums of their rates come first: w_z is left out.
    """
    robots = [load(name, warn=lambda _: None) for name in ("puma560", "stanford", "ur5")]
    for made in [build(robot, "inverse_dynamics", choice) for robot in robots for choice in CHOICES]:
        after = run(made, FRESH)
        labels = [op.label for op in after.operations if op.label]
        w = [label.link for label in labels if label.quantity == "w" and label.axis != "z"]
        assert all(one <= other for one, other in pairwise(w))
        n = [label.link for label in labels if label.quantity == "n"]
        assert all(one >= other for one, other in pairwise(n))
        assert set(w) | set(n) >= {2, 4}
