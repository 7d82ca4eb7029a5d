"""Order: every unlabelled step moves down to the quantity that first needs it.

The labelled quantities stay in the order of the recursion, so that the emitted code reads like it, and
values are computed shortly before they are used.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from robodyn.ir.program import Program
from robodyn.passes.dce import kept


def order(program: Program) -> Program:
    """``program`` in the order of its labelled quantities, each preceded by its own steps."""
    read = [[arg for arg in operation.args if isinstance(arg, int)] for operation in program.operations]
    labelled = [i for i, operation in enumerate(program.operations) if operation.label is not None]
    results = [operand for operand in program.results() if isinstance(operand, int)]
    return kept(program, before_use([*labelled, *results], read))


def before_use(roots: Iterable[int], read: Sequence[Sequence[int]]) -> list[int]:
    """The operations that ``roots`` need, root by root, each after those that it reads: depth first, the
    first of ``read[i]`` first."""
    placed: list[int] = []
    done = bytearray(len(read))
    stack: list[int] = []
    for root in roots:
        stack.append(root)
        while stack:
            i = stack.pop()
            if i < 0:  # what ~i reads has been placed
                placed.append(~i)
            elif not done[i]:
                done[i] = 1
                stack.append(~i)
                stack += read[i][::-1]
    return placed
