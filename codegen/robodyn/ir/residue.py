"""Elements of a finite field that behave like numbers, so that a recursion over any scalar runs on them."""

from __future__ import annotations

from fractions import Fraction

from robodyn.ir.field import Field

Number = int | Fraction


class Residue:
    """An element of ``field``: ``+ - * /`` with elements, integers and fractions; functions that arithmetic
    alone does not have are random ones, as in :func:`~robodyn.ir.fingerprint.fingerprint`."""

    __slots__ = ("field", "value")

    def __init__(self, field: Field, value: int) -> None:
        self.field = field
        self.value = value

    def _of(self, other: Residue | Number) -> int | None:
        """``other`` as an element of the field; None: it knows better what to do with one."""
        if other.__class__ is Residue:
            return other.value
        return self.field.number(other) if isinstance(other, (int, Fraction)) else None

    def __add__(self, other: Residue | Number) -> Residue:
        if other.__class__ is int and not other:
            return self
        value = other.value if other.__class__ is Residue else self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, (self.value + value) % self.field.prime)

    __radd__ = __add__

    def __sub__(self, other: Residue | Number) -> Residue:
        value = other.value if other.__class__ is Residue else self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, (self.value - value) % self.field.prime)

    def __rsub__(self, other: Number) -> Residue:
        value = self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, (value - self.value) % self.field.prime)

    def __mul__(self, other: Residue | Number) -> Residue:
        if other.__class__ is int and other == 1:
            return self
        value = other.value if other.__class__ is Residue else self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, self.value * value % self.field.prime)

    __rmul__ = __mul__

    def __truediv__(self, other: Residue | Number) -> Residue:
        value = self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, self.value * self._inverse(value) % self.field.prime)

    def __rtruediv__(self, other: Number) -> Residue:
        value = self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, value * self._inverse(self.value) % self.field.prime)

    def _inverse(self, value: int) -> int:
        if not value:
            raise ZeroDivisionError("division by what is zero at a random point")
        return pow(value, -1, self.field.prime)

    def __neg__(self) -> Residue:
        return Residue(self.field, -self.value % self.field.prime)

    def __abs__(self) -> Residue:
        return self._call("abs")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (Residue, int, Fraction)) and self.value == self._of(other)

    def __hash__(self) -> int:
        return hash(self.value)

    def sign(self) -> Residue:
        """Sign; odd."""
        return self._call("sign")

    def tanh(self) -> Residue:
        """Hyperbolic tangent; odd."""
        return self._call("tanh")

    def atan2(self, x: Residue | Number) -> Residue:
        """The angle of the point (``x``, this)."""
        return self._call("atan2", x)

    def select(self, a: Residue | Number, b: Residue | Number) -> Residue:
        """``a`` where this is more than 0, else ``b``."""
        return self._call("select", a, b)

    def _call(self, op: str, *others: Residue | Number) -> Residue:
        values = [x.value if isinstance(x, Residue) else self.field.number(x) for x in others]
        return Residue(self.field, self.field.opaque(op, self.value, *values))

    def __repr__(self) -> str:
        return f"{self.value:x} mod {self.field.prime:x}"
