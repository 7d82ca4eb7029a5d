"""How the tool is accelerated while no joint is: the rate of the Jacobian times the joints' rates, over any
scalar, in few operations.

From the tip to the base, place, velocity, acceleration and turning of the tool relative to the carrier of a
section are those relative to its last link, turned, and what the section's own rate adds (Craig, 5.6, and 6.2
for accelerations). All is zero or constant at the tip, and what comes out at the base is along its axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from robodyn.dynamics.arm import about_z
from robodyn.dynamics.sections import Section, Step, along, grounded, sections_of
from robodyn.dynamics.state import Dynamics
from robodyn.dynamics.vectors import ZERO, Vector, named, plus


@dataclass(frozen=True, slots=True)
class Relative:
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
    tool = Relative(ZERO, ZERO, ZERO, ZERO, ZERO)
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
    at: Dynamics, section: Section, rates: Sequence[Any], tool: Relative, *, early: bool
) -> Relative:
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
    return Relative(
        *(named(at.mark, section.untwisted(u), link, name) for u, name in zip(moved, names, strict=True))
    )


def _turned(step: Step, rate: Any, tool: Relative) -> Relative:
    """The tool relative to the section's axes: turned, and what the link's ``rate`` adds."""
    c, s = step.c, step.s
    place, carried, spin = (about_z(c, s, u) for u in (tool.place, tool.velocity, tool.spin))
    velocity = plus(carried, _spun(rate, place))
    acceleration = plus(about_z(c, s, tool.acceleration), _spun(rate, plus(carried, velocity)))
    spin_rate = plus(about_z(c, s, tool.spin_rate), _spun(rate, spin))
    moved = (place, velocity, acceleration, plus(spin, (0, 0, rate)), spin_rate)
    return Relative(*(_flipped(step, u) for u in moved))


def _turned_early(step: Step, rate: Any, tool: Relative) -> Relative:
    """The same, what the rate adds being turned as well."""
    velocity = plus(tool.velocity, _spun(rate, tool.place))
    acceleration = plus(tool.acceleration, _spun(rate, plus(tool.velocity, velocity)))
    spin_rate = plus(tool.spin_rate, _spun(rate, tool.spin))
    moved = (tool.place, velocity, acceleration, plus(tool.spin, (0, 0, rate)), spin_rate)
    return Relative(*(step.turned(u) for u in moved))


def _spun(rate: Any, u: Vector) -> Vector:
    """``rate z x u``."""
    return -(rate * u[1]), rate * u[0], 0


def _flipped(step: Step, u: Vector) -> Vector:
    return u[0], step.way * u[1], step.way * u[2]
