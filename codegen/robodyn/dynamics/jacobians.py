"""Geometric Jacobian of the tool's origin, what its rate gives, and joint torques of a wrench on the tool,
over any scalar, in few operations.

Column j is ``z x r`` and ``z``: the joint's axis, and the lever ``r`` from its frame's origin to the tool. A
lever may be nested from the tip, along the axes of the section or link that it begins in, where the cross
product is only a swap; the two axes across the joint's, seen from the frame that is asked for, turn it there.
Or it is put together in that frame, out of offsets along axes that are there in any case, and multiplied by
the joint's axis. An axis is multiplied up with its section's, or turned there from a section nearby, along
whose axes it has zeros. Which takes fewer operations depends on the arm, and is counted.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NamedTuple

from robodyn.dynamics.arm import about_z, into_child, origin
from robodyn.dynamics.limits import SECTIONS_TRIED
from robodyn.dynamics.poses import placed, tool_place
from robodyn.dynamics.sections import ROWS, Placed, Row, Section, Step, along, grounded, sections_of, tried
from robodyn.dynamics.state import Dynamics
from robodyn.dynamics.vectors import ZERO, Vector, cross, dot, minus, named, plus, scaled

#: What is tried: a row of the axes that is made of the others, and from how many sections nearby directions
#: are written; with levers put together anywhere, and with nested ones. Other combinations have not paid.
_ANYWHERE: tuple[tuple[Row, int], ...] = (*((row, 0) for row in ROWS), (0, 3))
_NESTED: tuple[tuple[Row, int], ...] = ((None, 0), (None, 3))
_OF_LONG_ARMS: tuple[tuple[Row, int], ...] = ((None, 0), (0, 0))

#: Velocity of the tool's origin, and angular velocity, at a unit rate of a joint.
Column = tuple[Vector, Vector]


class Lever(NamedTuple):
    """From a link's origin to the tool's [m], along the axes of its section and, where it is the last one of
    that, along its own."""

    in_section: Vector
    own: Vector | None


def levers(sections: Sequence[Section]) -> list[Lever]:
    """The levers of all links, nested from the tip."""
    result: list[Lever] = []
    beyond: Vector = ZERO
    for section in reversed(sections):
        *inner, last = section.steps
        own = plus(last.reach, beyond)
        lever = last.turned(own)
        result.append(Lever(lever, own))
        for step in reversed(inner):
            lever = plus(step.turned(step.reach), lever)
            result.append(Lever(lever, None))
        beyond = section.untwisted(plus(section.offset, lever))
    return result[::-1]


def levers_outside(arm: Placed, nested: Sequence[Lever], first: int) -> list[Vector]:
    """The levers of all links along the axes that ``arm`` is placed along: nested in the sections from number
    ``first`` on, turned there by the axes of that section, and put together there before it."""
    result: list[Vector] = []
    beyond: Vector = ZERO
    for k in reversed(range(len(arm.sections))):
        section, axes = arm.sections[k], arm.axes[k]
        if k >= first:
            result += [along(axes, nested[step.link].in_section) for step in reversed(section.steps)]
            start = nested[section.steps[0].link].in_section
            beyond = along(axes, plus(section.offset, start))
            continue
        inside = section.last.turned(section.last.reach)
        for step in reversed(section.steps):
            if step is not section.last:
                inside = plus(step.turned(step.reach), inside)
            result.append(plus(along(axes, inside), beyond))
        beyond = plus(along(axes, plus(section.offset, inside)), beyond)
    return result[::-1]


def columns(
    at: Dynamics, place: Callable[[Dynamics, Row], Placed] = placed, *, nested_only: bool = False
) -> list[Column]:
    """The columns [n] of the Jacobian along the axes that ``place`` places the arm along, a row of their
    components made of the others where that suits; with ``nested_only`` no lever is put together there."""

    def written(row: Row, nearby: int) -> list[Any]:
        both = _columns(at, place(at, row), nearby, nested_only=nested_only)
        return [x for v, w in both for x in (*v, *w)]

    ways = _NESTED if nested_only else _ANYWHERE
    if len(at.arm.bodies) > SECTIONS_TRIED:
        ways = _OF_LONG_ARMS
    values = at.cheapest.apart([partial(written, row, nearby) for row, nearby in ways])
    vectors = [(values[k], values[k + 1], values[k + 2]) for k in range(0, len(values), 3)]
    return list(zip(vectors[::2], vectors[1::2], strict=True))


def _columns(at: Dynamics, arm: Placed, nearby: int, *, nested_only: bool) -> list[Column]:
    nested = levers(arm.sections)
    starts = () if nested_only else tried(range(len(arm.sections) + 1))
    outside = [levers_outside(arm, nested, k) for k in starts]
    choices: list[list[Vector]] = []
    angular: list[Vector] = []
    directions = at.cheapest([_directions(arm, k, nearby) for k in range(len(arm.sections))])
    for section, axes, (x, y, z) in zip(arm.sections, arm.axes, directions, strict=True):
        for step in section.steps:
            link, axis = step.link, scaled(step.way, (x, y, z))
            if not at.arm.bodies[link].revolute:
                choices.append([axis])
                angular.append(ZERO)
                continue
            lever = nested[link]
            ways = [_across(axes[0], axes[1], lever.in_section, step.way)]
            if lever.own is not None:
                ways.append(_across(arm.links[link][0], arm.links[link][1], lever.own, 1))
            ways += [cross(axis, far[link]) for far in outside]
            choices.append(ways)
            angular.append(axis)
    linear = at.cheapest(choices)
    marked = [named(at.mark, (x, y, z), i, "v") for i, (x, y, z) in enumerate(linear, 1)]
    return list(zip(marked, angular, strict=True))


def _directions(arm: Placed, k: int, nearby: int) -> list[Vector]:
    """Ways to write the direction of section number ``k``: its axis, and from so many sections ``nearby``,
    along whose axes it has few components that are not zero."""
    ways = [arm.axes[k][2]]
    direction: Vector = (0, 0, 1)
    for j in range(k - 1, max(-1, k - 1 - nearby), -1):
        direction = arm.sections[j].last.turned(arm.sections[j + 1].untwisted(direction))
        ways.append(along(arm.axes[j], direction))
    direction = (0, 0, 1)
    for j in range(k + 1, min(len(arm.sections), k + 1 + nearby)):
        direction = arm.sections[j].twisted(arm.sections[j - 1].last.turned_back(direction))
        ways.append(along(arm.axes[j], direction))
    return ways


def _across(x: Vector, y: Vector, lever: Vector, way: int) -> Vector:
    """``z x lever``, the lever along the axes ``x``, ``y`` (and ``z``, times ``way``)."""
    return plus(scaled(way * lever[0], y), scaled(-(way * lever[1]), x))


# --- the rate of the Jacobian ------------------------------------------------------------------------------
# From the tip to the base, place, velocity, acceleration and turning of the tool relative to the carrier of a
# section are those relative to its last link, turned, and what the section's own rate adds (Craig, 5.6, and
# 6.2 for accelerations). All is zero or constant at the tip; what comes out at the base is along its axes.


@dataclass(frozen=True, slots=True)
class _Relative:
    """The tool relative to a link, along axes that it carries: ``place`` [m], ``velocity`` and
    ``acceleration`` of its origin, ``spin`` and ``spin_rate`` of its axes [rad/s, rad/s^2]."""

    place: Vector
    velocity: Vector
    acceleration: Vector
    spin: Vector
    spin_rate: Vector


def tool_drift(at: Dynamics) -> list[Any]:
    """Acceleration of the tool's origin and angular acceleration [6] at zero joint accelerations, along the
    world's axes."""
    qd = at.inputs["qd"]
    motion, turns = at.motion(qd, at.rest), at.turns(qd, at.rest)
    base, sections = grounded(at.arm.base, sections_of(at.arm, motion, turns))
    tool = _Relative(ZERO, ZERO, ZERO, ZERO, ZERO)
    for section in sections[:0:-1]:
        tool = _relative_to_carrier(at, section, turns.rate, tool, early=False)
    ways = []
    for early in (False, True):  # what nobody asks for need not be turned
        last = _relative_to_carrier(at, sections[0], turns.rate, tool, early=early)
        accelerations = (along((base.x, base.y, base.z), u) for u in (last.acceleration, last.spin_rate))
        ways.append([x for u in accelerations for x in u])
    (result,) = at.cheapest([ways])
    return list(result)


