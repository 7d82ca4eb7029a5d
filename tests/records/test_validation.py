"""A record is used only where it computes what the recursion does: one sign, one digit, and it is refused."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from records.made import ELBOW, SMOOTH, TOOL, arm, better, bundled, fast, recorded
from robodyn import InputError, Options, program
from robodyn.counts import count
from robodyn.dynamics.equality import equals_recursion
from robodyn.ir import Input, Operand, Operation, Program
from robodyn.ir.fingerprint import fingerprint
from robodyn.optimize.records import Record, bundled_records, identity, parse_record
from robodyn.optimize.records.validation import validated
from robodyn.passes import FAST, SPELLING, run
from robodyn.passes.specialise import at_rest
from robodyn.robot import Robot
from robodyn.robot.values import circle_point
from robodyn.search.walk import Walk
from robodyn_testing.random_robots import random_robot

ROBOT = bundled("stanford_3dof_d3")
PROGRAM = fast(ROBOT)


def refused(made: Program, robot: Robot = ROBOT, function: str = "inverse_dynamics") -> bool:
    recursion = fast(robot, function)
    record = recorded(robot, made, function)
    assert validated(recursion, recursion, record) is recursion
    try:
        return validated(made, recursion, record) is not made
    except InputError as error:
        message = str(error)
    assert f"the record of {robot.name} does not compute its {function}" in message
    return True


def with_operation(made: Program, k: int, changed: Operation) -> Program:
    return replace(made, operations=(*made.operations[:k], changed, *made.operations[k + 1 :]), origin=None)


def mutants(made: Program) -> list[tuple[str, Program]]:
    """``made`` with one thing changed."""
    found = []
    for k, (op, args, label) in enumerate(made.operations):
        changed: list[Operation] = []
        if op in ("add", "sub"):
            changed.append(Operation("sub" if op == "add" else "add", args, label))
        if op == "mul":
            changed.append(Operation("add", args, label))
        if op in ("sin", "cos"):
            changed.append(Operation("cos" if op == "sin" else "sin", args, label))
        if op in ("sign", "tanh"):
            changed.append(Operation("neg", args, label))
        for place, arg in enumerate(args):
            others: list[Operand] = []
            if isinstance(arg, Fraction):
                others = [-arg, arg + Fraction(1, 10**18), arg + Fraction(1, 10 * arg.denominator), arg * 10]
            elif isinstance(arg, Input):
                others = [arg._replace(array="qdd" if arg.array == "qd" else "qd", index=0)]
            elif arg:
                others = [arg - 1]
            changed += [Operation(op, (*args[:place], x, *args[place + 1 :]), label) for x in others]
        found += [
            (f"{k}: {op} {args} -> {new.op} {new.args}", with_operation(made, k, new)) for new in changed
        ]
    return found


@pytest.mark.parametrize(
    "robot",
    [ROBOT, arm(ELBOW), *(pytest.param(arm(text), marks=pytest.mark.slow) for text in (TOOL, SMOOTH))],
    ids=["stanford", "elbow", "tool", "smooth"],
)
def test_one_thing_changed_is_enough(robot: Robot) -> None:
    made = fast(robot)
    assert not refused(made, robot)
    ones = mutants(made)
    assert len(ones) > 100
    values = fingerprint(
        replace(made, outputs=(("all", tuple(range(len(made.operations)))),)), 3, circle_point
    )
    for told, mutant in ones:
        try:
            same = values[-1:] and fingerprint(mutant, 3, circle_point) == fingerprint(made, 3, circle_point)
        except ValueError:  # a sine of what is no angle
            same = False
        assert refused(mutant, robot) is not same, told


def test_outputs_must_be_those_of_the_function() -> None:
    ((name, elements),) = PROGRAM.outputs
    x, y, z = elements
    assert refused(fast(bundled("stanford_3dof")))
    for outputs in (
        ((name, (y, x, z)),),
        ((name, (x, y)),),
        ((name, (x, y, z, z)),),
        (("M", elements),),
        ((name, elements), ("M", elements)),
        ((name, (x, y, Fraction(0))),),
        (),
    ):
        assert refused(replace(PROGRAM, outputs=outputs))


@pytest.mark.parametrize(
    "extra",
    [Input("q", 3), Input("q", 99), Input("tau", 0), Input("m", None), Input("q", None), Input("sc", 0)],
    ids=str,
)
def test_inputs_that_the_kernel_does_not_have(extra: Input) -> None:
    """Even where they make no difference: the kernel would read beyond its arrays."""
    n = len(PROGRAM.operations)
    ((name, (x, *rest)),) = PROGRAM.outputs
    more = (Operation("sub", (extra, extra)), Operation("add", (x, n)))
    made = Program((*PROGRAM.operations, *more), ((name, (n + 1, *rest)),))
    assert refused(made)
    record = recorded(ROBOT, made)
    with pytest.raises(InputError):
        program(ROBOT, "inverse_dynamics", Options(("inverse_dynamics",), records=(record,)))


def test_inputs_that_the_recursion_does_not_read_may_be_read() -> None:
    """The gravity of an upright arm does not depend on the first joint: a record may come to that late."""
    robot = arm(ELBOW.replace("[0.3, 0, -9.81]", "[0, 0, -9.81]").replace("alpha: pi/2", "alpha: 0"))
    assert Input("q", 0) not in fast(robot, "gravity").inputs()
    plain = fast(robot)
    n = len(plain.operations)
    ((name, (x, y)),) = plain.outputs
    late = (
        Operation("sin", (Input("q", 0),)),
        Operation("mul", (n, n)),
        Operation("cos", (Input("q", 0),)),
        Operation("mul", (n + 2, n + 2)),
        Operation("add", (n + 1, n + 3)),
        Operation("mul", (n + 4, y)),
    )
    record = recorded(robot, Program((*plain.operations, *late), ((name, (x, n + 5)),)))
    gravity, inputs = fast(robot, "gravity"), [Input("q", 0), Input("q", 1)]
    assert (
        Input("q", 0) in validated(at_rest(record.program, "gravity"), gravity, record, FAST, inputs).inputs()
    )
    with pytest.raises(InputError):
        validated(at_rest(record.program, "gravity"), gravity, record, FAST, inputs[1:])
    made = program(robot, "gravity", Options(("gravity",), records=(record,)))
    assert equals_recursion(robot, "gravity", made)
    assert count(made).total <= count(fast(robot, "gravity")).total


def test_the_error_names_the_file() -> None:
    text = recorded(ROBOT, mutants(PROGRAM)[0][1]).text()
    record = parse_record(text, "here/wrong.record")
    with pytest.raises(InputError, match=r"^here/wrong\.record: the record of stanford_3dof_d3"):
        program(ROBOT, "inverse_dynamics", Options(("inverse_dynamics",), records=(record,)))


# --- what is made of records ------------------------------------------------------------------------------


def test_a_record_is_used_where_it_is_better_and_only_there() -> None:
    robot = arm(ELBOW)
    record = better(robot)
    options = Options(("inverse_dynamics",), records=(record,))
    made = program(robot, "inverse_dynamics", options)
    assert count(made).total == count(record.program).total < count(fast(robot)).total
    assert equals_recursion(robot, "inverse_dynamics", made)
    worse = recorded(robot, program(robot, "inverse_dynamics", Options(optimize="none")))
    assert count(worse.program).total > count(fast(robot)).total
    options = replace(options, records=(worse,))
    assert program(robot, "inverse_dynamics", options) == fast(robot)


@pytest.mark.parametrize(("seed", "joints"), [(36, 2), (58, 4), (5, 1)])
@pytest.mark.parametrize("function", ["inverse_dynamics", "gravity", "mass_matrix"])
def test_a_record_a_little_worse_than_fast_is_not_used(function: str, seed: int, joints: int) -> None:
    """Even where it is far better than the recursion is before the passes, as on these arms."""
    robot = random_robot(seed, joints=joints, exotic=0)
    plain = fast(robot, function)
    ((name, (*elements, last)),) = plain.outputs
    n = len(plain.operations)
    more = (Operation("mul", (Fraction(2), last)), Operation("mul", (Fraction(1, 2), n)))
    worse = recorded(robot, Program((*plain.operations, *more), ((name, (*elements, n + 1)),)), function)
    made = program(robot, function, Options((function,), records=(worse,)))
    assert count(made).total <= count(plain).total


@pytest.mark.parametrize(
    "changes",
    [{"optimize": "none"}, {"optimize": "fast"}, {"regroup": False}, {"formulation": "newton_euler"}],
    ids=str,
)
def test_options_that_take_no_record(changes: dict[str, str]) -> None:
    robot = arm(ELBOW)
    plain = Options(("inverse_dynamics",), **changes)  # type: ignore[arg-type]
    made = program(robot, "inverse_dynamics", replace(plain, records=(better(robot),)))
    assert made == program(robot, "inverse_dynamics", plain)


def check_what_is_made_of(robot: Robot, record: Record) -> None:
    for function in ("inverse_dynamics", "gravity", "bias"):
        made = program(robot, function, Options((function,), records=(record,)))
        assert count(made).total <= count(fast(robot, function)).total
        assert equals_recursion(robot, function, made), function


@pytest.mark.parametrize("robot", [arm(TOOL), *(random_robot(seed, exotic=0) for seed in (2, 10, 22))])
def test_gravity_and_bias_made_of_a_record_are_exact(robot: Robot) -> None:
    walk = Walk([fast(robot)], seed=5)
    walk.run(800, 0.3)
    for made in (fast(robot), run(walk.best(), SPELLING)):
        check_what_is_made_of(robot, recorded(robot, made))


@pytest.mark.thorough
def test_committed_records_are_trusted_exact_and_better() -> None:
    paths = sorted(bundled_records().glob("*.record"))
    for path in paths:
        record = parse_record(path.read_text(encoding="utf-8"), str(path))
        robot = bundled(record.robot)
        assert record.identity == identity(robot)
        assert not refused(record.program, robot, record.function), path.name
        assert equals_recursion(robot, record.function, record.program, points=1), path.name
        if record.objective == "total":
            assert count(record.program).total <= count(fast(robot, record.function)).total, path.name
