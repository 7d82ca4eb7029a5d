"""Which step of the recursion each operation serves, so that intermediate results can be named after it."""

from __future__ import annotations

from robodyn.ir.program import Label, Program


def steps_served(program: Program) -> list[Label]:
    """A label for every operation: its own; else that of the first labelled value that is computed from it;
    else the array that the result goes to, with its element (from 1) for a link."""
    steps: list[Label | None] = [operation.label for operation in program.operations]
    for array, elements in program.outputs:
        for k, operand in enumerate(elements, 1):
            if isinstance(operand, int) and steps[operand] is None:
                steps[operand] = Label(k, array, "")
    first: list[int | None] = [None if step is None else i for i, step in enumerate(steps)]
    for i in range(len(steps) - 1, -1, -1):  # users stand after what they read
        reached = first[i]
        for arg in program.operations[i].args:
            if not isinstance(arg, int) or steps[arg] is not None or reached is None:
                continue
            known = first[arg]
            first[arg] = reached if known is None else min(known, reached)
    served: list[Label] = []
    for i, at in enumerate(first):
        label = None if at is None else steps[at]
        if label is None:
            raise ValueError(f"operation {i} serves no result: a program holds nothing that is not used")
        served.append(label)
    return served
