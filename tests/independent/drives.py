"""What stands between motors and links: the formulas of docs/effects.md, in the order of the page."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca
from scipy.interpolate import PchipInterpolator

if TYPE_CHECKING:
    from independent.reference import SX, Reference

Entry = dict[str, Any]


@dataclass(frozen=True)
class Entries:
    """Effects of an arm: of its links (from 0), and of the whole robot (None)."""

    all: tuple[tuple[int | None, Entry], ...]

    def of(self, effect: str, link: int | None) -> list[Entry]:
        return [entry for where, entry in self.all if where == link and entry["effect"] == effect]


def entries(arm: Mapping[str, Any]) -> Entries:
    """All entries, the shorthand ``friction`` among them."""
    every: list[tuple[int | None, Entry]] = [(None, entry) for entry in arm.get("effects", ())]
    for k, link in enumerate(arm["links"]):
        friction = link.get("friction", {})
        if "viscous" in friction:
            every.append((k, {"effect": "viscous_friction", "coefficient": friction["viscous"]}))
        if "coulomb" in friction:
            every.append((k, {"effect": "coulomb_friction", "level": friction["coulomb"]}))
        every += [(k, entry) for entry in link.get("effects", ())]
    return Entries(tuple(every))


def direction(arm: Mapping[str, Any], speed: SX) -> SX:
    """Sgn of a speed, as ``friction_at_rest`` has it."""
    rest = arm.get("friction_at_rest", "exact")
    if rest == "exact":
        return ca.sign(speed)
    if "smooth" in rest:
        return ca.tanh(speed / rest["smooth"]["velocity"])
    return ca.if_else(ca.fabs(speed) < rest["dead_band"]["velocity"], 0, ca.sign(speed))


def torques(arm: Reference) -> SX:
    """Of each joint: what its motor gives, or behind the gear what the link takes."""
    found = []
    for k in range(arm.n):
        torque = arm.of_links[k] + springs(arm, k)
        torque += bearings(arm, k, torque)
        if arm.motor_side:
            torque = losses(arm, k, torque) + arm.of_motors[k] + friction(arm, k)
        found.append(torque)
    return ca.vertcat(*found)


def springs(arm: Reference, k: int) -> SX:
    """On the link's side."""
    total = ca.SX(0)
    for entry in arm.effects.of("spring", k):
        way = arm.q[k] - entry.get("rest", 0)
        total += entry["stiffness"] * way + entry.get("cubic", 0) * way**3
    for entry in arm.effects.of("gas_spring", k):
        angle, ratio = arm.q[k] - entry.get("dead_center", 0), entry.get("ratio", 0.25)
        length = ca.sqrt(1 + ratio**2 - 2 * ratio * ca.cos(angle))
        travel = 2 * (1 - ca.cos(angle)) / (length + 1 - ratio)
        total += entry["torque"] * (1 + entry.get("rise", 0) * travel) * ca.sin(angle) / length
    return total


def bearings(arm: Reference, k: int, torque: SX) -> SX:
    """Under the reactions of the links, and the torque of what comes before."""
    total = ca.SX(0)
    for entry in arm.effects.of("load_dependent_friction", k):
        (fx, fy, fz), (nx, ny, _) = (ca.vertsplit(x) for x in arm.reactions[k])
        kind = entry["bearing"]
        if kind == "journal" and "span" not in entry:
            kind = "radial"
        share = entry.get("mu_r", entry.get("mu", 0) * entry.get("radius", 1))
        half = entry.get("span", 0) / 2
        if kind == "journal" and entry.get("variant") == "printed":
            load = ca.hypot(half * fx + ny, half * fy + nx) + ca.hypot(half * fx - ny, half * fy - nx)
            load /= 2 * half
        elif kind == "journal":
            load = ca.hypot(half * fx + ny, half * fy - nx) + ca.hypot(half * fx - ny, half * fy + nx)
            load /= 2 * half
        elif kind == "linear":
            sides = (half * fx - ny, half * fx + ny, half * fy - nx, half * fy + nx)
            load, share = sum(ca.fabs(x) for x in sides) / (2 * half), entry["mu"]
        elif kind == "thrust":
            load = ca.fabs(fz)
        elif kind == "radial":
            load = ca.hypot(fx, fy)
        else:
            load, share = ca.fabs(torque), entry["mu"]
        total += share * load * direction(arm.arm, arm.qd[k])
    return total


def losses(arm: Reference, k: int, torque: SX) -> SX:
    """What the gear takes, on the torque that it transmits."""
    for entry in arm.effects.of("transmission_loss", k):
        s = direction(arm.arm, arm.qd[k])
        good = entry.get("efficiency", 1)
        if isinstance(good, list):
            good = efficiency(
                good, entry.get("interpolation", "linear"), ca.fabs(torque) / entry["rated_torque"]
            )
        lost = ca.if_else(torque * s >= 0, 1 / good - 1, good - 1) * torque * ca.fabs(s)
        torque = torque + lost + entry.get("breakaway", 0) * s
    return torque


def efficiency(knots: list[list[float]], interpolation: str, load: SX) -> SX:
    """Through the knots, by straight lines or Fritsch and Carlson's monotone cubic; level beyond them."""
    x, y = [a for a, _ in knots], [b for _, b in knots]
    ends = PchipInterpolator(x, y).derivative()(x).tolist()
    value = ca.SX(y[0])
    for k in range(len(x) - 1):
        u, width = load - x[k], x[k + 1] - x[k]
        rise = (y[k + 1] - y[k]) / width
        if interpolation == "linear":
            part = y[k] + rise * u
        else:
            c = (3 * rise - 2 * ends[k] - ends[k + 1]) / width
            d = (ends[k] + ends[k + 1] - 2 * rise) / width**2
            part = y[k] + u * (ends[k] + u * (c + u * d))
        value = ca.if_else(load >= x[k], part, value)
    return ca.if_else(load >= x[-1], y[-1], value)


def friction(arm: Reference, k: int) -> SX:
    """On the motor's side: friction and ripple, and friction of motors that drive two joints."""
    q, qd = arm.q[k], arm.qd[k]
    s = direction(arm.arm, qd)
    of = arm.effects.of
    total = sum((x["coefficient"] * qd for x in of("viscous_friction", k)), ca.SX(0))
    total += sum(x["level"] * s for x in of("coulomb_friction", k))
    total += sum(x["level"] * s for x in of("presliding_hysteresis", k))  # in steady motion
    for entry in of("asymmetric_friction", k):
        total += ca.if_else(qd >= 0, entry["positive"], entry["negative"]) * s
    for entry in of("stribeck_friction", k):
        fading = ca.exp(-((ca.fabs(qd) / entry["velocity"]) ** entry.get("exponent", 2)))
        total += (entry["level"] + (entry["static"] - entry["level"]) * fading) * s
    for entry in of("power_law_friction", k):
        speed = qd / entry.get("velocity", 1)
        total += entry["level"] * speed * (speed**2 + 1e-6) ** ((entry.get("exponent", 0.5) - 1) / 2)
    for entry in of("torque_ripple", k):
        total += entry["amplitude"] * ca.sin(entry["cycles_per_rev"] * q + entry.get("phase", 0))
    for j in range(arm.n):
        for entry in of("motor_coupling", j):
            other, ratio = entry["with"] - 1, entry.get("ratio", 1)
            share = (j == k) + (other == k) * ratio
            turns = arm.qd[j] + ratio * arm.qd[other]
            drag = entry.get("viscous", 0) * turns + entry.get("coulomb", 0) * direction(arm.arm, turns)
            total += share * drag
    return total
