"""What links answer a push with: exactly what the mass matrix says, in fewer operations on long arms."""

from __future__ import annotations

from fractions import Fraction

import pytest

from dynamics.direct import exact_arm
from ir.programs import Point, results
from robodyn import Options, program
from robodyn.counts import count
from robodyn.dynamics.arm import build_arm
from robodyn.dynamics.equality import same_in_field
from robodyn.dynamics.functions import FUNCTIONS, Function
from robodyn.dynamics.limits import MANY_JOINTS
from robodyn.ir import Graph
from robodyn.kernels.generate import SingularArm
from robodyn.optimize.programs import Choice, build
from robodyn.optimize.slide import centred
from robodyn.passes import FRESH, unchecked
from robodyn.robot import Robot, read_text

OF_LONG_ARMS = [function for function in FUNCTIONS.values() if function.of_long_arms]

#: On a wall, with a tool; a slide whose origin moves beside what it carries, and its tool with that.
SLIDING = read_text("""\
name: sliding
base: {xyz: [0.1, -0.2, 1], rpy: [0, pi/2, 0.3]}
tool: {xyz: [0.02, 0.3, 0.1], rpy: [0.2, 0, 0.7]}
gravity: [0, 0, -9.81]
links:
  - {joint: revolute, d: 0.3, mass: 2, com: [0.1, 0, 0.2], motor_inertia: 0.3}
  - {joint: revolute, alpha: -pi/2, a: 0.1, mass: 3, com: [0, 0.2, 0.2], inertia: {xx: 0.2, yy: 0.2, zz: 0.1}}
  - {joint: prismatic, alpha: pi/2, a: 0.2, mass: 1, com: [0.1, 0, 0.3], inertia: {xx: 0.1, yy: 0.2, zz: 0.2}}
  - {joint: revolute, a: 0.2, mass: 1, com: [0.1, 0.1, 0.1], inertia: {xx: 0.1, yy: 0.1, zz: 0.1}}
""")
ARMS = [
    SLIDING,
    *(exact_arm(seed, joints=1 + seed % 6, prismatic=0.3, motors=seed % 2) for seed in range(40, 46)),
]


@pytest.mark.parametrize("function", OF_LONG_ARMS, ids=lambda function: function.name)
@pytest.mark.parametrize("robot", ARMS, ids=lambda robot: robot.name)
def test_they_are_what_the_mass_matrix_says(robot: Robot, function: Function) -> None:
    at = Point(3)
    for choice in (Choice(), Choice(regroup=False, chains=False)):
        try:
            wanted = results(build(robot, function.name, choice), at)
        except ZeroDivisionError:  # a joint moves without inertia
            with pytest.raises(SingularArm):
                program(robot, function.name)
            return
        for way in function.of_long_arms:
            assert results(build(robot, function.name, choice, way), at) == wanted


@pytest.mark.parametrize("joints", [2, 5, 7])
def test_one_random_push_tells_a_wrong_entry(joints: int) -> None:
    """By plain Newton-Euler alone, also where there are fewer random numbers than a push has."""
    robot = exact_arm(45, joints=joints, prismatic=0.2, motors=1)
    right = program(robot, "lambda_inverse")
    assert same_in_field(robot, "lambda_inverse", right)
    entries = list(right.results())
    for k in range(0, len(entries), 7):
        wrong = [
            *entries[:k],
            entries[k - 1] if entries[k - 1] != entries[k] else Fraction(1),
            *entries[k + 1 :],
        ]
        assert not same_in_field(robot, "lambda_inverse", right.with_results(tuple(wrong)))


def test_a_tool_stays_where_it_is_when_its_frame_moves() -> None:
    arm = build_arm(SLIDING, lambda x: x, Graph().input)
    moved = centred(arm)
    shift = moved.bodies[2].d - arm.bodies[2].d
    assert shift
    assert moved.tool.origin == (Fraction(1, 50), Fraction(3, 10), Fraction(1, 10) - shift)


@pytest.mark.thorough
@pytest.mark.parametrize("function", OF_LONG_ARMS, ids=lambda function: function.name)
def test_long_arms_take_fewer_operations_so(function: Function) -> None:
    arm = exact_arm(3, joints=24, prismatic=0.2, parallel=0.3)
    over_matrix, by_answers = (
        count(unchecked(build(arm, function.name, Choice(), way), FRESH)).total
        for way in (function.outputs, *function.of_long_arms)
    )
    assert by_answers < 0.9 * over_matrix
    assert count(program(arm, function.name, Options(optimize="fast"))).total <= by_answers


@pytest.mark.parametrize("function", OF_LONG_ARMS, ids=lambda function: function.name)
def test_arms_of_few_joints_are_not_tried(function: Function) -> None:
    assert not set(function.of_long_arms) & set(function.without_effects(MANY_JOINTS - 1))
    assert set(function.of_long_arms) <= set(function.without_effects(MANY_JOINTS))
