"""What may not be claimed: anything of an arm that stands, or of logs that the model does not fit at all."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from diagnose.plain_arms import PENDULUM, logged, read
from robodyn.diagnose.judgement import STANDS, structure
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.rows import rows_of
from robodyn.gate.gate import inspect
from robodyn.report.diagnosis_headline import headline


@pytest.mark.parametrize("noise", [1e-6, 0.3])
def test_of_an_arm_that_stands_nothing_is_claimed(noise: float) -> None:
    """A torque that is 3 N m too large may be a load, a wrong mass or an offset: one number says none."""
    arm = read(PENDULUM)
    log = logged(arm)
    rng = np.random.default_rng(2)
    q, tau = (x + y * rng.standard_normal(log.q.shape) for x, y in ((0.3, noise), (14.0, 0.05)))
    still = replace(log, q=q, tau=tau)
    diagnosis = diagnose(arm, [still])
    assert diagnosis.verdict == "unexplained"
    assert diagnosis.findings == ()
    assert diagnosis.model == arm
    assert STANDS in diagnosis.words
    assert headline(diagnosis) == f"pendulum: {STANDS}."


def test_more_than_the_torque_itself_is_no_noise() -> None:
    """What is constant, or white, is not correlated: it is structure all the same where it is more than the
    joint has of torque."""
    arm = read(PENDULUM)
    rows = rows_of(arm, [inspect(logged(arm), arm)])
    torque = np.sqrt(np.mean(rows.seen("tau") ** 2))
    white = np.random.default_rng(3).standard_normal(rows.seen("tau").shape)
    for shape in (1 + 0.01 * white, white):
        assert structure(rows, 0.8 * torque * shape) == 0
        assert structure(rows, 1.2 * torque * shape) > 10
