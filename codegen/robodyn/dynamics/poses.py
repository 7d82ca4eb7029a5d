"""Where the tool and the links are, over any scalar, in few operations.

A rotation is multiplied up from the base, 18 operations a section. A place is a sum of offsets, and there
are two ways to add one to what lies further out: along the axes of the world, which the rotation has in any
case (a product and a sum for each of its numbers and each axis), or along the section's, nested as in
``R1 (p1 + R2 (p2 + ...))``, where the sum is carried on by 6 operations a section. Which takes fewer depends
on how many numbers of which offset are zero.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from robodyn.dynamics.functions.record import Dynamics
from robodyn.dynamics.sections import Axes, Placed, Section, along, placed_in, sections_of
from robodyn.dynamics.vectors import ZERO, Vector, named, plus


def placed(at: Dynamics) -> Placed:
    """The sections of the arm, along the world's axes."""
    sections = sections_of(at.arm, at.motion(at.rest, at.rest), at.turns(at.rest, at.rest))
    return placed_in(at.arm.base, sections, at.mark)


def tool_axes(at: Dynamics, arm: Placed) -> Axes:
    """The axes of the tool."""
    x, y, z = (along(arm.links[-1], axis) for axis in (at.arm.tool.x, at.arm.tool.y, at.arm.tool.z))
    return x, y, z


def tool_place(at: Dynamics, arm: Placed) -> Vector:
    """The tool's origin [m]."""
    ways = [_summed(at, arm, turned) for turned in _where_to_turn(len(arm.sections))]
    x, y, z = at.cheapest(ways)
    return named(at.mark, (x, y, z), len(arm.links), "p")


def _where_to_turn(count: int) -> Iterator[Collection[int]]:
    """Sections at which the sum of what lies further out is turned into the world at once: all from one on,
    or one."""
    yield from (range(k, count) for k in range(1, count + 1))
    yield from ((k,) for k in range(1, count - 1))


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


def rows_of(axes: Axes) -> list[Vector]:
    """The rotation whose columns are ``axes``, row by row."""
    return list(zip(*axes, strict=True))


def flat(rows: Sequence[Sequence[object]]) -> list[object]:
    """Rows one after another."""
    return [x for row in rows for x in row]
