"""The one sentence of a diagnosis: grouped by kind, what all joints lack first, and what stays."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from report.made_up import made, many
from robodyn.diagnose.result import Estimate, Finding, Gap
from robodyn.report.diagnosis_headline import LINE, headline, in_a_line, missing_words
from robodyn.report.diagnosis_summary import summary
from robodyn.robot import load


def found(effect: str, *joints: int | None, **values: float) -> list[Finding]:
    numbers = {name: Estimate(value, 0.1, "") for name, value in values.items()}
    return [Finding(effect, j, numbers, 0.95, (), "", None, 1.0, 1.0) for j in joints]


def words(*findings: list[Finding], n: int = 6) -> str:
    return ", ".join(missing_words([one for group in findings for one in group], n))


def test_a_stock_arm_from_its_drawing() -> None:
    """The TX40: friction of three kinds, rotors, and a motor that drives joints 5 and 6."""
    lacking = [
        found("motor_coupling", 6, **{"with": 5.0}),
        found("viscous_friction", 1, 2, 4, 5),
        found("rotor_inertia", 1, 2, 3, 4),
        found("power_law_friction", 3, 6),
        found("coulomb_friction", 1),
    ]
    assert words(*lacking) == "friction at all joints, rotor inertia at joints 1 to 4, a coupled wrist (5, 6)"


@pytest.mark.parametrize(
    ("findings", "text"),
    [
        (found("viscous_friction", 1, 2, 3, 4, 5, 6), "viscous friction at all joints"),
        (found("viscous_friction", 1, 2, 4, 5, 6), "viscous friction at all joints but 3"),
        (found("coulomb_friction", 2, 5), "Coulomb friction at joints 2 and 5"),
        (found("gas_spring", 2), "a gas spring at joint 2"),
        (found("gas_spring", 2, 3), "gas springs at joints 2 and 3"),
        (found("payload", None), "a payload"),
        (found("base_tilt", None) + found("torque_bias", 4), "a tilted base, a torque offset at joint 4"),
        (found("inertial_error", 3), "wrong inertial numbers of link 3"),
        (found("inertial_error", 2, 4), "wrong inertial numbers of links 2 and 4"),
        (found("motor_coupling", 3, **{"with": 2.0}), "coupled joints (2, 3)"),
        (
            found("viscous_friction", 1, 2, 3, 4, 5, 6) + found("rotor_inertia", 1, 2, 3, 4, 5, 6),
            "viscous friction and rotor inertia at all joints",
        ),
        (found("effect_of_tomorrow", 2), "effect_of_tomorrow at joint 2"),
    ],
)  # fmt: skip
def test_each_kind_in_words(findings: list[Finding], text: str) -> None:
    assert words(findings) == text


def test_more_than_a_handful_is_counted() -> None:
    ids = ("backlash", "spring", "torque_bias", "encoder_offset", "torque_ripple", "joint_elasticity")
    things = missing_words([one for k, id in enumerate(ids) for one in found(id, k + 1)], 8)
    assert things[0] == "backlash at joint 1"
    assert things[4:] == ["2 more"]


def test_the_sentence_ends_with_what_stays() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    diagnosis = made(robot)
    assert headline(diagnosis).endswith("is missing; 12 % of the torque stays unexplained.")
    assert headline(diagnosis, validated=False).endswith("is missing; 11 % of the torque stays unexplained.")
    unknown = replace(diagnosis, gap=replace(diagnosis.gap, torque=None))
    assert headline(unknown).endswith("is missing.")
    both = replace(unknown, findings=tuple(found("viscous_friction", 1) + found("gas_spring", 2)))
    assert (
        headline(both) == "puma560_3dof: viscous friction at joint 1 and a gas spring at joint 2 are missing."
    )
    none = replace(diagnosis, gap=replace(diagnosis.gap, validate_after=np.full(3, 1e-3)))
    assert "less than 1 % of the torque" in headline(none)


def test_consistent_is_said_of_the_noise_floor_only() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    one = np.ones(3)
    quiet = made(robot, verdict="consistent", findings=(), gap=Gap(one, one, 1.2 * one, 1.2 * one, one))
    assert "what it leaves is at the noise floor" in headline(quiet)
    rough = np.array([1.0, 3.1, 1.7])
    loud = made(robot, verdict="consistent", findings=(), gap=Gap(rough, rough, rough, rough, one))
    assert headline(loud) == (
        "puma560_3dof lacks no effect that the logs could name, but joint 2 leaves three times the noise."
    )
    refitted = replace(loud, extra={"refitted": 0.1})
    assert headline(refitted) == (
        "puma560_3dof is within your 10 %: refitted numbers are in model.yaml, joint 2 leaves three times "
        "the noise."
    )
    settled = replace(quiet, extra={"refitted": 0.3})
    assert headline(settled) == (
        "puma560_3dof is within your 30 %: refitted numbers are in model.yaml, what they leave is at the "
        "noise floor."
    )
    assert any(line.startswith("gap after") for line in summary(settled, "r.html", validated=True))
    assert not any(line.startswith("gap after") for line in summary(quiet, "r.html", validated=True))


@pytest.mark.parametrize(
    ("room", "line"),
    [
        (90, "puma560: friction, rotor inertia, a payload, a coupled wrist and torque ripple are missing"),
        (LINE, "puma560: friction, rotor inertia, a payload and 2 more are missing"),
        (55, "puma560: friction, rotor inertia and 3 more are missing"),
        (40, "puma560: friction and 4 more are missing"),
        (35, "puma560: 21 effects are missing"),
        (30, "21 effects are missing"),
        (10, "21 effect…"),
    ],
)  # fmt: skip
def test_any_number_of_findings_is_a_line(room: int, line: str) -> None:
    diagnosis = made(load("puma560", warn=lambda _: None), findings=many(6))
    shown, rest = in_a_line(diagnosis, room=room)
    assert shown == line
    assert rest == (
        "A payload, friction and rotor inertia at all joints, a coupled wrist (5, 6) and torque ripple at "
        "joint 4; 12 % of the torque stays unexplained."
    )


def test_what_fits_is_said_once() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    assert in_a_line(made(robot)) == (
        "puma560_3dof: Coulomb friction at joint 3 is missing", "12 % of the torque stays unexplained."
    )  # fmt: skip
    one = np.ones(3)
    quiet = made(robot, verdict="consistent", findings=(), gap=Gap(one, one, 1.2 * one, 1.2 * one, one))
    assert in_a_line(quiet) == (
        "puma560_3dof explains the logs: no effect needs to be added", "What it leaves is at the noise floor."
    )  # fmt: skip
    assert in_a_line(made(robot, verdict="unexplained", findings=())) == (
        "A residual remains that no effect of the catalogue explains", "It is largest at joint 3."
    )  # fmt: skip
    for effect, line in (
        ("transmission_loss", "transmission loss at joint 2 is missing"),
        ("inertial_error", "wrong inertial numbers of link 2 are missing"),
    ):
        assert in_a_line(made(robot, findings=tuple(found(effect, 2))))[0] == f"puma560_3dof: {line}"
    contact = found("external_contact", None, start=1.0, end=2.0, link=2.0)
    assert in_a_line(made(robot, findings=tuple(contact))) == (
        "puma560_3dof: no effect is missing, but something touched the arm",
        "Something touched link 2 from 1.00 to 2.00 s.",
    )
    long = replace(robot, name="a" * 63)
    assert in_a_line(made(long))[0] == "Coulomb friction is missing"
