"""Dead code: operations that no output needs go."""

from __future__ import annotations

from robodyn.ir.program import Operand, Operation, Program


def dce(program: Program) -> Program:
    """``program`` without operations that no output needs."""
    live: set[int] = set()
    stack = [x for x in program.results() if isinstance(x, int)]
    while stack:
        i = stack.pop()
        if i not in live:
            live.add(i)
            stack.extend(arg for arg in program.operations[i].args if isinstance(arg, int))
    return kept(program, sorted(live))


def kept(program: Program, order: list[int]) -> Program:
    """``program`` with just the operations ``order``, in that order."""
    place = {old: new for new, old in enumerate(order)}

    def moved(operand: Operand) -> Operand:
        return place[operand] if isinstance(operand, int) else operand

    operations = tuple(
        Operation(op, tuple(map(moved, args)), label)
        for op, args, label in (program.operations[i] for i in order)
    )
    outputs = tuple((name, tuple(map(moved, elements))) for name, elements in program.outputs)
    return Program(operations, outputs)
