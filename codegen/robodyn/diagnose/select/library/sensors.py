"""What sensors and limits of a drive make of the torque."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.library.candidate import Candidate, Context, single
from robodyn.diagnose.select.twist import slopes_of

Floats = NDArray[np.float64]

#: Limits of a drive as shares of the largest torque, and the share of samples that pile up at a sensor's.
_LIMITS = (0.5, 0.65, 0.8, 0.9, 0.96)
_PILED = 0.003
#: A drive that is at its limit for more of a log than this leaves nothing to compare.
_CLIPPED = 0.3
#: What a limit must explain of the squares where it clips.
_RIGHT = 0.4


def sensor(c: Context, j: int) -> Iterator[Candidate]:
    """What the torque channel and the encoder of a joint may show wrong."""
    one = np.ones_like(c.signals.t)
    total = c.at.total[:, j]
    yield single("torque_bias", j, [one], (0,), lambda x: {"bias": float(x[0])}, 1)
    yield single("torque_gain", j, [total], (0,), lambda x: {"gain": float(x[0])}, 2)
    late = -np.gradient(c.signals.filtered(total), c.signals.period)
    yield single("time_delay", j, [late], (1,), lambda x: {"delay": float(x[0])}, 3)
    column = -slopes_of(c.model, c.slow.q, c.slow.qd, c.slow.qdd, c.plain, j).place
    yield Candidate(
        "encoder_offset", j + 1, tuple(range(c.n)), column[:, :, None], (0,),
        lambda x: {"offset": float(x[0])}, 3, coarse=True, feasible=lambda x: bool(abs(x[0]) < 0.25),
    )  # fmt: skip


def saturation(c: Context, j: int) -> Iterator[Candidate]:
    """Beyond a limit the drive gives no more than that, and the log has the command; or the log stops
    there."""
    tau = c.signals.tau[:, j]
    for share in _LIMITS:
        yield clipped(c, j, {"limit": share * float(np.abs(tau).max())})
    top, total = float(np.abs(tau).max()), c.at.total[:, j]
    if np.mean(np.abs(tau) > (1 - 1e-9) * top) > _PILED:
        beyond = -np.sign(total) * np.maximum(np.abs(total) - top, 0.0)
        yield single(
            "torque_saturation", j, [beyond], (1,), lambda x: {"limit": top, "clips": "sensor"}, 2,
            fixed=True, local=True, feasible=_about_one,
        )  # fmt: skip


def clipped(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    """A drive's limit: what the commands have beyond it."""
    tau, limit = c.signals.tau[:, j], given["limit"]
    beyond = np.sign(tau) * np.maximum(np.abs(tau) - limit, 0.0)
    # It must be right where it clips: cutting peaks off makes every torque smaller.
    at = beyond != 0
    rest = (tau - c.at.total[:, j])[at]
    right = np.sum((rest - beyond[at]) ** 2) < (1 - _RIGHT) * np.sum(rest**2)
    if np.mean(at) > _CLIPPED or not right:
        beyond = np.zeros_like(tau)
    return single(
        "torque_saturation", j, [beyond], (1,), lambda x: {"limit": limit, "clips": "drive"}, 2,
        fixed=True, local=True, given=given, feasible=_about_one,
    )  # fmt: skip


def _about_one(x: Floats) -> bool:
    return bool(0.7 < x[0] < 1.3)