def _relative_to_carrier(
    at: Dynamics, section: Section, rates: Sequence[Any], tool: _Relative, *, early: bool
) -> _Relative:
    """The tool relative to what carries the section, along its axes, from the same relative to the section's
    last link."""
    *inner, last = section.steps
    slides = not at.arm.bodies[last.link].revolute
    rate = 0 if slides else rates[last.link]
    tool = replace(tool, place=plus(last.reach, tool.place))
    tool = _turned_early(last, rate, tool) if early else _turned(last, rate, tool)
    place, velocity, acceleration = tool.place, tool.velocity, tool.acceleration
    for step in reversed(inner):
        arm = about_z(step.c, step.s, step.reach)
        speed = _spun(rates[step.link], arm)
        place = plus(_flipped(step, arm), place)
        velocity = plus(_flipped(step, speed), velocity)
        acceleration = plus(_flipped(step, _spun(rates[step.link], speed)), acceleration)
    place = plus(section.offset, place)
    if slides:
        velocity = plus(velocity, (0, 0, at.inputs["qd"][last.link]))
    moved = (place, velocity, acceleration, tool.spin, tool.spin_rate)
    link = section.steps[0].link + 1
    names = ("r", "vr", "ar", "wr", "alphar")
    return _Relative(
        *(named(at.mark, section.untwisted(u), link, name) for u, name in zip(moved, names, strict=True))
    )


