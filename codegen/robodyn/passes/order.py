"""Which operations stay, and in which order.

Dead code, what no output needs, goes. In the order of reading every unlabelled step moves down to the
quantity that first needs it: the labelled quantities stay in the order of the recursion, so that the emitted
code reads like it, and values are computed shortly before they are used. For kernels with our own sine and
cosine these come before all else, so that they can be computed together; so do arctangents that do not need
each other.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from robodyn.ir.program import STATE, Input, Operand, Program, operation_of


def dce(program: Program) -> Program:
    """``program`` without operations that no output needs."""
    return kept(program, sorted(needed(program, program.results())))


def needed(program: Program, operands: Iterable[Operand]) -> set[int]:
    """The operations that ``operands`` need, their own among them."""
    live: set[int] = set()
    stack = [x for x in operands if isinstance(x, int)]
    while stack:
        i = stack.pop()
        if i not in live:
            live.add(i)
            stack.extend(arg for arg in program.operations[i].args if isinstance(arg, int))
    return live


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


#: What an angle is made with.
SUMS = ("add", "sub", "mul", "neg")


def is_position(operand: Input | Fraction) -> bool:
    """Whether the caller gives it with the positions: a constant, a run-time parameter, a position, or
    one that a step goes on from."""
    return isinstance(operand, Fraction) or operand.index is None or operand.is_of("q", STATE)


def angles_first(program: Program) -> Program:
    """``program`` with the angles of its sines and cosines, and these, before all else."""
    early = of_positions(program)
    sums = needed(program, [program.operations[i].args[0] for i in early])
    return _first(program, [*sorted(sums), *sorted(early)])


def _first(program: Program, front: list[int]) -> Program:
    """``program`` with the operations ``front`` before all else, each once."""
    return kept(program, list(dict.fromkeys([*front, *range(len(program.operations))])))


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
    front: list[int] = []
    for level in sorted(levels):
        run = levels[level]
        front += [*sorted(needed(program, [x for i in run for x in program.operations[i].args])), *run]
    return _first(program, front)
