"""The motion that a page plays: a sum of sines within the limits, and its torques."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from robodyn.report.arm_kernel import ArmKernel, Floats
from robodyn.robot.model import Robot
from robodyn.simulate.limits import with_limits

#: [Hz], harmonics, and the share of the limits that is used: one period takes eight seconds.
_FREQUENCY, _HARMONICS, _SHARE, _SEED = 0.125, 3, 0.6, 1
#: Samples of a period that are drawn.
SAMPLES: Final = 240


def motion(robot: Robot, kernel: ArmKernel) -> dict[str, Any]:
    """One period of the motion, as coefficients (position is ``mean + sines sin(k w t) + cosines cos(k w t)``
    [rad or m], a list a joint), and the torques [N m or N] at ``times`` [s]."""
    from robodyn.simulate.trajectories.fourier import fourier

    limited, assumed = with_limits(robot)
    period = 1 / _FREQUENCY
    path = fourier(limited, _FREQUENCY, _HARMONICS, _SEED, share=_SHARE, period=period / SAMPLES)
    arrays = {"q": path.q, "qd": path.qd, "qdd": path.qdd}
    torques = kernel.rows("inverse_dynamics", arrays, period / SAMPLES)["tau"]
    holding = kernel.rows("gravity", arrays)["tau"]
    return {
        "period": period,
        "step": period / SAMPLES,
        "mean": path.provenance["mean"],
        "sines": path.provenance["sines"],
        "cosines": path.provenance["cosines"],
        "assumed_limits": list(assumed),
        "times": path.t.tolist(),
        "position": _columns(path.q),
        "torque": _columns(torques),
        "gravity": _columns(holding),
    }


def _columns(values: Floats) -> list[list[float]]:
    """Of an array [K, n] a list for each joint, to six digits."""
    return [[float(f"{x:.6g}") for x in column] for column in np.asarray(values).T]
