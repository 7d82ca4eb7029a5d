"""Effects that remember, and inverse dynamics of drives with them, a step at a time, in double precision over
many states; the companion of :mod:`robodyn.verify.effects`.

Drives are written from their order (:mod:`robodyn.effects.effect`) on top of :class:`.Reference` and
:class:`.Drives`: the torque behind the bearings is that of a robot whose torques are the links', the motor's
side is a drive without link.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.robot.model import EffectEntry, Robot
from robodyn.verify.declared import NoReferenceError
from robodyn.verify.effects import Drives, Reactions, Settings, place_of, settings
from robodyn.verify.numbers import Parameters, filled
from robodyn.verify.reference import Reference


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


_COUPLERS = ("joint_elasticity", "backlash")
_DAHL = "presliding_hysteresis"
_LINK_SIDE = ("link", "bearing", "rigid")


class Stepping:
    """The inverse dynamics of ``robot`` with its memory; states are in the order of the kernel's.

    Raises
    ------
    InputError: a run-time parameter has no value.
    """

    def __init__(self, robot: Robot, parameters: Parameters | None = None) -> None:
        values = filled(robot, parameters)
        self._n = robot.n
        link = tuple(e for e in robot.effects if place_of(e.effect) in _LINK_SIDE)
        motor = tuple(e for e in robot.effects if e not in link and e.effect not in (*_COUPLERS, _DAHL))
        self._links = Reference(replace(robot, torque_side="link", effects=link), values)
        self._motors = Drives(replace(robot, effects=motor), values)
        self._memories: list[tuple[EffectEntry, slice]] = []
        k = 0
        for i in range(1, robot.n + 1):
            entries = [e for e in robot.effects_at(i) if e.effect in (*_COUPLERS, _DAHL)]
            for entry in sorted(entries, key=lambda e: e.effect == _DAHL):
                count = 1 if entry.effect == _DAHL else 3
                self._memories.append((entry, slice(k, k + count)))
                k += count
        self.states = k
        self._settings = {id(entry): settings(entry, values) for entry, _ in self._memories}

    def step(self, q: Floats, qd: Floats, qdd: Floats, state: Floats, dt: float) -> tuple[Floats, Floats]:
        """Torques ``[N, n]`` [N m or N] and the states ``[N, states]`` after ``dt`` [s]."""
        link = [q.copy(), qd.copy(), qdd.copy()]
        couplers = [(e, part) for e, part in self._memories if e.effect in _COUPLERS]
        for entry, part in couplers:
            assert entry.joint is not None
            if entry.text("encoder") == "motor":
                link[0][:, entry.joint - 1] -= state[:, part.start]
        passed = self._links.inverse_dynamics(*link)
        moved, after = [q.copy(), qd.copy(), qdd.copy()], state.copy()
        for entry, part in couplers:
            assert entry.joint is not None
            i = entry.joint - 1
            stepped = twist_step(
                entry.effect, self._settings[id(entry)], passed[:, i], Twist(*state[:, part].T), dt
            )
            after[:, part] = np.stack([stepped.way, stepped.rate, stepped.acceleration], axis=1)
            if entry.text("encoder") == "link":
                for array, ahead in zip(moved, after[:, part].T, strict=True):
                    array[:, i] += ahead
        nothing = np.zeros((len(q), self._n, 3))
        tau = self._motors.torque(moved[0], moved[1], moved[2], Reactions(passed, nothing, nothing))
        for entry, part in self._memories:
            if entry.effect == _DAHL:
                assert entry.joint is not None
                i = entry.joint - 1
                z, torque = bristle_step(self._settings[id(entry)], moved[1][:, i], state[:, part.start], dt)
                after[:, part.start] = z
                tau[:, i] += torque
        return tau, after
