"""Every pass keeps what a program computes, on random programs and real ones, and does what it is for."""

from __future__ import annotations

import dataclasses
from collections import Counter
from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from dynamics.direct import exact_arm
from ir.programs import EVERYTHING, EXACT, Point, every_value, exactly, points, programs, results
from robodyn import Options, load, program
from robodyn.counts import count
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.ir import Graph, Input, Label, Operand, Operation, Program
from robodyn.ir.fingerprint import agree, fingerprint
from robodyn.ir.lowering import lower
from robodyn.kernels.generate import SingularArm
from robodyn.optimize.programs import Choice, build
from robodyn.passes import FAST, FRESH, SPELLING, PassError, cse, dce, factor, fold, negate, order, run
from robodyn.passes.specialise import at_rest
from robodyn.passes.trig_given import describe, given_layout, trig_given
from robodyn.robot import read_text
from robodyn.robot.values import circle_point

PASSES = (fold, cse, dce, factor, negate, order)
CHOICES = (Choice(), Choice(regroup=False, chains=False), Choice("newton_euler", regroup=False, chains=False))
A, B, C, X, Y = (Input(name, None) for name in "abcxy")


def name_of(value: Any) -> str:
    return getattr(value, "__name__", str(value))


def real_programs() -> list[Program]:
    """Programs as the recursions leave them."""
    found = []
    robots = [load("stanford_3dof"), exact_arm(3, joints=4), exact_arm(5, joints=3, prismatic=0.7)]
    for robot in robots:
        for choice in CHOICES:
            for function in FUNCTIONS:
                try:
                    found.append(build(robot, function, choice))
                except (SingularArm, ZeroDivisionError):
                    assert function == "forward_dynamics"
    return found


REAL = real_programs()


def results_or_reject(made: Program, at: Point) -> list[Fraction]:
    try:
        return results(made, at)
    except ZeroDivisionError:
        reject()


def ops(made: Program) -> Counter[str]:
    return Counter(op.op for op in made.operations)


def expression(build_: Callable[..., list[Any]], names: str = "abcxy", fold_: bool = True) -> Program:
    """The program of what ``build_`` makes of the nodes called ``names``."""
    graph = Graph(fold=fold_)
    values = build_(*(graph.input(name) for name in names))
    return lower(graph, [("t", values)])


def check_straight(made: Program) -> None:
    """Each operation uses only what stands before it."""
    for i, operation in enumerate(made.operations):
        assert all(0 <= arg < i for arg in operation.args if isinstance(arg, int))
    assert all(0 <= x < len(made.operations) for x in made.results() if isinstance(x, int))


# --- meaning ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("step", PASSES, ids=name_of)
@settings(deadline=None, max_examples=60)
@given(made=programs(EXACT), at=points)
def test_a_pass_keeps_the_values_of_any_program(
    step: Callable[[Program], Program], made: Program, at: Point
) -> None:
    expected = results_or_reject(made, at)
    after = step(made)
    check_straight(after)
    assert results(after, at) == expected
    assert [(name, len(elements)) for name, elements in after.outputs] == [
        (name, len(elements)) for name, elements in made.outputs
    ]
    once_more = step(after)
    assert results(once_more, at) == expected


@settings(deadline=None, max_examples=100)
@given(programs(EVERYTHING), st.permutations(PASSES), st.integers(0, 99))
def test_any_order_of_passes_is_accepted(made: Program, steps: list[Any], seed: int) -> None:
    try:
        before = fingerprint(made, seed, circle_point)
    except ZeroDivisionError:
        reject()
    assert fingerprint(run(made, steps), seed, circle_point) == before


@pytest.mark.parametrize("step", [*PASSES, "FAST", "FRESH", "SPELLING"], ids=name_of)
def test_a_pass_keeps_the_values_of_real_programs(step: Any) -> None:
    together = {"FAST": FAST, "FRESH": FRESH, "SPELLING": SPELLING}
    for made in REAL:
        after = run(made, together[step]) if isinstance(step, str) else step(made)
        check_straight(after)
        assert results(after, Point(1)) == results(made, Point(1))


