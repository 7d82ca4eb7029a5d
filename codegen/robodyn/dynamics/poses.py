"""Where the tool and the links are, over any scalar, in few operations.

A rotation is multiplied up from the base, 18 operations a section. A place is a sum of offsets, and there
are two ways to add one to what lies further out: along the axes of the world, which the rotation has in any
case (a product and a sum for each of its numbers and each axis), or along the section's, nested as in
``R1 (p1 + R2 (p2 + ...))``, where the sum is carried on by 6 operations a section. Which takes fewer depends
on how many numbers of which offset are zero.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import Any

from robodyn.dynamics.functions.record import Dynamics
from robodyn.dynamics.limits import SECTIONS_TRIED
from robodyn.dynamics.sections import Axes, Placed, Section, along, grounded, placed_in, sections_of, tried
from robodyn.dynamics.vectors import ZERO, Vector, named, plus
from robodyn.effects.scalars import is_zero


def sections(at: Dynamics) -> list[Section]:
    """The sections of the arm at rest."""
    return sections_of(at.arm, at.motion(at.rest, at.rest), at.turns(at.rest, at.rest))


def placed(at: Dynamics) -> Placed:
    """The sections of the arm, along the world's axes."""
    return placed_in(*grounded(at.arm.base, sections(at)), at.mark)


def tool_axes(at: Dynamics, arm: Placed) -> Axes:
    """The axes of the tool; one that is turned about the last joint's axis only may turn with the joint."""
    tool, last = at.arm.tool, arm.sections[-1].last
    ways = [_along_each(arm.links[last.link], (tool.x, tool.y, tool.z))]
    if is_zero(tool.z[0]) and is_zero(tool.z[1]):
        c, s = tool.x[0], tool.x[1]
        joined = replace(last, c=c * last.c - s * last.s, s=s * last.c + c * last.s)
        flip = ((1, 0, 0), (0, tool.z[2], 0), tool.z)
        ways.append(_along_each(joined.outward(arm.axes[-1]), flip))
    (chosen,) = at.cheapest([[flat(axes) for axes in ways]])
    x, y, z = ((chosen[k], chosen[k + 1], chosen[k + 2]) for k in (0, 3, 6))
    return x, y, z


def _along_each(axes: Axes, vectors: Axes) -> Axes:
    x, y, z = (along(axes, u) for u in vectors)
    return x, y, z


def tool_place(at: Dynamics, arm: Placed) -> Vector:
    """The tool's origin [m]."""
    ways = [_summed(at, arm, turned) for turned in _where_to_turn(len(arm.sections))]
    ((x, y, z),) = at.cheapest([ways])
    return named(at.mark, (x, y, z), len(arm.links), "p")


def _where_to_turn(count: int) -> Iterator[Collection[int]]:
    """Sections at which the sum of what lies further out is turned into the world at once: all from one on,
    or one."""
    yield from (range(k, count) for k in tried(range(1, count + 1)))
    yield from ((k,) for k in tried(range(1, count - 1)))


def _summed(at: Dynamics, arm: Placed, turned: Collection[int]) -> Vector:
    """The tool's origin, with the sum turned into the world at the sections ``turned``."""
    beyond: Vector = ZERO
    terms = []
    for k in reversed(range(len(arm.sections))):
        section = arm.sections[k]
        beyond = plus(_from_carrier(section, beyond), section.offset)
        if k in turned:
            terms.append(along(arm.axes[k], beyond))
            beyond = ZERO
        elif k == 0:
            terms.append(along(arm.axes[0], beyond))
        beyond = section.untwisted(beyond)
    return plus(at.arm.base.origin, *reversed(terms))


def _from_carrier(section: Section, beyond: Vector) -> Vector:
    """From the section's first origin to what lies ``beyond`` its last link's along that link's axes [m]."""
    *inner, last = section.steps
    total = last.turned(plus(last.reach, beyond))
    for step in reversed(inner):
        total = plus(step.turned(step.reach), total)
    return total


def link_places(at: Dynamics, arm: Placed) -> list[Vector]:
    """The origins of the links [m]."""
    places: list[Vector] = []
    starts: list[Vector] = []  # of the sections: origins of the links that carry them
    before = at.arm.base.origin
    for k, section in enumerate(arm.sections):
        starts.append(before)
        for step in section.steps:
            ways = [
                plus(starts[j], along(arm.axes[j], _to_link(arm.sections[j : k + 1], step.link)))
                for j in range(k, max(-1, k - SECTIONS_TRIED), -1)
            ]
            if step.link in arm.links and step is not section.steps[0]:
                reach = section.steps[step.link - section.steps[0].link - 1].reach
                ways.append(plus(before, along(arm.links[step.link - 1], reach)))
            ((x, y, z),) = at.cheapest([ways])
            before = named(at.mark, (x, y, z), step.link + 1, "p")
            places.append(before)
    return places


def _to_link(sections: Sequence[Section], link: int) -> Vector:
    """From what carries the first of ``sections`` to the origin of ``link`` in the last [m], along the axes
    of the first."""
    beyond: Vector = ZERO
    for section in reversed(sections):
        total: Vector = ZERO
        for step in reversed(section.steps):
            if step.link < link and step is not section.last:
                total = plus(step.turned(step.reach), total)
        if section is not sections[-1]:
            total = plus(total, section.last.turned(beyond))
        beyond = plus(section.offset, total)
        beyond = section.untwisted(beyond) if section is not sections[0] else beyond
    return beyond


def rows_of(axes: Axes) -> list[Vector]:
    """The rotation whose columns are ``axes``, row by row."""
    return list(zip(*axes, strict=True))


def flat(rows: Sequence[Sequence[Any]]) -> list[Any]:
    """Rows one after another."""
    return [x for row in rows for x in row]
