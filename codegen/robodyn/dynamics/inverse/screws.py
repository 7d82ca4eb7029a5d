"""An arm as the axes of its joints: what inverse kinematics is written in terms of.

The pose that an arm gives the tool is a product of displacements, one a joint, about or along axes that stand
where they are when all angles are 0: ``T = S1(theta1) ... Sn(thetan) T0`` (Brockett 1984; Murray, Li and
Sastry, A Mathematical Introduction to Robotic Manipulation, 3.2). Angles are those of the Denavit-Hartenberg
rows, the joints' own offsets included.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from math import cos, sin, sqrt
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm, into_parent, origin
from robodyn.dynamics.inverse.limits import NEGLIGIBLE, TRIED
from robodyn.dynamics.vectors import BASE, ZERO, Frame, Vector, cross, dot, minus, plus, scaled
from robodyn.ir.evaluate import Circle


def across(axis: Vector, v: Vector) -> Vector:
    """What of ``v`` is perpendicular to the unit vector ``axis``."""
    return minus(v, scaled(dot(axis, v), axis))


def turned(axis: Vector, angle: Circle, v: Vector) -> Vector:
    """``v`` turned about the unit vector ``axis`` (Rodrigues)."""
    along = scaled(dot(axis, v), axis)
    c, s = angle
    return plus(along, scaled(c, minus(v, along)), scaled(s, cross(axis, v)))


def opposite(angle: Circle) -> Circle:
    """The angle's negative."""
    return angle[0], -angle[1]


@dataclass(frozen=True, slots=True)
class Axis:
    """The axis of ``joint`` (from 0): its unit ``direction``, and a ``point`` [m] of it, any."""

    joint: int
    revolute: bool
    direction: Vector
    point: Vector

    def undone(self, position: Any, v: Vector) -> Vector:
        """A vector before the joint, at ``position`` (an angle, or a length), seen from behind it."""
        return turned(self.direction, opposite(position), v) if self.revolute else v

    def point_behind(self, position: Any, point: Vector) -> Vector:
        """A point before the joint, seen from behind it."""
        if not self.revolute:
            return minus(point, scaled(position, self.direction))
        return plus(self.point, self.undone(position, minus(point, self.point)))

    def reversed(self) -> Axis:
        """The axis along which the same angles turn the other way."""
        return replace(self, direction=scaled(-1, self.direction))

    def nearest(self, point: Vector) -> Vector:
        """The point of the axis nearest to ``point``."""
        along = dot(self.direction, minus(point, self.point))
        return plus(self.point, scaled(along, self.direction))

    def distance(self, point: Vector) -> float:
        """From ``point`` to the axis [m], in floats."""
        u = across(self.direction, minus(point, self.point))
        return sqrt(dot(u, u))

    def is_along(self, other: Axis) -> bool:
        """Whether the directions of two axes are one line's, of exact numbers."""
        return not any(cross(self.direction, other.direction))

    def slope(self, other: Axis) -> float:
        """The sine of the angle between two axes, in floats."""
        u = cross(self.direction, other.direction)
        return sqrt(dot(u, u))


def feet(one: Axis, other: Axis) -> tuple[Vector, Vector]:
    """The points of two axes that are nearest to each other; of parallel ones any such."""
    if one.is_along(other):
        return one.point, other.nearest(one.point)
    w, k = minus(other.point, one.point), dot(one.direction, other.direction)
    s = (dot(w, one.direction) - k * dot(w, other.direction)) / (1 - k * k)
    foot = plus(one.point, scaled(s, one.direction))
    return foot, other.nearest(foot)


class Target(NamedTuple):
    """The displacement that the joints have to add up to: it takes ``x`` to ``R (x - start) + end``."""

    rows: tuple[Vector, Vector, Vector]
    start: Vector
    end: Vector

    def placed(self, point: Vector) -> Vector:
        """Where it takes ``point`` [m]."""
        return plus(self.turned(minus(point, self.start)), self.end)

    def turned(self, v: Vector) -> Vector:
        """``R v``."""
        x, y, z = self.rows
        return dot(x, v), dot(y, v), dot(z, v)

    def inverse(self) -> Target:
        """The displacement back."""
        x, y, z = zip(*self.rows, strict=True)
        return Target((x, y, z), self.end, self.start)

    def behind(self, axis: Axis, position: Any) -> Target:
        """The displacement that is left behind ``axis``, its joint being at ``position``."""
        columns = [axis.undone(position, column) for column in zip(*self.rows, strict=True)]
        x, y, z = zip(*columns, strict=True)
        return Target((x, y, z), self.start, axis.point_behind(position, self.end))