@pytest.mark.parametrize("step", PASSES, ids=name_of)
def test_a_program_means_the_same_wherever_it_came_from(step: Callable[[Program], Program]) -> None:
    """Passes may start from the graph that a program was written out from, or build it again."""
    for made in REAL:
        alone = dataclasses.replace(made, origin=None)
        assert results(step(alone), Point(2)) == results(step(made), Point(2))
        assert count(step(alone)).total == count(step(made)).total


@pytest.mark.parametrize("step", PASSES, ids=name_of)
def test_a_pass_is_deterministic_and_changes_no_other_program(step: Callable[[Program], Program]) -> None:
    for made in REAL[:5]:
        text = made.dump()
        assert step(made).dump() == step(made).dump()
        assert made.dump() == text


@pytest.mark.parametrize("step", PASSES, ids=name_of)
@settings(deadline=None, max_examples=40)
@given(made=programs(EXACT, labels=False), at=points, data=st.data())
def test_labels_stay_on_their_values(
    step: Callable[[Program], Program], made: Program, at: Point, data: st.DataObject
) -> None:
    """A label may go with its operation, and may turn its sign; it never names another value."""
    operations = list(made.operations)
    for k, i in enumerate(data.draw(st.sets(st.integers(0, len(operations) - 1), max_size=5))):
        operations[i] = operations[i]._replace(label=Label(k + 1, "w", "x"))
    named = dataclasses.replace(made, operations=tuple(operations), origin=None)
    try:
        true = {
            op.label: x for op, x in zip(named.operations, every_value(named, at), strict=True) if op.label
        }
    except ZeroDivisionError:
        reject()
    after = step(named)
    for (_, _, label), value in zip(after.operations, every_value(after, at), strict=True):
        if label is not None:
            assert value == (-1 if label.negative else 1) * true[label._replace(negative=False)]


# --- run --------------------------------------------------------------------------------------------------


def test_no_pass_changes_nothing() -> None:
    assert run(REAL[0], ()) is REAL[0]


def broken(change: Callable[[int, Operation], Operation | None]) -> list[Callable[[Program], Program]]:
    """Passes that change one operation each."""

    def at(i: int) -> Callable[[Program], Program]:
        def wrong(made: Program) -> Program:
            operations = list(made.operations)
            operations[i] = change(i, operations[i]) or operations[i]
            return Program(tuple(operations), made.outputs)

        return wrong

    return [at(i) for i in range(len(REAL[0].operations)) if change(i, REAL[0].operations[i]) is not None]


def _other_sign(_: int, operation: Operation) -> Operation | None:
    other = {"add": "sub", "sub": "add"}.get(operation.op)
    return operation._replace(op=other) if other else None


def _other_constant(_: int, operation: Operation) -> Operation | None:
    first, *rest = operation.args
    if not isinstance(first, Fraction):
        return None
    return operation._replace(args=(first * (1 + Fraction(1, 10**12)), *rest))


def _other_operand(i: int, operation: Operation) -> Operation | None:
    found = [k for k, arg in enumerate(operation.args) if isinstance(arg, int)]
    if operation.op in ("sin", "cos") or not found or operation.args[found[0]] == 0:
        return None
    args = list(operation.args)
    args[found[0]] = int(args[found[0]]) - 1  # type: ignore[arg-type]
    return operation._replace(args=tuple(args))


@pytest.mark.parametrize("change", [_other_sign, _other_constant, _other_operand], ids=name_of)
def test_a_pass_that_changes_the_meaning_is_caught(change: Any) -> None:
    wrong = broken(change)
    assert len(wrong) > 5
    expected = results(REAL[0], Point(1))
    for step in wrong:
        assert results(step(REAL[0]), Point(1)) != expected
        with pytest.raises(PassError, match="test_passes changed the program"):
            run(REAL[0], (dce, step))
    assert not issubclass(PassError, (ValueError, RuntimeError))


def test_a_swapped_result_is_caught() -> None:
    def swapped(made: Program) -> Program:
        first, second, *rest = made.results()
        return made.with_results((second, first, *rest))

    with pytest.raises(PassError):
        run(REAL[0], (swapped,))


