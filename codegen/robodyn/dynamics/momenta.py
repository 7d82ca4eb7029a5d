"""Velocities, kinetic energy and momentum of an arm, from moments of mass about its frames' origins; any
scalar.

Everything is linear or quadratic in the rates, so no acceleration is formed. A link has two sets of axes: its
own, and those in which its joint, or the chain of parallel joints that it follows, begins to turn.

Sources: Featherstone 2008, sections 2.10 and 5.1 (spatial momentum, and its rate); for the derivative by the
positions De Luca, Albu-Schaeffer, Haddadin, Hirzinger 2006, whose observer needs it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from robodyn.dynamics.arm import about_x, about_z, origin
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.state import Moving, Posture, Rotor
from robodyn.dynamics.vectors import HALF, ZERO, Mark, Pair, Vector, cross, dot, named, plus, scaled, unmarked
from robodyn.effects.scalars import is_zero
from robodyn.ir.program import Label


class Twist(NamedTuple):
    """Velocities of a link [rad/s, m/s]: its own ``w`` and its origin's ``v`` along its own axes; along those
    in which it begins to turn ``start_w``, ``start_v`` and the angular velocity ``carrier`` of what carries
    the joint, or its chain."""

    w: Vector
    v: Vector
    start_w: Vector
    start_v: Vector
    carrier: Vector


def twists(at: Posture, mark: Mark = unmarked) -> list[Twist]:
    """Velocities of the links [n]."""
    arm, motion, turns = at.arm, at.motion, at.turns
    links: list[Twist] = []
    for i, body in enumerate(arm.bodies):
        c, s = turns.c[i], turns.s[i]
        w = v = ZERO
        if i:
            before, p = links[-1], origin(body, motion.d[i])
            if turns.follows[i]:
                reach = about_z(turns.c[i - 1], turns.s[i - 1], p)
                w, v = before.carrier, plus(before.start_v, cross(before.start_w, reach))
            else:
                w, v = before.w, plus(before.v, cross(before.w, p))
        carrier, v = (about_x(body.cos_alpha, -body.sin_alpha, u) for u in (w, v))
        w = carrier
        if body.revolute:
            w = plus(w, (0, 0, turns.rate[i]))
        else:
            v = plus(v, (0, 0, motion.qd[i]))
        own_w = named(mark, about_z(c, -s, w), i + 1, "w")
        links.append(Twist(own_w, named(mark, about_z(c, -s, v), i + 1, "vo"), w, v, carrier))
    return links


def kinetic_energy(at: Moving, rotors: Sequence[Rotor], mark: Mark = unmarked) -> Any:
    """Kinetic energy [J] of the links and ``rotors``."""
    total: Any = 0
    for rotor in rotors:
        rate = rotor.rate(at.motion.qd)
        total = total + HALF * rotor.inertia * (rate * rate)
    for i, (lump, twist) in enumerate(zip(at.lumps, twists(at, mark), strict=True), 1):
        (x, y, z), v, (hx, hy, hz), j = twist.w, twist.v, lump.first, lump.inertia()
        # w . (J w / 2 + h x v) + m v . v / 2
        total = total + HALF * j.zz * (z * z)
        total = total + x * (HALF * j.xx * x + j.xy * y + j.xz * z) + y * (HALF * j.yy * y + j.yz * z)
        total = total + hx * (v[1] * z - v[2] * y) + hy * (v[2] * x - v[0] * z) + hz * (v[0] * y - v[1] * x)
        if not is_zero(lump.mass):
            total = total + HALF * lump.mass * dot(v, v)
        total = mark(total, Label(i, "ke", ""))
    return total


def momenta(at: Moving, rotors: Sequence[Rotor], mark: Mark = unmarked) -> tuple[list[Any], list[Any]]:
    """``M qd`` [n], and the kinetic energy's derivatives [n] by the joint positions at fixed rates.

    A joint turns all that it carries along: at a unit of its position, their velocities, seen from where they
    are, change by those of the carrier crossed with the joint's axis, and the energy by that times their
    momentum.
    """
    arm = at.arm
    links = twists(at, mark)
    own = [_momentum(lump, twist) for lump, twist in zip(at.lumps, links, strict=True)]
    carried = gathered(at, own, mark, ("pl", "pa"))
    momentum: list[Any] = []
    slope: list[Any] = []
    for body, twist, (linear, angular) in zip(arm.bodies, links, carried, strict=True):
        (wx, wy, _), (vx, vy, _) = twist.start_w, twist.start_v
        if body.revolute:
            momentum.append(angular[2])
            slope.append((angular[0] * wy - angular[1] * wx) + (linear[0] * vy - linear[1] * vx))
        else:
            momentum.append(linear[2])
            slope.append(linear[0] * wy - linear[1] * wx)
    for rotor in rotors:
        for joint, ratio in rotor.rates:
            momentum[joint] = momentum[joint] + ratio * (rotor.inertia * rotor.rate(at.motion.qd))
    return momentum, slope


def gathered(
    at: Posture, own: Sequence[Pair], mark: Mark = unmarked, names: tuple[str, str] = ("f0", "n0")
) -> list[Pair]:
    """For each joint [n] the sum over all that it carries of a vector and its moment (of momentum, of force),
    along the axes in which the joint begins to turn. ``own`` are the links', along their own axes; emitted
    code calls the sums ``names``."""
    arm, motion, turns, n = at.arm, at.motion, at.turns, len(at.arm.bodies)
    sums: list[Pair] = [(ZERO, ZERO)] * n
    for i in reversed(range(n)):
        c, s = turns.c[i], turns.s[i]
        inner, inner_n = own[i]
        outer, outer_n = ZERO, ZERO
        if i + 1 < n:
            child = arm.bodies[i + 1]
            f, moment = (about_x(child.cos_alpha, child.sin_alpha, u) for u in sums[i + 1])
            p = origin(child, motion.d[i + 1])
            if turns.follows[i + 1]:
                outer, outer_n = f, plus(moment, cross(about_z(c, s, p), f))
            else:
                inner, inner_n = plus(inner, f), plus(inner_n, moment, cross(p, f))
        linear = named(mark, plus(about_z(c, s, inner), outer), i + 1, names[0])
        angular = named(mark, plus(about_z(c, s, inner_n), outer_n), i + 1, names[1])
        sums[i] = linear, angular
    return sums


def _momentum(lump: Lump, twist: Twist) -> Pair:
    """Linear momentum of a link [kg m/s], and angular about its frame's origin [kg m^2/s]."""
    linear = plus(scaled(lump.mass, twist.v), cross(twist.w, lump.first))
    return linear, plus(lump.inertia().times(twist.w), cross(lump.first, twist.v))
