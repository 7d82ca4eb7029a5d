"""Torques of arms with effects in many digits: the balance of :mod:`.world_dynamics`, and on top of it the
drives in the order that ``docs/effects.md`` states, each effect by its equation as it is typeset there.

Of the library only descriptions and the LaTeX of the catalogue are used: no equation, recursion, graph or
field. What the page says in words (steady values, efficiency curves, steps of what remembers) is written here
by hand.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any, Final

import mpmath

from effects.typeset_effects import definitions, typeset
from robodyn.effects.catalogue import CATALOGUE
from robodyn.robot.model import EffectEntry, Robot
from robodyn.robot.values import Affine
from robodyn.verify.declared import value
from robodyn_testing.world_dynamics import Loads, direction, loads, number

COUPLERS: Final = ("joint_elasticity", "backlash")
LINK: Final = ("spring", "gas_spring")
MOTOR: Final = (
    "viscous_friction", "coulomb_friction", "asymmetric_friction", "stribeck_friction", "power_law_friction",
    "presliding_hysteresis", "rotor_inertia", "torque_ripple",
)  # fmt: skip


def power(x: Any, exponent: Any) -> Any:
    """``x^exponent``, of a negative ``x`` where the exponent is whole."""
    return x ** int(exponent) if mpmath.isint(exponent) and abs(exponent) < 99 else mpmath.power(x, exponent)


MANY_DIGITS: Final[dict[str, Any]] = {
    "number": mpmath.mpf, "pow": power, "sqrt": mpmath.sqrt, "exp": mpmath.exp, "sin": mpmath.sin,
    "cos": mpmath.cos,
}  # fmt: skip


@dataclass
class Side:
    """Motion [n] of links or of motors: rad or m, per second."""

    q: list[Any]
    qd: list[Any]
    qdd: list[Any]


@dataclass(frozen=True)
class Place:
    """What an equation reads: motion, direction, the torque so far, force and moment in the joint."""

    q: Any
    qd: Any
    qdd: Any
    way: Any
    tau: Any = 0
    f: Sequence[Any] = (0, 0, 0)
    n: Sequence[Any] = (0, 0, 0)


def plain(entry: EffectEntry, parameters: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of an effect in the digits in use; curves of efficiency stay exact."""
    return {
        name: number(x, parameters) if isinstance(x, (Fraction, Affine)) else x for name, x in entry.settings
    }


def equation(id: str, p: Mapping[str, Any], at: Place) -> Any:
    """What the effect adds at a place, by its equation on the page; presliding in steady motion."""
    symbols: dict[str, Any] = {r"\dot q": at.qd, r"\ddot q": at.qdd, r"\dot u": at.qd, r"\ddot u": at.qdd}
    symbols |= {"q": at.q, "s": at.way, r"\tau": at.tau, r"\tau_L": at.tau}
    symbols |= {rf"\operatorname{{sgn}}{name}": at.way for name in (r"\dot q", r"\dot u")}
    symbols |= {f"f_{axis}": x for axis, x in zip("xyz", at.f, strict=True)}
    symbols |= {f"n_{axis}": x for axis, x in zip("xyz", at.n, strict=True)}
    for parameter in CATALOGUE[id].parameters:
        if parameter.symbol and isinstance(p.get(parameter.name), mpmath.mpf):
            symbols[parameter.symbol] = p[parameter.name]
    if "mu_r" in p:
        symbols |= {r"\mu": p["mu_r"], "r": 1}
    if id == "transmission_loss":
        if isinstance(p["efficiency"], tuple):
            load = abs(at.tau) / p["rated_torque"]
            symbols[r"\eta"] = efficiency(load, p["efficiency"], p["interpolation"])
        return value(typeset(id, p), symbols, MANY_DIGITS) - at.tau
    if id == "load_dependent_friction" and p.get("variant") == "printed":
        symbols["n_x"] = -symbols["n_x"]
    for symbol, text in definitions(id):
        symbols[symbol] = value(text, symbols, MANY_DIGITS)
    latex = r"F_c \operatorname{sgn}\dot q" if id == "presliding_hysteresis" else typeset(id, p)
    return value(latex, symbols, MANY_DIGITS)


