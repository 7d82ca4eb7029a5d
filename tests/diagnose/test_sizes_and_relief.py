"""What is known of the size of an effect, and when the arm's own numbers alone speak for one."""

from __future__ import annotations

import numpy as np
import pytest

from identify.exact import log_of
from robodyn.diagnose.select.forward import _is_vague
from robodyn.diagnose.select.library import candidates, context_of
from robodyn.diagnose.select.library.candidate import single
from robodyn.diagnose.select.scope import Scope
from robodyn.diagnose.select.trial import _relieved
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.signals import signals_of
from robodyn.robot import load


@pytest.mark.parametrize(
    ("efficiency", "breakaway", "errors", "is_vague"),
    [
        (0.9, 0.0, (0.005, 0.03), False),  # a loss by load, and no more than that
        (0.9, 0.5, (0.2, 0.03), False),
        (0.9, 0.01, (0.2, 0.03), True),
        (0.99, 0.0, (0.004, 0.03), False),
        (0.99, 0.0, (0.008, 0.03), True),
    ],
)
def test_a_loss_is_known_where_one_of_its_sizes_is(
    efficiency: float, breakaway: float, errors: tuple[float, float], is_vague: bool
) -> None:
    """An efficiency of 1 is none: it is known by how far it is from there."""
    candidate = single(
        "transmission_loss", 0, [np.ones(4)] * 2, (1, 1),
        lambda x: {"efficiency": float(x[0]), "breakaway": float(x[1])}, 1,
    )  # fmt: skip
    x = np.array([efficiency, breakaway])
    assert _is_vague(candidate, x, np.diag(np.square(errors))) == is_vague


def test_what_gains_more_is_judged_no_more_strictly() -> None:
    gains = np.array([50.0, 60.0, 60.0, 30.0, 1000.0])
    relief = np.array([26.0, 26.0, 20.0, 10.0, 26.0])
    assert _relieved(gains, relief).tolist() == [True, True, False, False, True]
    assert _relieved(gains[1:], relief[1:]).tolist() == [False] * 4  # none is by itself


def test_no_gear_has_ten_degrees_of_play() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    context = context_of(Model(robot), signals_of(log_of(robot, noise=0.01, seconds=1.0)))
    one = next(c for c in candidates(context, Scope(frozenset({"backlash"}))) if "stiffness" in c.values)
    assert one.again is not None
    likely = {gap: one.again(context, {**one.values, "gap": gap}) for gap in (0.004, 0.17)}
    assert [each.likely(np.ones(1)) for each in likely.values()] == [True, False]
