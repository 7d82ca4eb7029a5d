"""What a joint adds to the torque of its link: the rotor on the diagonal, friction, and when neither."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest

from dynamics.direct import exact_arm
from ir.programs import Point, exactly
from robodyn import Options, program
from robodyn.dynamics.functions import by_default
from robodyn.dynamics.joints import smoothed_sign
from robodyn.ir import Input, Operation, Program
from robodyn.ir.evaluate import evaluate
from robodyn.ir.fingerprint import fingerprint
from robodyn.robot import Robot, fold_rotor, read_text
from robodyn.robot.values import circle_point
from robodyn_testing import covering
from robodyn_testing.functions import SAMPLED

ARMS = [exact_arm(seed, joints=3, motors=0, friction=0) for seed in range(40, 44)]
MOTOR, VISCOUS, COULOMB = (Fraction(x) for x in ("1.7", "0.9", "2.3"))
SIGN = Program((Operation("sign", (Input("x", None),)),), (("t", (0,)),))
#: Functions that drives have no part in.
WITHOUT_DRIVES = (
    "gravity",
    "potential_energy",
    "coriolis",
    "momentum_observer_term",
    "christoffel_symbols",
)
WAYS = (Options(), Options(regroup=False, optimize="none"), Options(formulation="newton_euler"))


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


@pytest.mark.parametrize(("joint", "options"), covering([0, 1, 2], WAYS))
def test_rotor_and_friction_add_to_their_own_joint_only(joint: int, options: Options) -> None:
    for robot in ARMS:
        at = Point(joint)
        qd, qdd = (at.number(Input(name, joint)) for name in ("qd", "qdd"))
        bare = torque(replace(robot, torque_side="motor"), at, options)
        for numbers, added in (
            ({"motor_inertia": MOTOR}, MOTOR * qdd),
            ({"viscous": VISCOUS}, VISCOUS * qd),
            ({"coulomb": COULOMB}, COULOMB * (1 if qd > 0 else -1)),
            (
                {"motor_inertia": MOTOR, "viscous": VISCOUS, "coulomb": COULOMB},
                MOTOR * qdd + VISCOUS * qd + COULOMB * (1 if qd > 0 else -1),
            ),
        ):
            found = torque(driven(robot, joint, **numbers), at, options)
            assert [x - y for x, y in zip(found, bare, strict=True)] == [
                added if i == joint else 0 for i in range(robot.n)
            ]


def test_friction_at_rest_is_nothing_and_changes_sign_with_the_velocity() -> None:
    robot = driven(ARMS[0], 1, coulomb=COULOMB)
    bare = replace(ARMS[0], torque_side="motor")
    zero = [Fraction(0)] * 3
    assert torque(robot, Point(1), qd=zero) == torque(bare, Point(1), qd=zero)
    for speed, way in ((Fraction(1, 10**9), 1), (Fraction(-1, 10**9), -1)):
        qd = [Fraction(0), speed, Fraction(0)]
        found, without = (torque(arm, Point(1), qd=qd) for arm in (robot, bare))
        assert found[1] - without[1] == way * COULOMB


@pytest.mark.parametrize("function", SAMPLED)
def test_torques_of_the_links_side_have_neither_rotor_nor_friction(function: str) -> None:
    for bare in ARMS:
        robot = bare
        for joint in range(3):
            robot = driven(robot, joint, motor_inertia=MOTOR, viscous=VISCOUS, coulomb=COULOMB)
        behind = replace(robot, torque_side="link")
        if function == "forward_dynamics":
            bare, behind = (driven(driven(arm, 0), 0) for arm in (bare, bare))
        assert same_program(replace(bare, torque_side=behind.torque_side), behind, function)
        front = program(robot, "inverse_dynamics")
        assert {op.op for op in front.operations} >= {"sign"}


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


def test_a_rotor_is_on_the_diagonal_of_the_mass_matrix() -> None:
    for robot in ARMS:
        with_rotor, without = (
            exactly(program(arm, "mass_matrix"), Point(3))["M"]
            for arm in (driven(robot, 2, motor_inertia=MOTOR), replace(robot, torque_side="motor"))
        )
        difference = [x - y for x, y in zip(with_rotor, without, strict=True)]
        assert difference == [0] * 8 + [MOTOR]


def test_a_rotor_folded_into_the_link_is_another_model() -> None:
    robot = driven(exact_arm(6, joints=3, prismatic=0, parallel=0, degenerate=0), 2, motor_inertia=MOTOR)
    folded = fold_rotor(robot)
    assert folded.links[2].inertia.zz == robot.links[2].inertia.zz + MOTOR
    zero = [Fraction(0)] * 3
    assert not same_program(folded, robot)
    unit = [Fraction(0), Fraction(0), Fraction(1)]
    assert torque(folded, Point(1), qd=zero, qdd=unit)[2] == torque(robot, Point(1), qd=zero, qdd=unit)[2]


def test_a_sign_over_plain_numbers() -> None:
    """As the recursion takes it where it runs on numbers instead of nodes."""
    for velocity, way in ((Fraction(0), 0), (Fraction(1, 9), 1), (Fraction(-1, 9), -1)):
        assert smoothed_sign(velocity, None) == way
        assert smoothed_sign(float(velocity), None) == way
        assert evaluate(SIGN, {Input("x", None): velocity})["t"] == [way]
    assert smoothed_sign(0.3, 0.1) == math.tanh(0.3 / 0.1)


# --- smooth at rest ---------------------------------------------------------------------------------------


def test_smooth_friction_is_a_tanh_of_the_velocity() -> None:
    rest = Fraction(1, 50)
    exact = driven(ARMS[1], 0, coulomb=COULOMB, viscous=VISCOUS)
    smooth = replace(exact, rest_velocity=rest)
    made = program(smooth, "inverse_dynamics")
    ops = [op.op for op in made.operations]
    assert (ops.count("tanh"), ops.count("sign")) == (1, 0)
    bare = program(replace(ARMS[1], torque_side="motor"), "inverse_dynamics")
    for speed in (0.0, 1e-3, -0.02, 0.3, -5.0):
        inputs = {x: 0.37 * (k + 1) for k, x in enumerate(made.inputs())}
        inputs[Input("qd", 0)] = speed
        inputs |= {x: 0.1 for x in bare.inputs() if x not in inputs}
        found, without = (evaluate(arm, inputs)["tau"] for arm in (made, bare))
        added = float(COULOMB) * math.tanh(speed / float(rest)) + float(VISCOUS) * speed
        assert math.isclose(found[0] - without[0], added, rel_tol=1e-9, abs_tol=1e-9)
        assert found[1:] == without[1:] or [
            round(a - b, 12) for a, b in zip(found[1:], without[1:], strict=True)
        ] == [0, 0]


def test_smooth_friction_where_nothing_moves() -> None:
    """Gravity torques and the mass matrix have no friction in them, smooth or not."""
    robot = replace(driven(ARMS[1], 0, coulomb=COULOMB, viscous=VISCOUS), rest_velocity=Fraction(1, 10))
    bare = replace(ARMS[1], torque_side="motor")
    for function in ("gravity", "mass_matrix"):
        assert same_program(robot, bare, function)
    assert not same_program(robot, bare, "bias")
