"""Order: every unlabelled step moves down to the quantity that first needs it.

The labelled quantities stay in the order of the recursion, so that the emitted code reads like it, and
values are computed shortly before they are used.
"""

from __future__ import annotations

from robodyn.ir.program import Program
from robodyn.passes.dce import kept


def order(program: Program) -> Program:
    """``program`` in the order of its labelled quantities, each preceded by its own steps."""
    placed: list[int] = []
    done: set[int] = set()

    def place(root: int) -> None:
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
            args = [arg for arg in program.operations[i].args if isinstance(arg, int)]
            stack.extend((arg, False) for arg in reversed(args))

    for i, operation in enumerate(program.operations):
        if operation.label is not None:
            place(i)
    for operand in program.results():
        if isinstance(operand, int):
            place(operand)
    return kept(program, placed)
