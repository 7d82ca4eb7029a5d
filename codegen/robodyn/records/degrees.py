"""How a program reads its inputs: which of them as angles, and of which degree its values are in the others.

A polynomial of low degree cannot be small at a few magnitudes and large between them; ``(qd / 7)^64`` can.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from robodyn.ir.program import Input, Operand, Program

#: Kinds of inputs whose degrees are counted: positions, rates, accelerations and run-time parameters.
_KINDS = ("q", "qd", "qdd")
_ZERO = (0, 0, 0, 0)

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
    used, angles = _used(program), _angles(program)
    numbers: set[Input] = set()
    values: list[Degrees] = []

    def degrees(operand: Operand) -> Degrees:
        if operand.__class__ is int:
            return values[operand]
        if not isinstance(operand, Input):
            return _ZERO
        numbers.add(operand)
        kind = _KINDS.index(operand.array) if operand.is_of(*_KINDS) else len(_KINDS)
        return (*_ZERO[:kind], 1, *_ZERO[kind + 1 :])  # type: ignore[return-value]  # four of them

    highest = _ZERO
    for k, (op, args, _) in enumerate(program.operations):
        if k not in used or op in ("sin", "cos"):
            values.append(_ZERO)
            continue
        of = [degrees(x) for x in args]
        if op == "add" or op == "sub":
            value = _each_highest(of)
        elif op == "mul" or op == "div":
            (a, b, c, d), (e, f, g, h) = of
            value = (a + e, b + f, c + g, d + h)
        elif op == "neg" or op == "abs":
            value = of[0]
        else:  # bounded
            value = _ZERO
            highest = _each_highest((highest, *of))
        values.append(value)
        if value != highest:
            highest = _each_highest((highest, value))
    highest = _each_highest((highest, *(degrees(x) for x in program.results() if x.__class__ is not int)))
    return Reading(frozenset(angles), frozenset(numbers), highest)


def _each_highest(of: Iterable[Degrees]) -> Degrees:
    a, b, c, d = zip(*of, strict=True)
    return max(a), max(b), max(c), max(d)


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
