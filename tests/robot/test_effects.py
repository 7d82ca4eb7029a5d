"""Effects in a description: how they are read and written, and those that only change numbers which the arm
has anyway and end up in those numbers."""

from __future__ import annotations

import subprocess
import sys
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import yaml

from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError
from robodyn.robot import DoubtfulRobot, Inertia, json_schema, read_text, to_yaml
from robodyn.robot.keys import EFFECTS
from robodyn.robot.model import EffectEntry
from robodyn.robot.values import ZERO, parameter
from robodyn_testing import exactly, require_module, sampled
from robodyn_testing.effect_arms import arm_of, arm_text
from robodyn_testing.random_effects import FOLDED, with_random_effects
from robodyn_testing.random_robots import random_robot

F = Fraction

#: An entry of every effect as text, and what is read of it.
EXAMPLES: dict[str, tuple[str, dict[str, Any]]] = {
    "viscous_friction": ("coefficient: 2", {"coefficient": F(2)}),
    "coulomb_friction": ("level: fc", {"level": parameter("fc")}),
    "asymmetric_friction": (
        "positive: 1, negative: 2*fn", {"positive": F(1), "negative": 2 * parameter("fn")},
    ),
    "stribeck_friction": (
        "level: 1, static: 1.5, velocity: 1/20",
        {"level": F(1), "static": F(3, 2), "velocity": F(1, 20), "exponent": F(2)},
    ),
    "presliding_hysteresis": (
        "stiffness: 1e4, level: 2, damping: 3", {"stiffness": F(10000), "level": F(2), "damping": F(3)},
    ),
    "load_dependent_friction": (
        "bearing: journal, mu: 0.1, radius: r, span: 0.2",
        {"bearing": "journal", "mu": F(1, 10), "radius": parameter("r"), "span": F(1, 5)},
    ),
    "transmission_loss": (
        "efficiency: [[0, 0.5], [1/2, 0.75], [1, 1]], rated_torque: 30",
        {"breakaway": ZERO, "efficiency": ((ZERO, F(1, 2)), (F(1, 2), F(3, 4)), (F(1), F(1))),
         "rated_torque": F(30), "interpolation": "linear"},
    ),
    "spring": ("cubic: -2, stiffness: -k", {"stiffness": -parameter("k"), "rest": ZERO, "cubic": F(-2)}),
    "joint_elasticity": (
        "stiffness: 1000, encoder: link", {"stiffness": F(1000), "damping": ZERO, "encoder": "link"},
    ),
    "backlash": (
        "gap: 1e-3",
        {"gap": F(1, 1000), "encoder": "motor", "stiffness": F(10000), "damping": F(1),
         "transition": F(1, 20)},
    ),
    "power_law_friction": (
        "level: 2, exponent: 0.7", {"level": F(2), "exponent": F(7, 10), "velocity": F(1)},
    ),
    "rotor_inertia": ("inertia: 0.5", {"inertia": F(1, 2)}),
    "torque_ripple": (
        "amplitude: 0.1, cycles_per_rev: 200, phase: pi/2",
        {"amplitude": F(1, 10), "cycles_per_rev": F(200), "phase": F("1.5707963267948966")},
    ),
    "motor_coupling": (
        "with: 2, ratio: -1", {"with": 2, "ratio": F(-1), "inertia": ZERO, "viscous": ZERO, "coulomb": ZERO},
    ),
    "inertial_error": ("delta_mass: 1, delta_yz: d", {"delta_mass": F(1), "delta_yz": parameter("d")}),
    "gas_spring": (
        "torque: 50, rise: 0.3",
        {"torque": F(50), "dead_center": ZERO, "rise": F(3, 10), "ratio": F(1, 4)},
    ),
    "torque_bias": ("bias: -1", {"bias": F(-1)}),
    "torque_gain": ("gain: -0.02", {"gain": F(-1, 50)}),
    "time_delay": ("delay: 2e-3", {"delay": F(1, 500)}),
    "encoder_offset": ("offset: pi/2", {"offset": F("1.5707963267948966")}),
    "torque_saturation": ("limit: 50", {"limit": F(50), "clips": "drive"}),
    "payload": (
        "mass: m, com: [0, 0, c], inertia: {xx: 1, xy: -2}",
        {"mass": parameter("m"), "com": (ZERO, ZERO, parameter("c")), "inertia": Inertia(F(1), xy=F(-2))},
    ),
    "base_tilt": ("tilt_x: 0.1", {"tilt_x": F(1, 10)}),
    "external_contact": (
        "start: 1, end: 1.5, link: 2, force_z: -9, log: '12: ab'",
        {"start": F(1), "end": F(3, 2), "link": 2, "force_x": ZERO, "force_y": ZERO, "force_z": F(-9),
         "log": "12: ab"},
    ),
}  # fmt: skip


