"""How far along a straight way one is: a number from 0 to 1 over a duration, with its two rates."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError

Floats = NDArray[np.float64]
ProfileName = Literal["quintic", "trapezoid", "constant"]
#: Share of the way [K], its rate [K] (1/s) and the rate's rate [K] (1/s^2) at times [K] (s).
Profile = Callable[[Floats], tuple[Floats, Floats, Floats]]

PROFILES: tuple[ProfileName, ...] = ("quintic", "trapezoid", "constant")
_RAMP = 0.25


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
