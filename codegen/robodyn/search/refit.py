"""The same operations with other constants: a program of one arm made into that of another one.

Arms that are built alike, with other lengths and masses, differ in the constants of their best programs. A
path of arms, whose function is a polynomial in t, leads from the arm of the program (t = 0) to the other
(t = 1). The constants are power series in t that keep the program equal to the function: order by order a
linear system, at some points of a finite field, that is eliminated once. They are rational functions of t,
which the series tell; their values at 1 are recognised as fractions.

Nothing is proven here: the series may end at a program that is another function, which shows when it is
compared.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Final

from robodyn.ir.field import Field
from robodyn.ir.fingerprint import fingerprint
from robodyn.ir.program import Input, Operand, Program
from robodyn.optimize.records.record import values_in
from robodyn.robot.values import circle_point
from robodyn.search.modular import Elimination, fraction_of, value_at_one

#: Mersenne primes: of the first fractions of 80 digits are recognised, of the second those of 320.
_PRIMES: Final = (2**607 - 1, 2**2203 - 1)
#: Lengths of the series after which their functions are looked for; of six joints, degrees are up to 9.
_LENGTHS: Final = (8, 16, 28)
#: Points are added until so many in a row say nothing new: what has no solution shows by them.
_IDLE: Final = 2
_FIXED: Final = ("sin", "cos")
_OPERATIONS: Final = frozenset(("add", "sub", "mul", "neg", *_FIXED))

Clock = Callable[[], float]


def refitted(
    program: Program, path: Sequence[Program], end: float, clock: Clock = time.monotonic
) -> Program | None:
    """``program``, which computes ``path[0]``, with constants for ``path[1]``.

    ``path`` has the function at t = 0, 1, 2, ... as programs, of which there are more than the degree in t.
    None where the constants of these operations cannot follow, or the time is over at ``end``, by ``clock``.
    """
    if any(operation.op not in _OPERATIONS for operation in program.operations):
        return None
    for prime in _PRIMES:
        try:
            constants = _Refit(program, path, prime).constants(lambda: clock() > end)
        except (_NoFollowing, ArithmeticError):
            return None
        if constants is not None:
            return _with(program, constants)
    return None


class _NoFollowing(Exception):
    """No constants make the program the function, near to t = 0 already; or the time is over."""


@dataclass(frozen=True, slots=True)
class _Steps:
    """A program by places: its operations, then its ``constants``, then ``leaves`` that do not change (inputs
    and 0). ``operations`` are name, place, place (the same one where there is one only); ``ends`` the places
    of the outputs, each once, and ``firsts`` which outputs those are."""

    operations: tuple[tuple[str, int, int], ...]
    ends: tuple[int, ...]
    firsts: tuple[int, ...]
    constants: tuple[Fraction, ...]
    leaves: tuple[Operand, ...]

    @property
    def changing(self) -> int:
        """From this place on nothing changes."""
        return len(self.operations) + len(self.constants)


def _steps(program: Program) -> _Steps:
    constants: list[Fraction] = []
    leaves: dict[Operand, int] = {}
    pairs: list[tuple[str, list[tuple[str, int]]]] = []

    def place(operand: Operand) -> tuple[str, int]:
        if isinstance(operand, int):
            return "operation", operand
        if isinstance(operand, Fraction) and operand:  # each on its own: arms may differ in what is equal
            constants.append(operand)
            return "constant", len(constants) - 1
        return "leaf", leaves.setdefault(operand, len(leaves))

    for op, args, _ in program.operations:
        pairs.append((op, [] if op in _FIXED else [place(x) for x in args]))
    results = program.results()
    firsts = [results.index(x) for x in dict.fromkeys(results)]
    ends = [place(results[k]) for k in firsts]
    n, k = len(pairs), len(constants)
    first = {"operation": 0, "constant": n, "leaf": n + k}

    def at(pair: tuple[str, int]) -> int:
        return first[pair[0]] + pair[1]

    operations = tuple((op, at(args[0]), at(args[-1])) if args else (op, 0, 0) for op, args in pairs)
    return _Steps(operations, tuple(map(at, ends)), tuple(firsts), tuple(constants), tuple(leaves))


def _with(program: Program, constants: Sequence[Fraction]) -> Program:
    """``program`` with other constants, in the order of :func:`_steps`."""
    values = iter(constants)

    def changed(operand: Operand) -> Operand:
        return next(values) if isinstance(operand, Fraction) and operand else operand

    operations = tuple(
        operation if operation.op in _FIXED else operation._replace(args=tuple(map(changed, operation.args)))
        for operation in program.operations
    )
    outputs = tuple((name, tuple(map(changed, elements))) for name, elements in program.outputs)
    return replace(program, operations=operations, outputs=outputs, origin=None)


class _Refit:
    """Series of the constants of a program modulo a prime, and of its values at some points of the field."""

    def __init__(self, program: Program, path: Sequence[Program], prime: int) -> None:
        self._prime = prime
        self._steps = steps = _steps(program)
        numbers = Field("refit", prime=prime)
        self._series = [[numbers.number(x)] for x in steps.constants]
        self._points: list[list[list[int]]] = []
        self._wanted: list[list[int]] = []
        # Constants with many digits are the arm's and are solved for; plain ones stay where they can.
        self._order = sorted(range(len(self._series)), key=lambda k: -_digits(steps.constants[k]))
        self._system = Elimination(len(self._series), prime)
        idle = 0
        for k in range(len(self._series) + _IDLE):
            idle = 0 if self._another_point(program, path, f"refit {k}") else idle + 1
            if idle == _IDLE:
                break

    def _another_point(self, program: Program, path: Sequence[Program], seed: str) -> bool:
        """Whether one point more says more of the constants."""
        field, steps = Field(seed, prime=self._prime), self._steps
        first = values_in(program, field)
        fixed = [field.variable(x) if isinstance(x, Input) else 0 for x in steps.leaves]
        point = [*([x] for x in first), *self._series, *([x] for x in fixed)]
        self._points.append(point)
        values = [fingerprint(each, field, circle_point) for each in path]
        self._wanted += [_coefficients([row[i] for row in values], self._prime) for i in steps.firsts]
        news = [self._system.add([row[k] for k in self._order]) for row in self._gradients(point)]
        return any(news)

    def constants(self, late: Callable[[], bool]) -> list[Fraction] | None:
        """The constants at t = 1; None where a larger prime may tell.

        Raises
        ------
        _NoFollowing: there are none, or it is ``late``.
        """
        order = 0
        for length in _LENGTHS:
            while order < length:
                if late():
                    raise _NoFollowing
                self._extend(order)
                order += 1
            images = [value_at_one(series, self._prime) for series in self._series]
            if None not in images:
                fractions = [fraction_of(x, self._prime) for x in images if x is not None]
                return None if None in fractions else [x for x in fractions if x is not None]
        raise _NoFollowing

    def _extend(self, order: int) -> None:
        """One coefficient more of every series."""
        for series in self._series if order else ():
            series.append(0)
        wanted = [row[order] if order < len(row) else 0 for row in self._wanted]
        lacking = [(x - y) % self._prime for x, y in zip(wanted, self._outputs(order), strict=True)]
        if not any(lacking):
            return
        solution = self._system.solve(lacking) if order else None
        if solution is None:
            raise _NoFollowing
        for k, x in zip(self._order, solution, strict=True):
            self._series[k][order] = x
        self._outputs(order)

    def _outputs(self, order: int) -> list[int]:
        """The coefficients of that order of the outputs, point by point; those of all values are put in place
        of what stands there."""
        steps, prime = self._steps, self._prime
        fixed = steps.changing
        outputs = []
        for values in self._points:

            def coefficient(i: int, values: list[list[int]] = values) -> int:
                return values[i][order] if i < fixed else 0 if order else values[i][0]

            for k, (op, i, j) in enumerate(steps.operations if order else ()):
                if op in _FIXED:
                    x = 0
                elif op == "mul":
                    if i >= fixed:
                        x = values[i][0] * coefficient(j)
                    elif j >= fixed:
                        x = values[j][0] * coefficient(i)
                    else:
                        x = sum([y * z for y, z in zip(values[i], values[j][order::-1], strict=True) if y])
                elif op == "neg":
                    x = -coefficient(i)
                else:
                    x = coefficient(i) + coefficient(j) if op == "add" else coefficient(i) - coefficient(j)
                values[k][order:] = [x % prime]
            outputs += [coefficient(i) for i in steps.ends]
        return outputs

    def _gradients(self, values: list[list[int]]) -> list[list[int]]:
        """Of each output at a point its derivatives by the constants, where the series begin."""
        steps, prime, rows = self._steps, self._prime, []
        count = len(steps.operations)
        for end in steps.ends:
            adjoint = [0] * (steps.changing + len(steps.leaves))
            adjoint[end] = 1
            for k in range(min(end, count - 1), -1, -1):
                weight = adjoint[k] = adjoint[k] % prime
                op, i, j = steps.operations[k]
                if not weight or op in _FIXED:
                    continue
                if op == "mul":
                    adjoint[i] += weight * values[j][0]
                    adjoint[j] += weight * values[i][0]
                else:
                    adjoint[i] += -weight if op == "neg" else weight
                    if op != "neg":
                        adjoint[j] += weight if op == "add" else -weight
            rows.append([x % prime for x in adjoint[count : steps.changing]])
        return rows


def _digits(x: Fraction) -> int:
    return x.numerator.bit_length() + x.denominator.bit_length()


def _coefficients(values: Sequence[int], prime: int) -> list[int]:
    """The polynomial that has these values at 0, 1, 2, ..., lowest coefficient first."""
    total = [0] * len(values)
    for i, value in enumerate(values):
        polynomial, scale = [1], 1
        for j in range(len(values)):
            if i != j:
                polynomial = [x - j * y for x, y in zip([0, *polynomial], [*polynomial, 0], strict=True)]
                scale *= i - j
        factor = value * pow(scale, -1, prime)
        total = [(x + y * factor) % prime for x, y in zip(total, polynomial, strict=True)]
    return total
