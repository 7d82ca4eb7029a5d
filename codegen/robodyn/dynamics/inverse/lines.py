"""Lines in space: where the axes of an arm meet, and points on them that make its offsets simple."""

from __future__ import annotations

from math import sqrt

from robodyn.dynamics.inverse.screws import Axis, across, minus
from robodyn.dynamics.vectors import Vector, cross, dot, plus, scaled


def nearest(axis: Axis, point: Vector) -> Vector:
    """The point of ``axis`` nearest to ``point``."""
    return plus(axis.point, scaled(dot(axis.direction, minus(point, axis.point)), axis.direction))


def feet(one: Axis, other: Axis) -> tuple[Vector, Vector]:
    """The points of two axes that are nearest to each other; of parallel ones any such."""
    w = minus(other.point, one.point)
    k = dot(one.direction, other.direction)
    if one_way(one, other):
        return one.point, nearest(other, one.point)
    s = (dot(w, one.direction) - k * dot(w, other.direction)) / (1 - k * k)
    foot = plus(one.point, scaled(s, one.direction))
    return foot, nearest(other, foot)


def one_way(one: Axis, other: Axis) -> bool:
    """Whether the directions of two axes are one line's, of exact numbers."""
    x, y, z = cross(one.direction, other.direction)
    return bool(x == 0 and y == 0 and z == 0)


def distance(axis: Axis, point: Vector) -> float:
    """From ``point`` to ``axis`` [m], in floats."""
    x, y, z = across(axis.direction, minus(point, axis.point))
    return sqrt(x * x + y * y + z * z)


def slope(one: Axis, other: Axis) -> float:
    """The sine of the angle between two axes, in floats."""
    u = cross(one.direction, other.direction)
    return sqrt(dot(u, u))