@dataclass(frozen=True, slots=True)
class Chain:
    """Axes [n] from base to tip at rest, and the frame of the tool there, all in the frame of the arm."""

    axes: tuple[Axis, ...]
    tool: Frame

    @property
    def size(self) -> Fraction:
        """No less than any lever of the arm at any position, and about its reach [m]."""
        points = [*(axis.point for axis in self.axes), self.tool.origin]
        total = sum((abs(x) for one, other in pairwise(points) for x in minus(other, one)), Fraction(0))
        return total or Fraction(1)

    def reversed(self) -> Chain:
        """The same joints from tip to base: they add up to the inverse displacement."""
        return replace(self, axes=tuple(axis.reversed() for axis in reversed(self.axes)))

    def without(self, place: int, position: Any) -> tuple[Axis, ...]:
        """The other axes where the joint at ``place`` is at ``position``: those before it are seen from
        behind it, so that all add up to the displacement that it leaves of a target."""
        fixed = self.axes[place]

        def seen(axis: Axis) -> Axis:
            direction = fixed.undone(position, axis.direction)
            return replace(axis, direction=direction, point=fixed.point_behind(position, axis.point))

        return (*map(seen, self.axes[:place]), *self.axes[place + 1 :])

    def through(self, points: dict[int, Vector]) -> Chain:
        """The same axes, with these points of them by joint."""
        axes = (replace(axis, point=points.get(axis.joint, axis.point)) for axis in self.axes)
        return replace(self, axes=tuple(axes))

    def target(self, pose: Sequence[Any], base: Frame) -> Target:
        """What the joints have to add up to for the tool to be at ``pose`` [12], ``[R p]`` row by row, with
        the frame of the arm at ``base``."""
        columns = [(pose[k], pose[k + 4], pose[k + 8]) for k in range(4)]
        end = base.back(minus(columns.pop(), base.origin))
        x, y, z = map(base.back, columns)
        u, v, w = self.tool.rotation()
        one, two, three = ((dot(r, u), dot(r, v), dot(r, w)) for r in zip(x, y, z, strict=True))
        return Target((one, two, three), self.tool.origin, end)


def chain_of(arm: Arm) -> Chain:
    """The axes of ``arm`` at rest, of its description's exact numbers."""
    size = Fraction(max(1, *(abs(x) for body in arm.bodies for x in (body.a, body.b, body.d))))

    def clean(frame: Frame) -> Frame:
        """``frame`` with what is nothing but the description's rounding taken for 0."""

        def of(u: Vector, size: Fraction | int = 1) -> Vector:
            x, y, z = (Fraction(0) if abs(x) <= NEGLIGIBLE * size else Fraction(x) for x in u)
            return x, y, z

        return Frame(of(frame.origin, size), of(frame.x), of(frame.y), of(frame.z))

    frame, axes = BASE, []
    for joint, body in enumerate(arm.bodies):
        c, s = (1, 0) if body.revolute else (body.theta.cos, body.theta.sin)
        x, y, z = (into_parent(body, c, s, unit) for unit in (BASE.x, BASE.y, BASE.z))
        frame = clean(Frame(origin(body, body.d), x, y, z).within(frame))
        axes.append(Axis(joint, body.revolute, frame.z, frame.origin))
    return Chain(tuple(axes), clean(arm.tool.within(frame)))


def as_floats(chain: Chain, size: Fraction) -> Chain:
    """The same in floats, lengths as shares of ``size``."""

    def of(u: Vector, unit: Fraction | int = 1) -> Vector:
        return float(u[0] / unit), float(u[1] / unit), float(u[2] / unit)

    axes = (replace(x, direction=of(x.direction), point=of(x.point, size)) for x in chain.axes)
    tool = chain.tool
    return Chain(tuple(axes), Frame(of(tool.origin, size), of(tool.x), of(tool.y), of(tool.z)))


# --- whether joints can move a tool in all directions -------------------------------------------------------


def least_motion(chain: Chain) -> float:
    """Of ``chain``, in floats with lengths as shares of its size, the last pivot of its Jacobian (of the
    tool's place for three joints or fewer, else of place and direction) in the best of some configurations:
    more than rounding where it has full rank."""
    return max(_last_pivot(_jacobian_columns(chain, k)) for k in range(len(TRIED)))


def _jacobian_columns(chain: Chain, start: int) -> list[list[float]]:
    """What moves the tool, by joint, in one of several configurations."""
    tip: Vector = chain.tool.origin
    columns: list[tuple[Vector, Vector]] = []
    for k in reversed(range(len(chain.axes))):
        axis, angle = chain.axes[k], TRIED[(start + k) % len(TRIED)] + 0.1 * k
        z = axis.direction
        if axis.revolute:
            circle = (cos(angle), sin(angle))
            columns = [(turned(z, circle, v), turned(z, circle, w)) for v, w in columns]
            lever = turned(z, circle, minus(tip, axis.point))
            tip = plus(axis.point, lever)
            columns.append((cross(z, lever), z))
        else:
            tip = plus(tip, scaled(angle, z))
            columns.append((z, ZERO))
    return [[*v] if len(columns) <= 3 else [*v, *w] for v, w in columns]


def _last_pivot(rows: list[list[float]]) -> float:
    """That of elimination with complete pivoting: 0 where the rows depend on each other."""
    pivot = 0.0
    for step in range(min(len(rows), len(rows[0]))):
        i, j = max(
            ((i, j) for i in range(step, len(rows)) for j in range(step, len(rows[0]))),
            key=lambda place: abs(rows[place[0]][place[1]]),
        )
        rows[step], rows[i] = rows[i], rows[step]
        for row in rows:
            row[step], row[j] = row[j], row[step]
        pivot = abs(rows[step][step])
        if not pivot:
            return 0.0
        for row in rows[step + 1 :]:
            share = row[step] / rows[step][step]
            row[step:] = [x - share * y for x, y in zip(row[step:], rows[step][step:], strict=True)]
    return pivot
