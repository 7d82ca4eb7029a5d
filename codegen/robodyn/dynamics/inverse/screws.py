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
from typing import Any

from robodyn.dynamics.arm import Arm, into_parent, origin
from robodyn.dynamics.frame import BASE, Frame
from robodyn.dynamics.inverse.limits import NEGLIGIBLE
from robodyn.dynamics.vectors import Vector, cross, dot, plus, scaled

#: An angle as (cosine, sine).
Circle = tuple[Any, Any]


def minus(u: Vector, v: Vector) -> Vector:
    """``u - v``."""
    return u[0] - v[0], u[1] - v[1], u[2] - v[2]


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


def sum_of(one: Circle, other: Circle) -> Circle:
    """The sum of two angles."""
    (c, s), (e, f) = one, other
    return c * e - s * f, s * e + c * f


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


@dataclass(frozen=True, slots=True)
class Target:
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
    frame, axes = BASE, []
    for joint, body in enumerate(arm.bodies):
        c, s = (1, 0) if body.revolute else (body.theta.cos, body.theta.sin)
        x, y, z = (into_parent(body, c, s, unit) for unit in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
        frame = Frame(origin(body, body.d), x, y, z).within(frame)
        frame = Frame(_clean(frame.origin, size), *(_clean(u, 1) for u in (frame.x, frame.y, frame.z)))
        axes.append(Axis(joint, body.revolute, frame.z, frame.origin))
    tool = arm.tool.within(frame)
    tool = Frame(_clean(tool.origin, size), *(_clean(u, 1) for u in (tool.x, tool.y, tool.z)))
    return Chain(tuple(axes), tool)


def _clean(u: Vector, size: Fraction | int) -> Vector:
    """``u`` with what is nothing but a description's rounding, for numbers of ``size``, taken for 0."""
    x, y, z = (Fraction(0) if abs(x) <= NEGLIGIBLE * size else Fraction(x) for x in u)
    return x, y, z


def as_floats(chain: Chain, size: Fraction) -> Chain:
    """The same in floats, lengths as shares of ``size``."""

    def of(u: Vector, unit: Fraction | int = 1) -> Vector:
        return float(u[0] / unit), float(u[1] / unit), float(u[2] / unit)

    axes = (replace(x, direction=of(x.direction), point=of(x.point, size)) for x in chain.axes)
    tool = chain.tool
    tool = Frame(of(tool.origin, size), of(tool.x), of(tool.y), of(tool.z))
    return Chain(tuple(axes), tool)
