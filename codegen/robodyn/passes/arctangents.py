"""Arctangents together: those that do not need each other stand one after another.

So that they can be computed together. A change of order: for kernels with our own arctangent.
"""

from __future__ import annotations

from robodyn.ir.program import Program
from robodyn.passes.dce import kept


def arctangents_together(program: Program) -> Program:
    """``program`` with its arctangents in as few runs as they need each other: before each run what it needs
    and is not there yet, all else behind the last."""
    if sum(op.op == "atan2" for op in program.operations) < 2:
        return program
    #: By operation how many arctangents, its own too, stand on the longest way to it.
    depth: list[int] = []
    levels: dict[int, list[int]] = {}
    for i, (op, args, _) in enumerate(program.operations):
        depth.append(max((depth[x] for x in args if isinstance(x, int)), default=0) + (op == "atan2"))
        if op == "atan2":
            levels.setdefault(depth[i], []).append(i)
    order: list[int] = []
    placed: set[int] = set()
    for level in sorted(levels):
        run = levels[level]
        needed: set[int] = set()
        stack = [x for i in run for x in program.operations[i].args]
        while stack:
            x = stack.pop()
            if isinstance(x, int) and x not in placed and x not in needed:
                needed.add(x)
                stack.extend(program.operations[x].args)
        order += [*sorted(needed), *run]
        placed.update(needed, run)
    return kept(program, [*order, *(i for i in range(len(program.operations)) if i not in placed)])
