"""How a program reads its inputs: which of them as angles, and of which degree its values are in the others.

A polynomial of low degree cannot be small at a few magnitudes and large between them; ``(qd / 7)^64`` can.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce

from robodyn.ir.program import Input, Operand, Program

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
