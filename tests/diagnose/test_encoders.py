"""The stiffness of a joint from its two encoders, whatever the time between their readings."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.encoders import elastic_findings, elasticity, stiff_words
from robodyn.gate.gate import Gate, inspect
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.robot import Robot, load, read_text
from robodyn.robot.writer import to_yaml

STIFFNESS, RATE, SKEW = 20_000.0, 500.0, 0.003


@pytest.fixture(scope="module")
def arm() -> Robot:
    text = to_yaml(load("puma560_3dof", warn=lambda _: None))
    return read_text(text.replace("motor_inertia: 4.71", "motor_inertia: 2"), warn=lambda _: None)


def logged(arm: Robot, seed: int, *, skew: float = SKEW, stiffness: float = STIFFNESS) -> Log:
    """A log whose joint 2 is elastic, with friction and a rotor that are not described, noise, and an offset
    between its encoders."""
    rng = np.random.default_rng(seed)
    t = np.arange(0, 10, 1 / RATE)

    def motion(at: np.ndarray, order: int) -> np.ndarray:
        draw = np.random.default_rng(seed)
        total = np.zeros((len(at), 3))
        for k in range(1, 6):
            w = 2 * math.pi * 0.1 * k
            size, phase = draw.uniform(0.1, 0.35, 3), draw.uniform(-3, 3, 3)
            total += size * w**order * np.sin(w * at[:, None] + phase + order * math.pi / 2)
        return total

    q, qd, qdd = (motion(t, order) for order in range(3))
    link = Model(replace(arm, links=tuple(
        replace(x, joint=replace(x.joint, motor_inertia=arm.links[0].mass * 0)) for x in arm.links
    ))).evaluate(q, qd, qdd).rigid  # fmt: skip
    motor = q.copy()
    motor[:, 1] += link[:, 1] / stiffness
    speed = np.gradient(motor, 1 / RATE, axis=0)
    rate = np.gradient(speed, 1 / RATE, axis=0)
    tau = link + 2.0 * np.sign(speed) + 1.5 * speed + np.array([1.14, 4.71, 0.83]) * rate
    ql = np.full_like(q, np.nan)
    ql[:, 1] = motion(t - skew, 0)[:, 1] + 0.004 + 2e-5 * rng.standard_normal(len(t))
    noise = rng.standard_normal(q.shape)
    return Log(t, motor + 1e-5 * noise[:, ::-1], None, None, tau + 0.3 * noise, ql=ql)


def gates(arm: Robot, *seeds: int, **how: float) -> list[Gate]:
    return [inspect(logged(arm, seed, **how), arm) for seed in seeds]


def test_the_stiffness_is_within_its_error_beside_rotor_friction_offset_and_skew(arm: Robot) -> None:
    (one,) = elasticity(arm, gates(arm, 1, 2))
    assert one.joint == 2
    assert one.is_identifiable
    assert one.stiffness == pytest.approx(STIFFNESS, rel=0.1)
    assert abs(one.compliance - 1 / STIFFNESS) < 3 * one.stderr
    assert one.least_stiffness < STIFFNESS
    assert one.skew - 1.5 / STIFFNESS == pytest.approx(SKEW, abs=2e-4)  # viscous friction is in it
    assert one.explained > 0.99
    # Read at one time, as they were not, the encoders would tell another stiffness.
    assert abs(one.without_skew / STIFFNESS - 1) > 0.3


@pytest.mark.thorough
def test_errors_hold_what_is_true(arm: Robot) -> None:
    ones = [elasticity(arm, gates(arm, seed))[0] for seed in range(3, 15)]
    off = np.array([(one.compliance - 1 / STIFFNESS) / one.stderr for one in ones])
    assert np.mean(np.abs(off) < 2.2) >= 0.8


def test_a_stiff_gear_is_not_called_elastic(arm: Robot) -> None:
    (one,) = elasticity(arm, gates(arm, 1, stiffness=1e9))
    assert not one.is_identifiable
    assert one.least_stiffness > 1e5
    assert elastic_findings(arm, [one]) == ()
    (words,) = stiff_words(arm, [one])
    assert words.startswith("joint 2: its second encoder is read about 3 ms late, and beside that no spring")
    assert words.endswith("if it were not")


def test_a_finding_has_the_stiffness_and_its_unit(arm: Robot) -> None:
    seen = elasticity(arm, gates(arm, 1))
    (finding,) = elastic_findings(arm, seen)
    assert stiff_words(arm, seen) == ()
    assert (finding.effect, finding.joint) == ("joint_elasticity", 2)
    stiffness = finding.parameters["stiffness"]
    assert stiffness.unit == "N m/rad"
    assert stiffness.value == pytest.approx(STIFFNESS, rel=0.15)
    assert "the link's is read about 2.9 ms late" in finding.where


def test_without_second_encoders_nothing_is_said(arm: Robot) -> None:
    log = logged(arm, 1)
    assert elasticity(arm, [inspect(replace(log, ql=None), arm)]) == ()
    soft = "\n    effects: [{effect: joint_elasticity, stiffness: 1e4}]"
    described = read_text(
        to_yaml(arm).replace("motor_inertia: 2\n", f"motor_inertia: 2{soft}\n"), warn=lambda _: None
    )
    assert elastic_findings(described, elasticity(described, gates(arm, 1))) == ()


@pytest.mark.slow
def test_diagnose_names_the_elastic_joint_beside_what_the_torques_lack(arm: Robot) -> None:
    full = read_text(to_yaml(load("puma560_3dof", warn=lambda _: None)), warn=lambda _: None)
    log = logged(arm, 1)
    result = diagnose(full, [log])
    assert result.verdict == "missing_effect"
    (one,) = (f for f in result.findings if f.effect == "joint_elasticity")
    assert one.joint == 2
    assert one.parameters["stiffness"].value == pytest.approx(STIFFNESS, rel=0.1)
    assert {f.effect for f in result.findings} == {"joint_elasticity", "viscous_friction", "coulomb_friction"}
    # An undamped spring may ring: it is in the model only where the torques do not fit worse with it.
    plain = diagnose(full, [log], without=["joint_elasticity"]).gap
    assert np.all(result.gap.train_after <= 1.06 * plain.train_after)
    assert diagnose(result.model, [log]).verdict == "consistent"
    assert not [f for f in diagnose(full, [log], without=["joint_elasticity"]).findings if f.joint == 2
                and f.effect == "joint_elasticity"]  # fmt: skip
