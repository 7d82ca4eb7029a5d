"""Our own bound of rounding errors: interval arithmetic, error by error through the program.

It is coarser than Gappa's where that knows more, and shares nothing with it: a check of sanity, and what
bounds the errors of angles before a sine is taken of them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from robodyn.errors import InputError
from robodyn.ir.program import Input, Operand, Program

#: Binary digits of the type, and the exponent of its smallest subnormal number.
DIGITS = {"float": 24, "double": 53}
SMALLEST = {"float": -149, "double": -1074}
LARGEST = {"float": (2.0 - 2.0**-23) * 2.0**127, "double": math.nextafter(math.inf, 0)}

#: Operations with a bound here and in Gappa's scripts.
BOUNDED = frozenset({"add", "sub", "mul", "neg", "sin", "cos", "sign", "abs"})

_NO_BOUND = "no bound of rounding errors can be proven of this kernel"
_OTHERS = "choose the other proofs: --only eva,stack,misra"


def up(x: float) -> float:
    """The next double above."""
    return math.nextafter(x, math.inf)


def down(x: float) -> float:
    """The next double below."""
    return math.nextafter(x, -math.inf)


@dataclass(frozen=True, slots=True)
class Bounded:
    """The exact value lies in [low, high], the computed one no farther than ``error`` from it."""

    low: float
    high: float
    error: float = 0.0

    @property
    def size(self) -> float:
        """The largest absolute exact value."""
        return max(abs(self.low), abs(self.high))


def ulp(size: float, scalar: str) -> float:
    """The distance of neighbours of the type just below or at ``size``, or more."""
    if size == 0.0:
        return 2.0 ** SMALLEST[scalar] if scalar == "float" else 5e-324
    exponent = math.frexp(size)[1]  # size < 2**exponent
    return math.ldexp(1.0, max(exponent - DIGITS[scalar], SMALLEST[scalar]))


def enclosed(value: Fraction) -> tuple[float, float]:
    """Doubles to both sides of ``value``, equal where it is one."""
    near = float(value)
    exact = Fraction(near)
    return (near if exact <= value else down(near)), (near if exact >= value else up(near))


class Forward:
    """The values of ``program`` computed in ``scalar`` while inputs stay in ``ranges``.

    ``trig_ulps`` bounds the error of sine and cosine in units in the last place below 1 (2^-24, 2^-53), while
    the angle is within ``limit`` [rad] (None: wherever it is).

    Raises
    ------
    InputError: an operation whose error nobody states.
    """

    def __init__(
        self,
        program: Program,
        ranges: Mapping[Input, tuple[Fraction, Fraction]],
        scalar: str,
        trig_ulps: float,
        limit: float | None = None,
    ) -> None:
        self.limit = limit
        self.program, self.ranges, self.scalar = program, ranges, scalar
        self.trig = trig_ulps * 2.0 ** -DIGITS[scalar]
        self.values: list[Bounded] = []
        for op, args, _ in program.operations:
            if op not in BOUNDED:
                raise InputError(
                    _NO_BOUND,
                    found=f"the operation {op}",
                    expected=f"nothing but {', '.join(sorted(BOUNDED))}",
                    remedy=_OTHERS,
                )
            self.values.append(self._operation(op, args))

    def of(self, operand: Operand) -> Bounded:
        """An operation's value, an input's, or a constant's once it is rounded to the type."""
        if isinstance(operand, int):
            return self.values[operand]
        if isinstance(operand, Input):
            if operand not in self.ranges:
                raise InputError(
                    _NO_BOUND, found=f"the input {operand}, of which no range is known", remedy=_OTHERS
                )
            low, high = self.ranges[operand]
            return Bounded(enclosed(low)[0], enclosed(high)[1])
        low_, high_ = enclosed(operand)
        error = abs(Fraction(as_scalar(operand, self.scalar)) - operand)
        return Bounded(low_, high_, enclosed(error)[1])

    def _operation(self, op: str, args: tuple[Operand, ...]) -> Bounded:
        x = self.of(args[0])
        if op in ("sin", "cos"):  # neither grows faster than its argument
            if self.limit is not None and not x.size + x.error <= self.limit:
                raise InputError(
                    "an angle is beyond what the sine and cosine are made for",
                    found=f"up to {x.size:g} rad",
                    expected=f"at most {self.limit:g} rad",
                    remedy="give smaller ranges, as --ranges q=2*pi",
                )
            return Bounded(-1.0, 1.0, up(x.error + self.trig))
        if op == "neg":
            return Bounded(-x.high, -x.low, x.error)
        if op == "abs":
            return Bounded(max(x.low, -x.high, 0.0), x.size, x.error)
        if op == "sign":
            if not isinstance(args[0], Input):
                raise InputError(_NO_BOUND, found="the sign of a computed value, which jumps", remedy=_OTHERS)
            return Bounded(-1.0, 1.0)
        y = self.of(args[1])
        if op == "mul":
            return self._product(x, y, square=args[0] == args[1])
        if op == "sub":
            y = Bounded(-y.high, -y.low, y.error)
        low, high, carried = down(x.low + y.low), up(x.high + y.high), up(x.error + y.error)
        return self._rounded(low, high, carried)

    def _product(self, x: Bounded, y: Bounded, *, square: bool) -> Bounded:
        corners = [a * b for a in (x.low, x.high) for b in (y.low, y.high)]
        low, high = (0.0 if square else down(min(corners))), up(max(corners))
        carried = up(up(up(x.size * y.error) + up(y.size * x.error)) + up(x.error * y.error))
        return self._rounded(low, high, carried)

    def _rounded(self, low: float, high: float, carried: float) -> Bounded:
        size = up(max(abs(low), abs(high)) + carried)
        if not size < LARGEST[self.scalar]:
            raise InputError(f"within the ranges a value of the kernel may not fit into a {self.scalar}")
        return Bounded(low, high, up(carried + ulp(size, self.scalar) / 2))


def as_scalar(value: Fraction, scalar: str) -> float:
    """``value`` rounded to the type, as the literal in C is."""
    from robodyn.emit.spelling import nearest_float

    return nearest_float(value) if scalar == "float" else float(value)
