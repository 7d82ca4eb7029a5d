"""What is hidden by another engine is named, nothing is named where nothing is, and the gap closes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from benchmarks.blind_arms.cases import Case
from benchmarks.blind_arms.logs import effect, hidden_log

from robodyn.diagnose.result import Diagnosis
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.library import context_of
from robodyn.diagnose.select.selection import encoder_torque_noise, select
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log, read_log
from robodyn.logs.signals import signals_of, smoothed_motion
from robodyn.robot import load
from robodyn.robot.model import EffectEntry


def one_in_ci(cases: Sequence[tuple[Any, ...]]) -> list[Any]:
    """The first of ``cases``, and the others, which are whole diagnoses too, for ``make prove-all``."""
    return [cases[0], *(pytest.param(*case, marks=pytest.mark.slow) for case in cases[1:])]


#: Arm, effect, joint, seed, gap over noise.
CLEAR = (
    ("puma560_3dof", "viscous_friction", 2, 1, 3.7),
    ("puma560_3dof", "stribeck_friction", 1, 1, 4.8),
    ("puma560_3dof", "base_tilt", None, 1, 7.6),
    ("puma560_3dof", "torque_saturation", 2, 1, 5.1),
)


@pytest.mark.parametrize(("arm_name", "effect", "joint", "seed", "ratio"), one_in_ci(CLEAR))
def test_what_is_hidden_is_named_first(
    arm_name: str, effect: str, joint: int | None, seed: int, ratio: float
) -> None:
    hidden = Case(arm_name, ((effect, joint),), seed, ratio).make()
    found = select(hidden.given, hidden.train).findings
    assert [(one.trial.candidate.effect, one.trial.candidate.joint) for one in found] == [(effect, joint)]


@pytest.mark.parametrize(
    "hidden",
    [
        [effect("power_law_friction", 1, level=0.5, exponent=0.6)],
        [effect("viscous_friction", 1, coefficient=0.4), effect("coulomb_friction", 1, level=0.1)],
    ],
    ids=["a power", "a line"],
)
@pytest.mark.thorough
def test_one_law_of_friction_stands_in_the_place_of_two_where_the_log_says_so(
    hidden: list[EffectEntry],
) -> None:
    logs = hidden_log(
        "puma560_3dof", hidden, seed=5, duration=6.0, noise_share=0.015, validation=False, friction=False
    )
    named = select(logs.given, logs.train).findings
    assert {(one.trial.candidate.effect, one.trial.candidate.joint) for one in named} == {
        (each.effect, each.joint) for each in hidden
    }


@pytest.mark.thorough
def test_nothing_is_named_where_nothing_is_hidden() -> None:
    hidden = Case("puma560_3dof", (), 3, 1.0, friction=True).make()
    assert select(hidden.given, hidden.train).findings == ()


@pytest.mark.thorough
def test_a_diagnosis_closes_the_gap_and_then_says_consistent() -> None:
    hidden = Case("puma560_3dof", (("coulomb_friction", 3),), 1, 7.6).make()
    found = diagnose(hidden.given, [hidden.train], hidden.validate)
    assert found.verdict == "missing_effect"
    assert [(f.effect, f.joint) for f in found.findings] == [("coulomb_friction", 3)]
    gap = found.gap
    removable = gap.validate_before[2] - hidden.truth.noise[2]
    assert gap.validate_before[2] - gap.validate_after[2] > 0.9 * removable
    again = diagnose(found.model, [hidden.train], hidden.validate)
    assert again.verdict == "consistent"
    assert found.to_dict()["findings"][0]["parameters"]["level"]["unit"] == "N*m"


# --- several effects, and what nothing explains -----------------------------------------------------------


TX40 = Path(__file__).parents[2] / "examples" / "tx40"

PAIRS = (
    ((("time_delay", None), ("coulomb_friction", 2)), 5.783),
    ((("viscous_friction", 1), ("payload", None)), 4.787),
    ((("spring", 1), ("torque_ripple", 2)), 4.284),
)


@pytest.mark.parametrize(("hidden", "ratio"), one_in_ci(PAIRS), ids=lambda x: str(x))
@pytest.mark.slow
def test_two_effects_are_both_named(hidden: tuple[tuple[str, int | None], ...], ratio: float) -> None:
    made = Case("puma560_3dof", hidden, 1, ratio).make()
    found = diagnose(made.given, [made.train], made.validate)
    assert {(f.effect, f.joint) for f in found.findings if f.confidence >= 0.5} == set(hidden)
    assert np.all(found.gap.validate_after < 1.3 * made.truth.noise)


@pytest.mark.parametrize(
    "effect", ["random_offset", pytest.param("acceleration_friction", marks=pytest.mark.slow)]
)
@pytest.mark.thorough
def test_what_is_in_no_catalogue_is_not_named(effect: str) -> None:
    made = Case("puma560_3dof", ((effect, 1),), 1, 6.0).make()
    found = diagnose(made.given, [made.train], made.validate)
    assert found.verdict == "unexplained"
    assert not [f for f in found.findings if f.confidence >= 0.5]


@pytest.mark.thorough
def test_a_real_arm_lacks_friction_and_the_coupling_of_its_wrist() -> None:
    """Staubli TX40, from its CAD model: what the figaroh-plus repository identified."""
    first = select(load(str(TX40 / "tx40.yaml")), read_log(TX40 / "tx40.csv", 6))
    found = [(one.trial.candidate.effect, one.trial.candidate.joint) for one in first.findings]
    assert ("motor_coupling", 6) in found
    assert {joint for effect, joint in found if effect == "viscous_friction"} >= {1, 2, 3, 4}


@pytest.mark.slow
def test_a_real_arm_from_rigid_to_coupled() -> None:
    robot, log = load(str(TX40 / "tx40.yaml")), read_log(TX40 / "tx40.csv", 6)
    found = diagnose(robot, [log])
    named = {(f.effect, f.joint) for f in found.findings if f.confidence >= 0.5}
    assert ("motor_coupling", 6) in named
    assert {effect for effect, _ in named} >= {"viscous_friction", "coulomb_friction"}
    size = np.sqrt(np.mean(log.tau**2, axis=0))
    assert np.mean(found.gap.train_after / size) < 0.15


def test_ends_of_a_motion_keep_their_acceleration() -> None:
    t = np.arange(450) / 1000
    q = np.sin(2 * np.pi * 1.3 * t)[:, None]
    smooth = smoothed_motion(q, 1000.0, 15.0)
    second = np.gradient(np.gradient(smooth, 1e-3, axis=0), 1e-3, axis=0)
    exact = -((2 * np.pi * 1.3) ** 2) * q
    assert np.abs(second - exact)[3:-3].max() < 0.15 * np.abs(exact).max()


@pytest.mark.slow
def test_pieces_of_a_log_count() -> None:
    made = Case("puma560_3dof", (("viscous_friction", 2),), 1, 5.0).make()
    log = made.train
    kept = (log.t // 0.45).astype(int) % 3 != 2
    pieces = Log(log.t[kept], log.q[kept], None, None, log.tau[kept])
    found = diagnose(made.given, [pieces], made.validate)
    assert [(f.effect, f.joint) for f in found.findings if f.confidence >= 0.5] == [("viscous_friction", 2)]


# --- too little motion ------------------------------------------------------------------------------------


def diagnosed(case: Case) -> Diagnosis:
    made = case.make()
    return diagnose(made.given, [made.train], made.validate)


@pytest.mark.thorough
def test_friction_and_bias_are_rivals_where_a_joint_goes_one_way() -> None:
    found = diagnosed(Case("puma560_3dof", (("torque_bias", 2),), 1, 4.806, motion="one_way"))
    (first,) = found.findings
    assert first.joint == 2
    assert {first.effect, *first.confounded_with} >= {"coulomb_friction", "torque_bias"}
    # Three rivals and more: nobody can claim one of them.
    assert len(first.confounded_with) >= 3
    assert first.confidence < 0.5
    assert found.verdict == "unexplained"
    assert first.experiment
    assert "one direction" in str(found.record)


@pytest.mark.slow
def test_noise_of_the_encoders_is_no_elastic_joint() -> None:
    found = diagnosed(Case("puma560_3dof", (("viscous_friction", 2),), 2, 3.485, motion="narrow"))
    assert {(f.effect, f.joint) for f in found.findings} == {("viscous_friction", 2)}


@pytest.mark.slow
def test_a_joint_that_sets_out_is_not_touched() -> None:
    found = diagnosed(Case("puma560_3dof", (("coulomb_friction", 3),), 1, 6.0, motion="one_way"))
    assert "external_contact" not in {f.effect for f in found.findings}


@pytest.mark.slow
def test_errors_within_the_stated_confidence_are_no_finding() -> None:
    made = Case("stanford", (), 23, 1.0, friction=True, inertia_error=0.03).make()
    assert select(made.given, made.train).findings == ()


def test_what_noise_of_the_encoders_makes_of_torques() -> None:
    robot, rng = load("ur5"), np.random.default_rng(0)
    t = np.arange(20_000) / 1000
    slow = 0.5 * np.sin(0.7 * t[:, None] + np.arange(6))
    noisy = signals_of(Log(t, slow + 1e-5 * rng.standard_normal(slow.shape), None, None, 0 * slow), cutoff=15)
    clean = signals_of(Log(t, slow, None, None, 0 * slow), cutoff=15)
    model = Model(robot)
    tau = [model.torque(s.q, s.qd, s.qdd) for s in (noisy, clean)]
    seen = noisy.thinned(noisy.filtered(tau[0] - tau[1])).std(axis=0)
    np.testing.assert_allclose(encoder_torque_noise(context_of(model, noisy)), seen, rtol=0.2)
