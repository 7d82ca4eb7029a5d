"""A program as a graph and back, which passes share, and the two passes that are nothing else."""

from __future__ import annotations

from typing import Any

from robodyn.ir.graph import Graph, Scalar
from robodyn.ir.lowering import lower
from robodyn.ir.program import Program


def as_graph(program: Program, *, fold: bool) -> tuple[Graph, list[tuple[str, list[Any]]]]:
    """``program`` as a graph to read, and its outputs there: the one it was written out from, or a new
    one. A graph that folds does for a reader who wants no folding; not the other way round."""
    if program.origin is not None and (program.origin[0].fold or not fold):
        graph, outputs = program.origin
        return graph, outputs
    graph = Graph(fold=fold)
    return graph, grouped(program, graph.replay(program))


def grouped(program: Program, values: list[Scalar]) -> list[tuple[str, list[Any]]]:
    """Values given one after another, under the names of the program's outputs."""
    outputs = []
    position = 0
    for name, elements in program.outputs:
        outputs.append((name, values[position : position + len(elements)]))
        position += len(elements)
    return outputs


def cse(program: Program) -> Program:
    """``program`` with equal operations (up to order and sign of operands) merged, and no algebra done."""
    return lower(*as_graph(program, fold=False))


def fold(program: Program) -> Program:
    """``program`` without arithmetic among constants and identities: ``k (l x)`` is ``(k l) x``."""
    return lower(*as_graph(program, fold=True))