def efficiency(load: Any, knots: Sequence[tuple[Fraction, Fraction]], interpolation: str) -> Any:
    """The curve at a load fraction: straight lines, or the cubic of Fritsch and Butland; level beyond."""
    x = [number(k[0], {}) for k in knots]
    if load <= x[0] or load >= x[-1]:
        return number(knots[0 if load <= x[0] else -1][1], {})
    k = max(i for i in range(len(x)) if x[i] <= load)
    d = [(y1 - y0) / (x1 - x0) for (x0, y0), (x1, y1) in pairwise(knots)]
    y, far, slope = number(knots[k][1], {}), load - x[k], number(d[k], {})
    if interpolation == "linear" or len(x) == 2:
        return y + slope * far
    h = [x1 - x0 for (x0, _), (x1, _) in pairwise(knots)]
    slopes = [Fraction(0)] * len(knots)
    for i in range(1, len(d)):
        if d[i - 1] * d[i] > 0:
            w, v = 2 * h[i] + h[i - 1], h[i] + 2 * h[i - 1]
            slopes[i] = (w + v) / (w / d[i - 1] + v / d[i])
    for end, i, j in ((0, 0, 1), (-1, -1, -2)):
        m = d[i] + h[i] * (d[i] - d[j]) / (h[i] + h[j])
        m = m if m * d[i] > 0 else Fraction(0)
        slopes[end] = 3 * d[i] if d[i] * d[j] <= 0 and abs(m) > 3 * abs(d[i]) else m
    t, width = far / number(h[k], {}), number(h[k], {})
    m0, m1 = number(slopes[k], {}), number(slopes[k + 1], {})
    rise = t * t * (3 - 2 * t)
    bend = m0 * t * (1 - t) ** 2 + m1 * t * t * (t - 1)
    return y + rise * slope * width + width * bend


