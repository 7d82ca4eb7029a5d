"""Counting what a variant costs, fast: its recursion over numbers of GF(2^61 - 1).

The same policy as :class:`~robodyn.optimize.merging.MergingGraph`, which builds the program of what is
found: values that are equal are one, constants fold. Here a quantity *is* its value at the random point,
constants are integers modulo the prime, and nothing exact is computed. Speed is the only reason for this
second graph; a test holds the two together.

The prime is fixed, and small enough for a machine word. A description may be written so that numbers
vanish or coincide in this field; the count is then wrong, and a dearer variant may be chosen. No program is
built here, so none can be wrong.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from fractions import Fraction
from typing import Any, Final

from robodyn.dynamics.arm import JointAngle

#: A Mersenne prime.
PRIME: Final = (1 << 61) - 1
_HALF: Final = PRIME // 2

#: How a value came by. An entry is ``(kind, the positions that it reads, more)``: for ``OFFSET``, u + k, more
#: is ``(u, k)``, for ``SCALE``, k u, it is k. A position is a value or its negative, whichever is smaller.
ADD, OFFSET, MUL, SCALE, INPUT, COS, SIN, CALL, NUMBER = range(9)
Entry = tuple[int, tuple[int, ...], Any]


def random_residue(name: str) -> int:
    """A number of the field, the same for the same name."""
    digest = hashlib.blake2b(f"merging {name}".encode(), digest_size=16).digest()
    return int.from_bytes(digest, "little") % PRIME


def residue(x: Fraction | int) -> int:
    """A rational's place in the field, never 0 of one that is not 0; of one that has none a random place."""
    if x.denominator % PRIME and (x.numerator % PRIME or not x):
        return x.numerator * pow(x.denominator, -1, PRIME) % PRIME
    return random_residue(f"number {x}")


def turned_by(first: tuple[int, int], second: tuple[int, int]) -> tuple[int, int]:
    """The point of the circle whose angle is the sum of two angles, each as (cos, sin)."""
    (c, s), (e, f) = first, second
    return (c * e - s * f) % PRIME, (s * e + c * f) % PRIME


def in_field(x: Any) -> Any:
    """A constant as an integer: small whole ones as they are, others modulo the prime. A value is one
    already."""
    if isinstance(x, Value):
        return x
    return x.numerator if x.denominator == 1 and -PRIME < x < PRIME else residue(x)


class Circle:
    """The random point at which an arm's variants are compared: cosines and sines of its joint angles."""

    def __init__(self) -> None:
        self._points: dict[Any, tuple[int, int]] = {}
        self._inputs: dict[tuple[str, int], int] = {}

    def input(self, array: str, index: int) -> int:
        """The value of an input."""
        key = (array, index)
        if key not in self._inputs:
            self._inputs[key] = random_residue(f"{array} {index}")
        return self._inputs[key]

    def joint(self, i: int) -> tuple[int, int]:
        """Cosine and sine of joint ``i``'s variable."""
        if i not in self._points:
            t = random_residue(f"circle q {i}")
            inverse = pow(1 + t * t, -1, PRIME)
            self._points[i] = ((1 - t * t) * inverse % PRIME, 2 * t * inverse % PRIME)
        return self._points[i]

    def of(self, angle: JointAngle) -> tuple[int, int]:
        """Cosine and sine of ``angle``, a constant of quarter turns left out."""
        key = (angle.terms, None if angle.offset.quarter is not None else angle.offset.radians)
        if key not in self._points:
            total = (1, 0)
            if angle.offset.quarter is None:
                total = (residue(angle.offset.cos), residue(angle.offset.sin))
            for joint, sign in angle.terms:
                c, s = self.joint(joint)
                total = turned_by(total, (c, s if sign > 0 else PRIME - s))
            self._points[key] = total
        return self._points[key]


class Value:
    """A value of a tally; ``+ - *`` with values and integers."""

    __slots__ = ("graph", "value")

    def __init__(self, graph: Tally, value: int) -> None:
        self.graph = graph
        self.value = value

    def __neg__(self) -> Value:
        return Value(self.graph, PRIME - self.value)

    def __add__(self, other: Any) -> Any:
        graph = self.graph
        if other.__class__ is Value:
            value = self.value + other.value
            if value >= PRIME:
                value -= PRIME
            position = value if value <= _HALF else PRIME - value
            if position in graph.entries:
                return Value(graph, value) if position > 1 else graph.number(value)
            return graph.summed(self.value, other.value, value)
        if not other:
            return self
        return graph.offset(self.value, other)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        graph = self.graph
        if other.__class__ is Value:
            u, v = self.value, other.value
            value = u * v % PRIME
            position = value if value <= _HALF else PRIME - value
            if position not in graph.entries:
                one, two = u if u <= _HALF else PRIME - u, v if v <= _HALF else PRIME - v
                graph.entries[position] = (MUL, (one, two), None)
            elif position <= 1:
                return graph.number(value)
            return Value(graph, value)
        if other.__class__ is int:
            if other == 1:
                return self
            if other == -1:
                return Value(graph, PRIME - self.value)
        return graph.scaled(self.value, other)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        if other.__class__ is Value:
            return self.graph.divided(self.value, other.value)
        return self * pow(residue(other), -1, PRIME)

    def __rtruediv__(self, other: Any) -> Any:
        return self.graph.divided(residue(other), self.value) if other else 0


