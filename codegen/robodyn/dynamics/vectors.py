"""Vectors of three scalars of any kind: floats, fractions, graph nodes, sympy expressions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from robodyn.ir.program import Label

Vector = tuple[Any, Any, Any]
#: Names a value of the recursion and hands it (or its name) back; the identity for plain numbers.
Mark = Callable[[Any, Label], Any]

ZERO: Vector = (0, 0, 0)
AXES = ("x", "y", "z")


def unmarked(value: Any, label: Label) -> Any:
    """The mark of scalars that need no names."""
    return value


def plus(*vectors: Vector) -> Vector:
    """Sum of vectors, from left to right."""
    x, y, z = vectors[0]
    for u in vectors[1:]:
        x, y, z = x + u[0], y + u[1], z + u[2]
    return x, y, z


def scaled(factor: Any, u: Vector) -> Vector:
    """``factor * u``."""
    return factor * u[0], factor * u[1], factor * u[2]


def cross(u: Vector, v: Vector) -> Vector:
    """``u x v``."""
    return (
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    )


def dot(u: Vector, v: Vector) -> Any:
    """``u . v``."""
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def named(mark: Mark, vector: Vector, link: int, quantity: str) -> Vector:
    """``vector`` with each component marked."""
    if mark is unmarked:
        return vector
    x, y, z = (mark(value, Label(link, quantity, axis)) for value, axis in zip(vector, AXES, strict=True))
    return x, y, z
