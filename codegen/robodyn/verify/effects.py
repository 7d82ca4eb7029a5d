"""Effects by their printed equations, in double precision: what the catalogue's are compared with.

Written from the sources that the catalogue names, case by case, where the catalogue has one formula for all
cases. Nothing here is shared with the equations in :mod:`robodyn.effects`, which kernels are made of. An
effect that is not known here is compared with what its definition prints (:mod:`.declared`); where that does
not do, an error says so.

What remembers enters by its steady form: presliding by its level, elastic joints and backlash as rigid
joints; its steps stand in :mod:`robodyn.verify.stateful`. Sensors and contacts are in no torque. What the
reader of a description resolves (rotor inertia, base tilt, errors of inertial parameters) is not looked for.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.robot.model import EffectEntry, Robot
from robodyn.robot.values import Affine
from robodyn.verify.declared import declared_place, declared_torque
from robodyn.verify.numbers import Parameters, exact_value, length, real, sign, size

#: Parameters of an effect by name: floats, words, knots, numbers of joints.
Settings = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class State:
    """Many states of one joint.

    ``q, qd, qdd`` ``[N]``: its motion [rad or m, per second]; ``way`` ``[N]``: the direction of it; ``tau``
    ``[N]``: the torque that has come so far [N m or N]; ``f, n`` ``[N, 3]``: force [N] and moment [N m] that
    the joint of a rigid arm passes to the link, about the origin and along the axes of the link's frame.
    """

    q: Floats
    qd: Floats
    qdd: Floats
    way: Floats
    tau: Floats
    f: Floats
    n: Floats


@dataclass(frozen=True, slots=True)
class Reactions:
    """What the rigid arm takes from its joints: ``tau`` ``[N, n]``; ``f`` and ``n`` ``[N, n, 3]``, in each
    link's frame."""

    tau: Floats
    f: Floats
    n: Floats


def settings(entry: EffectEntry, parameters: Parameters) -> dict[str, Any]:
    """The parameters of ``entry`` with floats for exact numbers and run-time names."""

    def plain(value: Any) -> Any:
        if isinstance(value, (Fraction, Affine)):
            return real(exact_value(value, parameters))
        return tuple(plain(x) for x in value) if isinstance(value, tuple) else value

    return {name: plain(value) for name, value in entry.settings}


def direction(speed: Floats, rest_velocity: float | None, dead_band: float | None) -> Floats:
    """sgn of ``speed``, 0 at 0; smoothed over ``rest_velocity``; 0 for speeds within ``dead_band``, half at
    its edge."""
    if rest_velocity is not None:
        return np.tanh(speed / rest_velocity)
    if dead_band is not None:
        return sign(speed) * np.heaviside(np.abs(np.real(speed)) - dead_band, 0.5)
    return sign(speed)


def added_torque(effect: str, p: Settings, at: State) -> Floats:
    """What the effect of that id adds to the torque of a joint, ``[N]`` [N m or N]; of motors that drive two
    joints, the motor's torque. What is not known here is what its own definition prints.

    Raises
    ------
    NoReferenceError: that cannot be read.
    """
    match effect:
        case "viscous_friction":
            return np.asarray(p["coefficient"] * at.qd)
        case "power_law_friction":
            ratio = at.qd / p["velocity"]
            stretched = np.sqrt(ratio**2 + 1e-6)
            return np.asarray(p["level"] * ratio / stretched * stretched ** p["exponent"])
        case "coulomb_friction" | "presliding_hysteresis":
            return np.asarray(p["level"] * at.way)
        case "asymmetric_friction":
            return _between(at.way, -p["negative"], 0.0, p["positive"])
        case "stribeck_friction":
            fading = np.exp(-np.power(size(at.qd) / p["velocity"], p["exponent"]))
            return np.asarray((p["static"] * fading + p["level"] * (1 - fading)) * at.way)
        case "spring":
            way = at.q - p["rest"]
            return np.asarray(p["stiffness"] * way + p["cubic"] * way**3)
        case "gas_spring":
            return _strut(p, at.q - p["dead_center"])
        case "torque_ripple":
            return np.asarray(p["amplitude"] * np.sin(p["cycles_per_rev"] * at.q + p["phase"]))
        case "motor_coupling":
            return np.asarray(p["inertia"] * at.qdd + p["viscous"] * at.qd + p["coulomb"] * at.way)
        case "load_dependent_friction":
            return np.asarray(_normal_forces(p, at) * at.way)
        case "transmission_loss":
            return _loss(p, at)
    return declared_torque(effect, p, _symbols(at))


def _symbols(at: State) -> dict[str, Floats]:
    """What the symbols of printed equations stand for."""
    axes = {
        f"{name}_{axis}": vector[:, k]
        for name, vector in (("f", at.f), ("n", at.n))
        for k, axis in enumerate("xyz")
    }
    moved = {"q": at.q, r"\dot q": at.qd, r"\ddot q": at.qdd, r"\operatorname{sgn}\dot q": at.way}
    return {**moved, **axes, r"\tau": at.tau, r"\tau_L": at.tau}


