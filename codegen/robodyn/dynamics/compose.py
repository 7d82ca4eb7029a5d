"""Forward dynamics out of programs of the bias and the mass matrix, however they were found."""

from __future__ import annotations

from typing import Any

from robodyn.dynamics.mass_matrix import solve_symmetric
from robodyn.ir.graph import Graph, lower
from robodyn.ir.program import Label, Program


def composed_forward_dynamics(bias: Program, mass_matrix: Program) -> Program:
    """``qdd = M^-1 (tau - h)``: ``bias`` gives ``h`` [n], ``mass_matrix`` gives ``M`` [n, n] row by row."""
    graph = Graph()
    h = graph.replay(bias)
    entries = graph.replay(mass_matrix)
    n = len(h)
    matrix: list[list[Any]] = [list(entries[n * i : n * (i + 1)]) for i in range(n)]
    right = [graph.input("tau", i) - h[i] for i in range(n)]

    def mark(value: Any, label: Label) -> Any:
        return graph.label(value, label)

    return lower(graph, [("qdd", solve_symmetric(matrix, right, mark))])
