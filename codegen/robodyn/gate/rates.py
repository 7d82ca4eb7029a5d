"""Logged rates against the slope of what they are the rates of: unit, sign, order of the columns, lag."""

from __future__ import annotations

import itertools
import math

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.gate import limits
from robodyn.gate.flag import Flag, named, refuse
from robodyn.gate.smooth import Smooth
from robodyn.robot.model import Robot


def check_rates(
    smooth: Smooth, robot: Robot, period: float, flags: list[Flag], moves: NDArray[np.bool_]
) -> tuple[bool, bool]:
    """Whether logged velocities and accelerations can be used; ``moves`` [n]: which joints do.

    Raises
    ------
    InputError: velocities in another unit, of another sign, or in other columns than the positions.
    """
    usable = [True, True]
    for k, (group, slope, logged, derived) in enumerate(
        (
            ("qd", "dq/dt", smooth.logged_qd, smooth.qd),
            ("qdd", "the second slope of q", smooth.logged_qdd, smooth.qdd),
        )
    ):
        if logged is not None and moves.any():
            a, b = logged[smooth.inside], derived[smooth.inside]
            usable[k] = _check(group, slope, a - a.mean(axis=0), b - b.mean(axis=0), robot, flags, moves)
    if usable[0] and smooth.logged_qd is not None:
        lag = _lags(smooth.logged_qd, smooth, period)
        late = [j + 1 for j in range(robot.n) if lag[j] > max(limits.LATE_SHARE * period, limits.LATE_TIME)]
        if late:
            text = f"late against dq/dt by up to {1e3 * float(np.nanmax(lag)):.3g} ms: a filter"
            flags.append(Flag("velocity_lag", named("qd", late), (), text, tuple(late)))
    return usable[0], usable[1]


def _check(
    group: str, slope: str, a: Floats, b: Floats, robot: Robot, flags: list[Flag], moves: NDArray[np.bool_]
) -> bool:
    """Whether rates ``a`` [K, n] follow the slopes ``b`` [K, n]."""
    sizes = np.sqrt((a * a).mean(axis=0)), np.sqrt((b * b).mean(axis=0))
    if not sizes[0][moves].any():
        text = f"zero throughout although joints move: {group} is taken from q instead"
        flags.append(Flag("rates_unusable", group, (), text))
        return False
    with np.errstate(invalid="ignore", divide="ignore"):
        match = (a.T @ b) / len(a) / np.outer(*sizes)
    match = np.where(np.isfinite(match), match, 0.0)
    scale = np.diag(match) * sizes[0] / np.where(sizes[1] > 0, sizes[1], 1)
    own = np.abs(np.diag(match))
    _refuse_order(group, match, moves)
    is_usable = True
    for j in np.flatnonzero(moves).tolist():
        column = f"{group}{j + 1}"
        kind = text = ""
        if own[j] > limits.SURE_CORRELATION:
            for factor, what, remedy in _known(robot.links[j].joint.kind, group, j + 1):
                if abs(scale[j] / factor - 1) < limits.RATE_SCALE:
                    refuse(
                        f"{column} does not fit q{j + 1}: {what}",
                        found=f"{column} = {scale[j]:.4g} times {slope}",
                        expected=f"{column} = {slope}",
                        remedy=remedy,
                    )
            if abs(scale[j] - 1) > limits.RATE_SCALE:
                kind, text = "rate_scale", f"{scale[j]:.3g} times {slope}"
        elif own[j] < limits.NO_CORRELATION and group == "qd":
            kind, text = "rate_mismatch", f"does not follow {slope} (correlation {match[j, j]:.2f})"
        if kind:
            is_usable = False
            flags.append(Flag(kind, column, (), text, (j + 1,)))
    return is_usable


def _known(kind: str, group: str, joint: int) -> list[tuple[float, str, str]]:
    """Factors of a rate that are known: what it is then, and the remedy."""
    degree, rate, q = math.degrees(1.0), f"{group}{joint}", f"q{joint}"
    own = [(-1.0, "its sign is flipped", f"change the sign of {rate}")]
    if kind == "revolute":
        own.append((degree, "degrees for radians in the rate", f"multiply {rate} by pi/180"))
        own.append((1 / degree, "degrees for radians in the position", f"multiply {q} by pi/180"))
    else:
        own.append((1e3, "millimetres in the rate", f"divide {rate} by 1000"))
        own.append((1e-3, "millimetres in the position, or t in milliseconds", f"write {q} in m and t in s"))
    return [*own, (1e3, "t in milliseconds", "divide t by 1000")] if group == "qd" else own


def _refuse_order(group: str, match: Floats, moves: NDArray[np.bool_]) -> None:
    """Refuse two rates that each follow the other's position."""
    for j, i in itertools.combinations(np.flatnonzero(moves).tolist(), 2):
        crossed = min(abs(match[i, j]), abs(match[j, i]))
        straight = max(abs(match[i, i]), abs(match[j, j]))
        if crossed > limits.SURE_CORRELATION and straight < 0.9 * crossed:
            refuse(
                f"columns of joints {j + 1} and {i + 1} are swapped",
                found=f"{group}{j + 1} follows the slope of q{i + 1} and {group}{i + 1} that of q{j + 1} "
                f"(correlation {crossed:.2f}, in the order of the names {straight:.2f})",
                expected=f"{group}{j + 1} to be the rate of q{j + 1}",
                remedy="set the columns right: either positions or rates are in another joint's place",
            )


def _lags(logged: Floats, smooth: Smooth, period: float) -> Floats:
    """How much later a logged velocity [K, n] is than the slope of the position [n], s; NaN: not seen."""
    rows = np.flatnonzero(smooth.inside)
    reach = max(2, round(limits.LONGEST_LAG / period))
    runs = np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1)
    longest = max(runs, key=len)[:50_000]
    result = np.full(smooth.q.shape[1], math.nan)
    if len(longest) < 4 * reach:
        return result
    first, last = int(longest[0]) + reach, int(longest[-1]) - reach
    for j in range(len(result)):
        late = logged[first:last, j]
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
