"""What gravity does to an arm, from first moments of mass about the frames' origins; any scalar.

Potential energy and the torques at rest are linear in masses times gravity. Where both are numbers they are
multiplied once and for all (:func:`weighed`), and a component of gravity is 1 and costs nothing.

Source: Craig, Introduction to Robotics, 6.73 (potential energy); its derivative by a joint's position is the
moment of what the joint carries.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

from robodyn.dynamics.arm import about_x, about_z, origin
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.state import Dynamics, Moving
from robodyn.dynamics.vectors import ZERO, Mark, Vector, dot, named, plus, scaled, unmarked
from robodyn.ir.program import Label


def weighed(at: Moving) -> Moving:
    """The same where gravity is concerned: gravity in units of its largest component, all masses multiplied
    by that; unchanged where one of these numbers is known at run time only."""
    exact = [x for lump in (*at.lumps, at.ground) for x in (lump.mass, *lump.first)]
    if not all(isinstance(x, int | Fraction) for x in (*exact, *at.arm.gravity)) or not any(at.arm.gravity):
        return at
    unit = Fraction(max(map(abs, at.arm.gravity)))
    gx, gy, gz = (_exact(x / unit) for x in at.arm.gravity)
    return replace(
        at,
        arm=replace(at.arm, gravity=(gx, gy, gz)),
        lumps=[_times(lump, unit) for lump in at.lumps],
        ground=_times(at.ground, unit),
        weighed=True,
    )


def _times(lump: Lump, unit: Fraction) -> Lump:
    x, y, z = (_exact(h * unit) for h in lump.first)
    return replace(lump, mass=_exact(lump.mass * unit), first=(x, y, z))


def _exact(x: Fraction) -> Fraction | int:
    return x.numerator if x.denominator == 1 else x


# --- potential energy -------------------------------------------------------------------------------------


def potential_outward(at: Moving, mark: Mark = unmarked) -> Any:
    """Potential energy [J], that of the base's origin 0: gravity carried from base to tip."""
    arm, turns = at.arm, at.turns
    height: Any = 0  # of the frame's origin: -g . position
    own = start = arm.gravity
    total: Any = -dot(own, at.ground.first)
    for i, (body, lump) in enumerate(zip(arm.bodies, at.lumps, strict=True)):
        p = origin(body, at.motion.d[i])
        if turns.follows[i]:
            height = height - dot(start, about_z(turns.c[i - 1], turns.s[i - 1], p))
        else:
            height, start = height - dot(own, p), own
        start = about_x(body.cos_alpha, -body.sin_alpha, start)
        own = about_z(turns.c[i], -turns.s[i], start)
        total = mark(total + (lump.mass * height - dot(own, lump.first)), Label(i + 1, "pe", ""))
    return total


def potential_inward(at: Moving, mark: Mark = unmarked) -> Any:
    """The same, the first moment of what each joint carries gathered from tip to base."""
    arm = at.arm
    first, mass = moments(at, mark)[0].start, sum(lump.mass for lump in at.lumps)
    body = arm.bodies[0]
    first = about_x(body.cos_alpha, body.sin_alpha, first)
    whole = plus(first, scaled(mass, origin(body, at.motion.d[0])), at.ground.first)
    return -dot(arm.gravity, whole)


# --- torques at rest --------------------------------------------------------------------------------------


class Moment(NamedTuple):
    """The first moment [kg m] of all that a joint carries about the link's origin, along the axes that its
    turn starts from, and along the link's ``own``: None where a parallel joint follows. Their ``mass``."""

    start: Vector
    own: Vector | None
    mass: Any


def moments(at: Moving, mark: Mark = unmarked) -> list[Moment]:
    """Of all joints [n], gathered from tip to base."""
    arm, turns = at.arm, at.turns
    result: list[Moment] = []
    for i in reversed(range(len(arm.bodies))):
        inner, outer, mass = at.lumps[i].first, ZERO, at.lumps[i].mass
        follows = bool(result) and turns.follows[i + 1]
        if result:
            child, beyond = arm.bodies[i + 1], result[-1]
            p = scaled(beyond.mass, origin(child, at.motion.d[i + 1]))
            turned = about_x(child.cos_alpha, child.sin_alpha, beyond.start)
            if follows:
                outer = plus(turned, about_z(turns.c[i], turns.s[i], p))
            else:
                inner = plus(inner, turned, p)
            mass = mass + beyond.mass
        start = plus(about_z(turns.c[i], turns.s[i], inner), outer)
        start = named(mark, start, i + 1, "hw" if at.weighed else "hc")
        result.append(Moment(start, None if follows else inner, mass))
    return result[::-1]


def holding_torques(at: Dynamics, links: Moving) -> list[Any]:
    """Torques [n] (N m; N at prismatic joints) that hold the links at rest, without what drives do: of each
    joint the moment of gravity, along the axes in which that takes fewer operations."""
    arm, turns = links.arm, links.turns
    choices: list[list[list[Any]]] = []
    own = start = arm.gravity
    for i, (body, moment) in enumerate(zip(arm.bodies, moments(links, at.mark), strict=True)):
        start = about_x(body.cos_alpha, -body.sin_alpha, start if turns.follows[i] else own)
        own = about_z(turns.c[i], -turns.s[i], start)
        if not body.revolute:
            choices.append([[-moment.mass * start[2]]])
            continue
        ways = [(moment.start, start)] if moment.own is None else [(moment.start, start), (moment.own, own)]
        choices.append([[h[1] * g[0] - h[0] * g[1]] for h, g in ways])
    return [at.mark(torque, Label(i, "tau", "")) for i, (torque,) in enumerate(at.cheapest(choices), 1)]
