"""Every pass keeps what a program computes, on random programs and real ones, and does what it is for."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from ir.programs import EVERYTHING, EXACT, Point, every_value, points, programs, results
from passes.programs import REAL, check_straight, name_of, results_or_reject
from robodyn.counts import count
from robodyn.ir import Label, Operation, Program
from robodyn.ir.fingerprint import fingerprint
from robodyn.passes import FAST, FRESH, SPELLING, PassError, cse, dce, factor, fold, negate, order, run, units
from robodyn.robot.values import circle_point

PASSES = (fold, cse, dce, factor, units, negate, order)


# --- meaning ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("step", PASSES, ids=name_of)
@settings(deadline=None, max_examples=30)
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


@settings(deadline=None, max_examples=50)
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
    for made in REAL[::3]:
        alone = dataclasses.replace(made, origin=None)
        assert results(step(alone), Point(2)) == results(step(made), Point(2))
        difference = count(step(alone)).total - count(step(made)).total
        # Units are found by a descent, where the order of the inputs may decide between equals.
        assert abs(difference) <= (count(made).total / 10 if step is units else 0)


@pytest.mark.parametrize("step", PASSES, ids=name_of)
@settings(deadline=None, max_examples=20)
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
