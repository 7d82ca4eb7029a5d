"""Programs of inverse kinematics: closed to 60 digits, and refused where anything in them is wrong."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import pytest

from robodyn.dynamics.closure import is_simple
from robodyn.dynamics.functions import FUNCTIONS, NoSuchFunction
from robodyn.ir.program import Operation, Program
from robodyn.kernels.proof import Unequal, closes, prove
from robodyn.optimize.programs import Choice, build, inverse_kinematics_of, signature
from robodyn.robot import load, read_text
from robodyn.robot.model import Robot
from robodyn_testing.cases import covering
from robodyn_testing.functions import OF_POSES


def arm(name: str) -> Robot:
    return load(name, warn=lambda _: None)


@cache
def drafted(name: str, function: str) -> Program:
    return build(arm(name), function, Choice())


@pytest.mark.parametrize(("name", "function"), covering(["stanford", "ur5", "iiwa"], OF_POSES))
def test_programs_lead_back_to_the_pose(name: str, function: str) -> None:
    robot = arm(name)
    assert is_simple(robot)
    prove(robot, function, drafted(name, function))


def test_an_arm_for_places() -> None:
    text = "name: three\nlinks:\n"
    for alpha, a, d in (("0", 0, 0.4), ("pi/2", 0, 0.1), ("0", 0.5, 0)):
        text += f"  - {{joint: revolute, alpha: {alpha}, a: {a}, d: {d}, mass: 1}}\n"
    robot = read_text(text + "tool: {xyz: [0.4, 0.1, 0]}\n", "three.yaml")
    assert inverse_kinematics_of(robot).place_only
    assert closes(robot, "inverse_kinematics", build(robot, "inverse_kinematics", Choice()))
    assert signature(robot, "inverse_kinematics").outputs[0] == ("solutions", 4 * 3)


def test_run_time_lengths_have_no_closed_form() -> None:
    text = "name: lengthy\nlinks:\n"
    for a in ("0", "reach", "0.3"):
        text += f"  - {{joint: revolute, alpha: 0, a: {a}, mass: 1}}\n"
    with pytest.raises(NoSuchFunction, match="run-time parameters"):
        signature(read_text(text, "lengthy.yaml"), "inverse_kinematics")


# --- a wrong program is refused -----------------------------------------------------------------------------

Break = Callable[[Program], Program]


def with_operation(program: Program, place: int, op: str, *args: object) -> Program:
    operations = list(program.operations)
    operations[place] = Operation(op, args or operations[place].args, operations[place].label)  # type: ignore[arg-type]
    return replace(program, operations=tuple(operations))


def results(program: Program, name: str, change: Callable[[list[object]], None]) -> Program:
    outputs = []
    for array, elements in program.outputs:
        row: list[object] = list(elements)
        if array == name:
            change(row)
        outputs.append((array, tuple(row)))
    return replace(program, outputs=tuple(outputs))  # type: ignore[arg-type]


def flipped(program: Program) -> Program:
    """The first sum that a root is taken of as a difference."""
    for op, args, _ in program.operations:
        if op == "sqrt" and isinstance(args[0], int):
            place = args[0]
            while program.operations[place].op == "select":
                place = program.operations[place].args[1]  # type: ignore[assignment]
            other = {"add": "sub", "sub": "add"}.get(program.operations[place].op)
            if other:
                return with_operation(program, place, other)
    raise AssertionError("no root of a sum")


def exchanged(program: Program) -> Program:
    """A joint's positions of two branches exchanged."""

    def change(row: list[object]) -> None:
        other = next(k for k in range(0, len(row), 6) if row[k] != row[0])
        row[0], row[other] = row[other], row[0]

    return results(program, "solutions", change)


def unclamped(program: Program) -> Program:
    """A root of what may be negative."""
    for place, (op, args, _) in enumerate(program.operations):
        if op == "sqrt" and isinstance(args[0], int):
            inner = program.operations[args[0]]
            if inner.op == "select" and inner.args[0] == inner.args[1]:
                return with_operation(program, place, "sqrt", inner.args[1])
    raise AssertionError("no clamp before a root")


def always_there(program: Program) -> Program:
    """A branch that is said to exist, and a program that never says so."""
    return results(program, "exists", lambda row: row.__setitem__(0, 1))


def never_there(program: Program) -> Program:
    return results(program, "exists", lambda row: row.__setitem__(slice(None), [0] * len(row)))


def forgotten(program: Program) -> Program:
    """One branch in the place of all."""
    return results(program, "solutions", lambda row: row.__setitem__(slice(None), row[:6] * (len(row) // 6)))


BROKEN = [flipped, exchanged, unclamped, always_there, never_there, forgotten]


@pytest.mark.parametrize(("name", "broken"), covering(["ur5", "puma560"], BROKEN))
def test_a_wrong_program_is_refused(name: str, broken: Break) -> None:
    program = broken(drafted(name, "inverse_kinematics"))
    with pytest.raises(
        Unequal, match=r"inverse_kinematics of \w+ differs from plain forward kinematics at [qp] ="
    ):
        prove(arm(name), "inverse_kinematics", program)


def test_they_are_no_polynomials_to_search_for() -> None:
    assert not any(FUNCTIONS[name].searchable for name in OF_POSES)