def _between(way: Floats, backward: Any, still: Any, forward: Any) -> Floats:
    """Forward or backward torque; for directions in between, that share of it from the one at rest."""
    return np.asarray(
        np.where(np.real(way) > 0, still + way * (forward - still), still - way * (backward - still))
    )


def _normal_forces(p: Settings, at: State) -> Floats:
    """Friction of a bearing in motion, ``[N]``: its coefficient times what presses on it."""
    grip = p["mu_r"] if "mu_r" in p else p["mu"] * p.get("radius", 1.0)
    match p["bearing"]:
        case "torque":
            load = size(at.tau)
        case "thrust":
            load = size(at.f[:, 2])
        case "journal" if "span" in p:
            one, other = two_supports(p["span"], at.f, at.n, mirrored=p.get("variant") == "printed")
            load = length(one[:, 0], one[:, 1]) + length(other[:, 0], other[:, 1])
        case "linear":
            load = np.sum(size(np.stack(two_supports(p["span"], at.f, at.n))), axis=(0, 2))
        case _:
            load = length(at.f[:, 0], at.f[:, 1])
    return np.asarray(grip * load)


def two_supports(span: float, f: Floats, n: Floats, *, mirrored: bool = False) -> tuple[Floats, Floats]:
    """Forces ``[N, 2]`` [N] along x and y of supports at z = span/2 and -span/2 that make up ``f`` and ``n``
    ``[N, 3]``; ``mirrored``: with the sign of n_x that Eq 3.3 of the thesis has in print."""
    z = span / 2
    balance = np.array(
        [
            [1.0, 0.0, 1.0, 0.0],  # f_x
            [0.0, 1.0, 0.0, 1.0],  # f_y
            [0.0, -z, 0.0, z],  # n_x = -z F_y
            [z, 0.0, -z, 0.0],  # n_y = z F_x
        ]
    )
    n_x = -n[:, 0] if mirrored else n[:, 0]
    loads = np.stack([f[:, 0], f[:, 1], n_x, n[:, 1]])
    reactions = np.linalg.solve(balance, loads).T
    return reactions[:, :2], reactions[:, 2:]


def _strut(p: Settings, angle: Floats) -> Floats:
    """Moment about the axis, against that of a strut from the crank's end to a pivot at (1, 0)."""
    crank = p["ratio"]
    if crank == 0:  # a crank of no length under a force without end: a plain sine
        return np.asarray(p["torque"] * (1 + p["rise"] * (1 - np.cos(angle))) * np.sin(angle))
    end = crank * np.stack([np.cos(angle), np.sin(angle)])
    along = np.array([[1.0], [0.0]]) - end
    strut = length(along[0], along[1])
    travel = (strut - (1 - crank)) / crank
    pull = p["torque"] * (1 + p["rise"] * travel) / crank * along / strut
    return np.asarray(-(end[0] * pull[1] - end[1] * pull[0]))


def _loss(p: Settings, at: State) -> Floats:
    """Table 3.2 by its cases, less the torque that goes in at rest."""
    eta: Any = p["efficiency"]
    if isinstance(eta, tuple):
        eta = efficiency(size(at.tau) / p["rated_torque"], eta, p["interpolation"])
    drives, brakes, load = at.tau / eta, at.tau * eta, np.real(at.tau)
    forward = np.where(load > 0, drives, brakes) + p["breakaway"]
    backward = np.where(load < 0, drives, brakes) - p["breakaway"]
    return np.asarray(_between(at.way, backward, at.tau, forward) - at.tau)


def efficiency(load: Floats, knots: tuple[tuple[float, float], ...], interpolation: str) -> Floats:
    """Efficiency ``[N]`` at load fractions ``[N]``; level beyond the outer knots."""
    x, y = np.array(knots).T
    if len(x) == 1:
        return np.full_like(load, y[0])
    within = np.real(load)
    k = np.clip(np.searchsorted(x, within, side="right") - 1, 0, len(x) - 2)
    t = (np.where(within < x[0], x[0], np.where(within > x[-1], x[-1], load)) - x[k]) / (x[k + 1] - x[k])
    if interpolation == "linear" or len(x) == 2:
        return np.asarray(y[k] + (y[k + 1] - y[k]) * t)
    width, slopes = x[k + 1] - x[k], _slopes_at_knots(x, y)
    rise = t * t * (3 - 2 * t)
    start, end = t * (1 - t) ** 2, t * t * (t - 1)
    return np.asarray(y[k] * (1 - rise) + y[k + 1] * rise + width * (slopes[k] * start + slopes[k + 1] * end))


