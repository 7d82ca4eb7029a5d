"""Joint screw axes of an arm (product of exponentials), the model behind inverse kinematics.

The pose of the tool is a product of displacements, ``T = S1(theta1) ... Sn(thetan) T0`` (Brockett 1984;
Murray, Li and Sastry, A Mathematical Introduction to Robotic Manipulation, 3.2). Each joint has one
displacement, about or along its axis at rest, when all angles are 0. Angles are those of the
Denavit-Hartenberg rows, including the joint offsets.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from math import cos, sin, sqrt
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm, into_parent, origin
from robodyn.dynamics.inverse.limits import ALMOST, FULL_RANK, NEGLIGIBLE, TRIED
from robodyn.dynamics.vectors import BASE, ZERO, Frame, Vector, cross, dot, minus, plus, scaled
from robodyn.ir.evaluate import Circle


def across(axis: Vector, v: Vector) -> Vector:
    """The component of ``v`` perpendicular to the unit vector ``axis``."""
    return minus(v, scaled(dot(axis, v), axis))


def turned(axis: Vector, angle: Circle, v: Vector) -> Vector:
    """``v`` rotated about the unit vector ``axis`` (Rodrigues)."""
    along = scaled(dot(axis, v), axis)
    c, s = angle
    return plus(along, scaled(c, minus(v, along)), scaled(s, cross(axis, v)))


def opposite(angle: Circle) -> Circle:
    """The angle's negative."""
    return angle[0], -angle[1]


@dataclass(frozen=True, slots=True)
class Axis:
    """The axis of ``joint`` (from 0): its unit ``direction`` and any ``point`` [m] on it."""

    joint: int
    revolute: bool
    direction: Vector
    point: Vector

    def inverse_rotation(self, position: Any, v: Vector) -> Vector:
        """Rotate a vector by the inverse of the joint's displacement ``position`` (an angle or a length)."""
        return turned(self.direction, opposite(position), v) if self.revolute else v

    def inverse_displacement(self, position: Any, point: Vector) -> Vector:
        """Move a point by the inverse of the joint's displacement ``position``."""
        if not self.revolute:
            return minus(point, scaled(position, self.direction))
        return plus(self.point, self.inverse_rotation(position, minus(point, self.point)))

    def reversed(self) -> Axis:
        """The same axis with the opposite direction."""
        return replace(self, direction=scaled(-1, self.direction))

    def nearest(self, point: Vector) -> Vector:
        """The point of the axis nearest to ``point``."""
        along = dot(self.direction, minus(point, self.point))
        return plus(self.point, scaled(along, self.direction))

    def distance(self, point: Vector) -> float:
        """The distance of ``point`` from the axis [m], in floats."""
        u = across(self.direction, minus(point, self.point))
        return sqrt(dot(u, u))

    def is_along(self, other: Axis) -> bool:
        """Whether two axes are parallel or antiparallel; their numbers must be exact."""
        return not any(cross(self.direction, other.direction))

    def slope(self, other: Axis) -> float:
        """The sine of the angle between two axes, in floats."""
        u = cross(self.direction, other.direction)
        return sqrt(dot(u, u))


def feet(one: Axis, other: Axis) -> tuple[Vector, Vector]:
    """The end points of the common perpendicular of two axes; of one of them if the axes are parallel."""
    if one.is_along(other):
        return one.point, other.nearest(one.point)
    w, k = minus(other.point, one.point), dot(one.direction, other.direction)
    s = (dot(w, one.direction) - k * dot(w, other.direction)) / (1 - k * k)
    foot = plus(one.point, scaled(s, one.direction))
    return foot, other.nearest(foot)


class Target(NamedTuple):
    """The displacement that all joints together must produce: ``x`` moves to ``R (x - start) + end``."""

    rows: tuple[Vector, Vector, Vector]
    start: Vector
    end: Vector

    def placed(self, point: Vector) -> Vector:
        """``point`` [m] after the displacement."""
        return plus(self.turned(minus(point, self.start)), self.end)

    def turned(self, v: Vector) -> Vector:
        """The rotated vector ``R v``."""
        x, y, z = self.rows
        return dot(x, v), dot(y, v), dot(z, v)

    def inverse(self) -> Target:
        """The inverse displacement."""
        x, y, z = zip(*self.rows, strict=True)
        return Target((x, y, z), self.end, self.start)

    def behind(self, axis: Axis, position: Any) -> Target:
        """The displacement left for the later joints once the first one, of ``axis``, is at ``position``."""
        columns = [axis.inverse_rotation(position, column) for column in zip(*self.rows, strict=True)]
        x, y, z = zip(*columns, strict=True)
        return Target((x, y, z), self.start, axis.inverse_displacement(position, self.end))


