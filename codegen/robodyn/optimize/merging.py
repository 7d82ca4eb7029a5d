"""A graph that merges nodes of equal value, however they were come by.

Equal is what agrees at one random point of a finite field, where every rational constant has its place and
sines and cosines obey the addition theorems. The field is drawn from a hash of the robot
(:mod:`robodyn.ir.field`): neither chance nor whoever writes a robot's file makes two values that differ one.
What is built so is compared with the plain recursion in other fields before it is shown
(:mod:`robodyn.dynamics.equality`).
"""

from __future__ import annotations

from fractions import Fraction

from robodyn.ir.digits import MOST_POSITIONS, too_large
from robodyn.ir.field import Field
from robodyn.ir.graph import Graph, Node, Scalar, sum_of
from robodyn.ir.key import Key, children
from robodyn.robot.values import circle_point

#: Operations that are found by their values.
_BY_VALUE = ("add", "mul", "scale")
#: What stands for position 0, beyond the numbers that stand for themselves.
_FIRST = 2


class MergingGraph(Graph):
    """A graph in which a node is its value at a random point of ``field``.

    :class:`~robodyn.ir.field.Vanishes` is raised where a constant that is not zero would be zero there.
    """

    def __init__(self, field: Field) -> None:
        super().__init__()
        self.field = field
        self._prime = field.prime
        self._value: list[int] = []
        #: What has a value already: a number -1, 0 or 1, or ``_FIRST`` + position, negative of minus a node.
        #: No nodes: they would keep the graph, and it them, until Python looks for such circles.
        self._by_value: dict[int, int] = {0: 0, 1: 1, field.prime - 1: -1}

    def _of(self, a: Scalar) -> int:
        if isinstance(a, Node):
            value = self._value[a.position]
            return value if a.sign > 0 else -value
        return self.field.number(a)

    def _known(self, known: int) -> Scalar:
        """What stands in the table as ``known``."""
        if known >= _FIRST:
            return Node(self, known - _FIRST, 1)
        return known if known > -_FIRST else Node(self, -known - _FIRST, -1)

    def add(self, a: Scalar, b: Scalar) -> Scalar:
        """``a + b``."""
        if isinstance(a, Node) and isinstance(b, Node):
            value = (self._of(a) + self._of(b)) % self._prime
            known = self._by_value.get(value)
            if known is not None:
                return self._known(known)
            simpler = self._simpler_sum(a, b)
            if simpler is not None:
                return simpler
            key, sign = sum_of(a, b)
            return Node(self, self._appended(key, value if sign > 0 else self._prime - value), sign)
        if isinstance(a, Node) or isinstance(b, Node):
            known = self._by_value.get((self._of(a) + self._of(b)) % self._prime)
            if known is not None:
                return self._known(known)
        return super().add(a, b)

    def mul(self, a: Scalar, b: Scalar) -> Scalar:
        """``a * b``."""
        if isinstance(a, Node) and isinstance(b, Node):
            i, j = a.position, b.position
            sign = a.sign * b.sign
            value = self._value[i] * self._value[j] % self._prime
            known = self._by_value.get(value)
            if known is not None:
                return self._known(known * sign)
            return Node(self, self._appended(("mul", i, j) if i <= j else ("mul", j, i), value), sign)
        if isinstance(a, Node) or isinstance(b, Node):
            known = self._by_value.get(self._of(a) * self._of(b) % self._prime)
            if known is not None:
                return self._known(known)
        return super().mul(a, b)

    def _node(self, key: Key, sign: int = 1, known: Key | None = None) -> Node:
        if key[0] in _BY_VALUE:  # sums and products come here with new values only
            return Node(self, self._appended(key, self._evaluated(key)), sign)
        known = known or key
        position = self._table.get(known)
        if position is None:
            position = self._table[known] = self._appended(key, self._evaluated(key))
        return Node(self, position, sign)

    def _appended(self, key: Key, value: int) -> int:
        position = len(self.keys)
        if position >= MOST_POSITIONS:
            raise too_large()
        self.keys.append(key)
        self.reads.append(children(key))
        self._value.append(value)
        if key[0] != "const" and value not in self._by_value:
            self._by_value[value] = _FIRST + position
            self._by_value[self._prime - value] = -_FIRST - position
        return position

    def _evaluated(self, key: Key) -> int:
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
