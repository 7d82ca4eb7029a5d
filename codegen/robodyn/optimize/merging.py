"""A graph that merges nodes of equal value, however they were come by.

Equal is what agrees at one random point of a finite field, where every rational constant has its place and
sines and cosines obey the addition theorems. The field is drawn from a hash of the robot
(:mod:`robodyn.ir.field`): neither chance nor whoever writes a robot's file makes two values that differ one.
What is built so is compared with the plain recursion in other fields before it is shown
(:mod:`robodyn.dynamics.equality`).
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.ir.field import Field
from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.robot.values import circle_point


class MergingGraph(Graph):
    """A graph in which a node is its value at a random point of ``field``.

    :class:`~robodyn.ir.field.Vanishes` is raised where a constant that is not zero would be zero there.
    """

    def __init__(self, field: Field) -> None:
        super().__init__()
        self.field = field
        self._half = field.prime // 2
        self._value: list[int] = []
        self._by_value: dict[int, tuple[int, int]] = {1: (-1, 1)}

    def _known(self, value: int) -> Scalar | None:
        """What has ``value`` already: a number 0 or 1, a node, or the negative of one."""
        if not value:
            return 0
        large = value > self._half
        entry = self._by_value.get(self.field.prime - value if large else value)
        if entry is None:
            return None
        position, sign = entry
        if large:
            sign = -sign
        return sign if position < 0 else Node(self, position, sign)

    def _of(self, a: Scalar) -> int:
        if isinstance(a, Node):
            return self._value[a.position] if a.sign > 0 else self.field.prime - self._value[a.position]
        return self.field.number(a)

    def add(self, a: Scalar, b: Scalar) -> Scalar:
        """``a + b``."""
        if isinstance(a, Node) or isinstance(b, Node):
            known = self._known((self._of(a) + self._of(b)) % self.field.prime)
            if known is not None:
                return known
        return super().add(a, b)

    def mul(self, a: Scalar, b: Scalar) -> Scalar:
        """``a * b``."""
        if isinstance(a, Node) or isinstance(b, Node):
            known = self._known(self._of(a) * self._of(b) % self.field.prime)
            if known is not None:
                return known
        return super().mul(a, b)

    def _node(self, key: tuple[Any, ...], sign: int = 1) -> Node:
        position = super()._node(key, 1).position
        if position == len(self._value):
            value = self._evaluated(key)
            self._value.append(value)
            if key[0] != "const":
                large = value > self._half
                self._by_value.setdefault(
                    self.field.prime - value if large else value, (position, -1 if large else 1)
                )
        return Node(self, position, sign)

    def _evaluated(self, key: tuple[Any, ...]) -> int:
        value, field = self._value, self.field
        op: str = key[0]
        at: tuple[int, ...] = key[1:]
        if op == "add":
            return (value[at[0]] + at[1] * value[at[2]]) % field.prime
        if op == "mul":
            return value[at[0]] * value[at[1]] % field.prime
        if op == "scale":
            return field.number(key[1]) * value[at[1]] % field.prime
        if op == "const":
            return field.number(key[1])
        if op in ("cos", "sin"):
            return self._angle(at[0])[op == "sin"]
        if op == "div":
            return value[at[0]] * pow(value[at[1]], -1, field.prime) % field.prime
        return field.variable(key[1]) if op == "input" else field.random(f"{key}")

    def _angle(self, position: int) -> tuple[int, int]:
        """The point of the circle of the angle at ``position``: a sum of inputs and constants."""
        key = self.keys[position]
        if key[0] == "input":
            return self.field.angle(key[1])
        if key[0] == "const":
            return self._constant_angle(key[1])
        if key[0] == "add":
            c, s = self._angle(key[3])
            return self.field.turn(self._angle(key[1]), (c, s if key[2] > 0 else -s))
        return self.field.circle(f"{key} {position}")

    def _constant_angle(self, angle: Fraction) -> tuple[int, int]:
        """The point of the circle of a constant angle [rad]."""
        c, s = circle_point(angle)
        return self.field.number(c), self.field.number(s)
