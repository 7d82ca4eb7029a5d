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
    read = [
        [arg for arg in reversed(operation.args) if isinstance(arg, int)] for operation in program.operations
    ]
    labelled = [i for i, operation in enumerate(program.operations) if operation.label is not None]
    results = [operand for operand in program.results() if isinstance(operand, int)]
    return kept(program, before_use([*labelled, *results], read))


def before_use(roots: Iterable[int], read: Sequence[Sequence[int]]) -> list[int]:
    """The operations that ``roots`` need, root by root, each after those that it reads: depth first, the
    last of ``read[i]`` first."""
    placed: list[int] = []
    done: set[int] = set()
    for root in roots:
        stack = [(root, False)]
        while stack:
            i, ready = stack.pop()
            if i in done:
                continue
            if ready:
                done.add(i)
                placed.append(i)
                continue
            stack.append((i, True))
            stack.extend((x, False) for x in read[i])
    return placed
