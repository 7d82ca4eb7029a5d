"""A log beside a robot's description: joints, limits, and signs by the torque of gravity."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.logs.limits import BEYOND, GAIN_MATCH, LARGE_GAIN, SIGN_MATCH, SMALL_GAIN, TELLING
from robodyn.logs.log import Log
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]

#: Rows at which gravity is evaluated.
STATES = 4000


@dataclass(frozen=True, slots=True)
class JointCheck:
    """A ``joint`` (from 1): its range [rad or m] beside the limits; how its torque goes with gravity's:
    ``correlation``, and ``gain``, how many times gravity's torque is in it; NaN where gravity's hardly
    changes, and ``low`` and ``high`` where no position is a number. ``remarks``: what that means."""

    joint: int
    low: float
    high: float
    limits: tuple[float, float] | None
    correlation: float
    gain: float
    remarks: tuple[str, ...]


def check_joints(log: Log, robot: Robot) -> tuple[JointCheck, ...]:
    """Each joint of ``log`` beside the ``robot``, which has as many."""
    rows = np.unique(np.linspace(0, log.samples - 1, min(STATES, log.samples)).astype(int))
    q, tau = log.q[rows], log.tau[rows]
    sound = np.isfinite(q).all(axis=1) & np.isfinite(tau).all(axis=1)
    q, tau = q[sound], tau[sound]
    gravity = np.zeros_like(q)
    if len(q) and not robot.parameters:
        zero = np.zeros_like(q)
        from robodyn.kernels.array_dynamics import Model
        from robodyn.robot.masses import massless

        gravity = Model(massless(robot)).torque(q, zero, zero)
    largest = float(np.ptp(gravity, axis=0).max(initial=0.0)) if len(q) else 0.0
    checks = []
    for j, link in enumerate(robot.links):
        pair = link.joint.limits.position
        limits = None if pair is None else (float(pair[0]), float(pair[1]))
        x = log.q[:, j][np.isfinite(log.q[:, j])]
        low, high = (float(x.min()), float(x.max())) if len(x) else (np.nan, np.nan)
        correlation, gain = _match(gravity[:, j], tau[:, j], largest)
        remarks = _remarks(low, high, limits, correlation, gain)
        checks.append(JointCheck(j + 1, low, high, limits, correlation, gain, remarks))
    return tuple(checks)


def flipped(checks: tuple[JointCheck, ...]) -> tuple[int, ...]:
    """The joints (from 1) whose torques have the other sign: all of them, where all do of which gravity says
    something, and these are several."""
    telling = [check for check in checks if abs(check.correlation) > SIGN_MATCH]
    turned = [check for check in telling if check.correlation < 0]
    if len(turned) == len(telling) > 1:
        return tuple(check.joint for check in checks)
    return tuple(check.joint for check in turned)


def _match(gravity: Floats, tau: Floats, largest: float) -> tuple[float, float]:
    """Correlation of a torque with gravity's, and the gain between them."""
    if len(gravity) < 10 or np.ptp(gravity) <= TELLING * largest or np.ptp(gravity) == 0:
        return float("nan"), float("nan")
    g, x = gravity - gravity.mean(), tau - tau.mean()
    power, other = float(g @ g), float(x @ x)
    if not other > 0:
        return float("nan"), float("nan")
    return float(g @ x) / (power * other) ** 0.5, float(g @ x) / power


def _remarks(
    low: float, high: float, limits: tuple[float, float] | None, correlation: float, gain: float
) -> tuple[str, ...]:
    remarks = []
    if limits is not None:
        room = BEYOND * (limits[1] - limits[0])
        if low < limits[0] - room or high > limits[1] + room:
            remarks.append("positions beyond the joint's limits: another unit, zero or joint?")
    if correlation < -SIGN_MATCH:
        remarks.append("the torque goes against gravity's: turn the sign of tau or of q")
    if abs(correlation) > GAIN_MATCH and gain < SMALL_GAIN:
        remarks.append("far smaller than gravity's: of the motor, in front of its gear? write gear")
    if abs(correlation) > GAIN_MATCH and gain > LARGE_GAIN:
        remarks.append("far larger than gravity's: another unit, such as mN m?")
    return tuple(remarks)
