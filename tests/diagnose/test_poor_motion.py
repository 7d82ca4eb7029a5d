"""Too little motion: rivals are declared, noise of the encoders gets no name, and what to record is told."""

from __future__ import annotations

import numpy as np
import pytest

from diagnose.hidden.cases import Case
from robodyn.diagnose.result import Diagnosis
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.library import context_of
from robodyn.diagnose.select.selection import encoder_torque_noise, select
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.signals import signals_of
from robodyn.robot import load


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


@pytest.mark.thorough
def test_noise_of_the_encoders_is_no_elastic_joint() -> None:
    found = diagnosed(Case("puma560_3dof", (("viscous_friction", 2),), 2, 3.485, motion="narrow"))
    assert {(f.effect, f.joint) for f in found.findings} == {("viscous_friction", 2)}


@pytest.mark.thorough
def test_a_joint_that_sets_out_is_not_touched() -> None:
    found = diagnosed(Case("puma560_3dof", (("coulomb_friction", 3),), 1, 6.0, motion="one_way"))
    assert "external_contact" not in {f.effect for f in found.findings}


@pytest.mark.thorough
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
