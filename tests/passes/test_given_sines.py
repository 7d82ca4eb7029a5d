"""Programs whose sines and cosines are given, and parameters that are called like arrays."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from ir.programs import Point, exactly, results
from passes.programs import REAL, ops
from robodyn import Options, load, program
from robodyn.counts import count
from robodyn.ir import Input, Operand, Operation, Program
from robodyn.ir.fingerprint import agree
from robodyn.optimize.programs import Choice, build
from robodyn.passes import FAST, FRESH, SPELLING, run
from robodyn.passes.specialise import at_rest
from robodyn.passes.trig_given import describe, given_layout, trig_given
from robodyn.robot import read_text
from robodyn.robot.values import circle_point

# --- given sines ------------------------------------------------------------------------------------------
from robodyn_testing.by_hand import by_hand


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


def test_the_layout_is_by_joint_and_told_in_words() -> None:
    made = by_hand(
        "sin q[1], cos q[1], add q[0] q[1], cos %2, sub q[0] 1/4, sin %4, mul q[2] %0", "%1 %3 %5 %6"
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
