"""Several effects at once, and what nothing of the library explains."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from diagnose.hidden.cases import Case
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.selection import select
from robodyn.logs.log import Log, read_log
from robodyn.logs.signals import smoothed_motion
from robodyn.robot import load
from robodyn_testing import representative, sampled

TX40 = Path(__file__).parents[2] / "examples" / "tx40"

PAIRS = (
    ((("time_delay", None), ("coulomb_friction", 2)), 5.783),
    ((("viscous_friction", 1), ("payload", None)), 4.787),
    ((("spring", 1), ("torque_ripple", 2)), 4.284),
)


@pytest.mark.parametrize(("hidden", "ratio"), sampled(PAIRS, every=3), ids=lambda x: str(x))
@pytest.mark.thorough
def test_two_effects_are_both_named(hidden: tuple[tuple[str, int | None], ...], ratio: float) -> None:
    made = Case("puma560_3dof", hidden, 1, ratio).make()
    found = diagnose(made.given, [made.train], made.validate)
    assert {(f.effect, f.joint) for f in found.findings if f.confidence >= 0.5} == set(hidden)
    assert np.all(found.gap.validate_after < 1.3 * made.truth.noise)


@pytest.mark.parametrize(
    "effect", representative(["random_offset", "acceleration_friction"], "random_offset")
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


@pytest.mark.thorough
def test_pieces_of_a_log_count() -> None:
    made = Case("puma560_3dof", (("viscous_friction", 2),), 1, 5.0).make()
    log = made.train
    kept = (log.t // 0.45).astype(int) % 3 != 2
    pieces = Log(log.t[kept], log.q[kept], None, None, log.tau[kept])
    found = diagnose(made.given, [pieces], made.validate)
    assert [(f.effect, f.joint) for f in found.findings if f.confidence >= 0.5] == [("viscous_friction", 2)]
