"""Effects that remember, step by step, in double precision over many states; the companion of
:mod:`robodyn.verify.effects`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from robodyn.verify.declared import NoReferenceError
from robodyn.verify.effects import Floats, Settings

_HALVINGS = 200


def bristle_step(p: Settings, qd: Floats, z: Floats, dt: float) -> tuple[Floats, Floats]:
    """LuGre after ``dt`` [s] at the constant velocity ``qd`` ``[N]``, from the bend ``z`` ``[N]`` [rad or m]:
    the bend and the torque [N m or N] then.

    Over the way s the bend obeys ``dz/ds = 1 - z/z_s`` against the motion, with ``z_s`` the bend of sliding.
    A sample that cannot be (``qd`` or ``dt`` infinite or no number, or ``dt`` negative) leaves the bend as it
    is; where it is the velocity, there is no torque (nan).
    """
    limit = p["level"] / p["stiffness"]
    sense = np.sign(qd)
    along = z * sense
    with np.errstate(all="ignore"):
        way = np.abs(qd) * dt
        gone = -np.expm1(-way / limit)
        after = np.where(np.isfinite(way) & (way > 0), sense * (along + (limit - along) * gone), z)
        rate = np.where(np.isfinite(qd), qd * (1 - after * sense / limit), np.nan)
    return after, np.asarray(p["stiffness"] * after + p["damping"] * rate)


def twist(effect: str, p: Settings, tau: Floats) -> Floats:
    """Motor less link [rad or m], ``[N]``, at rest under the torque ``tau`` ``[N]`` that passes."""
    stretched = tau / p["stiffness"]
    if effect == "joint_elasticity":
        return np.asarray(stretched)
    if effect != "backlash":
        raise NoReferenceError(f"there is no reference for {effect}, a joint that twists")
    size = np.abs(tau)
    return np.asarray(stretched + np.sign(tau) * p["gap"] / 2 * size / (size + p["transition"]))


def twist_torque(effect: str, p: Settings, way: Floats, rate: Floats) -> Floats:
    """Torque ``[N]`` [N m or N] of the twist ``way`` and its ``rate`` ``[N]``: the inverse of :func:`twist`,
    by bisection, and damping."""
    low, high = np.zeros_like(way), p["stiffness"] * np.abs(way)
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        less = twist(effect, p, middle) < np.abs(way)
        low, high = np.where(less, middle, low), np.where(less, high, middle)
    return np.asarray(np.sign(way) * high + p["damping"] * rate)


@dataclass(frozen=True, slots=True)
class Twist:
    """How far motors are ahead of links, ``[N]`` [rad or m], and the first and second rates of that."""

    way: Any
    rate: Any
    acceleration: Any


def twist_step(effect: str, p: Settings, tau: Floats, before: Twist, dt: float) -> Twist:
    """The twist ``dt`` [s] later under the torque ``tau`` ``[N]``, its rates as differences; at rest if
    ``dt`` is 0; as before where ``tau`` or ``dt`` is infinite or no number, or ``dt`` negative."""
    if not 0 <= dt < np.inf:
        return before
    with np.errstate(all="ignore"):
        state = _twist_step(effect, p, tau, before, dt)
        parts = [(getattr(state, x), getattr(before, x)) for x in ("way", "rate", "acceleration")]
        good = np.isfinite(sum(np.abs(new) for new, _ in parts))
        return Twist(*(np.where(good, new, old) for new, old in parts))


def _twist_step(effect: str, p: Settings, tau: Floats, before: Twist, dt: float) -> Twist:
    rest = twist(effect, p, tau)
    if dt == 0:
        return Twist(rest, np.zeros_like(rest), np.zeros_like(rest))
    slope = np.full_like(tau, 1 / p["stiffness"])  # of the twist over the torque
    if effect == "backlash":
        slope = slope + p["gap"] * p["transition"] / 2 / (np.abs(tau) + p["transition"]) ** 2
    kept = np.exp(-dt / (p["damping"] * slope)) if p["damping"] else 0.0
    way = kept * before.way + (1 - kept) * rest
    rate = (way - before.way) / dt
    return Twist(way, rate, (rate - before.rate) / dt)
