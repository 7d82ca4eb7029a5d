"""Effects that only change numbers which the arm has anyway: they end up in those numbers."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from robodyn.effects.catalogue import CATALOGUE
from robodyn.robot import DoubtfulRobot, Inertia, Robot, read_text, to_yaml
from robodyn.robot.folding import folded
from robodyn.robot.model import EffectEntry
from robodyn.robot.values import ZERO, parameter
from robodyn_testing import exactly
from robodyn_testing.effect_arms import arm_of

F = Fraction


@pytest.mark.parametrize(
    ("effects", "link"),
    [
        ("{effect: viscous_friction, coefficient: fv}", "    friction: {viscous: fv}\n"),
        ("{effect: coulomb_friction, level: 3}", "    friction: {coulomb: 3}\n"),
        (
            "{effect: coulomb_friction, level: 3}, {effect: viscous_friction, coefficient: 2}",
            "    friction: {viscous: 2, coulomb: 3}\n",
        ),
        ("{effect: rotor_inertia, inertia: 0.5}", "    motor_inertia: 1/2\n"),
    ],
)
@pytest.mark.parametrize("kind", ["revolute", "prismatic"])
def test_what_has_two_spellings_is_one_thing(effects: str, link: str, kind: str) -> None:
    assert arm_of(effects, kind=kind) == arm_of(link=link, kind=kind)


def test_the_other_half_of_friction_may_stand_in_the_shorthand() -> None:
    joint = arm_of("{effect: coulomb_friction, level: 3}", link="    friction: {viscous: 2}\n").links[0].joint
    assert (joint.viscous, joint.coulomb) == exactly(2, 3)


def test_rotor_inertia_adds_to_motor_inertia() -> None:
    robot = arm_of("{effect: rotor_inertia, inertia: j}", link="    motor_inertia: 1.5\n")
    assert robot.links[0].joint.motor_inertia == parameter("j") + F(3, 2)


def test_an_inertial_error_is_added_to_its_link() -> None:
    robot = arm_of(
        "{effect: inertial_error, delta_mass: -0.5, delta_com_y: dy, delta_xx: 0.01, delta_yz: -0.02}",
        link="    com: [1, 2, 3]\n    inertia: {xx: 0.5, yy: 0.5, zz: 0.5, yz: 0.01}\n",
    )
    link = robot.links[0]
    assert robot.effects == ()
    assert link.mass == F(3, 2)
    assert link.com == exactly(1, parameter("dy") + 2, 3)
    assert link.inertia == Inertia(F(51, 100), F(1, 2), F(1, 2), yz=F(-1, 100))


def test_an_error_that_no_body_has_is_doubted_at_the_link() -> None:
    with pytest.warns(DoubtfulRobot, match=r"<text>:3:5: link 1: inertia is not physical"):
        arm_of("{effect: inertial_error, delta_xx: -1}")


def test_base_tilt_turns_gravity_about_x_and_then_about_y() -> None:
    x, y = 0.3, -0.2
    robot = arm_of("", f"{{effect: base_tilt, tilt_x: {x}, tilt_y: {y}}}", head="gravity: [1, -2, -9.5]\n")
    about_x = np.array([[1, 0, 0], [0, np.cos(x), -np.sin(x)], [0, np.sin(x), np.cos(x)]])
    about_y = np.array([[np.cos(y), 0, np.sin(y)], [0, 1, 0], [-np.sin(y), 0, np.cos(y)]])
    found = np.array([float(g) for g in robot.gravity])
    np.testing.assert_allclose(found, about_y @ about_x @ np.array([1, -2, -9.5]), rtol=1e-15)
    assert robot.effects == ()
    assert read_text(to_yaml(robot)) == robot


@pytest.mark.parametrize(
    ("tilt", "gravity"),
    [
        ("tilt_x: 0", (1, -2, F(-19, 2))),
        ("tilt_x: 0, tilt_y: 0", (1, -2, F(-19, 2))),
        ("tilt_x: pi/2", (1, F(19, 2), -2)),
        ("tilt_y: -pi/2", (F(19, 2), -2, 1)),
        ("tilt_x: pi, tilt_y: pi", (-1, 2, F(-19, 2))),
    ],
)
def test_right_angles_of_tilt_are_exact(tilt: str, gravity: tuple[Fraction, ...]) -> None:
    robot = arm_of("", f"{{effect: base_tilt, {tilt}}}", head="gravity: [1, -2, -9.5]\n")
    assert robot.gravity == gravity


def test_entries_of_a_robot_made_elsewhere_fold_as_in_reading() -> None:
    """What `diagnose` finds is such a robot."""
    entries = "{effect: rotor_inertia, inertia: 1}, {effect: inertial_error, delta_mass: 1}"
    friction = "{effect: viscous_friction, coefficient: 2}, {effect: coulomb_friction, level: 3}"
    read = arm_of(
        f"{entries}, {friction}, {{effect: spring, stiffness: 1}}", "{effect: base_tilt, tilt_x: 1}"
    )
    zero = dict.fromkeys(CATALOGUE["inertial_error"].names, ZERO)
    plain = arm_of("{effect: spring, stiffness: 1}")
    made = Robot(
        plain.name,
        plain.links,
        effects=(
            EffectEntry("rotor_inertia", 1, (("inertia", F(1)),)),
            EffectEntry("inertial_error", 1, tuple((zero | {"delta_mass": F(1)}).items())),
            EffectEntry("viscous_friction", 1, (("coefficient", F(2)),)),
            EffectEntry("coulomb_friction", 1, (("level", F(3)),)),
            *plain.effects,
            EffectEntry("base_tilt", None, (("tilt_x", F(1)), ("tilt_y", ZERO))),
        ),
    )
    assert folded(made) == read
    assert folded(read) == read
