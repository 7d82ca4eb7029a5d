"""A graph of hash-consed nodes that behave like numbers.

Equal nodes are one node the moment they are written, so common-subexpression elimination is not a
search. A node is a sign and a position: ``x - y`` and ``y - x`` are one position with two signs, and
a minus costs nothing until a program is written out (:func:`~robodyn.ir.lowering.lower`).

Constants stay plain :class:`~fractions.Fraction`; arithmetic among constants never enters the graph,
and ``0 * x``, ``1 * x``, ``x + 0`` give what they should at once.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any, Union

from robodyn.ir.digits import MOST_POSITIONS, check_digits, too_large
from robodyn.ir.key import Key, children, multiple, plain_sum
from robodyn.ir.program import Input, Label, Operand, Program

Scalar = Union["Node", Fraction, int]


class Node:
    """A signed value of a graph; ``+ - * /`` with nodes, integers and fractions."""

    __slots__ = ("graph", "position", "sign")

    def __init__(self, graph: Graph, position: int, sign: int) -> None:
        self.graph = graph
        self.position = position
        self.sign = sign

    def __neg__(self) -> Node:
        return Node(self.graph, self.position, -self.sign)

    def __add__(self, other: Scalar) -> Scalar:
        if other.__class__ is int and not other:  # very often
            return self
        if isinstance(other, (Node, int, Fraction)):
            return self.graph.add(self, other)
        return NotImplemented

    __radd__ = __add__

    def __sub__(self, other: Scalar) -> Scalar:
        if isinstance(other, (Node, int, Fraction)):
            return self.graph.add(self, -other)
        return NotImplemented

    def __rsub__(self, other: Fraction | int) -> Scalar:
        if isinstance(other, (int, Fraction)):
            return self.graph.add(-self, other)
        return NotImplemented

    def __mul__(self, other: Scalar) -> Scalar:
        if other.__class__ is int and -1 <= other <= 1:
            return self if other == 1 else -self if other else 0
        if isinstance(other, (Node, int, Fraction)):
            return self.graph.mul(self, other)
        return NotImplemented

    __rmul__ = __mul__

    def __truediv__(self, other: Scalar) -> Scalar:
        if isinstance(other, Node):
            return self.graph.div(self, other)
        if isinstance(other, (int, Fraction)):
            return self.graph.mul(self, 1 / Fraction(other))
        return NotImplemented

    def __rtruediv__(self, other: Fraction | int) -> Scalar:
        if isinstance(other, (int, Fraction)):
            return self.graph.div(other, self)
        return NotImplemented

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Node):
            return False
        same_graph = self.graph is other.graph
        return same_graph and (self.position, self.sign) == (other.position, other.sign)

    def __hash__(self) -> int:
        return hash((self.position, self.sign))

    def __repr__(self) -> str:
        return f"{'-' if self.sign < 0 else ''}%{self.position}"


class Graph:
    """Owner of nodes. ``fold=False`` merges equal nodes and does no algebra besides."""

    def __init__(self, *, fold: bool = True) -> None:
        self.fold = fold
        #: What each position is. Operands have smaller positions: the order of creation is one of evaluation.
        self.keys: list[Key] = []
        #: The positions that each one reads; what each, taken with sign +1, is part of.
        self.reads: list[tuple[int, ...]] = []
        self.labels: dict[int, Label] = {}
        self._table: dict[Key, int] = {}

    # -- leaves ---------------------------------------------------------------------------------
    def input(self, array: str, index: int | None = None) -> Node:
        """The input ``array[index]``, or the run-time parameter ``array``."""
        return self._node(("input", Input(array, index)))

    def constant(self, value: Fraction | int) -> Node:
        """A constant as a node; rarely needed, since constants mix with nodes as they are."""
        size = abs(Fraction(value))
        return self._node(("const", size), -1 if value < 0 else 1, ("const", *size.as_integer_ratio()))

    def label(self, value: Any, label: Label) -> Any:
        """Name ``value`` if it is a node that has no name yet; hand it back."""
        if isinstance(value, Node) and self.keys[value.position][0] not in ("input", "const"):
            self.labels.setdefault(value.position, label if value.sign > 0 else label.flipped())
        return value

    # -- operations -----------------------------------------------------------------------------
    def add(self, a: Scalar, b: Scalar) -> Scalar:
        """``a + b``."""
        if not isinstance(a, Node):
            return self.add(b, a) if isinstance(b, Node) else a + b
        if not isinstance(b, Node):
            if b == 0:
                return a
            b = self.constant(b)
        simpler = self._simpler_sum(a, b)
        return self._node(*sum_of(a, b)) if simpler is None else simpler

    def mul(self, a: Scalar, b: Scalar) -> Scalar:
        """``a * b``."""
        if not isinstance(a, Node):
            return self.mul(b, a) if isinstance(b, Node) else a * b
        if isinstance(b, Node):
            i, j = a.position, b.position
            return self._node(("mul", i, j) if i <= j else ("mul", j, i), a.sign * b.sign)
        numerator, denominator = b.as_integer_ratio()  # arithmetic of Fractions is slow
        if not numerator:
            return 0
        sign, position, factor = a.sign, a.position, b
        if numerator < 0:
            sign, factor, numerator = -sign, -b, -numerator
        if numerator == 1 == denominator:
            return Node(self, position, sign)
        if self.fold:
            key = self.keys[position]
            if key[0] == "const":
                constant: Fraction = sign * factor * key[1]
                return constant
            if key[0] == "scale":
                factor, position = factor * key[1], key[2]
                numerator, denominator = factor.as_integer_ratio()
                if numerator == 1 == denominator:
                    return Node(self, position, sign)
        factor = Fraction(factor) if isinstance(factor, int) else factor
        return self._node(("scale", factor, position), sign, ("scale", numerator, denominator, position))

    def div(self, a: Scalar, b: Scalar) -> Scalar:
        """``a / b``."""
        if not isinstance(b, Node):
            return self.mul(a, 1 / Fraction(b))
        if not isinstance(a, Node):
            if a == 0:
                return 0
            a = self.constant(a)
        if self.fold and a.position == b.position:
            return Fraction(a.sign * b.sign)
        return self._node(("div", a.position, b.position), a.sign * b.sign)

    def sin(self, a: Scalar) -> Scalar:
        """Sine; odd."""
        return self._odd("sin", a)

    def cos(self, a: Scalar) -> Scalar:
        """Cosine; even."""
        if not isinstance(a, Node) and a == 0:
            return Fraction(1)
        return self._node(("cos", self._as_node(a).position))

    def sqrt(self, a: Scalar) -> Scalar:
        """Square root."""
        return self._signed("sqrt", a)

    def tanh(self, a: Scalar) -> Scalar:
        """Hyperbolic tangent; odd."""
        return self._odd("tanh", a)

    def sign(self, a: Scalar) -> Scalar:
        """Sign, 0 at 0; odd."""
        return self._odd("sign", a)

    def abs(self, a: Scalar) -> Scalar:
        """Absolute value; even."""
        return self._node(("abs", a.position)) if isinstance(a, Node) else max(a, -a)

    def exp(self, a: Scalar) -> Scalar:
        """Exponential."""
        if not isinstance(a, Node) and a == 0:
            return Fraction(1)
        return self._signed("exp", a)

    def pow(self, a: Scalar, b: Scalar) -> Scalar:
        """``a`` to the power of ``b``, for ``a`` of 0 or more; whole powers up to 4 are products."""
        if not isinstance(b, Node) and b in (1, 2, 3, 4):
            square = a if b == 1 else self.mul(a, a)
            return square if b <= 2 else self.mul(square, a if b == 3 else square)
        return self._signed("pow", a, b)

    def atan2(self, y: Scalar, x: Scalar) -> Scalar:
        """The angle of the point (x, y), within [-pi, pi]; 0 of two zeros. Odd in ``y``."""
        if not isinstance(y, Node) and not isinstance(x, Node) and y == 0 <= x:
            return 0
        sign = self._as_node(y).sign
        return sign * self._signed("atan2", sign * y, x)

    def select(self, condition: Scalar, a: Scalar, b: Scalar) -> Scalar:
        """``a`` where ``condition`` is more than 0, else ``b``."""
        if not isinstance(condition, Node):
            return a if condition > 0 else b
        if a == b:
            return a
        sign = self._as_node(b if a == 0 else a).sign
        return sign * self._signed("select", condition, sign * a, sign * b)

    def apply(self, op: str, args: Sequence[Scalar]) -> Scalar:
        """An operation by its name in a program."""
        if op == "sub":
            return self.add(args[0], -args[1])
        if op == "neg":
            return -args[0]
        result: Scalar = getattr(self, op)(*args)
        return result

    def replay(self, program: Program, inputs: Mapping[Input, Scalar] | None = None) -> list[Scalar]:
        """Build ``program`` in this graph; the values of its outputs, one after another, with
        ``inputs`` in the place of inputs."""
        value = self._reader(self.replay_all(program, inputs), inputs or {})
        return [value(operand) for operand in program.results()]

    def replay_all(self, program: Program, inputs: Mapping[Input, Scalar] | None = None) -> list[Scalar]:
        """The same; the values of its operations."""
        values: list[Scalar] = []
        value = self._reader(values, inputs or {})
        for op, args, label in program.operations:
            node = self.apply(op, [value(arg) for arg in args])
            if label is not None:
                self.label(node, label)
            self._check_digits(node)
            values.append(node)
        return values

    def _reader(self, values: list[Scalar], inputs: Mapping[Input, Scalar]) -> Callable[[Operand], Scalar]:
        """What an operand of a program is here, where its operations are ``values``."""

        def value(operand: Operand) -> Scalar:
            if isinstance(operand, int):
                return values[operand]
            if isinstance(operand, Input):
                return inputs[operand] if operand in inputs else self.input(*operand)
            return operand

        return value

    def _check_digits(self, value: Scalar) -> None:
        key = self.keys[value.position] if isinstance(value, Node) else ("const", value)
        if key[0] == "const" or key[0] == "scale":
            check_digits(key[1])

    def position(self, key: Key, known: Key | None = None) -> int:
        """The position of ``key``, a new one if there is none yet; the table has it as ``known``."""
        # A Fraction's hash takes a modular inverse; its two integers, in ``known``, do as well.
        known = known or key
        position = self._table.get(known)
        if position is None:
            position = self._table[known] = len(self.keys)
            if position >= MOST_POSITIONS:
                raise too_large()
            self.keys.append(key)
            self.reads.append(key[1:] if key[0] == "mul" else children(key))
        return position

    # -- inside ---------------------------------------------------------------------------------
    def _node(self, key: Key, sign: int = 1, known: Key | None = None) -> Node:
        return Node(self, self.position(key, known), sign)

    def _as_node(self, a: Scalar) -> Node:
        return a if isinstance(a, Node) else self.constant(a)

    def _signed(self, op: str, *operands: Scalar) -> Node:
        nodes = map(self._as_node, operands)
        return self._node((op, *(x for node in nodes for x in (node.position, node.sign))))

    def _odd(self, op: str, a: Scalar) -> Scalar:
        if not isinstance(a, Node) and a == 0:
            return 0
        a = self._as_node(a)
        return self._node((op, a.position), a.sign)

    def _simpler_sum(self, a: Node, b: Node) -> Scalar | None:
        """``a + b`` where algebra makes less of it than an addition, else None."""
        i, j = a.position, b.position
        if not self.fold or plain_sum(self.keys, i, j):
            return None
        if i == j:
            return self.mul(Node(self, i, 1), a.sign + b.sign)
        one, other = self.keys[i], self.keys[j]
        if one[0] == "scale" or other[0] == "scale":  # k x + l x = (k + l) x
            (ka, x), (kb, _) = multiple(one, i), multiple(other, j)
            return self.mul(Node(self, x, 1), a.sign * ka + b.sign * kb)
        (rest_a, ca), (rest_b, cb) = self._offset(a), self._offset(b)
        if ca and cb:  # (x + c) + (y + d) = (x + y) + (c + d)
            return self.add(rest_a, rest_b) + (ca + cb)
        return None

    def _offset(self, a: Node) -> tuple[Scalar, Fraction | int]:
        """``a`` as a value plus a constant."""
        key = self.keys[a.position]
        if key[0] == "const":
            return 0, a.sign * key[1]
        if key[0] == "add":
            _, i, relative, j = key
            if self.keys[j][0] == "const":
                return Node(self, i, a.sign), a.sign * relative * self.keys[j][1]
            if self.keys[i][0] == "const":
                return Node(self, j, a.sign * relative), a.sign * self.keys[i][1]
        return a, 0


def sum_of(a: Node, b: Node) -> tuple[Key, int]:
    """``a + b``: an operation of which it is plus or minus the value, and that sign."""
    if a.position > b.position:
        a, b = b, a
    return ("add", a.position, a.sign * b.sign, b.position), a.sign