class WorldArm:
    """``robot`` as it is described, errors of links and all: no effect of it folded into others.

    ``parameters``: values of its run-time names, in the digits in use.
    """

    def __init__(self, robot: Robot, parameters: Mapping[str, Any]) -> None:
        self.robot, self.parameters = robot, parameters
        self.motor = robot.torque_side == "motor"
        self._loads: dict[tuple[Any, ...], Loads] = {}
        self.at = [
            [(e.effect, plain(e, parameters)) for e in robot.effects_at(i)] for i in range(1, robot.n + 1)
        ]

    def loads(self, q: Sequence[Any], qd: Sequence[Any], qdd: Sequence[Any]) -> Loads:
        """What the links and the payload take from their joints; calculated once for a motion."""
        key = (*q, *qd, *qdd)
        if key not in self._loads:
            self._loads[key] = loads(self.robot, q, qd, qdd, self.parameters)
        return self._loads[key]

    def rigid(self, q: Sequence[Any], qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Torques [n] of the links and the payload, and of motors' inertia: what a mass matrix is of."""
        tau = list(self.loads(q, qd, qdd).tau)
        if self.motor:
            for i, link in enumerate(self.robot.links):
                tau[i] += number(link.joint.motor_inertia, self.parameters) * qdd[i]
                for id, p in self.at[i]:
                    if id == "rotor_inertia":
                        tau[i] += p["inertia"] * qdd[i]
                    if id == "motor_coupling":
                        k, rho = p["with"] - 1, p["ratio"]
                        shared = p["inertia"] * (qdd[i] + rho * qdd[k])
                        tau[i] += shared
                        tau[k] += rho * shared
        return tau

    @property
    def feels_load(self) -> bool:
        """Whether friction depends on accelerations."""
        kinds = ("load_dependent_friction", *(("transmission_loss",) if self.motor else ()))
        return any(id in kinds for effects in self.at for id, _ in effects)

    def torques(
        self,
        q: Sequence[Any],
        qd: Sequence[Any],
        qdd: Sequence[Any],
        state: Sequence[Any] | None = None,
        dt: Any = None,
    ) -> tuple[list[Any], list[Any]]:
        """Torques [n] of the motors (or behind bearings), and the states ``dt`` [s] later; without ``state``
        nothing is remembered."""
        link, motor = Side(list(q), list(qd), list(qdd)), Side(list(q), list(qd), list(qdd))
        left, after = list(state or ()), []
        before: list[list[Any]] = [[] for _ in range(self.robot.n)]
        for i in range(self.robot.n):
            if self.motor and state is not None:
                for id, p in sorted(self.at[i], key=lambda effect: effect[0] not in COUPLERS):
                    if id in COUPLERS:
                        before[i], left = left[:3], left[3:]
                        if p["encoder"] == "motor":
                            link.q[i] -= before[i][0]
                    elif id == "presliding_hysteresis":
                        left = left[1:]
        passed = self._passed(link)
        tau = list(passed)
        left = list(state or ())
        for i in range(self.robot.n if self.motor else 0):
            if before[i]:
                left = left[3:]
                id, p = next(effect for effect in self.at[i] if effect[0] in COUPLERS)
                twist = next_twist(id, p, passed[i], before[i], dt)
                after += twist
                if p["encoder"] == "link":
                    for row, ahead in zip((motor.q, motor.qd, motor.qdd), twist, strict=True):
                        row[i] += ahead
            at = self._place(motor, i, tau=passed[i])
            joint = self.robot.links[i].joint
            tau[i] += sum(equation(id, p, at) for id, p in self.at[i] if id == "transmission_loss")
            tau[i] += number(joint.motor_inertia, self.parameters) * at.qdd
            tau[i] += number(joint.viscous, self.parameters) * at.qd
            tau[i] += number(joint.coulomb, self.parameters) * at.way
            for id, p in self.at[i]:
                if id == "presliding_hysteresis" and state is not None:
                    z, torque = next_bend(p, at.qd, left[0], dt)
                    left = left[1:]
                    after.append(z)
                    tau[i] += torque
                elif id in MOTOR:
                    tau[i] += equation(id, p, at)
        for i in range(self.robot.n if self.motor else 0):
            for id, p in self.at[i]:
                if id == "motor_coupling":
                    k, rho = p["with"] - 1, p["ratio"]
                    q, qd, qdd = (row[i] + rho * row[k] for row in (motor.q, motor.qd, motor.qdd))
                    shared = equation(id, p, Place(q, qd, qdd, direction(self.robot, qd)))
                    tau[i] += shared
                    tau[k] += rho * shared
        return tau, after

    def _passed(self, link: Side) -> list[Any]:
        """Torques [n] behind the bearings: the arm's, springs', and friction under the load of both."""
        loads = self.loads(link.q, link.qd, link.qdd)
        passed = []
        for i, effects in enumerate(self.at):
            at = self._place(link, i)
            tau = loads.tau[i] + sum(equation(id, p, at) for id, p in effects if id in LINK)
            loaded = self._place(link, i, tau=tau, f=loads.f[i], n=loads.n[i])
            rubbing = (equation(id, p, loaded) for id, p in effects if id == "load_dependent_friction")
            passed.append(tau + sum(rubbing))
        return passed

    def _place(self, side: Side, i: int, **load: Any) -> Place:
        return Place(side.q[i], side.qd[i], side.qdd[i], direction(self.robot, side.qd[i]), **load)


def next_twist(id: str, p: Mapping[str, Any], tau: Any, before: Sequence[Any], dt: Any) -> list[Any]:
    """Twist, its rate and acceleration ``dt`` [s] later under the torque ``tau``: damping lets it follow the
    twist at rest exponentially, rates are differences; at rest where ``dt`` is 0."""
    rest, slope = tau / p["stiffness"], 1 / p["stiffness"]
    if id == "backlash":
        near = abs(tau) + p["transition"]
        rest += p["gap"] / 2 * tau / near
        slope += p["gap"] / 2 * p["transition"] / near**2  # of the twist over the torque
    if dt == 0:
        return [rest, mpmath.mpf(0), mpmath.mpf(0)]
    kept = mpmath.exp(-dt / (p["damping"] * slope)) if p["damping"] else 0
    twist = rest + (before[0] - rest) * kept
    rate = (twist - before[0]) / dt
    return [twist, rate, (rate - before[1]) / dt]


def next_bend(p: Mapping[str, Any], qd: Any, z: Any, dt: Any) -> tuple[Any, Any]:
    """The bend of bristles ``dt`` [s] later at a constant velocity, and the torque then."""
    sense = (qd > 0) - (qd < 0)
    slides = sense * p["level"] / p["stiffness"]
    moved = slides + (z - slides) * mpmath.exp(-abs(qd) * dt * p["stiffness"] / p["level"]) if sense else z
    rate = qd - p["stiffness"] * abs(qd) / p["level"] * moved
    return moved, p["stiffness"] * moved + p["damping"] * rate
