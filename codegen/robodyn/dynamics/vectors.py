"""Vectors of three scalars of any kind: floats, fractions, graph nodes, sympy expressions; frames, rows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.ir.program import Label

Vector = tuple[Any, Any, Any]
#: A vector of motion or force, and that of its turn or moment, in either order.
Pair = tuple[Vector, Vector]
#: Names a value of the recursion and hands it (or its name) back; the identity for plain numbers.
Mark = Callable[[Any, Label], Any]

ZERO: Vector = (0, 0, 0)
AXES = ("x", "y", "z")
HALF = Fraction(1, 2)


def unmarked(value: Any, label: Label) -> Any:
    """The mark of scalars that need no names."""
    return value


def plus(*vectors: Vector) -> Vector:
    """Sum of vectors, from left to right."""
    x, y, z = vectors[0]
    for u in vectors[1:]:
        x, y, z = x + u[0], y + u[1], z + u[2]
    return x, y, z


def minus(u: Vector, v: Vector) -> Vector:
    """``u - v``."""
    return u[0] - v[0], u[1] - v[1], u[2] - v[2]


def scaled(factor: Any, u: Vector) -> Vector:
    """``factor * u``."""
    return factor * u[0], factor * u[1], factor * u[2]


def cross(u: Vector, v: Vector) -> Vector:
    """``u x v``."""
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def dot(u: Vector, v: Vector) -> Any:
    """``u . v``."""
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def named(mark: Mark, vector: Vector, link: int, quantity: str) -> Vector:
    """``vector`` with each component marked."""
    if mark is unmarked:
        return vector
    x, y, z = (mark(value, Label(link, quantity, axis)) for value, axis in zip(vector, AXES, strict=True))
    return x, y, z


def inner(u: Sequence[Any], v: Sequence[Any]) -> Any:
    """``u^T v``, of any length."""
    return sum(x * y for x, y in zip(u, v, strict=True))


def flat(rows: Sequence[Sequence[Any]]) -> list[Any]:
    """Rows one after another."""
    return [x for row in rows for x in row]


def products(entries: Sequence[Any], x: Sequence[Any]) -> list[Any]:
    """Rows, one after another in ``entries``, each times ``x``."""
    n = len(x)
    return [inner(entries[k : k + n], x) for k in range(0, len(entries), n)]


@dataclass(frozen=True, slots=True)
class Frame:
    """A frame in another: its origin [m] and its unit axes, the columns of the rotation."""

    origin: Vector
    x: Vector
    y: Vector
    z: Vector

    def rotation(self) -> tuple[Vector, Vector, Vector]:
        """Rows of the rotation [3, 3] that takes vectors of the frame into the other."""
        x, y, z = zip(self.x, self.y, self.z, strict=True)
        return x, y, z

    def place(self, point: Vector) -> Vector:
        """``point`` [m] of the frame, seen from the other [m]."""
        return plus(self.origin, self.turned(point))

    def turned(self, u: Vector) -> Vector:
        """A vector of the frame along the other's axes."""
        return plus(scaled(u[0], self.x), scaled(u[1], self.y), scaled(u[2], self.z))

    def back(self, u: Vector) -> Vector:
        """A vector along the other's axes, along the frame's own."""
        return dot(self.x, u), dot(self.y, u), dot(self.z, u)

    def within(self, outer: Frame) -> Frame:
        """The same frame where the other one lies in ``outer``."""
        return Frame(outer.place(self.origin), *(outer.turned(u) for u in (self.x, self.y, self.z)))


#: The other itself.
BASE = Frame(ZERO, (1, 0, 0), (0, 1, 0), (0, 0, 1))