class Tally:
    """The values that a recursion has come by, and how."""

    def __init__(self, circle: Circle) -> None:
        self.entries: dict[int, Entry] = {0: (NUMBER, (), None), 1: (NUMBER, (), None)}
        self.circle = circle

    # -- leaves -----------------------------------------------------------------------------------
    def input(self, array: str, index: int = -1) -> Value:
        """The input ``array[index]``, or the run-time parameter ``array``."""
        return self._at(self.circle.input(array, index), INPUT, ())

    def trigonometry(self, angle: JointAngle) -> tuple[Any, Any]:
        """Cosine and sine of ``angle``, as :func:`~robodyn.optimize.programs.turned` has them."""
        total: Any = 0
        for joint, sign in angle.terms:
            total = total + sign * self.input("q", joint)
        cosine, sine = int(angle.offset.cos), int(angle.offset.sin)
        if angle.offset.quarter is None:
            total = total + residue(Fraction(angle.offset.radians))
            cosine, sine = 1, 0
        c, s = self.circle.of(angle)
        reads = (_position(total.value),)
        c_value, s_value = self._at(c, COS, reads), self._at(s, SIN, reads)
        return cosine * c_value - sine * s_value, cosine * s_value + sine * c_value

    def sign(self, a: Any) -> Any:
        """Sign; odd."""
        return self._call("sign", a)

    def tanh(self, a: Any) -> Any:
        """Hyperbolic tangent; odd."""
        return self._call("tanh", a)

    def _call(self, name: str, a: Any) -> Any:
        if not isinstance(a, Value):
            return random_residue(f"{name} {a}") if a else 0
        position = _position(a.value)
        value = self._at(random_residue(f"{name} {position}"), CALL, (position,))
        return value if a.value == position else -value

    # -- operations, where the result is new -------------------------------------------------------
    def number(self, value: int) -> int:
        """0, 1 or -1, whose ``value`` this is."""
        return value if value <= 1 else value - PRIME

    def offset(self, u: int, k: Any) -> Any:
        """``u + k``, k a constant."""
        k = k % PRIME if k.__class__ is int else residue(k)
        value = (u + k) % PRIME
        position = value if value <= _HALF else PRIME - value
        if position in self.entries:
            return Value(self, value) if position > 1 else self.number(value)
        if not k:
            return Value(self, u)
        own = u if u <= _HALF else PRIME - u
        kind, _, more = self.entries[own]
        if kind == OFFSET:
            rest, more_k = more if own == u else (PRIME - more[0], PRIME - more[1])
            return self.offset(rest, more_k + k)
        if value != position:
            u, k = PRIME - u, PRIME - k
        self.entries[position] = (OFFSET, (own,), (u, k))
        return Value(self, value)

    def summed(self, u: int, v: int, value: int) -> Any:
        """``u + v``, which is ``value``."""
        entries = self.entries
        one, two = u if u <= _HALF else PRIME - u, v if v <= _HALF else PRIME - v
        if one == two:
            return self.scaled(u, 2)
        kind_one, reads_one, more_one = entries[one]
        kind_two, reads_two, more_two = entries[two]
        if kind_one == SCALE or kind_two == SCALE:
            x, ka = (reads_one[0], more_one) if kind_one == SCALE else (one, 1)
            y, kb = (reads_two[0], more_two) if kind_two == SCALE else (two, 1)
            if x == y:  # k x + l x = (k + l) x
                return self.scaled(x, (ka if one == u else -ka) + (kb if two == v else -kb))
        if kind_one == OFFSET and kind_two == OFFSET:  # (x + c) + (y + d) = (x + y) + (c + d)
            ru, k = more_one if one == u else (PRIME - more_one[0], PRIME - more_one[1])
            rv, m = more_two if two == v else (PRIME - more_two[0], PRIME - more_two[1])
            return Value(self, ru) + Value(self, rv) + (k + m)
        entries[value if value <= _HALF else PRIME - value] = (ADD, (one, two), None)
        return Value(self, value)

    def scaled(self, u: int, k: Any) -> Any:
        """``k u``, k a constant."""
        k = k % PRIME if k.__class__ is int else residue(k)
        value = u * k % PRIME
        position = value if value <= _HALF else PRIME - value
        if position in self.entries:
            return Value(self, value) if position > 1 else self.number(value)
        own = u if u <= _HALF else PRIME - u
        if own != u:
            k = -k
        kind, reads, more = self.entries[own]
        if kind == SCALE:
            own, k = reads[0], k * more
        self.entries[position] = (SCALE, (own,), (k if value == position else -k) % PRIME)
        return Value(self, value)

    def divided(self, u: int, v: int) -> Value:
        """``u / v``; what it costs is the same in every variant, and is not counted."""
        reads = tuple(p for p in map(_position, (u, v)) if p in self.entries)
        return self._at(u * pow(v, -1, PRIME) % PRIME, CALL, reads)

    def _at(self, value: int, kind: int, reads: tuple[int, ...]) -> Value:
        self.entries.setdefault(_position(value), (kind, reads, None))
        return Value(self, value)

    # -- counting ---------------------------------------------------------------------------------
    def needed(self, outputs: Iterable[Any]) -> set[int]:
        """The positions that ``outputs`` need."""
        entries = self.entries
        stack = [_position(value.value) for value in outputs if value.__class__ is Value]
        wanted: set[int] = set()
        while stack:
            position = stack.pop()
            if position not in wanted:
                wanted.add(position)
                stack += entries[position][1]
        return wanted


def _position(value: int) -> int:
    return value if value <= _HALF else PRIME - value
