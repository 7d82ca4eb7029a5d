"""Each way to write a function is right, whichever way gravity points and whatever is known at run time only;
and those for arms of few joints, of many, and without drives take fewer operations there."""

from __future__ import annotations

from fractions import Fraction

import pytest

from dynamics.direct import exact_arm
from robodyn import Options, program
from robodyn.counts import count
from robodyn.dynamics.equality import same_in_field
from robodyn.dynamics.functions import FUNCTIONS, Function
from robodyn.dynamics.limits import FEW_JOINTS, MANY_JOINTS
from robodyn.ir import Program
from robodyn.optimize.programs import Choice, build
from robodyn.passes import FRESH, unchecked
from robodyn.robot import Robot, load, read_text
from robodyn_testing import representative

#: A slide behind parallel joints, one of them upside down, on a wall, with a tool; friction, rotors, a name.
LEANING = """\
name: leaning
gravity: {gravity}
base: {{xyz: [0.1, -0.2, 1], rpy: [0, pi/2, 0.3]}}
tool: {{xyz: [0.02, 0.3, 0.1], rpy: [0.2, 0, 0.7]}}
links:
  - {{joint: revolute, d: 0.3, mass: 3, com: [0.1, 0.2, 0.3], motor_inertia: 0.1}}
  - {{joint: revolute, alpha: -pi/2, a: 0.1, mass: {mass}, com: [0.1, 0, 0.2], inertia: {{zz: 1}}, {drive}}}
  - {{joint: revolute, alpha: pi, a: 0.2, theta: pi/2, mass: 1, com: [0, 0.1, 0.1], {drive}}}
  - {{joint: prismatic, alpha: 0.4, a: 0.2, d: 0.1, mass: 1.5, com: [0.1, 0, 0]}}
  - {{joint: revolute, alpha: pi/2, d: 0.2, theta: 0.3, mass: 0.5, com: [0, 0.2, 0.1], inertia: {{xx: 0.1}}}}
"""


def leaning(gravity: str, mass: str = "2") -> Robot:
    drive = "friction: {viscous: 0.2, coulomb: 0.3}"
    return read_text(LEANING.format(gravity=gravity, mass=mass, drive=drive), warn=lambda _: None)


ARMS = {
    "level": leaning("[0, 9.8, 0]"),
    "of a run-time mass": leaning("[1.5, -3, 2]", "load"),
    "weightless": leaning("[0, 0, 0]"),
    "of few joints": exact_arm(22, joints=3, prismatic=0.2, degenerate=0.0, motors=1, parallel=0.8),
    "of one joint": exact_arm(41, joints=1, degenerate=0.0),
}
SEVERAL = [f for f in FUNCTIONS.values() if len({*f.writings(1), *f.without_effects(MANY_JOINTS)}) > 1]
OF_LONG_ARMS = [function for function in SEVERAL if function.of_long_arms]


@pytest.mark.parametrize("arm", representative(ARMS, "of a run-time mass", "of one joint"))
@pytest.mark.parametrize("function", SEVERAL, ids=lambda function: function.name)
def test_each_way_to_write_it_is_right(function: Function, arm: str) -> None:
    robot = ARMS[arm]
    for writing in (*function.writings(robot.n), *function.without_effects(MANY_JOINTS)):
        for choice in (Choice(), Choice(regroup=False, chains=False)):
            assert same_in_field(robot, function.name, build(robot, function.name, choice, writing))


@pytest.mark.parametrize("joints", [2, 5, 7])
def test_one_random_push_tells_a_wrong_entry(joints: int) -> None:
    """By plain Newton-Euler alone, also where there are fewer random numbers than a push has."""
    robot = exact_arm(45, joints=joints, prismatic=0.2, motors=1)
    right = program(robot, "lambda_inverse")
    assert same_in_field(robot, "lambda_inverse", right)
    entries = list(right.results())
    for k in range(0, len(entries), 7):
        other = entries[k - 1] if entries[k - 1] != entries[k] else Fraction(1)
        elements = (*entries[:k], other, *entries[k + 1 :])
        wrong = Program(right.operations, (("lambda_inv", elements),))
        assert not same_in_field(robot, "lambda_inverse", wrong)


def operations(robot: Robot, function: Function) -> list[int]:
    """Of each way to write it, the last for rigid or long arms."""
    ways = (*function.writings(robot.n), *function.without_effects(robot.n))
    return [count(unchecked(build(robot, function.name, Choice(), way), FRESH)).total for way in ways]


@pytest.mark.parametrize("name", ["panda", "rx90", "stanford"])
def test_by_weights_gravity_takes_fewer_operations_than_the_recursion_at_rest(name: str) -> None:
    robot = load(name, warn=lambda _: None)
    recursion, by_weights = operations(robot, FUNCTIONS["gravity"])
    assert by_weights < recursion
    assert count(program(robot, "gravity", Options(("gravity",)))).total <= by_weights


@pytest.mark.thorough
@pytest.mark.parametrize("name", [*(function.name for function in OF_LONG_ARMS), "forward_dynamics"])
def test_long_arms_take_fewer_operations_without_a_mass_matrix(name: str) -> None:
    """They grow with the joints and not with their cube."""
    arm = exact_arm(3, joints=24, prismatic=0.2, parallel=0.3)
    over_matrix, by_bodies = operations(arm, FUNCTIONS[name])
    assert by_bodies < 0.9 * over_matrix
    assert count(program(arm, name, Options(optimize="fast"))).total <= by_bodies


def test_arms_of_few_joints_are_not_tried_in_ways_for_many_nor_long_ones_in_those_for_few() -> None:
    for function in SEVERAL:
        assert not set(function.of_long_arms) & set(function.without_effects(MANY_JOINTS - 1))
        assert set(function.of_long_arms) <= set(function.without_effects(MANY_JOINTS))
        assert set(function.small) <= set(function.writings(FEW_JOINTS))
        assert not set(function.small) & set(function.writings(FEW_JOINTS + 1))
