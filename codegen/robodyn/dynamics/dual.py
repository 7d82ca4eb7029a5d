"""A scalar and its derivative along one direction: recursions over any scalar run on these as well.

They differentiate whatever is written over any scalar, exactly, and share nothing with derivatives that are
written out: functions are checked by them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.dynamics.arm import Arm, Motion
from robodyn.effects.scalars import quotient, sign, tangent


class Dual:
    """``value + slope e`` with ``e * e = 0``: ``+ - * /`` with others of its kind and with plain scalars.

    The derivative of ``sgn x`` is 0 everywhere.
    """

    __slots__ = ("slope", "value")
    #: Arrays of numpy leave arithmetic with these to these.
    __array_ufunc__ = None

    def __init__(self, value: Any, slope: Any) -> None:
        self.value, self.slope = value, slope

    def __neg__(self) -> Dual:
        return Dual(-self.value, -self.slope)

    def __add__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.value + other.value, self.slope + other.slope)
        return Dual(self.value + other, self.slope)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Dual:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Dual:
        return self.__neg__().__add__(other)

    def __mul__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.value * other.value, self.slope * other.value + self.value * other.slope)
        return Dual(self.value * other, self.slope * other)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            value = self.value / other.value
            return Dual(value, (self.slope - value * other.slope) / other.value)
        return Dual(quotient(self.value, other), quotient(self.slope, other))

    def __rtruediv__(self, other: Any) -> Dual:
        value = other / self.value
        return Dual(value, -(value * self.slope) / self.value)

    def sign(self) -> Dual:
        """-1, 0 or 1."""
        return Dual(sign(self.value), 0 * self.slope)

    def tanh(self) -> Dual:
        """Hyperbolic tangent."""
        value = tangent(self.value)
        return Dual(value, (1 - value * value) * self.slope)


def slopes(values: Sequence[Any]) -> list[Any]:
    """The derivatives of ``values``, 0 of plain scalars."""
    return [value.slope if isinstance(value, Dual) else 0 for value in values]


def values(scalars: Sequence[Any]) -> list[Any]:
    """What ``scalars`` are without their derivatives."""
    return [x.value if isinstance(x, Dual) else x for x in scalars]


def moving_along(
    arm: Arm, motion: Motion, dq: Sequence[Any], dqd: Sequence[Any], dqdd: Sequence[Any]
) -> Motion:
    """``motion`` of ``arm`` as duals, whose derivatives are those along the direction ``dq, dqd, dqdd`` [n]
    of positions, rates and accelerations."""
    c, s, d = list(motion.c), list(motion.s), list(motion.d)
    for i, body in enumerate(arm.bodies):
        if body.revolute:
            c[i], s[i] = Dual(c[i], -(s[i] * dq[i])), Dual(s[i], c[i] * dq[i])
        else:
            d[i] = Dual(d[i], dq[i])
    qd = tuple(map(Dual, motion.qd, dqd))
    qdd = tuple(map(Dual, motion.qdd, dqdd))
    return replace(motion, c=tuple(c), s=tuple(s), d=tuple(d), qd=qd, qdd=qdd)