@pytest.mark.parametrize("effect", CATALOGUE)
def test_every_effect_is_read_with_its_defaults_in_the_order_of_its_definition(effect: str) -> None:
    text, settings = EXAMPLES[effect]
    entry = f"{{effect: {effect}, {text}}}"
    of_robot = CATALOGUE[effect].level == "robot"
    described = arm_text("", entry) if of_robot else arm_text(entry)
    robot = read_text(described)
    if effect in FOLDED:
        assert robot.effects == ()
        assert robot != read_text(arm_text())
    else:
        assert robot.effects == (EffectEntry(effect, None if of_robot else 1, tuple(settings.items())),)
    assert read_text(to_yaml(robot)) == robot
    validator = require_module("jsonschema").Draft202012Validator(json_schema())
    assert [error.message for error in validator.iter_errors(yaml.safe_load(described))] == []


def test_entries_come_base_to_tip_and_then_those_of_the_robot() -> None:
    robot = read_text(
        "name: arm\neffects: [{effect: payload, mass: m_1}, {effect: torque_gain, gain: 0.1}]\nlinks:\n"
        "  - {joint: revolute, effects: [{effect: torque_bias, bias: 1}, {effect: spring, stiffness: k}]}\n"
        "  - {joint: prismatic, effects: [{effect: backlash, gap: g}]}\n"
    )
    assert [(entry.effect, entry.joint) for entry in robot.effects] == [
        ("torque_bias", 1),
        ("spring", 1),
        ("backlash", 2),
        ("payload", None),
        ("torque_gain", None),
    ]
    assert robot.parameters == ("k", "g", "m_1")
    assert robot.effects_at(2) == robot.effects[2:3]


@pytest.mark.parametrize(
    ("at_joint", "of_robot"),
    [
        ("{effect: torque_ripple, amplitude: 1, cycles_per_rev: 2}, "
         "{effect: torque_ripple, amplitude: 1, cycles_per_rev: 3}", ""),
        ("{effect: load_dependent_friction, bearing: thrust, mu_r: 1}, "
         "{effect: load_dependent_friction, bearing: radial, mu_r: 1}", ""),
        ("{effect: backlash, gap: 1}, {effect: spring, stiffness: 1}, {effect: stribeck_friction, level: 1, "
         "static: 1, velocity: 1}", ""),
        ("", ", ".join(["{effect: external_contact, start: 1, end: 2, link: 1}"] * 2)),
    ],
)  # fmt: skip
def test_some_may_stand_together(at_joint: str, of_robot: str) -> None:
    assert len(arm_of(at_joint, of_robot).effects) == (at_joint + of_robot).count("effect:")


def test_a_joint_may_be_coupled_with_two_others() -> None:
    robot = read_text(
        "name: arm\nlinks:\n  - joint: revolute\n    effects: [{effect: motor_coupling, with: 2}, "
        "{effect: motor_coupling, with: 3}]\n  - joint: revolute\n  - joint: revolute\n"
    )
    assert [entry["with"] for entry in robot.effects] == [2, 3]


@pytest.mark.parametrize(
    ("entry", "warned"),
    [
        ("{effect: transmission_loss, efficiency: 0.8}", True),
        ("{effect: torque_ripple, amplitude: 1, cycles_per_rev: 2}", True),
        ("{effect: motor_coupling, with: 2}", True),
        ("{effect: joint_elasticity, stiffness: 1}", True),
        ("{effect: spring, stiffness: 1}", False),
        ("{effect: load_dependent_friction, bearing: thrust, mu_r: 1}", False),
        ("{effect: torque_bias, bias: 1}", False),
    ],
)
def test_what_acts_before_the_gear_is_kept_with_a_word_for_a_torque_behind_it(
    entry: str, warned: bool
) -> None:
    told: list[str] = []
    twice = f"{entry}, {{effect: backlash, gap: 1}}" if warned and "elasticity" not in entry else entry
    text = arm_text(twice, head="torque_side: link\n")
    robot = read_text(text, "arm.yaml", strict=True, warn=told.append)
    assert len(robot.effects) == twice.count("effect:")
    assert len(told) == warned
    assert all(line.startswith("arm.yaml:6:15: link 1: ") for line in told)