# --- what each is for -------------------------------------------------------------------------------------


def test_dead_code_goes() -> None:
    made = Program(
        (
            Operation("sin", (X,), Label(1, "s", "")),
            Operation("mul", (0, Y)),
            Operation("add", (X, Y)),
            Operation("neg", (1,)),
            Operation("mul", (2, Fraction(3))),
        ),
        (("t", (4, X)),),
    )
    after = dce(made)
    assert after.operations == (Operation("add", (X, Y)), Operation("mul", (0, Fraction(3))))
    assert after.outputs == (("t", (1, X)),)


@settings(deadline=None, max_examples=60)
@given(programs(EXACT))
def test_nothing_dead_is_left_and_nothing_else_gone(made: Program) -> None:
    after = dce(made)
    assert 0 not in after.uses()
    assert [op.op for op in dce(after).operations] == [op.op for op in after.operations]
    assert not Counter(op.label for op in after.operations) - Counter(op.label for op in made.operations)


def test_equal_operations_merge_up_to_order_and_sign() -> None:
    made = Program(
        (
            Operation("mul", (X, Y)),
            Operation("mul", (Y, X)),
            Operation("sub", (X, Y)),
            Operation("sub", (Y, X)),
            Operation("neg", (3,)),
            Operation("add", (0, 2)),
            Operation("add", (4, 1)),
            Operation("mul", (5, 6)),
        ),
        (("t", (7,)),),
    )
    assert ops(cse(made)) == {"mul": 2, "sub": 1, "add": 1}


def test_merging_does_no_algebra() -> None:
    made = Program(
        (
            Operation("add", (X, X)),
            Operation("mul", (Fraction(2), 0)),
            Operation("mul", (Fraction(3), 1)),
            Operation("add", (2, 0)),
        ),
        (("t", (3,)),),
    )
    assert ops(cse(made)) == {"add": 2, "mul": 2}
    assert fold(made).operations == (Operation("mul", (Fraction(14), X)),)


def test_constants_fold() -> None:
    made = Program(
        (
            Operation("mul", (Fraction(2), Fraction(3))),
            Operation("sub", (0, Fraction(6))),
            Operation("mul", (X, 1)),
            Operation("add", (Y, 2)),
            Operation("mul", (3, Fraction(1))),
            Operation("add", (4, Fraction(1, 2))),
            Operation("add", (5, Fraction(1, 2))),
        ),
        (("t", (6, 2)),),
    )
    assert fold(made) == Program((Operation("add", (Y, Fraction(1))),), (("t", (0, Fraction(0))),))


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


@settings(deadline=None, max_examples=60)
@given(programs(EXACT))
def test_factoring_never_costs(made: Program) -> None:
    try:
        before = count(fold(made)).total
        after = factor(made)
    except ZeroDivisionError:
        reject()
    assert count(after).total <= before or count(after).total <= count(made).total
    assert count(factor(after)).total == count(after).total


@pytest.mark.parametrize("step", [negate, order], ids=name_of)
def test_spelling_changes_no_count(step: Callable[[Program], Program]) -> None:
    for made in REAL:
        before, after = count(made), count(step(made))
        assert (after.mul, after.add, after.div, after.sincos, after.other) == (
            before.mul,
            before.add,
            before.div,
            before.sincos,
            before.other,
        )


@settings(deadline=None, max_examples=80)
@given(programs(EXACT))
def test_signs_move_and_operations_stay(made: Program) -> None:
    try:
        merged, after = cse(made), negate(made)
    except ZeroDivisionError:
        reject()
    for op in ("mul", "div", "sin", "cos", "sign"):
        assert ops(after)[op] == ops(merged)[op]
    assert count(after).add == count(merged).add


@pytest.mark.parametrize("function", FUNCTIONS)
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


# --- given sines ------------------------------------------------------------------------------------------