@dataclass(frozen=True, slots=True)
class Chain:
    """Axes [n] from base to tip at rest, and the frame of the tool there, all in the frame of the arm."""

    axes: tuple[Axis, ...]
    tool: Frame

    @property
    def size(self) -> Fraction:
        """Roughly the reach of the arm [m], and an upper bound of its lever arms at any position."""
        points = [*(axis.point for axis in self.axes), self.tool.origin]
        total = sum((abs(x) for one, other in pairwise(points) for x in minus(other, one)), Fraction(0))
        return total or Fraction(1)

    def reversed(self) -> Chain:
        """The same joints from tip to base; they produce the inverse displacement."""
        return replace(self, axes=tuple(axis.reversed() for axis in reversed(self.axes)))

    def without(self, place: int, position: Any) -> tuple[Axis, ...]:
        """The other axes, with the joint ``place`` fixed at ``position``.

        The axes before it are moved by the inverse of its displacement. The product of the remaining
        displacements is then the target with the fixed joint's displacement removed.
        """
        fixed = self.axes[place]

        def move_behind(axis: Axis) -> Axis:
            direction = fixed.inverse_rotation(position, axis.direction)
            return replace(axis, direction=direction, point=fixed.inverse_displacement(position, axis.point))

        return (*map(move_behind, self.axes[:place]), *self.axes[place + 1 :])

    def through(self, points: dict[int, Vector]) -> Chain:
        """The same axes, each described by the point that ``points`` has for its joint."""
        axes = (replace(axis, point=points.get(axis.joint, axis.point)) for axis in self.axes)
        return replace(self, axes=tuple(axes))

    def target(self, pose: Sequence[Any], base: Frame) -> Target:
        """The displacement that brings the tool to ``pose`` [12], which is ``[R p]`` row by row.

        ``base`` is the frame of the arm.
        """
        columns = [(pose[k], pose[k + 4], pose[k + 8]) for k in range(4)]
        end = base.back(minus(columns.pop(), base.origin))
        x, y, z = map(base.back, columns)
        u, v, w = self.tool.rotation()
        one, two, three = ((dot(r, u), dot(r, v), dot(r, w)) for r in zip(x, y, z, strict=True))
        return Target((one, two, three), self.tool.origin, end)


def chain_of(arm: Arm) -> Chain:
    """The axes of ``arm`` at rest, in the exact numbers of its description."""
    size = Fraction(max(1, *(abs(x) for body in arm.bodies for x in (body.a, body.b, body.d))))

    def clean(frame: Frame) -> Frame:
        """Set entries of ``frame`` to 0 that are within the rounding of the description."""

        def drop_rounding(u: Vector, size: Fraction | int = 1) -> Vector:
            x, y, z = (Fraction(0) if abs(x) <= NEGLIGIBLE * size else Fraction(x) for x in u)
            return x, y, z

        return Frame(
            drop_rounding(frame.origin, size), *(drop_rounding(u) for u in (frame.x, frame.y, frame.z))
        )

    frame, axes = BASE, []
    for joint, body in enumerate(arm.bodies):
        c, s = (1, 0) if body.revolute else (body.theta.cos, body.theta.sin)
        x, y, z = (into_parent(body, c, s, unit) for unit in (BASE.x, BASE.y, BASE.z))
        frame = clean(Frame(origin(body, body.d), x, y, z).within(frame))
        axes.append(Axis(joint, body.revolute, frame.z, frame.origin))
    return Chain(tuple(axes), clean(arm.tool.within(frame)))


def as_floats(chain: Chain, size: Fraction) -> Chain:
    """``chain`` in floats, with lengths divided by ``size``."""

    def to_floats(u: Vector, unit: Fraction | int = 1) -> Vector:
        return float(u[0] / unit), float(u[1] / unit), float(u[2] / unit)

    axes = (replace(x, direction=to_floats(x.direction), point=to_floats(x.point, size)) for x in chain.axes)
    tool = chain.tool
    return Chain(
        tuple(axes), Frame(to_floats(tool.origin, size), *(to_floats(u) for u in (tool.x, tool.y, tool.z)))
    )


# --- rank of the Jacobian -----------------------------------------------------------------------------------


def least_motion(chain: Chain, place_only: bool) -> float:
    """The last pivot of the Jacobian of ``chain``, the largest over several configurations.

    It exceeds rounding if the Jacobian has full rank. ``chain`` is in floats, with lengths divided by its
    size. With ``place_only`` the Jacobian is that of the tool's place.
    """
    return max(_last_pivot(_jacobian_columns(chain, k, place_only)) for k in range(len(TRIED)))


def only_places(chain: Chain) -> bool:
    """Whether ``chain``, in floats as above, is asked for the tool's place alone: three joints that move that
    in all directions do no more. Those that do not, as of an arm that is planar or nearly, are asked for all
    that they do."""
    if len(chain.axes) > 3:
        return False
    return least_motion(chain, True) > ALMOST or least_motion(chain, False) <= FULL_RANK


def _jacobian_columns(chain: Chain, start: int, place_only: bool) -> list[list[float]]:
    """The columns of the tool's Jacobian, from the last joint to the first, in configuration ``start``."""
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
    return [[*v] if place_only else [*v, *w] for v, w in columns]


def _last_pivot(rows: list[list[float]]) -> float:
    """The last pivot of Gaussian elimination with complete pivoting; 0 if the rows are linearly dependent."""
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
