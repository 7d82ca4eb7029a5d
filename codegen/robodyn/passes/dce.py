"""Dead code: operations that no output needs go."""

from __future__ import annotations

from robodyn.ir.program import Operand, Program, operation_of


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

    operations = []
    for i in order:
        op, args, label = program.operations[i]
        operations.append(operation_of((op, moved(args), label)))
    outputs = tuple((name, moved(elements)) for name, elements in program.outputs)
    return Program(tuple(operations), outputs)