def with_given(made: Program, at: Point) -> list[Fraction]:
    """The results of ``made`` with its sines and cosines read from ``sc``."""
    layout: Sequence[Any] = given_layout([made])
    numbers = {}
    for k, (kind, terms, constant) in enumerate(layout):
        angle: Operand = Fraction(0)
        operations: list[Operation] = []
        for x, multiple in terms:
            for _ in range(abs(multiple)):
                operations.append(Operation("add" if multiple > 0 else "sub", (angle, x)))
                angle = len(operations) - 1
        operations.append(Operation("add", (angle, constant)))
        if kind != "q":
            operations.append(Operation(kind, (len(operations) - 1,)))
        (numbers[Input("sc", k)],) = results(
            Program(tuple(operations), (("sc", (len(operations) - 1,)),)), at
        )
    after = trig_given(made, layout)
    assert not {"sin", "cos"} & ops(after).keys()
    assert not [x for x in after.inputs() if x.array == "q"]
    return [x for elements in exactly(after, at, numbers).values() for x in elements]


def test_given_sines_change_nothing_else() -> None:
    for made in REAL:
        for final in (run(made, FRESH), run(made, SPELLING)):
            assert with_given(final, Point(3)) == results(final, Point(3))
            after = trig_given(final, given_layout([final]))
            before, now = count(final), count(after)
            assert (now.mul, now.div, now.neg, now.sincos) == (before.mul, before.div, before.neg, 0)
            assert now.add <= before.add  # sums that were angles only are gone


@settings(deadline=None, max_examples=60)
@given(programs(EXACT), points)
def test_given_sines_of_any_program(made: Program, at: Point) -> None:
    expected = results_or_reject(made, at)
    assert with_given(made, at) == expected


def test_the_layout_is_by_joint_and_told_in_words() -> None:
    q1, q2, q3 = (Input("q", i) for i in range(3))
    made = Program(
        (
            Operation("sin", (q2,)),
            Operation("cos", (q2,)),
            Operation("add", (q1, q2)),
            Operation("cos", (2,)),
            Operation("sub", (q1, Fraction(1, 4))),
            Operation("sin", (4,)),
            Operation("mul", (q3, 0)),
        ),
        (("t", (1, 3, 5, 6)),),
    )
    told = [describe(given_) for given_ in given_layout([made, made])]
    assert sorted(told) == sorted(["sin(q1 - 0.25)", "cos(q1 + q2)", "cos(q2)", "sin(q2)", "q3"])
    assert told[-1] == "q3"
    assert told.index("cos(q2)") + 1 == told.index("sin(q2)")


def test_one_layout_serves_several_programs() -> None:
    robot = load("stanford_3dof")
    made = [run(build(robot, f, Choice()), FRESH) for f in ("gravity", "inverse_dynamics")]
    layout = given_layout(made)
    assert [describe(given_) for given_ in layout] == ["cos(q2)", "sin(q2)", "q3"]
    reads = [{x.index for x in trig_given(p, layout).inputs() if x.array == "sc"} for p in made]
    assert reads[0] <= reads[1] <= {0, 1, 2}


# --- run-time parameters that are called like arrays --------------------------------------------------------

NAMED_LIKE_ARRAYS = """\
name: awkward
links:
  - {joint: revolute, mass: 2, com: [qd, 0.1, 0], inertia: {zz: 0.3}, motor_inertia: qdd}
  - {joint: revolute, alpha: pi/2, a: 0.3, mass: q, com: [0.2, 0, 0.1], friction: {viscous: tau}}
"""


def test_a_parameter_that_is_called_like_an_array_is_none() -> None:
    """Neither given with the sines nor zero at rest."""
    robot = read_text(NAMED_LIKE_ARRAYS)
    inverse = program(robot, "inverse_dynamics", Options(optimize="fast"))
    names = {Input(name, None) for name in ("q", "qd", "qdd")}
    assert names <= set(inverse.inputs())
    for function in ("gravity", "bias"):
        plain = program(robot, function, Options(optimize="fast"))
        for other in (at_rest(inverse, function), run(at_rest(inverse, function), FAST)):
            assert agree(plain, other, circle_point)
        assert Input("q", None) in plain.inputs()
    layout = given_layout([inverse])
    assert all(x.index is not None for _, terms, _ in layout for x, _ in terms)
    assert names <= set(trig_given(inverse, layout).inputs())
