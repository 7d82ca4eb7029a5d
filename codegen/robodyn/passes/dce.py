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
    place = dict(zip(order, range(len(order)), strict=True))

    def moved(operands: tuple[Operand, ...]) -> tuple[Operand, ...]:
        return tuple([place[x] if isinstance(x, int) else x for x in operands])

    operations = program.operations
    moved_operations = [
        Operation(op, moved(args), label) for op, args, label in (operations[i] for i in order)
    ]
    outputs = tuple((name, moved(elements)) for name, elements in program.outputs)
    return Program(tuple(moved_operations), outputs)