def _turned(step: Step, rate: Any, tool: _Relative) -> _Relative:
    """The tool relative to the section's axes: turned, and what the link's ``rate`` adds."""
    c, s = step.c, step.s
    place, carried, spin = (about_z(c, s, u) for u in (tool.place, tool.velocity, tool.spin))
    velocity = plus(carried, _spun(rate, place))
    acceleration = plus(about_z(c, s, tool.acceleration), _spun(rate, plus(carried, velocity)))
    spin_rate = plus(about_z(c, s, tool.spin_rate), _spun(rate, spin))
    moved = (place, velocity, acceleration, plus(spin, (0, 0, rate)), spin_rate)
    return _Relative(*(_flipped(step, u) for u in moved))


def _turned_early(step: Step, rate: Any, tool: _Relative) -> _Relative:
    """The same, what the rate adds being turned as well."""
    velocity = plus(tool.velocity, _spun(rate, tool.place))
    acceleration = plus(tool.acceleration, _spun(rate, plus(tool.velocity, velocity)))
    spin_rate = plus(tool.spin_rate, _spun(rate, tool.spin))
    moved = (tool.place, velocity, acceleration, plus(tool.spin, (0, 0, rate)), spin_rate)
    return _Relative(*(step.turned(u) for u in moved))


def _spun(rate: Any, u: Vector) -> Vector:
    """``rate z x u``."""
    return -(rate * u[1]), rate * u[0], 0


def _flipped(step: Step, u: Vector) -> Vector:
    return u[0], step.way * u[1], step.way * u[2]


# --- joint torques of a wrench ------------------------------------------------------------------------------


def wrench_torques(at: Dynamics) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of the wrench on the tool, ``J^T w``: each column of the
    Jacobian times the wrench. Source: Craig, Introduction to Robotics, 5.9 (static forces)."""
    f, moment = _wrench(at)
    return [dot(v, f) + dot(w, moment) for v, w in columns(at)]


def wrench_torques_outward(at: Dynamics) -> list[Any]:
    """The same, force and moment about each origin turned from link to link, base to tip."""
    arm, (f, moment) = at.arm, _wrench(at)
    motion = at.motion(at.rest, at.rest)
    base = arm.base
    # About the base frame's origin, along its axes.
    lever = minus(tool_place(at, placed(at)), base.origin)
    moment = base.back(plus(moment, cross(lever, f)))
    f = base.back(f)
    torques = []
    for i, body in enumerate(arm.bodies):
        c, s = motion.c[i], motion.s[i]
        moment = into_child(body, c, s, plus(moment, cross(f, origin(body, motion.d[i]))))
        f = into_child(body, c, s, f)
        f, moment = named(at.mark, f, i + 1, "fw"), named(at.mark, moment, i + 1, "nw")
        torques.append(moment[2] if body.revolute else f[2])
    return torques


def _wrench(at: Dynamics) -> tuple[Vector, Vector]:
    """Force and moment at the tool's origin, along the world's axes."""
    fx, fy, fz, nx, ny, nz = at.inputs["w"]
    return (fx, fy, fz), (nx, ny, nz)
