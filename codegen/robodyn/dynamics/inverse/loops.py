"""Equations around the loop that joints and pose close, each of one joint's position, over any scalar.

The displacements of all joints are that of the target, ``S1 ... Sn = D``. So a direction or a point that
stands behind joint ``m`` may be carried to behind joint ``l`` in two ways: back through the joints between
them, or on through the others, the target and the base. What both ways give is the same; and so is how it
measures along a direction, or from a point, that stands there. Of joints on the way many do not count: a turn
about an axis leaves its direction and its points where they are, a slide all directions, and what is measured
along an axis does not see turns about it. Where one joint alone remains, of those that are not known, the
equation gives its position.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Literal, NamedTuple

from robodyn.dynamics.inverse.limits import SHORT
from robodyn.dynamics.inverse.screws import Axis, Target, turned
from robodyn.dynamics.inverse.subproblems import Branch, One, Setting, Two, is_number, preferred
from robodyn.dynamics.vectors import ZERO, Vector, dot, minus, plus, scaled
from robodyn.effects.scalars import choose

#: Whether a vector is carried back, to before joints, or on, to behind them.
Way = Literal["back", "on"]
WAYS: tuple[Way, Way] = ("back", "on")


class Object(NamedTuple):
    """What is carried: a direction or a point [m], ``value`` at rest, that stands behind joint ``at`` (from
    1; 0: before all of them)."""

    value: Vector
    is_point: bool
    at: int


class Equation(NamedTuple):
    """What gives the position of the axis ``place`` (from 0), in up to ``answers`` ways.

    ``carried`` is carried ``way`` through it. ``onto`` is what it is measured by: a direction, along which,
    or a point, from which; None: it is where the other way brings it, in all directions. ``instead``: another
    equation with as many answers, for poses at which the lever of this one is short.
    """

    place: int
    carried: Object
    way: Way
    onto: Object | None
    answers: int
    instead: Equation | None = None


def path(count: int, start: int, end: int, way: Way) -> Iterator[int | None]:
    """The places of axes (from 0) on the ``way`` from behind joint ``start`` to behind joint ``end``, of
    ``count`` in all; None stands for the target."""
    at = start
    while at != end:
        if way == "back":
            yield at - 1 if at else None
            at = at - 1 if at else count
        else:
            yield at if at < count else None
            at = at + 1 if at < count else 0


def carry(
    axes: Sequence[Axis], target: Target, positions: Mapping[int, Any], x: Object, end: int, way: Way
) -> Vector:
    """``x`` carried ``way`` to behind joint ``end``; joints without a position stay at rest."""
    v = x.value
    through = target if way == "on" else target.inverse()
    for place in path(len(axes), x.at, end, way):
        if place is None:
            v = through.placed(v) if x.is_point else through.turned(v)
        elif axes[place].joint in positions:
            axis = axes[place] if way == "back" else axes[place].reversed()
            v = _moved(axis, positions[axis.joint], v, x.is_point)
    return v


def _moved(axis: Axis, position: Any, v: Vector, is_point: bool) -> Vector:
    """A direction or point behind ``axis`` as it is before it."""
    if axis.revolute:
        return (
            plus(axis.point, turned(axis.direction, position, minus(v, axis.point)))
            if is_point
            else (turned(axis.direction, position, v))
        )
    return plus(v, scaled(position, axis.direction)) if is_point else v


def answered(
    axes: Sequence[Axis], target: Target, equation: Equation, branch: Branch, at: Setting
) -> Iterator[Branch]:
    """``branch`` with each position of the joint that ``equation`` gives."""
    joint, ways = axes[equation.place].joint, _ways(axes, target, equation, branch, at)
    if equation.instead is not None and not is_number(ways.lever):
        longer = _ways(axes, target, equation.instead, branch, at)
        ways = preferred(choose(ways.lever - SHORT * SHORT, 1, 0), ways, longer)
    if isinstance(ways, Two):
        yield from branch.with_each(joint, ways)
    else:
        yield branch.with_answer(joint, ways)


def _ways(axes: Sequence[Axis], target: Target, equation: Equation, branch: Branch, at: Setting) -> One | Two:
    """The answers of ``equation`` itself."""
    place, x, way, u, *_ = equation
    behind, before = (place + 1, place) if way == "back" else (place, place + 1)
    axis = axes[place] if way == "back" else axes[place].reversed()
    other: Way = "on" if way == "back" else "back"

    def brought(what: Object, end: int, by: Way) -> Vector:
        return carry(axes, target, branch.positions, what, end, by)

    y = brought(x, behind, way)
    if u is None:
        z = brought(x, before, other)
        if not axis.revolute:
            return One(dot(axis.direction, minus(z, y)), 0)
        if x.is_point:
            y, z = minus(y, axis.point), minus(z, axis.point)
        return at.onto(axis, y, z, 2 if x.is_point else 0)
    v, z = brought(u, before, other), brought(x, u.at, other)
    if u.is_point:
        square = dot(minus(z, u.value), minus(z, u.value))
        if axis.revolute:
            return at.fold(axis, minus(axis.point, v), minus(y, axis.point), square)
        w = minus(y, v)
        return at.slide(dot(w, axis.direction), dot(w, w) - square)
    along = dot(u.value, z)
    if x.is_point:  # what is measured from the origin there, from where that is brought
        along = along + dot(v, brought(Object(ZERO, True, u.at), before, other))
    if not axis.revolute:
        return at.along(dot(v, axis.direction), along - dot(v, y))
    if x.is_point:
        along, y = along - dot(v, axis.point), minus(y, axis.point)
    return at.reach(axis, y, v, along, 1 if x.is_point else 0)