@pytest.mark.parametrize("seed", sampled(range(12), every=3))
def test_random_effects_are_written_and_read_back(seed: int) -> None:
    robot = with_random_effects(random_robot(seed, exotic=0), seed, share=0.35, names=0.2)
    text = to_yaml(robot)
    read = read_text(text, warn=lambda _: None)  # degenerate links are doubted
    assert read == robot
    assert to_yaml(read) == text


def test_the_text_is_what_a_person_would_write() -> None:
    lines = [
        "    effects:",
        "      - {effect: transmission_loss, efficiency: [[0, 0.5], [1, 0.9]], rated_torque: 10}",
        "      - {effect: backlash, gap: 0.001, encoder: link}",
        "      - {effect: spring, stiffness: 2 - k, cubic: 1/3}",
        "effects:",
        "  - {effect: payload, mass: m_load, com: [0, 0, 0.1], inertia: {xx: 1}}",
        '  - {effect: external_contact, start: 0, end: 1, link: 2, force_x: 5, log: "null"}',
    ]
    joint = "\n".join(lines[1:4]).replace("- {", "  - {")
    robot = read_text(
        "name: arm\nlinks:\n  - joint: revolute\n    effects:\n"
        f"{joint}\n  - joint: revolute\n" + "\n".join(lines[4:])
    )
    written = to_yaml(robot).splitlines()
    start = written.index(lines[0])
    assert written[start : start + 4] == lines[:4]
    assert written[-3:] == lines[4:]


@pytest.mark.parametrize("work", ["load('puma560')", "to_yaml(r.load('puma560'))", "read_text(BARE)"])
def test_a_rigid_arm_does_without_the_catalogue(work: str) -> None:
    bare = arm_text(head="friction_at_rest: dead_band\n", link="    friction: {viscous: 1}\n")
    code = f"import sys, robodyn.robot as r\nBARE = {bare!r}\nr.{work}\n"
    code += "print('robodyn.effects.catalogue' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"


def test_a_thousand_effects_are_read_and_one_more_is_not() -> None:
    one = "{effect: torque_ripple, amplitude: 1, cycles_per_rev: 2}"
    contact = "{effect: external_contact, start: 1, end: 2, link: 1}"
    robot = arm_of(", ".join([one] * (EFFECTS - 1)), contact)
    assert len(robot.effects) == EFFECTS
    with pytest.raises(InputError, match="too many effects; expected at most 1000"):
        arm_of(", ".join([one] * (EFFECTS - 1)), f"{contact}, {contact}")


# --- folded into the arm ----------------------------------------------------------------------------------


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


def test_numbers_of_the_link_stand_beside_those_of_effects() -> None:
    joint = arm_of("{effect: coulomb_friction, level: 3}", link="    friction: {viscous: 2}\n").links[0].joint
    assert (joint.viscous, joint.coulomb) == exactly(2, 3)
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
        robot = arm_of("{effect: inertial_error, delta_xx: -1}")
    assert robot.links[0].inertia.xx == -1


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
        ("tilt_x: 0, tilt_y: 0", (1, -2, F(-19, 2))),
        ("tilt_x: pi/2", (1, F(19, 2), -2)),
        ("tilt_y: -pi/2", (F(19, 2), -2, 1)),
        ("tilt_x: pi, tilt_y: pi", (-1, 2, F(-19, 2))),
    ],
)
def test_right_angles_of_tilt_are_exact(tilt: str, gravity: tuple[Fraction, ...]) -> None:
    robot = arm_of("", f"{{effect: base_tilt, {tilt}}}", head="gravity: [1, -2, -9.5]\n")
    assert robot.gravity == gravity
