"""Angles first: sines and cosines that depend on positions alone come before all else.

So that they can be computed together. A change of order: for kernels with our own sine and cosine.
"""

from __future__ import annotations

from fractions import Fraction

from robodyn.ir.program import STATE, Input, Operand, Program
from robodyn.passes.dce import kept

#: What an angle is made with.
SUMS = ("add", "sub", "mul", "neg")


def is_position(operand: Input | Fraction) -> bool:
    """Whether the caller gives it with the positions: a constant, a run-time parameter, a position, or
    one that a step goes on from."""
    return isinstance(operand, Fraction) or operand.index is None or operand.is_of("q", STATE)


def angles_first(program: Program) -> Program:
    """``program`` with the angles of its sines and cosines, and these, before all else."""
    early = of_positions(program)
    sums: set[int] = set()
    stack: list[Operand] = [program.operations[i].args[0] for i in early]
    while stack:
        operand = stack.pop()
        if isinstance(operand, int) and operand not in sums:
            sums.add(operand)
            stack.extend(program.operations[operand].args)
    front = [*sorted(sums), *sorted(early)]
    placed = set(front)
    return kept(program, [*front, *(i for i in range(len(program.operations)) if i not in placed)])


def of_positions(program: Program) -> set[int]:
    """The sines and cosines of ``program`` whose angles are known from positions and parameters alone."""
    known: list[bool] = []
    positions: set[int] = set()
    for i, (op, args, _) in enumerate(program.operations):
        all_positions = all(known[x] if isinstance(x, int) else is_position(x) for x in args)
        known.append(op in SUMS and all_positions)
        if op in ("sin", "cos") and all_positions:
            positions.add(i)
    return positions
