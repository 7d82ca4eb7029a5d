"""Motions from joint position to joint position: quintic, trapezoid, and through points."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robodyn.errors import InputError
from robodyn.simulate.trajectories.profiles import Profile, quintic_profile, trapezoid_profile
from robodyn.simulate.trajectories.spline import hermite, least_jerk
from robodyn.simulate.trajectories.trajectory import PERIOD, Trajectory, joint_vector, sample_times

Floats = NDArray[np.float64]

_NO_WAY = 1e-100  # [rad or m]: a joint that goes less far sets no pace


def quintic(start: ArrayLike, end: ArrayLike, duration: float, *, period: float = PERIOD) -> Trajectory:
    """From ``start`` to ``end`` [n] (rad or m) in ``duration`` [s], at rest at both ends.

    Acceleration begins and ends at 0. The highest speed is 1.875 times the mean one, the highest acceleration
    5.7735 (10 / sqrt 3) times the distance over the duration squared. Sampled every ``period`` [s].

    Raises
    ------
    InputError: numbers that are not finite, lists of different lengths, a duration that is not positive.
    """
    ends = _ends(start, end)
    t = sample_times(duration, period, beyond=True)
    provenance = {**_named("quintic", ends), "time": float(duration)}
    return _straight(ends, partial(quintic_profile, float(duration)), t, provenance)


def trapezoid(
    start: ArrayLike, end: ArrayLike, velocity: ArrayLike, acceleration: ArrayLike, *, period: float = PERIOD
) -> Trajectory:
    """From ``start`` to ``end`` [n] (rad or m), as fast as ``velocity`` and ``acceleration`` allow.

    All joints speed up, go on and slow down together, on a straight line of joint positions; the slowest
    of them sets the pace. Where the way is too short for the full speed there is no constant part. The limits
    are one number for all joints or one each [n] (rad/s or m/s; per second squared).

    Raises
    ------
    InputError: no joint moves, a limit is not positive, or lists of different lengths.
    """
    ends = _ends(start, end)
    n = len(ends[0])
    way = np.abs(ends[1] - ends[0])
    if way.max() < _NO_WAY:
        raise InputError("the motion has no length", found="the end is the start", expected="two positions")
    fastest = _limit("velocity", velocity, n)
    hardest = _limit("acceleration", acceleration, n)
    moved = way > _NO_WAY
    speed = float((fastest[moved] / way[moved]).min())
    rate = float((hardest[moved] / way[moved]).min())
    ramp = min(speed / rate, 1 / np.sqrt(rate))
    duration = ramp + 1 / (rate * ramp)
    t = sample_times(duration, period, beyond=True)
    provenance = {
        **_named("trapezoid", ends),
        "velocity": fastest.tolist(),
        "acceleration": hardest.tolist(),
        "time": float(duration),
    }
    return _straight(ends, partial(trapezoid_profile, float(ramp), float(duration)), t, provenance)


def via(points: ArrayLike, times: ArrayLike, *, period: float = PERIOD) -> Trajectory:
    """Through ``points`` [m, n] (rad or m) at ``times`` [m] (s, the first 0), at rest at both ends.

    Pieces of degree five with four continuous derivatives: of all such motions the one of least jerk.

    Raises
    ------
    InputError: fewer than two points, times that do not rise from 0, or numbers that are not finite.
    """
    x = np.asarray(points, dtype=np.float64)
    knots = np.asarray(times, dtype=np.float64)
    if x.ndim != 2 or len(x) < 2 or x.shape[1] < 1 or not np.isfinite(x).all():
        raise InputError(
            "these are no points to go through",
            found=f"shape {list(x.shape)}",
            expected="[m, n], m at least 2, finite",
        )
    if (
        knots.shape != (len(x),)
        or knots[0] != 0
        or not (np.diff(knots) > 0).all()
        or not np.isfinite(knots).all()
    ):
        raise InputError(
            "times of the points do not rise from 0",
            found=str(knots.tolist()),
            expected=f"[{len(x)}] in s, 0 first",
        )
    still = np.zeros((2, x.shape[1]))
    v, a = least_jerk(knots, x, still, still)
    t = sample_times(float(knots[-1]), period, beyond=True)
    law = partial(_stopped, partial(hermite, knots, x, v, a), float(knots[-1]))
    provenance = {"kind": "via", "points": x.tolist(), "times": knots.tolist()}
    return Trajectory(t, *law(t), provenance, law)


def _stopped(
    law: Callable[[Floats], tuple[Floats, Floats, Floats]], end: float, t: Floats
) -> tuple[Floats, Floats, Floats]:
    """``law`` up to ``end``, and standing there afterwards."""
    q, qd, qdd = law(np.minimum(t, end))
    after = (t >= end)[:, None]
    return q, np.where(after, 0.0, qd), np.where(after, 0.0, qdd)


def _along(ends: tuple[Floats, Floats], profile: Profile, t: Floats) -> tuple[Floats, Floats, Floats]:
    start, end = ends
    s, rate, rate_rate = (x[:, None] for x in profile(t))
    way = end - start
    q = np.where(s < 0.5, start + s * way, end - (1 - s) * way)  # exactly the start and the end
    return q, rate * way, rate_rate * way


def _straight(
    ends: tuple[Floats, Floats], profile: Profile, t: Floats, provenance: dict[str, Any]
) -> Trajectory:
    law = partial(_along, ends, profile)
    return Trajectory(t, *law(t), provenance, law)


def _ends(start: ArrayLike, end: ArrayLike) -> tuple[Floats, Floats]:
    first = joint_vector("the start", start)
    return first, joint_vector("the end", end, len(first))


def _named(kind: str, ends: tuple[Floats, Floats]) -> dict[str, Any]:
    return {"kind": kind, "start": ends[0].tolist(), "end": ends[1].tolist()}


def _limit(what: str, value: ArrayLike, n: int) -> Floats:
    """``value`` of every joint [n], positive."""
    array = np.asarray(value, dtype=np.float64)
    limits = np.full(n, float(array)) if array.ndim == 0 else joint_vector(what, array, n)
    if not (limits > 0).all() or not np.isfinite(limits).all():
        raise InputError(f"{what} must be positive", found=str(limits.tolist()), expected="positive numbers")
    return limits
