"""From a graph to a straight-line program: what outputs need, in order, with a sign for each value.

A node is a sign and a position; here the signs become ``sub`` and ``neg``, as few as the order allows.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import compress

from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.ir.key import SIGNED, signed_operands
from robodyn.ir.program import Operand, Operation, Program, operation_of

Outputs = Iterable[tuple[str, Sequence[Scalar]]]


def needed(graph: Graph, outputs: Outputs) -> list[int]:
    """Positions that ``outputs`` need, in the order of creation."""
    reads = graph.reads
    wanted = bytearray(len(reads))
    for _, values in outputs:
        for value in values:
            if isinstance(value, Node):
                wanted[value.position] = 1
    for position in reversed(range(len(reads))):
        if wanted[position]:
            for child in reads[position]:
                wanted[child] = 1
    return list(compress(range(len(reads)), wanted))


def lower(graph: Graph, outputs: Outputs, stored: Mapping[int, int] | None = None) -> Program:
    """The straight-line program of what ``outputs`` need, in the order of creation.

    ``stored`` gives the sign with which a position is computed where that is not +1; a ``neg`` stands
    where signs do not fit. :mod:`robodyn.passes.negate` chooses signs so that few are left.
    """
    outputs = [(name, list(values)) for name, values in outputs]
    keys, labels = graph.keys, graph.labels
    sign = [1] * len(keys)
    for position, own in (stored or {}).items():
        sign[position] = own
    operations: list[Operation] = []
    place: list[Operand] = [0] * len(keys)
    negated: dict[int, Operand] = {}

    def minus(position: int) -> Operand:
        """Minus what stands in the place of ``position``."""
        there = place[position]
        if type(there) is Fraction:
            return -there
        if position not in negated:
            negated[position] = len(operations)
            operations.append(Operation("neg", (there,)))
        return negated[position]

    def signed(position: int, wanted: int) -> Operand:
        """``wanted`` times the value at ``position``."""
        return place[position] if wanted == sign[position] else minus(position)

    for position in needed(graph, outputs):
        key = keys[position]
        op, own = key[0], sign[position]
        args: tuple[Operand, ...]
        if op == "mul" or op == "div":
            _, i, j = key
            args = (place[i] if own * sign[i] * sign[j] > 0 else minus(i), place[j])
        elif op == "add":
            _, i, relative, j = key
            first, second = own * sign[i], own * relative * sign[j]
            if first < 0 < second:
                i, j, first, second = j, i, second, first
            args = (place[i] if first > 0 else minus(i), place[j])
            if second < 0:
                op = "sub"
        elif op == "scale":
            _, factor, i = key
            op, args = "mul", (factor if own == sign[i] else -factor, place[i])
        elif op == "input" or op == "const":
            place[position] = key[1]
            continue
        elif op in SIGNED:
            args = tuple([signed(p, s) for p, s in signed_operands(key, own)])
        elif op in ("cos", "abs"):
            args = (place[key[1]],)
        else:
            args = (signed(key[1], 1),)
        label = labels.get(position)
        if label is not None and own < 0:
            label = label.flipped()
        place[position] = len(operations)
        operations.append(operation_of((op, args, label)))

    def result(value: Scalar) -> Operand:
        return signed(value.position, value.sign) if isinstance(value, Node) else Fraction(value)

    results = tuple((name, tuple(map(result, values))) for name, values in outputs)
    return Program(tuple(operations), results, origin=(graph, outputs))
