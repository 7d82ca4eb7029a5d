"""Logged rates against the slope of what they are the rates of: unit, sign, order of the columns, lag."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from robodyn.gate.flag import Flag, Floats, named, refuse
from robodyn.gate.limits import (
    KNOWN_RATE_SCALE,
    LATE_SHARE,
    LATE_TIME,
    LONGEST_LAG,
    NO_CORRELATION,
    RATE_SCALE,
    SURE_CORRELATION,
)
from robodyn.gate.smooth import Smooth
from robodyn.robot.model import Robot


def check_rates(
    smooth: Smooth, robot: Robot, period: float, source: str | None, flags: list[Flag], noise: Floats
) -> tuple[bool, bool, Floats]:
    """Whether logged velocities and accelerations can be used, and the lag [n] of the velocities (s; NaN
    where none is to be seen). ``noise`` [n] is that of the positions.

    Raises
    ------
    InputError: velocities in another unit, of another sign, or in other columns than the positions.
    """
    lag = np.full(robot.n, math.nan)
    rates = smooth.logged_qd is not None
    if smooth.logged_qd is not None:
        rates = _check("qd", "dq/dt", smooth.logged_qd, smooth.qd, smooth, robot, source, flags, noise)
        if rates:
            lag = _lags(smooth, period)
            late = [j + 1 for j in range(robot.n) if lag[j] > max(LATE_SHARE * period, LATE_TIME)]
            if late:
                worst = float(np.nanmax(lag))
                text = f"late against dq/dt by up to {1e3 * worst:.3g} ms: a filter"
                flags.append(Flag("velocity_lag", named("qd", late), (), text, tuple(late)))
    accelerations = smooth.logged_qdd is not None
    if smooth.logged_qdd is not None:
        accelerations = _check(
            "qdd", "the second slope of q", smooth.logged_qdd, smooth.qdd, smooth, robot, source, flags, noise
        )
    return rates, accelerations, lag


def _check(
    group: str,
    slope: str,
    logged: Floats,
    derived: Floats,
    smooth: Smooth,
    robot: Robot,
    source: str | None,
    flags: list[Flag],
    noise: Floats,
) -> bool:
    if not smooth.inside.any():
        return True
    a, b = logged[smooth.inside], derived[smooth.inside]
    a, b = a - a.mean(axis=0), b - b.mean(axis=0)
    reach = np.ptp(smooth.q[smooth.inside], axis=0)
    moving = reach > np.maximum(30 * noise, 1e-3)
    sizes = np.sqrt((a * a).mean(axis=0)), np.sqrt((b * b).mean(axis=0))
    if not moving.any():
        return True
    if not sizes[0][moving].any():
        text = f"zero throughout although joints move: {group} is taken from q instead"
        flags.append(Flag("rates_unusable", group, (), text))
        return False
    with np.errstate(invalid="ignore", divide="ignore"):
        match = (a.T @ b) / len(a) / np.outer(*sizes)
    match = np.where(np.isfinite(match), match, 0.0)
    scale = np.diag(match) * sizes[0] / np.where(sizes[1] > 0, sizes[1], 1)
    own = np.abs(np.diag(match))
    _swapped(group, match, moving, source)
    known = _known(robot, group)
    unlike = []
    for j in np.flatnonzero(moving).tolist():
        column = f"{group}{j + 1}"
        if own[j] > SURE_CORRELATION:
            for factor, what, remedy in known[j]:
                if abs(scale[j] / factor - 1) < KNOWN_RATE_SCALE:
                    refuse(
                        source,
                        f"{column} does not fit q{j + 1}: {what}",
                        found=f"{column} = {scale[j]:.4g} times {slope}",
                        expected=f"{column} = {slope}",
                        remedy=remedy.format(group=group, j=j + 1),
                    )
            if abs(scale[j] - 1) > RATE_SCALE:
                text = f"{scale[j]:.3g} times {slope}"
                flags.append(Flag("rate_scale", column, (), text, (j + 1,)))
                unlike.append(j + 1)
        elif own[j] < NO_CORRELATION and group == "qd":
            unlike.append(j + 1)
            text = f"does not follow {slope} (correlation {match[j, j]:.2f})"
            flags.append(Flag("rate_mismatch", column, (), text, (j + 1,)))
    return not unlike


def _known(robot: Robot, group: str) -> list[list[tuple[float, str, str]]]:
    degree = math.degrees(1.0)
    rates: list[list[tuple[float, str, str]]] = []
    for link in robot.links:
        own: list[tuple[float, str, str]] = [(-1.0, "its sign is flipped", "change the sign of {group}{j}")]
        if link.joint.kind == "revolute":
            own += [
                (degree, "degrees for radians in the rate", "multiply {group}{j} by pi/180"),
                (1 / degree, "degrees for radians in the position", "multiply q{j} by pi/180"),
            ]
        else:
            own += [
                (1e3, "millimetres in the rate", "divide {group}{j} by 1000"),
                (1e-3, "millimetres in the position, or t in milliseconds", "write q{j} in m and t in s"),
            ]
        if group == "qd":
            own.append((1e3, "t in milliseconds", "divide t by 1000"))
        rates.append(own)
    return rates


def _swapped(group: str, match: Floats, moving: Any, source: str | None) -> None:
    """Refuse two rates that each follow the other's position."""
    n = len(match)
    for i in range(n):
        for j in range(i):
            crossed = min(abs(match[i, j]), abs(match[j, i]))
            straight = max(abs(match[i, i]), abs(match[j, j]))
            if moving[i] and moving[j] and crossed > SURE_CORRELATION and straight < 0.9 * crossed:
                refuse(
                    source,
                    f"columns of joints {j + 1} and {i + 1} are swapped",
                    found=f"{group}{j + 1} follows the slope of q{i + 1} and {group}{i + 1} that of q{j + 1} "
                    f"(correlation {crossed:.2f}, in the order of the names {straight:.2f})",
                    expected=f"{group}{j + 1} to be the rate of q{j + 1}",
                    remedy="set the columns right: either positions or rates are in another joint's place",
                )


def _lags(smooth: Smooth, period: float) -> Floats:
    """How much later the logged velocity is than the slope of the position [n], s."""
    assert smooth.logged_qd is not None
    rows = np.flatnonzero(smooth.inside)
    reach = max(2, round(LONGEST_LAG / period))
    runs = np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1)
    longest = max(runs, key=len)[:50_000]
    result = np.full(smooth.q.shape[1], math.nan)
    if len(longest) < 4 * reach:
        return result
    first, last = int(longest[0]) + reach, int(longest[-1]) - reach
    for j in range(len(result)):
        late = smooth.logged_qd[first:last, j]
        if not late.any():
            continue
        # The least difference rather than the largest product: right where the window's ends differ too.
        shifts = range(-2, reach + 1)
        error = np.array([((late - smooth.qd[first - k : last - k, j]) ** 2).mean() for k in shifts])
        k = int(error.argmin())
        if 0 < k < len(error) - 1 and error[k] < 0.1 * (late * late).mean():
            bend = error[k - 1] - 2 * error[k] + error[k + 1]
            result[j] = (shifts[k] + (0.5 * (error[k - 1] - error[k + 1]) / bend if bend > 0 else 0)) * period
    return result


def moving_joints(smooth: Smooth, noise: Floats) -> Sequence[int]:
    """Joints (from 0) that move visibly."""
    reach = np.ptp(smooth.q[smooth.inside], axis=0) if smooth.inside.any() else np.zeros(len(noise))
    return [int(j) for j in np.flatnonzero(reach > np.maximum(30 * noise, 1e-3))]
