"""From a graph to a straight-line program: what outputs need, in order, with a sign for each value.

A node is a sign and a position; here the signs become ``sub`` and ``neg``, as few as the order allows.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.ir.program import Label, Operand, Operation, Program

Outputs = Iterable[tuple[str, Sequence[Scalar]]]


def needed(graph: Graph, outputs: Outputs) -> list[int]:
    """Positions that ``outputs`` need, in the order of creation."""
    wanted: set[int] = set()
    stack = [v.position for _, values in outputs for v in values if isinstance(v, Node)]
    while stack:
        position = stack.pop()
        if position not in wanted:
            wanted.add(position)
            stack.extend(children(graph.keys[position]))
    return sorted(wanted)


def lower(graph: Graph, outputs: Outputs, stored: Mapping[int, int] | None = None) -> Program:
    """The straight-line program of what ``outputs`` need, in the order of creation.

    ``stored`` gives the sign with which a position is computed where that is not +1; a ``neg`` stands
    where signs do not fit. :mod:`robodyn.passes.negate` chooses signs so that few are left.
    """
    outputs = [(name, list(values)) for name, values in outputs]
    signs = stored or {}
    operations: list[Operation] = []
    place: dict[int, Operand] = {}
    negated: dict[int, Operand] = {}

    def emit(op: str, *args: Operand, label: Label | None = None) -> Operand:
        operations.append(Operation(op, args, label))
        return len(operations) - 1

    def operand(position: int, sign: int) -> Operand:
        """``sign`` times the value at ``position``."""
        there = place[position]
        if sign == signs.get(position, 1):
            return there
        if isinstance(there, Fraction):
            return -there
        if position not in negated:
            negated[position] = emit("neg", there)
        return negated[position]

    for position in needed(graph, outputs):
        key = graph.keys[position]
        op = key[0]
        own = signs.get(position, 1)
        label = graph.labels.get(position)
        if label is not None and own < 0:
            label = label.flipped()
        if op in ("input", "const"):
            place[position] = key[1]
        elif op == "add":
            _, i, relative, j = key
            first, second = own * signs.get(i, 1), own * relative * signs.get(j, 1)
            if first < 0 and second > 0:
                (i, first), (j, second) = (j, second), (i, first)
            left = operand(i, first * signs.get(i, 1))
            right = place[j]
            place[position] = emit("add" if second > 0 else "sub", left, right, label=label)
        elif op == "scale":
            factor = key[1] if own == signs.get(key[2], 1) else -key[1]
            place[position] = emit("mul", factor, place[key[2]], label=label)
        elif op in ("mul", "div"):
            sign = own * signs.get(key[1], 1) * signs.get(key[2], 1)
            left = operand(key[1], sign * signs.get(key[1], 1))
            place[position] = emit(op, left, place[key[2]], label=label)
        elif op in ("sqrt", "exp"):
            place[position] = emit(op, operand(key[1], key[2]), label=label)
        elif op == "pow":
            place[position] = emit(op, operand(key[1], key[2]), operand(key[3], key[4]), label=label)
        elif op in ("cos", "abs"):
            place[position] = emit(op, place[key[1]], label=label)
        else:
            place[position] = emit(op, operand(key[1], 1), label=label)

    def result(value: Scalar) -> Operand:
        return operand(value.position, value.sign) if isinstance(value, Node) else Fraction(value)

    results = tuple((name, tuple(map(result, values))) for name, values in outputs)
    return Program(tuple(operations), results, origin=(graph, outputs))


def children(key: tuple[Any, ...]) -> tuple[int, ...]:
    """Positions that a key reads."""
    op = key[0]
    if op in ("input", "const"):
        return ()
    if op == "add":
        return (key[1], key[3])
    if op == "scale":
        return (key[2],)
    if op in ("sqrt", "exp"):
        return (key[1],)
    if op == "pow":
        return (key[1], key[3])
    return tuple(key[1:])
