"""Effects that remember: torques along a motion, in the limit of short steps, and the equations of docs/.

How a kernel steps from one sample to the next is its own affair; that halving the step halves its distance
from the equations' solution is not. What Richardson's extrapolation leaves of three runs is compared.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Final

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp

from independent import drives
from independent.reference import Array, Reference

TIME: Final = 0.4
STEPS: Final = (250, 500, 1000)


class Motion:
    """Sines, with reversals."""

    def __init__(self, n: int) -> None:
        rng = np.random.default_rng(n)
        self.middle, self.size = rng.uniform(-1, 1, n), rng.uniform(0.1, 0.3, n)
        self.rate, self.phase = rng.uniform(8, 14, n), rng.uniform(0, 6, n)

    def at(self, t: float, order: int) -> Array:
        """The position, or a derivative of it."""
        middle = self.middle if order == 0 else 0.0
        return middle + self.size * self.rate**order * np.sin(self.rate * t + self.phase + order * np.pi / 2)

    def state(self, t: float) -> dict[str, Array]:
        return {name: self.at(t, order) for order, name in enumerate(("q", "qd", "qdd"))}


def along(
    motion: Motion, run: Callable[[Mapping[str, Array]], list[Array]], states: int, steps: int
) -> Array:
    """Torques at the end of so many steps."""
    torque, state = run({**motion.state(0.0), "state": np.zeros(states), "dt": np.zeros(1)})
    for k in range(1, steps + 1):
        at = motion.state(TIME * k / steps)
        torque, state = run({**at, "state": state, "dt": np.array([TIME / steps])})
    return torque


def torques(arm: Reference) -> Array:
    """What the equations say at the end of the motion."""
    couplers = [_coupler(arm, k) for k in range(arm.n)]
    if any(couplers):
        return _through_couplers(arm, couplers)
    motion, found = Motion(arm.n), np.zeros(arm.n)
    at = motion.state(TIME)
    for k in range(arm.n):
        for entry in arm.effects.of("presliding_hysteresis", k):

            def rate(t: float, z: Array, k: int = k, entry: dict[str, Any] = entry) -> Array:
                speed = motion.at(t, 1)[k]
                return np.asarray(speed - entry["stiffness"] * abs(speed) / entry["level"] * z)

            z = _solved(rate, np.zeros(1))
            found[k] += (entry["stiffness"] * z + entry.get("damping", 0) * rate(TIME, z))[0]
            found[k] -= entry["level"] * np.sign(at["qd"][k])  # steady friction, which the reference has
    return arm.inverse_dynamics(**at) + found


def _coupler(arm: Reference, k: int) -> dict[str, Any]:
    for effect in ("joint_elasticity", "backlash"):
        for entry in arm.effects.of(effect, k):
            return dict(entry)
    return {}


def _twist(entry: Mapping[str, Any], load: float) -> tuple[float, float]:
    """How far motor and link are apart at rest under a load, and the stiffness there."""
    twist, compliance = load / entry["stiffness"], 1 / entry["stiffness"]
    if "gap" in entry:
        half, w = entry["gap"] / 2, entry["transition"]
        twist += half * load / (abs(load) + w)
        compliance += half * w / (abs(load) + w) ** 2
    return twist, 1 / compliance


def _through_couplers(arm: Reference, couplers: list[dict[str, Any]]) -> Array:
    """Every joint has a coupler, all with the encoder on one side."""
    motion, n = Motion(arm.n), arm.n
    damping = np.array([entry["damping"] for entry in couplers])
    on_link = couplers[0].get("encoder", "motor") == "link"

    def load(t: float, twist: Array, name: str = "links") -> Array:
        at = motion.state(t)
        if not on_link:
            at["q"] = at["q"] - twist
        return arm.value(name, lambda: arm.of_links, **at).ravel()

    def rate(t: float, twist: Array) -> Array:
        rest = [_twist(entry, x) for entry, x in zip(couplers, load(t, twist), strict=True)]
        rates = [k * (x - y) for (x, k), y in zip(rest, twist, strict=True)]
        return np.asarray(np.array(rates) / damping, np.float64)

    twist = _solved(rate, np.zeros(n))
    at = motion.state(TIME)
    motor = dict(at)
    if on_link:
        step = 1e-5  # of time, for the second derivative of the solution
        speeds = [
            rate(TIME + side * step, _solved(rate, np.zeros(n), TIME + side * step)) for side in (-1, 1)
        ]
        motor["qd"] = at["qd"] + rate(TIME, twist)
        motor["qdd"] = at["qdd"] + (speeds[1] - speeds[0]) / (2 * step)
    motors = arm.value("motors", lambda: arm.of_motors, **motor).ravel()
    friction = ca.vertcat(*[drives.friction(arm, k) for k in range(n)])
    drag = arm.value("friction", lambda: friction, **motor).ravel()
    return np.asarray(load(TIME, twist) + motors + drag, np.float64)


def _solved(rate: Callable[[float, Array], Array], start: Array, end: float = TIME) -> Array:
    solution = solve_ivp(rate, (0.0, end), start, method="LSODA", rtol=1e-10, atol=1e-13)
    assert solution.success
    return np.asarray(solution.y[:, -1])


def compared(
    arm: Reference, states: int, run: Callable[[Mapping[str, Array]], list[Array]]
) -> tuple[float, float]:
    """How far extrapolation ends from the equations, as a share of the largest torque; and how far it may: no
    farther than two more halvings would, and that only where halvings halve."""
    motion, right = Motion(arm.n), torques(arm)
    ends = [along(motion, run, states, steps) for steps in STEPS]
    scale = max(float(np.abs(right).max()), 1.0)
    first, middle, last = (float(np.abs(end - right).max()) / scale for end in ends)
    halves = last < 1e-9 or (0.4 < last / middle < 0.6 and 0.4 < middle / first < 0.6)
    off = float(np.abs((8 * ends[2] - 6 * ends[1] + ends[0]) / 3 - right).max()) / scale
    return off if halves else np.inf, max(1e-9, last / 4)
