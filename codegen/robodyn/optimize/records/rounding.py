"""How much a record may lose to rounding: a program can be equal to the recursion and still be useless, as
``tau + (x + 1e20) - x - 1e20`` is.

The bound is the textbook's (N. Higham, Accuracy and Stability of Numerical Algorithms, chapter 3): each value
has a largest magnitude, all terms taken with the same sign, and each operation adds its own rounding to what
its operands bring. It holds wherever the inputs stay within the magnitudes given, not at samples only. And a
record is of no higher degree than the recursion in rates, accelerations, positions and parameters
(:func:`reading`), so that little happens between the magnitudes that are looked at.
A polynomial of low degree cannot be small at a few magnitudes and large between them; ``(qd / 7)^64`` can.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from typing import Final

from robodyn.ir.program import Input, Operand, Program
from robodyn.ir.signature import ScalarType

#: Kinds of inputs whose degrees are counted: positions, rates, accelerations and run-time parameters.
_KINDS = ("q", "qd", "qdd")
#: Degrees of one value stand in one number, so many bits each: a record has at most 1000 factors in a term.
_BITS = 16
_SHIFTS = tuple(_BITS * k for k in range(len(_KINDS) + 1))
_MOST = (1 << _BITS) - 1
_MASKS = tuple(_MOST << shift for shift in _SHIFTS)

Degrees = tuple[int, int, int, int]


@dataclass(frozen=True, slots=True)
class Reading:
    """Inputs that are read as ``angles``, in sines and cosines; those that are read as ``numbers``; and the
    highest ``degrees`` of any value in positions, rates, accelerations and run-time parameters."""

    angles: frozenset[Input]
    numbers: frozenset[Input]
    degrees: Degrees

    @property
    def positions(self) -> bool:
        """Whether positions are read as numbers: there are prismatic joints."""
        return self.degrees[0] > 0

    def within(self, other: Reading) -> bool:
        """Whether nothing is read otherwise than in ``other``, nor in a higher degree. Sines of positions
        that ``other`` does not read at all are harmless."""
        return (
            all(x.is_of("q") and x not in other.numbers for x in self.angles - other.angles)
            and self.numbers <= other.numbers
            and all(x <= y for x, y in zip(self.degrees, other.degrees, strict=True))
        )


def reading(program: Program) -> Reading:
    """How ``program`` reads its inputs."""
    used = _used(program)
    numbers: dict[Operand, int] = {}
    values: list[int] = []

    def degrees(operand: Operand) -> int:
        if operand.__class__ is int:
            return values[operand]
        if operand not in numbers:
            numbers[operand] = _first_degree(operand)
        return numbers[operand]

    highest = 0
    for k, (op, args, _) in enumerate(program.operations):
        if op == "sin" or op == "cos" or k not in used:
            value = 0
        elif op == "mul" or op == "div":
            value = degrees(args[0]) + degrees(args[1])
        elif op == "add" or op == "sub":
            value = _each_highest(degrees(args[0]), degrees(args[1]))
        elif op == "neg" or op == "abs":
            value = degrees(args[0])
        elif op == "select":
            highest = _each_highest(highest, degrees(args[0]))
            value = _each_highest(degrees(args[1]), degrees(args[2]))
        else:  # bounded
            highest, value = reduce(_each_highest, map(degrees, args), highest), 0
        values.append(value)
        highest = _each_highest(highest, value)
    for x in program.results():
        highest = _each_highest(highest, degrees(x))
    return Reading(
        frozenset(_angles(program)),
        frozenset(x for x in numbers if isinstance(x, Input)),
        tuple(highest >> shift & _MOST for shift in _SHIFTS),  # type: ignore[arg-type]  # four of them
    )


def _first_degree(operand: Operand) -> int:
    if not isinstance(operand, Input):
        return 0
    return 1 << _SHIFTS[_KINDS.index(operand.array) if operand.is_of(*_KINDS) else len(_KINDS)]


def _each_highest(a: int, b: int) -> int:
    if a == b or not b:
        return a
    if not a:
        return b
    return sum(max(a & mask, b & mask) for mask in _MASKS)


def _used(program: Program) -> set[int]:
    """The operations whose values reach a result, other than within a sine or cosine."""
    used = {x for x in program.results() if isinstance(x, int)}
    for k in range(len(program.operations) - 1, -1, -1):
        op, args, _ = program.operations[k]
        if k in used and op not in ("sin", "cos"):
            used.update(x for x in args if isinstance(x, int))
    return used


def _angles(program: Program) -> set[Input]:
    """Inputs that reach a sine or cosine through sums."""
    reached: set[Operand] = set()
    stack: list[Operand] = [op.args[0] for op in program.operations if op.op in ("sin", "cos")]
    while stack:
        operand = stack.pop()
        if operand in reached:
            continue
        reached.add(operand)
        if isinstance(operand, int):
            stack.extend(program.operations[operand].args)
    return {x for x in reached if isinstance(x, Input)}


@dataclass(frozen=True, slots=True)
class _Arithmetic:
    """Unit roundoff, half the smallest number, and the largest, of a floating-point format."""

    unit: float
    tiny: float
    largest: float


_ARITHMETIC: Final[Mapping[ScalarType, _Arithmetic]] = {
    "double": _Arithmetic(2.0**-53, 5e-324, 1.7976931348623157e308),
    "float": _Arithmetic(2.0**-24, 2.0**-150, 3.4028234663852886e38),
}

#: Magnitudes of positions (of prismatic joints [m]; an angle is at most a turn [rad]), rates and
#: accelerations at which bounds are compared: nearly at rest, fast without acceleration, a jerk from rest,
#: and far beyond any arm.
_STATES = ((0.01, 1e-3, 1e-3), (1.0, 30.0, 1e-3), (1.0, 1e-3, 1e3), (100.0, 1e3, 1e6))
#: Long axes, for arms whose positions are read as such.
_LONG = ((10.0, 1e-3, 1e-3), (100.0, 1e-3, 1e-3))
_TURN = 2 * math.pi
#: Magnitudes of run-time parameters: all of them, and each with the others at 1.
_PARAMETERS = (1e-6, 1e-3, 1e3, 1e6)

#: A record may lose so many times what the recursion loses, output by output; the worst of the records that
#: searches find loses 80 % of this. The torque of a joint may lose a share of what the largest torque may:
#: more nearly at rest, where torques without gravity vanish. An element of the mass matrix may not: it is
#: divided by.
_FACTOR, _SHARE, _SHARE_AT_REST = 100.0, 0.01, 0.1

#: How much more a tanh may be off than its argument is, relatively: x / cosh(x)^2 is at most this.
_STEEPEST = 0.45


class Rounding:
    """What a recursion loses to rounding in ``scalar``, and whether other programs lose about as little."""

    def __init__(self, recursion: Program, scalar: ScalarType = "double") -> None:
        self._arithmetic = _ARITHMETIC[scalar]
        self._reading = reading(recursion)
        self._parameters = tuple(x for x in recursion.inputs() if not x.is_of("q", "qd", "qdd"))
        self._moving = any(x.is_of("qd", "qdd") for x in recursion.inputs())
        self._allowed = list(self._bounds(recursion))

    def reads_as(self, program: Program) -> bool:
        """Whether ``program`` reads its inputs as the recursion does, in no higher degree."""
        return reading(program).within(self._reading)

    def allows(self, program: Program) -> bool:
        """Whether ``program`` loses at most 100 times what the recursion loses, output by output. Where one
        of the two overflows, the answer is no."""
        return all(
            self._within(errors, allowed, _SHARE_AT_REST if state == 0 else _SHARE)
            for state, (errors, allowed) in enumerate(zip(self._bounds(program), self._allowed, strict=True))
        )

    def _within(self, errors: list[float], allowed: list[float], share: float) -> bool:
        least = share * max(allowed, default=0.0) if self._moving else 0.0
        # Written so that NaN and infinity fail.
        return all(e <= _FACTOR * max(a, least) < math.inf for e, a in zip(errors, allowed, strict=True))

    def _bounds(self, program: Program) -> Iterator[list[float]]:
        """Of each state that is looked at, the largest rounding error of each output."""
        steps = _Steps(program, self._reading, self._arithmetic)
        states = _STATES if self._moving or self._reading.positions else _STATES[:1]
        for position, rate, acceleration in (*states, *(_LONG if self._reading.positions else ())):
            yield steps.errors({"q": position, "qd": rate, "qdd": acceleration}, {})
        for size in _PARAMETERS if self._parameters else ():
            together = dict.fromkeys(self._parameters, size)
            for parameters in (together, *({x: size} for x in self._parameters)):
                for position, rate, acceleration in _STATES[:2]:
                    yield steps.errors({"q": position, "qd": rate, "qdd": acceleration}, parameters)


class _Steps:
    """A program whose operands are places in one list: operations from the front, leaves from the end."""

    def __init__(self, program: Program, recursion: Reading, arithmetic: _Arithmetic) -> None:
        self._arithmetic = arithmetic
        self._numbers = recursion.numbers
        self._leaves: list[Operand] = []
        self._places: dict[Operand, int] = {}
        self._steps = [
            (op, self._place(args[0]), self._place(args[-1])) for op, args, _ in program.operations
        ]
        self._results = [self._place(operand) for operand in program.results()]
        self._constants = {
            k: self._constant(abs(x)) for k, x in enumerate(self._leaves) if isinstance(x, Fraction)
        }
        self._products = self._of_factors()

    def errors(self, arrays: Mapping[str, float], parameters: Mapping[Input, float]) -> list[float]:
        """The largest errors of the results where inputs have these magnitudes; parameters 1 if not given."""
        unit, tiny = self._arithmetic.unit, self._arithmetic.tiny
        n = len(self._steps)
        sizes, errors = [0.0] * n, [0.0] * n
        for k in range(len(self._leaves) - 1, -1, -1):  # the first leaf stands last
            size, error = self._constants.get(k, (0.0, 0.0))
            leaf = self._leaves[k]
            if isinstance(leaf, Input):
                angle = leaf.is_of("q") and leaf not in self._numbers
                size = _TURN if angle else _magnitude(leaf, arrays, parameters)
            sizes.append(size)
            errors.append(error)
        for k, (op, i, j) in enumerate(self._steps):
            x, ex = sizes[i], errors[i]
            if op == "mul":
                y, ey = sizes[j], errors[j]
                size = sizes[k] = x * y
                errors[k] = x * ey + y * ex + ex * ey + unit * size + tiny
            elif op == "add" or op == "sub":
                size = sizes[k] = x + sizes[j]
                errors[k] = ex + errors[j] + unit * size
            elif op == "neg" or op == "abs":
                sizes[k], errors[k] = x, ex
            elif op == "div":  # by what the recursion divides by as well: as large there
                sizes[k], errors[k] = x, ex + errors[j] + unit * x
            elif op == "sin" or op == "cos":
                sizes[k], errors[k] = 1.0, ex + unit
            elif op == "tanh" or op == "sign":
                relative = _STEEPEST * ex / x if x and self._products[i] else math.inf
                sizes[k], errors[k] = 1.0, min(2.0, ex, relative) + unit
            else:
                sizes[k], errors[k] = math.inf, math.inf
        if max(sizes, default=0.0) <= self._arithmetic.largest:
            return [errors[k] for k in self._results]
        return [math.inf for _ in self._results]

    def _place(self, operand: Operand) -> int:
        if operand.__class__ is int:
            return operand
        if operand not in self._places:
            self._leaves.append(operand)
            self._places[operand] = -len(self._leaves)
        return self._places[operand]

    def _of_factors(self) -> list[bool]:
        """Whether a value is a product of leaves, so that its error is one of its last digits."""
        signs: list[bool] = []
        for op, i, j in self._steps:
            signs.append(op in ("mul", "neg") and all(k < 0 or signs[k] for k in (i, j)))
        return signs + [True] * len(self._leaves)

    def _constant(self, size: Fraction) -> tuple[float, float]:
        """A constant as a number of the machine, and how far that is from it."""
        try:
            near = float(size)
        except OverflowError:
            return math.inf, math.inf
        if self._arithmetic.unit == 2.0**-53 and (not near or not 1e-290 < near < 1e290):
            return near, float(abs(Fraction(near) - size))
        return near, self._arithmetic.unit * near + self._arithmetic.tiny


def _magnitude(x: Input, arrays: Mapping[str, float], parameters: Mapping[Input, float]) -> float:
    return arrays[x.array] if x.is_of(*arrays) else parameters.get(x, 1.0)
