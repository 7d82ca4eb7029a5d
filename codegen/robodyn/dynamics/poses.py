"""Where the tool and the links are, over any scalar, in few operations.

A rotation is multiplied up from the base, 18 operations a section; or two of its rows are, 12 a section, and
the third is made of them in the end (:mod:`~robodyn.dynamics.sections`). A place is a sum of offsets, and
there are two ways to add one to what lies further out: along the axes of the world, which the rotation has in
any case (a product and a sum for each of its numbers and each axis), or along the section's, nested as in
``R1 (p1 + R2 (p2 + ...))``, where the sum is carried on by 6 operations a section. Which takes fewer depends
on how many numbers of which offset are zero.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from robodyn.dynamics.limits import SECTIONS_TRIED
from robodyn.dynamics.sections import (
    ROWS,
    Axes,
    Placed,
    Row,
    Section,
    along,
    grounded,
    placed_in,
    placed_in_tool,
    sections_of,
    tried,
    with_cofactor,
)
from robodyn.dynamics.state import Dynamics
from robodyn.dynamics.vectors import ZERO, Vector, flat, named, plus
from robodyn.effects.scalars import is_zero


def sections(at: Dynamics) -> list[Section]:
    """The sections of the arm at rest."""
    return sections_of(at.arm, at.motion(at.rest, at.rest), at.turns(at.rest, at.rest))


def placed(at: Dynamics, row: Row = None) -> Placed:
    """The sections of the arm, along the world's axes, ``row`` of the components made of the others."""
    return placed_in(*grounded(at.arm.base, sections(at)), at.mark, row)


def seen_from_tool(at: Dynamics, row: Row = None) -> Placed:
    """The same, along the tool's axes."""
    return placed_in_tool(at.arm.tool, sections(at), at.mark, row)


def pose(at: Dynamics) -> Sequence[Any]:
    """The tool's frame, ``[R p]`` row by row."""
    return at.cheapest.apart([partial(_pose, at, row) for row in ROWS])


def _pose(at: Dynamics, row: Row) -> list[Any]:
    arm = placed(at, row)
    rotation = rows_of(_tool_axes(at, arm, row))
    return flat([(*axis, p) for axis, p in zip(rotation, tool_place(at, arm), strict=True)])


def _tool_axes(at: Dynamics, arm: Placed, row: Row) -> Axes:
    """The axes of the tool; one that is turned about the last joint's axis only may turn with the joint."""
    tool, last = at.arm.tool, arm.sections[-1].last
    ways = [_along_each(arm.links[last.link], (tool.x, tool.y, tool.z), row)]
    if is_zero(tool.z[0]) and is_zero(tool.z[1]):
        c, s = tool.x[0], tool.x[1]
        joined = replace(last, c=c * last.c - s * last.s, s=s * last.c + c * last.s)
        flip = ((1, 0, 0), (0, tool.z[2], 0), tool.z)
        ways.append(_along_each(joined.outward(arm.axes[-1]), flip, row))
    (chosen,) = at.cheapest([[flat(axes) for axes in ways]])
    x, y, z = ((chosen[k], chosen[k + 1], chosen[k + 2]) for k in (0, 3, 6))
    return x, y, z


def _along_each(axes: Axes, vectors: Axes, row: Row) -> Axes:
    """Unit ``vectors`` of the ``axes`` along those that they are along, ``row`` of the components made of the
    others where a vector has several."""
    x, y, z = new = along(axes, vectors[0]), along(axes, vectors[1]), along(axes, vectors[2])
    if row is not None:
        x, y, z = (
            with_cofactor(new, k, row) if sum(not is_zero(c) for c in u) > 1 else new[k]
            for k, u in enumerate(vectors)
        )
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
