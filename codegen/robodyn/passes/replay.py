"""What passes share: a program as a graph and back."""

from __future__ import annotations

from typing import Any

from robodyn.ir.graph import Graph, Scalar
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
