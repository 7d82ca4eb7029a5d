"""An arm as sections between which axes change direction: what kinematics with few operations is written in.

A section is a joint with the parallel ones that follow it: its links turn about one direction, so that axes
need not turn from link to link (see :mod:`robodyn.dynamics.parallel`). An offset between sections is along
the axes behind the twist, where none of its numbers is multiplied by the twist's.

An entry of a rotation is its cofactor, two products of four others. So one row of the axes' components need
not be turned from section to section: what is asked for of it is made of the other two rows.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm, Motion, about_x, about_z, origin
from robodyn.dynamics.limits import SECTIONS_TRIED
from robodyn.dynamics.parallel import Turns
from robodyn.dynamics.vectors import BASE, ZERO, Frame, Mark, Vector, named, plus, scaled, unmarked
from robodyn.effects.scalars import is_zero

#: Three unit axes along those of another frame.
Axes = tuple[Vector, Vector, Vector]
#: Which components of axes (0 to 2) are made of the others; None: all are turned.
Row = int | None
#: What is tried. A row with many zeros is best turned; with axes at right angles one of these two has few.
ROWS: tuple[Row, ...] = (None, 0, 1)
SAME: Axes = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


@dataclass(frozen=True, slots=True)
class Step:
    """A link (from 0) in its section: the turn ``c, s`` of its frame about z from the section's axes, behind
    which its y and z axes are those times ``way`` (1, or -1 where its axis points against the section's);
    ``reach`` [m], along the link's axes, to the origin of the section's next link, or to the tool."""

    link: int
    c: Any
    s: Any
    way: int
    reach: Vector

    def outward(self, axes: Axes) -> Axes:
        """The link's axes from those of its section."""
        x, y, z = axes
        y, z = (scaled(self.way, u) for u in (y, z))
        return plus(scaled(self.c, x), scaled(self.s, y)), plus(scaled(self.c, y), scaled(-self.s, x)), z

    def inward(self, axes: Axes) -> Axes:
        """The section's axes from those of the link."""
        x, y, z = axes
        x, y = plus(scaled(self.c, x), scaled(-self.s, y)), plus(scaled(self.c, y), scaled(self.s, x))
        return x, scaled(self.way, y), scaled(self.way, z)

    def turned_back(self, u: Vector) -> Vector:
        """``u`` of the section's axes along the link's."""
        return about_z(self.c, -self.s, (u[0], self.way * u[1], self.way * u[2]))

    def turned(self, u: Vector) -> Vector:
        """``u`` of the link's axes along the section's."""
        x, y, z = about_z(self.c, self.s, u)
        return x, self.way * y, self.way * z


@dataclass(frozen=True, slots=True)
class Section:
    """Links whose joints turn about one direction. ``twist`` (cosine, sine) leads from the axes of the link
    before to the section's, about x; ``offset`` [m], along the section's axes, from that link's origin to the
    first one's."""

    steps: tuple[Step, ...]
    twist: tuple[Any, Any]
    offset: Vector

    @property
    def last(self) -> Step:
        """The link that carries the next section."""
        return self.steps[-1]

    def outward(self, axes: Axes) -> Axes:
        """The section's axes from those of the link that carries it."""
        x, y, z = axes
        c, s = self.twist
        return x, plus(scaled(c, y), scaled(s, z)), plus(scaled(c, z), scaled(-s, y))

    def inward(self, axes: Axes) -> Axes:
        """The axes of the link that carries the section from its own."""
        x, y, z = axes
        c, s = self.twist
        return x, plus(scaled(c, y), scaled(-s, z)), plus(scaled(c, z), scaled(s, y))

    def twisted(self, u: Vector) -> Vector:
        """``u`` of the axes of the link that carries the section along its own."""
        c, s = self.twist
        return about_x(c, -s, u)

    def untwisted(self, u: Vector) -> Vector:
        """``u`` of the section's axes along those of the link that carries it."""
        return about_x(*self.twist, u)


def sections_of(arm: Arm, motion: Motion, turns: Turns) -> list[Section]:
    """The sections of ``arm``, base to tip; the last link's ``reach`` is to the tool."""
    sections: list[Section] = []
    steps: list[Step] = []
    for i, (body, follows) in enumerate(zip(arm.bodies, turns.follows, strict=True)):
        way = steps[-1].way * int(body.cos_alpha) if follows else 1
        steps = steps if follows else []
        goes_on, reach = i + 1 < len(arm.bodies) and turns.follows[i + 1], ZERO
        if goes_on:
            reach = origin(arm.bodies[i + 1], motion.d[i + 1])
        elif i + 1 == len(arm.bodies):
            reach = arm.tool.origin
        steps.append(Step(i, turns.c[i], turns.s[i], way, reach))
        if not goes_on:
            first = arm.bodies[k := steps[0].link]
            twist = (first.cos_alpha, first.sin_alpha)
            sections.append(Section(tuple(steps), twist, (first.a, first.b, motion.d[k])))
    return sections


def grounded(base: Frame, sections: Sequence[Section]) -> tuple[Frame, list[Section]]:
    """The same with a ``base`` along the world's axes, if it is turned about the first joint's axis only:
    the turn is taken into the joint's."""
    first, *others = sections
    x, _, z = first.outward((base.x, base.y, base.z))
    if not (is_zero(z[0]) and is_zero(z[1])):
        return base, list(sections)
    c, s, way = x[0], z[2] * x[1], z[2]
    (step,) = first.steps
    step = replace(step, c=c * step.c - s * step.s, s=s * step.c + c * step.s)
    turned = Section((step,), (way, 0), about_z(c, s, first.offset))
    return replace(BASE, origin=base.origin), [turned, *others]


class Placed(NamedTuple):
    """Sections with the ``axes`` of each, and those of ``links`` (from 0), along the axes of one frame."""

    sections: Sequence[Section]
    axes: Sequence[Axes]
    links: Mapping[int, Axes]


def placed_in(base: Frame, sections: Sequence[Section], mark: Mark = unmarked, row: Row = None) -> Placed:
    """``sections`` along the axes of the frame that ``base`` is in, ``row`` of their components made of the
    others."""
    carrier: Axes = (base.x, base.y, base.z)
    axes: list[Axes] = []
    links: dict[int, Axes] = {}
    for section in sections:
        own = _completed(section.outward(carrier), carrier, 0, section.twist, row)
        axes.append(own)
        for step in section.steps:
            carrier = _completed(step.outward(own), own, 2, (step.c, step.s), row)
            carrier = links[step.link] = _marked(mark, carrier, step.link + 1)
    return Placed(sections, axes, links)


def placed_in_tool(
    tool: Frame, sections: Sequence[Section], mark: Mark = unmarked, row: Row = None
) -> Placed:
    """``sections`` along the axes of the ``tool``, which is in the last link's frame, ``row`` of their
    components made of the others. Of links only the last of each section are there, the others turn along
    with it."""
    link: Axes = tool.rotation()
    axes: list[Axes] = []
    links: dict[int, Axes] = {}
    for section in reversed(sections):
        last = section.last
        links[last.link] = link
        own = _completed(last.inward(link), link, 2, (last.c, last.s), row)
        own = _marked(mark, own, last.link + 1)
        axes.append(own)
        link = _completed(section.inward(own), own, 0, section.twist, row)
    return Placed(sections, axes[::-1], links)


def _completed(axes: Axes, before: Axes, fixed: int, turn: tuple[Any, Any], row: Row) -> Axes:
    """``axes``, those ``before`` turned about number ``fixed`` by the cosine and sine ``turn``; where that is
    two products, ``row`` of their components is made of the others."""
    moving = [k for k in range(3) if k != fixed]
    if row is None or any(map(is_zero, (*turn, *(before[k][row] for k in moving)))):
        return axes
    x, y, z = (axis if k == fixed else with_cofactor(axes, k, row) for k, axis in enumerate(axes))
    return x, y, z


def with_cofactor(axes: Axes, k: int, row: int) -> Vector:
    """Axis number ``k`` of right-handed ``axes``, component number ``row`` made of the other axes'."""
    p, q = (row + 1) % 3, (row + 2) % 3
    u, v = axes[(k + 1) % 3], axes[(k + 2) % 3]
    entry = u[p] * v[q] - u[q] * v[p]
    x, y, z = (entry if i == row else component for i, component in enumerate(axes[k]))
    return x, y, z


def _marked(mark: Mark, axes: Axes, link: int) -> Axes:
    x, y, z = (named(mark, u, link, quantity) for u, quantity in zip(axes, ("ex", "ey", "ez"), strict=True))
    return x, y, z


def along(axes: Axes, u: Vector) -> Vector:
    """``u`` of the ``axes`` along those that they are along."""
    return plus(*(scaled(x, axis) for x, axis in zip(u, axes, strict=True) if not is_zero(x)), ZERO)


def tried(places: Sequence[int]) -> Sequence[int]:
    """Of the sections ``places`` those that are worth trying: of many the first and the last."""
    half = SECTIONS_TRIED // 2
    return places if len(places) <= SECTIONS_TRIED else (*places[:half], *places[-half:])
