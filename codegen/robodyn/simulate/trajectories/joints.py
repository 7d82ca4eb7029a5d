"""Motions from joint position to joint position: quintic and trapezoid."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robodyn.errors import InputError
from robodyn.simulate.trajectories.profiles import Profile, quintic_profile, trapezoid_profile
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
