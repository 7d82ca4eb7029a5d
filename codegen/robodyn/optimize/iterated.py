"""The programs of a function whose results are approached: start, step and what follows."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from robodyn.dynamics.functions import Function
from robodyn.dynamics.fusing import Writing
from robodyn.dynamics.iterative import Iterative
from robodyn.ir.graph import Graph
from robodyn.ir.program import STATE, Iteration, Program

#: Arrays of nodes by name.
Inputs = Mapping[str, Sequence[Any]]
#: Values, one after another, as ``(name, elements)`` of each result.
Split = Callable[[Sequence[Any]], list[tuple[str, Sequence[Any]]]]


def iterated(
    function: Function,
    approach: Iterative,
    n: int,
    written: Callable[[Graph, Inputs, Writing, Split], Program],
) -> Program:
    """The program of ``function`` for ``n`` joints; ``written`` gives what a writing is of inputs in a
    graph, split into its results."""

    def part(writing: Writing, size: int, split: Split) -> Program:
        graph = Graph()
        inputs = function.nodes(graph.input, n)
        if size:
            inputs[STATE] = [graph.input(STATE, i) for i in range(size)]
            inputs["q"] = inputs[STATE][:n]
        return written(graph, inputs, writing, split)

    def state(values: Sequence[Any]) -> list[tuple[str, Sequence[Any]]]:
        return [(STATE, values)]

    start = part(approach.start, 0, state)
    size = len(start.results())
    step = part(approach.step, size // approach.rows, state)
    finish = part(approach.finish, size, lambda values: function.split(values, n))
    return replace(finish, iteration=Iteration(start, step, approach.most))
