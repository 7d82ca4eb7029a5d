"""Motions from joint position to joint position: quintic and trapezoid."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.simulate.trajectories.trajectory import PERIOD, Trajectory, joint_vector, sample_times

ProfileName = Literal["quintic", "trapezoid", "constant"]
#: Share of the way [K], its rate [K] (1/s) and the rate's rate [K] (1/s^2) at times [K] (s).
Profile = Callable[[Floats], tuple[Floats, Floats, Floats]]

PROFILES: tuple[ProfileName, ...] = ("quintic", "trapezoid", "constant")
_RAMP = 0.25

_NO_WAY = 1e-100  # [rad or m]: a joint that goes less far sets no pace


def quintic(start: ArrayLike, end: ArrayLike, duration: float, *, period: float = PERIOD) -> Trajectory:
    """From ``start`` to ``end`` [n] (rad or m) in ``duration`` [s], at rest at both ends.

    Acceleration begins and ends at 0. The highest speed is 1.875 times the mean one, the highest acceleration
    5.7735 (10 / sqrt 3) times the distance over the duration squared. Sampled every ``period`` [s].

    Raises
    ------
    InputError: numbers that are not finite, lists of different lengths, a duration that is not positive.
    """
    time = float(duration)
    return _straight("quintic", start, end, partial(quintic_profile, time), period, {"time": time})


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
    way = np.abs(np.subtract(*_ends(start, end)))
    n = len(way)
    if way.max() < _NO_WAY:
        raise InputError("the motion has no length", found="the end is the start", expected="two positions")
    fastest = _limit("velocity", velocity, n)
    hardest = _limit("acceleration", acceleration, n)
    moved = way > _NO_WAY
    speed = float((fastest[moved] / way[moved]).min())
    rate = float((hardest[moved] / way[moved]).min())
    ramp = min(speed / rate, 1 / np.sqrt(rate))
    duration = float(ramp + 1 / (rate * ramp))
    limits = {"velocity": fastest.tolist(), "acceleration": hardest.tolist(), "time": duration}
    return _straight(
        "trapezoid", start, end, partial(trapezoid_profile, float(ramp), duration), period, limits
    )


def _straight(
    kind: str, start: ArrayLike, end: ArrayLike, profile: Profile, period: float, more: dict[str, Any]
) -> Trajectory:
    """The motion from ``start`` to ``end`` by a ``profile``; what ``more`` there is to say of it."""
    first, last = _ends(start, end)
    law = partial(_along, first, last, profile)
    t = sample_times(more["time"], period, beyond=True)
    provenance = {"kind": kind, "start": first.tolist(), "end": last.tolist(), **more}
    return Trajectory(t, *law(t), provenance, law)


def _along(start: Floats, end: Floats, profile: Profile, t: Floats) -> tuple[Floats, Floats, Floats]:
    s, rate, rate_rate = (x[:, None] for x in profile(t))
    way = end - start
    q = np.where(s < 0.5, start + s * way, end - (1 - s) * way)  # exactly the start and the end
    return q, rate * way, rate_rate * way


def _ends(start: ArrayLike, end: ArrayLike) -> tuple[Floats, Floats]:
    first = joint_vector("the start", start)
    return first, joint_vector("the end", end, len(first))


def _limit(what: str, value: ArrayLike, n: int) -> Floats:
    """``value`` of every joint [n], positive."""
    array = np.asarray(value, dtype=np.float64)
    limits = np.full(n, float(array)) if array.ndim == 0 else joint_vector(what, array, n)
    if not (limits > 0).all() or not np.isfinite(limits).all():
        raise InputError(f"{what} must be positive", found=str(limits.tolist()), expected="positive numbers")
    return limits


# --- profiles: how far along a straight way one is, from 0 to 1, with its two rates -----------------------


def quintic_profile(duration: float, t: Floats) -> tuple[Floats, Floats, Floats]:
    """``10 s^3 - 15 s^4 + 6 s^5`` of ``s = t / duration``: at rest, without acceleration, at both ends."""
    s = np.clip(t / duration, 0.0, 1.0)
    way = s**3 * (10 + s * (-15 + s * 6))
    return way, 30 * s**2 * (1 - s) ** 2 / duration, 60 * s * (1 - s) * (1 - 2 * s) / duration**2


def trapezoid_profile(ramp: float, duration: float, t: Floats) -> tuple[Floats, Floats, Floats]:
    """Constant acceleration for ``ramp`` [s], constant speed, deceleration for ``ramp``; ``ramp`` is
    at most half the duration."""
    speed = 1 / (duration - ramp)
    rate = speed / ramp
    t = np.clip(t, 0.0, duration)
    left = duration - t
    way = np.where(
        t < ramp,
        rate * t**2 / 2,
        np.where(left <= ramp, 1 - rate * left**2 / 2, speed * (t - ramp / 2)),
    )
    velocity = np.minimum(np.minimum(rate * t, rate * left), speed)
    acceleration = np.where(t < ramp, rate, np.where((left <= ramp) & (left > 0), -rate, 0.0))
    return way, velocity, acceleration


def constant_profile(duration: float, t: Floats) -> tuple[Floats, Floats, Floats]:
    """Constant speed from the first moment to the last."""
    return t / duration, np.full_like(t, 1 / duration), np.zeros_like(t)


def profile_of(name: str, duration: float) -> Profile:
    """The profile ``name`` over ``duration`` [s]; the trapezoid speeds up for a quarter of it.

    Raises
    ------
    InputError: there is no such profile.
    """
    if name == "quintic":
        return lambda t: quintic_profile(duration, t)
    if name == "trapezoid":
        return lambda t: trapezoid_profile(_RAMP * duration, duration, t)
    if name == "constant":
        return lambda t: constant_profile(duration, t)
    raise InputError("there is no such profile", found=repr(name), expected=" or ".join(PROFILES))
