"""A graph that merges nodes of equal value, however they were come by.

Equal is what agrees at one random point of GF(2^61 - 1), where every rational constant has its place and
sines and cosines obey the addition theorems: two rational functions that differ agree there with a
probability of about degree / 2^61. What is built so is proved equal to the plain recursion on fractions
before it is shown (:mod:`robodyn.dynamics.equality`).
"""

from __future__ import annotations

import hashlib
from fractions import Fraction
from typing import Any

from robodyn.ir.evaluate import PRIME
from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.robot.values import circle_point

_HALF = PRIME // 2


def residue(x: Fraction | int) -> int:
    """A rational's place in the field."""
    if isinstance(x, int):
        return x % PRIME
    return x.numerator * pow(x.denominator, -1, PRIME) % PRIME


def random_residue(name: str) -> int:
    """A number of the field, the same for the same name."""
    digest = hashlib.blake2b(f"merging {name}".encode(), digest_size=16).digest()
    return int.from_bytes(digest, "little") % PRIME


class Angles:
    """Cosines and sines of angles in the field: the point of the circle of each joint's angle is drawn, that
    of a sum or of a constant follows."""

    def __init__(self) -> None:
        self._points: dict[Any, tuple[int, int]] = {}

    def of_input(self, array: str, index: int | None) -> tuple[int, int]:
        """The point of an input that is an angle."""
        key = (array, index)
        if key not in self._points:
            t = random_residue(f"circle {array} {index}")
            inverse = pow(1 + t * t, -1, PRIME)
            self._points[key] = ((1 - t * t) * inverse % PRIME, 2 * t * inverse % PRIME)
        return self._points[key]

    def of_constant(self, angle: Fraction) -> tuple[int, int]:
        """The point of a constant angle [rad]."""
        if angle not in self._points:
            c, s = circle_point(angle)
            self._points[angle] = (residue(c), residue(s))
        return self._points[angle]


def turned_by(first: tuple[int, int], second: tuple[int, int]) -> tuple[int, int]:
    """The point of the sum of two angles."""
    (c, s), (e, f) = first, second
    return (c * e - s * f) % PRIME, (s * e + c * f) % PRIME


class MergingGraph(Graph):
    """A graph in which a node is its value at a random point."""

    def __init__(self) -> None:
        super().__init__()
        self._value: list[int] = []
        self._by_value: dict[int, tuple[int, int]] = {1: (-1, 1)}
        self._residues: dict[tuple[int, int], int] = {}
        self._angles = Angles()

    def _residue(self, x: Fraction | int) -> int:
        key = (x.numerator, x.denominator)
        if key not in self._residues:
            self._residues[key] = residue(x)
        return self._residues[key]

    def _known(self, value: int) -> Scalar | None:
        """What has ``value`` already: a number 0 or 1, a node, or the negative of one."""
        if not value:
            return 0
        found = self._by_value.get(value if value <= _HALF else PRIME - value)
        if found is None:
            return None
        position, sign = found
        if value > _HALF:
            sign = -sign
        return sign if position < 0 else Node(self, position, sign)

    def _of(self, a: Scalar) -> int:
        if isinstance(a, Node):
            return self._value[a.position] if a.sign > 0 else PRIME - self._value[a.position]
        return self._residue(a)

    def add(self, a: Scalar, b: Scalar) -> Scalar:
        """``a + b``."""
        if isinstance(a, Node) or isinstance(b, Node):
            found = self._known((self._of(a) + self._of(b)) % PRIME)
            if found is not None:
                return found
        return super().add(a, b)

    def mul(self, a: Scalar, b: Scalar) -> Scalar:
        """``a * b``."""
        if isinstance(a, Node) or isinstance(b, Node):
            found = self._known(self._of(a) * self._of(b) % PRIME)
            if found is not None:
                return found
        return super().mul(a, b)

    def _node(self, key: tuple[Any, ...], sign: int = 1) -> Node:
        position = super()._node(key, 1).position
        if position == len(self._value):
            value = self._evaluated(key)
            self._value.append(value)
            if key[0] != "const":
                small = value if value <= _HALF else PRIME - value
                self._by_value.setdefault(small, (position, 1 if value <= _HALF else -1))
        return Node(self, position, sign)

    def _evaluated(self, key: tuple[Any, ...]) -> int:
        value = self._value
        op: str = key[0]
        at: tuple[int, ...] = key[1:]
        if op == "add":
            return (value[at[0]] + at[1] * value[at[2]]) % PRIME
        if op == "mul":
            return value[at[0]] * value[at[1]] % PRIME
        if op == "scale":
            return self._residue(key[1]) * value[at[1]] % PRIME
        if op == "const":
            return self._residue(key[1])
        if op in ("cos", "sin"):
            return self._angle(at[0])[op == "sin"]
        if op == "div":
            return value[at[0]] * pow(value[at[1]], -1, PRIME) % PRIME
        return random_residue(repr(key))

    def _angle(self, position: int) -> tuple[int, int]:
        """The point of the circle of the angle at ``position``: a sum of inputs and constants."""
        key = self.keys[position]
        if key[0] == "input":
            return self._angles.of_input(*key[1])
        if key[0] == "const":
            return self._angles.of_constant(key[1])
        if key[0] == "add":
            c, s = self._angle(key[3])
            return turned_by(self._angle(key[1]), (c, s if key[2] > 0 else PRIME - s))
        return self._angles.of_input(repr(key), position)
