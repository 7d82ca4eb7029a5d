"""What is hidden by another engine is named, nothing is named where nothing is, and the gap closes."""

from __future__ import annotations

import pytest

from diagnose.hidden.cases import Case
from diagnose.hidden.logs import effect, hidden_log
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.selection import select
from robodyn.robot.model import EffectEntry
from robodyn_testing import sampled

#: Arm, effect, joint, seed, gap over noise.
CLEAR = (
    ("puma560_3dof", "viscous_friction", 2, 1, 3.7),
    ("puma560_3dof", "stribeck_friction", 1, 1, 4.8),
    ("puma560_3dof", "base_tilt", None, 1, 7.6),
    ("puma560_3dof", "torque_saturation", 2, 1, 5.1),
)


@pytest.mark.parametrize(("arm_name", "effect", "joint", "seed", "ratio"), sampled(CLEAR, every=4))
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