def _slopes_at_knots(x: Floats, y: Floats) -> Floats:
    """Slopes of the monotone cubic: Fritsch and Butland's mean inside; at the ends that of a parabola through
    three knots, held back (Moler, Numerical Computing with MATLAB, section 3.6)."""
    h = np.diff(x)
    d = np.diff(y) / h
    slopes = np.zeros_like(x)
    for k in range(1, len(x) - 1):
        if d[k - 1] * d[k] > 0:
            before, after = 2 * h[k] + h[k - 1], h[k] + 2 * h[k - 1]
            slopes[k] = 3 * (h[k - 1] + h[k]) / (before / d[k - 1] + after / d[k])
    for end, near, far in ((0, 0, 1), (-1, -1, -2)):
        slope = d[near] + h[near] * (d[near] - d[far]) / (h[near] + h[far])
        if np.sign(slope) != np.sign(d[near]):
            slope = 0.0
        elif np.sign(d[near]) != np.sign(d[far]) and abs(slope) > abs(3 * d[near]):
            slope = 3 * d[near]
        slopes[end] = slope
    return slopes


#: Where in the drive an effect acts; of others the definition says it.
_PLACES = {
    "load_dependent_friction": "bearing", "transmission_loss": "gear", "motor_coupling": "pair",
    **dict.fromkeys(("spring", "gas_spring"), "link"),
    **dict.fromkeys(("joint_elasticity", "backlash"), "coupler"),
    **dict.fromkeys(("payload", "rotor_inertia", "inertial_error", "base_tilt"), "rigid"),
    **dict.fromkeys(
        ("viscous_friction", "coulomb_friction", "asymmetric_friction", "stribeck_friction",
         "power_law_friction", "presliding_hysteresis", "torque_ripple"), "motor",
    ),
}  # fmt: skip


def place_of(effect: str) -> str:
    """Where in the drive the effect of that id acts.

    Raises
    ------
    NoReferenceError: there is neither a reference for it, nor is it an equation alone.
    """
    return _PLACES.get(effect) or declared_place(effect)


class Drives:
    """The drives of ``robot``, joint by joint, from the links to the motors, at given parameters."""

    def __init__(self, robot: Robot, parameters: Parameters) -> None:
        self._n = robot.n
        self._at_motor = robot.torque_side == "motor"
        self._rest = None if robot.rest_velocity is None else float(robot.rest_velocity)
        self._band = None if robot.dead_band is None else float(robot.dead_band)
        self._entries = [
            (place_of(e.effect), e.effect, e.joint, settings(e, parameters)) for e in robot.effects
        ]
        joints = [link.joint for link in robot.links]
        self._rotor, self._viscous, self._coulomb = (
            np.array([real(exact_value(getattr(joint, name), parameters)) for joint in joints])
            for name in ("motor_inertia", "viscous", "coulomb")
        )

    @property
    def feels_load(self) -> bool:
        """Whether a torque of friction depends on the arm's, and so on accelerations."""
        places = ("bearing", "gear") if self._at_motor else ("bearing",)
        return any(place in places for place, _, _, _ in self._entries)

    def inertia(self) -> Floats:
        """What motors add to the mass matrix, ``[n, n]`` [kg m^2 or kg]."""
        total = np.diag(self._rotor)
        for j, k, p in self._pairs():
            row = np.zeros(self._n)
            row[j], row[k] = 1.0, p["ratio"]
            total = total + p["inertia"] * np.outer(row, row)
        return total if self._at_motor else np.zeros_like(total)

    def torque(self, q: Floats, qd: Floats, qdd: Floats, rigid: Reactions) -> Floats:
        """Torques ``[N, n]`` of states ``[N, n]``: of motors or, where asked for, behind bearings."""
        way = direction(qd, self._rest, self._band)
        tau = rigid.tau.copy()
        for i in range(self._n):
            at = State(q[:, i], qd[:, i], qdd[:, i], way[:, i], tau[:, i], rigid.f[:, i], rigid.n[:, i])
            at = replace(at, tau=at.tau + self._sum("link", i, at))
            at = replace(at, tau=at.tau + self._sum("bearing", i, at))
            if self._at_motor:
                at = replace(at, tau=at.tau + self._sum("gear", i, at))
                own = self._rotor[i] * at.qdd + self._viscous[i] * at.qd + self._coulomb[i] * at.way
                at = replace(at, tau=at.tau + own + self._sum("motor", i, at))
            tau[:, i] = at.tau
        for j, k, p in self._pairs():
            speed, rate = qd[:, j] + p["ratio"] * qd[:, k], qdd[:, j] + p["ratio"] * qdd[:, k]
            turned = direction(speed, self._rest, self._band)
            none = np.zeros_like(rigid.f[:, j])
            shared = added_torque("motor_coupling", p, State(speed, speed, rate, turned, speed, none, none))
            tau[:, j] += shared
            tau[:, k] += p["ratio"] * shared
        return tau

    def _sum(self, place: str, joint: int, at: State) -> Floats:
        """What the effects at that place of ``joint`` (from 0) add, each at the same torque."""
        total = np.zeros_like(at.q)
        for there, effect, where, p in self._entries:
            if there == place and where == joint + 1:
                total = total + added_torque(effect, p, at)
        return total

    def _pairs(self) -> list[tuple[int, int, dict[str, Any]]]:
        """Motors that drive two joints: the joints (from 0) and the parameters."""
        if not self._at_motor:
            return []
        pairs = [(joint, p) for place, _, joint, p in self._entries if place == "pair"]
        return [(joint - 1, p["with"] - 1, p) for joint, p in pairs if joint is not None]
