"""What MuJoCo lacks: effects as torques of each step, by formulas of their own.

Written from the sources that the catalogue names; nothing here is shared with :mod:`robodyn.effects` or
:mod:`robodyn.verify`. Dry friction holds a joint at rest (:meth:`~benchmarks.blind_arms.now.Now.rub`), or has
the direction ``clip(v / width, -1, 1)`` with a width [rad/s or m/s] so small that it only keeps the steps
from chattering.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from benchmarks.blind_arms.now import Force, Now, Scale, direction, width_of

from peers.numbers import Array, number
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True)
class Coupling:
    """A motor of ``inertia`` that turns by ``row`` @ qd."""

    row: Array
    inertia: float


@dataclass(frozen=True, slots=True)
class Forces:
    """The effects of an arm, by where they act: link, bearing, gear, motor, in this order; ``twist`` of
    joints with a motor apart: torque of twist and its rate; ``couplings``: inertia of motors on two joints;
    ``reactions``: the joints whose force and moment are needed."""

    link: tuple[Force, ...]
    bearing: tuple[Force, ...]
    gear: tuple[Force, ...]
    motor: tuple[Force, ...]
    twist: dict[int, Callable[[float, float], float]]
    couplings: tuple[Coupling, ...]
    reactions: tuple[int, ...]


_SENSORS = ("torque_bias", "torque_gain", "time_delay", "encoder_offset", "torque_saturation")
_RIGID = ("payload", "external_contact", "swinging_tool")


def forces(robot: Robot, scale: Scale) -> Forces:
    """The torques of the friction and the effects of ``robot``, save those of sensors and rigid bodies."""
    link: list[Force] = []
    bearing: list[Force] = []
    gear: list[Force] = []
    motor: list[Force] = []
    twist: dict[int, Callable[[float, float], float]] = {}
    couplings: list[Coupling] = []
    if any(part.joint.viscous or part.joint.coulomb for part in robot.links):
        motor.append(_plain_friction(robot, scale))
    for entry in robot.effects:
        if entry.effect in (*_SENSORS, *_RIGID):
            continue
        j = (entry.joint or 1) - 1
        p = {name: _plain(value) for name, value in entry.settings}
        match entry.effect:
            case "viscous_friction":
                motor.append(_viscous(j, p["coefficient"]))
            case "coulomb_friction":
                motor.append(_dry(j, lambda speed, level=p["level"]: level, scale, p["level"]))
            case "asymmetric_friction":
                motor.append(_asymmetric(j, p["positive"], p["negative"], scale))
            case "stribeck_friction":
                motor.append(_dry(j, _stribeck(p), scale, p["static"]))
            case "power_law_friction":
                motor.append(_power(j, p))
            case "presliding_hysteresis":
                motor.append(_bristles(j, p, scale))
            case "torque_ripple":
                motor.append(_ripple(j, p))
            case "spring":
                link.append(_spring(j, p))
            case "gas_spring":
                link.append(_strut(j, p))
            case "load_dependent_friction":
                bearing.append(_bearing(j, p, scale))
            case "transmission_loss":
                gear.append(_loss(j, p, scale))
            case "motor_coupling":
                row = np.zeros(robot.n)
                row[j], row[p["with"] - 1] = 1.0, p["ratio"]
                motor.append(_shared(row, p, scale))
                couplings.append(Coupling(row, p["inertia"]))
            case "joint_elasticity":
                twist[j] = lambda x, rate, k=p["stiffness"], d=p["damping"]: k * x + d * rate
            case "backlash":
                twist[j] = _teeth(p)
            case "random_offset":
                motor.append(_telegraph(j, p, scale))
            case "acceleration_friction":
                motor.append(_by_acceleration(j, p["coefficient"], scale))
            case _:
                raise ValueError(f"no formula for {entry.effect}")
    pressed = [
        e for e in robot.effects if e.effect == "load_dependent_friction" and e.text("bearing") != "torque"
    ]
    reactions = sorted({e.joint - 1 for e in pressed if e.joint})
    return Forces(
        tuple(link), tuple(bearing), tuple(gear), tuple(motor), twist, tuple(couplings), tuple(reactions)
    )


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return tuple(map(_plain, value))
    return value if isinstance(value, (str, int)) else float(value)


# --- friction of the motor --------------------------------------------------------------------------------


def _plain_friction(robot: Robot, scale: Scale) -> Force:
    """What the plain keys say of all joints."""
    viscous = np.array([number(part.joint.viscous) for part in robot.links])
    coulomb = np.array([number(part.joint.coulomb) for part in robot.links])
    width = np.array([width_of(scale, j, float(level)) for j, level in enumerate(coulomb)])

    def act(now: Now) -> None:
        now.motor += viscous * now.w
        if now.sticks:
            now.held_motor += coulomb
        else:
            now.motor += coulomb * np.clip(now.w / width, -1, 1)

    return act


def _viscous(j: int, coefficient: float) -> Force:
    def act(now: Now) -> None:
        now.motor[j] += coefficient * now.w[j]

    return act


def _power(j: int, p: dict[str, Any]) -> Force:
    level, exponent, of = p["level"], p["exponent"], p["velocity"]

    def act(now: Now) -> None:
        x = float(now.w[j]) / of
        now.motor[j] += level * x * (x * x + 1e-6) ** ((exponent - 1) / 2)

    return act


def _dry(j: int, level: Callable[[float], float], scale: Scale, largest: float) -> Force:
    width = width_of(scale, j, largest)

    def act(now: Now) -> None:
        speed = float(now.w[j])
        size = abs(speed) + 1e-12  # either way at rest as well
        now.rub(now.motor, j, speed, (level(-size), level(size)), width)

    return act


def _asymmetric(j: int, forward: float, backward: float, scale: Scale) -> Force:
    return _dry(j, lambda speed: forward if speed > 0 else backward, scale, max(forward, backward))


def _stribeck(p: dict[str, Any]) -> Callable[[float], float]:
    low, rise, knee, power = p["level"], p["static"] - p["level"], p["velocity"], p.get("exponent", 2.0)
    return lambda speed: low + rise * math.exp(-((abs(speed) / knee) ** power))


def _bristles(j: int, p: dict[str, Any], scale: Scale) -> Force:
    stiff, level, damping = p["stiffness"], p["level"], p["damping"]
    bend = 0.0

    def act(now: Now) -> None:
        nonlocal bend
        speed = float(now.w[j])
        travel = abs(speed) * scale.step
        before = bend
        if travel:
            end = math.copysign(level / stiff, speed)
            bend = end + (bend - end) * math.exp(-stiff * travel / level)
        now.motor[j] += stiff * bend + damping * (bend - before) / scale.step

    return act


def _ripple(j: int, p: dict[str, Any]) -> Force:
    size, waves, phase = p["amplitude"], p["cycles_per_rev"], p["phase"]

    def act(now: Now) -> None:
        now.motor[j] += size * math.sin(waves * float(now.theta[j]) + phase)

    return act


def _shared(row: Array, p: dict[str, Any], scale: Scale) -> Force:
    """Friction of a motor on two joints; its inertia is in the equations of motion."""
    joints = np.flatnonzero(row)
    width = max(width_of(scale, int(j), p["coulomb"] * abs(float(row[j]))) for j in joints)

    def act(now: Now) -> None:
        speed = float(row @ now.w)
        torque = p["viscous"] * speed + p["coulomb"] * direction(speed, width)
        now.motor += row * torque

    return act


# --- between motor and link -------------------------------------------------------------------------------


def _spring(j: int, p: dict[str, Any]) -> Force:
    def act(now: Now) -> None:
        way = float(now.q[j]) - p["rest"]
        now.link[j] += p["stiffness"] * way + p["cubic"] * way**3

    return act


def _strut(j: int, p: dict[str, Any]) -> Force:
    """A strut from a pivot a crank (here of length 1) off the axis to a fixed one: the law of cosines."""
    far = 1 / p["ratio"]

    def act(now: Now) -> None:
        angle = float(now.q[j]) - p["dead_center"]
        length = math.sqrt(1 + far * far - 2 * far * math.cos(angle))
        force = p["torque"] * (1 + p["rise"] * (length - (far - 1)))
        now.link[j] += force * far * math.sin(angle) / length

    return act


def _bearing(j: int, p: dict[str, Any], scale: Scale) -> Force:
    kind, span = p["bearing"], p.get("span")
    grip = p["mu_r"] if "mu_r" in p else p["mu"] * p.get("radius", 1.0)

    def pressed(now: Now) -> float:
        if kind == "torque":
            return abs(float(now.load[j] + now.link[j]))
        fx, fy, fz = now.f[j]
        if kind == "thrust":
            return abs(float(fz))
        if kind == "radial" or (kind == "journal" and not span):
            return math.hypot(fx, fy)
        mx, my, _ = now.m[j]
        assert span
        # Two supports, half a span up and down the axis: forces and moments balance.
        up = (fx / 2 + my / span, fy / 2 - mx / span)
        down = (fx / 2 - my / span, fy / 2 + mx / span)
        if kind == "journal":
            return math.hypot(*up) + math.hypot(*down)
        return float(sum(abs(x) for x in (*up, *down)))

    def act(now: Now) -> None:
        level = grip * pressed(now)
        now.rub(now.link, j, float(now.v[j]), (level, level), width_of(scale, j, level))

    return act


def _loss(j: int, p: dict[str, Any], scale: Scale) -> Force:
    """Table 3.2 of the thesis by its four quadrants."""
    curve = p["efficiency"]
    if isinstance(curve, tuple) and p.get("interpolation", "linear") != "linear" and len(curve) > 2:
        raise ValueError("no formula for a cubic curve")

    def act(now: Now) -> None:
        out = float(now.load[j] + now.link[j])
        if isinstance(curve, tuple):
            eta = float(np.interp(abs(out) / p["rated_torque"], *zip(*curve, strict=True)))
        else:
            eta = curve
        lifting, lowering = (abs(loss) + p["breakaway"] for loss in (out / eta - out, out * eta - out))
        levels = (lowering, lifting) if out > 0 else (lifting, lowering)
        width = width_of(scale, j, levels[int(now.w[j] > 0)])
        now.rub(now.gear, j, float(now.w[j]), levels, width)

    return act


def _teeth(p: dict[str, Any]) -> Callable[[float, float], float]:
    """Play whose flanks are the inverse of ``x = T/K + g/2 T/(|T| + w)``, read from a table."""
    half, stiff, soft = p["gap"] / 2, p["stiffness"], p["transition"]
    torques = np.concatenate([[0.0], np.geomspace(soft * 1e-4, soft * 1e7, 6000)])
    twists = torques / stiff + half * torques / (torques + soft)
    grid = np.concatenate([np.linspace(0, 2 * half, 4001), np.linspace(2 * half, twists[-1], 2001)[1:]])
    values = np.interp(grid, twists, torques)
    table, levels = grid.tolist(), values.tolist()
    fine, coarse = table[1], table[4001] - table[4000]
    last = len(table) - 2

    def torque(x: float, rate: float) -> float:
        size = abs(x)
        k = int(size / fine) if size < 2 * half else 4000 + int((size - 2 * half) / coarse)
        k = min(k, last)
        part = (size - table[k]) / (table[k + 1] - table[k])
        held = levels[k] + part * (levels[k + 1] - levels[k])
        return math.copysign(held, x) + float(p["damping"]) * rate

    return torque


# --- what no catalogue has --------------------------------------------------------------------------------


def _telegraph(j: int, p: dict[str, Any], scale: Scale) -> Force:
    """An offset that is there, or not, and changes its mind at random: ``level``, mean ``dwell`` [s]."""
    rng = np.random.default_rng((scale.seed, 4242))
    waits = rng.exponential(p["dwell"], int(10 + 4 * scale.duration / p["dwell"]))
    ends = np.cumsum(waits)
    step = 0

    def act(now: Now) -> None:
        nonlocal step
        while ends[step] < now.t:
            step += 1
        now.motor[j] += p["level"] * (0.5 if step % 2 else -0.5)

    return act


def _by_acceleration(j: int, coefficient: float, scale: Scale) -> Force:
    """Dry friction in proportion to the size of the joint's acceleration."""
    width = width_of(scale, j, coefficient * 20)

    def act(now: Now) -> None:
        level = coefficient * abs(float(now.alpha[j]))
        now.rub(now.motor, j, float(now.w[j]), (level, level), width)

    return act
