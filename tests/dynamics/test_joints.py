"""What a joint adds to the torque of its link: the rotor on the diagonal, friction, and when neither."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

from dynamics.direct import exact_arm
from ir.programs import Point, exactly
from robodyn import Options, program
from robodyn.dynamics.functions import by_default
from robodyn.ir import Input
from robodyn.ir.fingerprint import fingerprint
from robodyn.robot import Robot, fold_rotor, read_text
from robodyn.robot.values import circle_point

ARMS = [exact_arm(seed, joints=3, motors=0, friction=0) for seed in range(40, 44)]
MOTOR, COULOMB = Fraction("1.7"), Fraction("2.3")
#: Functions that drives have no part in.
WITHOUT_DRIVES = (
    "gravity",
    "potential_energy",
    "coriolis",
    "momentum_observer_term",
    "christoffel_symbols",
)


def driven(robot: Robot, joint: int, **numbers: Any) -> Robot:
    """``robot`` with numbers of one joint's drive set."""
    links = list(robot.links)
    links[joint] = replace(links[joint], joint=replace(links[joint].joint, **numbers))
    return replace(robot, links=tuple(links), torque_side="motor")


def torque(
    robot: Robot, at: Point, options: Options | None = None, **given: list[Fraction]
) -> list[Fraction]:
    numbers = {Input(name, i): x for name, array in given.items() for i, x in enumerate(array)}
    return exactly(program(robot, "inverse_dynamics", options), at, numbers)["tau"]


def same_program(one: Robot, other: Robot, function: str = "inverse_dynamics") -> bool:
    prints = [fingerprint(program(robot, function), 1, circle_point) for robot in (one, other)]
    return prints[0] == prints[1]


def test_friction_at_rest_is_nothing_and_changes_sign_with_the_velocity() -> None:
    robot = driven(ARMS[0], 1, coulomb=COULOMB)
    bare = replace(ARMS[0], torque_side="motor")
    zero = [Fraction(0)] * 3
    assert torque(robot, Point(1), qd=zero) == torque(bare, Point(1), qd=zero)
    for speed, way in ((Fraction(1, 10**9), 1), (Fraction(-1, 10**9), -1)):
        qd = [Fraction(0), speed, Fraction(0)]
        found, without = (torque(arm, Point(1), qd=qd) for arm in (robot, bare))
        assert found[1] - without[1] == way * COULOMB


def test_the_links_side_in_full() -> None:
    """As YAML: the same arm with and without a drive, torque behind the gear."""
    text = """
name: arm
torque_side: {side}
links:
  - {{joint: revolute, alpha: 0.3, a: 0.2, mass: 3, com: [0.1, 0.2, 0.3], inertia: {{xx: 1, yy: 1}}{drive}}}
  - {{joint: prismatic, alpha: pi/2, a: 0.2, mass: 2, com: [0.1, 0.2, 0.3]{drive}}}
"""
    drive = ", motor_inertia: 2.5, friction: {viscous: 1.2, coulomb: 3}"
    behind = read_text(text.format(side="link", drive=drive))
    bare = read_text(text.format(side="motor", drive=""))
    front = read_text(text.format(side="motor", drive=drive))
    for function in by_default():
        assert same_program(behind, bare, function)
        assert same_program(behind, front, function) is (function in WITHOUT_DRIVES), function


def test_a_rotor_folded_into_the_link_is_another_model() -> None:
    robot = driven(exact_arm(6, joints=3, prismatic=0, parallel=0, degenerate=0), 2, motor_inertia=MOTOR)
    folded = fold_rotor(robot)
    assert folded.links[2].inertia.zz == robot.links[2].inertia.zz + MOTOR
    zero = [Fraction(0)] * 3
    assert not same_program(folded, robot)
    unit = [Fraction(0), Fraction(0), Fraction(1)]
    assert torque(folded, Point(1), qd=zero, qdd=unit)[2] == torque(robot, Point(1), qd=zero, qdd=unit)[2]
