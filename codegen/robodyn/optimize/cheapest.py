"""Of several ways to write the same values the one that adds the fewest operations to a graph."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.ir.graph import Graph, Node
from robodyn.ir.lowering import needed

#: What counts, as :mod:`robodyn.counts` has it; a division and a root like anything else.
_COUNTED = ("add", "mul", "scale", "div", "sqrt")


class Cheapest:
    """Chooses, and remembers what it chose: values that are needed already cost nothing again."""

    __slots__ = ("_chosen",)

    def __init__(self) -> None:
        self._chosen: set[int] = set()

    def __call__(self, ways: Sequence[Sequence[Any]]) -> Sequence[Any]:
        """The first of those of ``ways`` that take the fewest further operations; the first where the values
        are not nodes of a graph."""
        graph = _graph(ways)
        if graph is None:
            return ways[0]
        further = [self._further(graph, way) for way in ways]
        best = min(range(len(ways)), key=lambda k: _count(graph, further[k]))
        self._chosen |= further[best]
        return ways[best]

    def _further(self, graph: Graph, values: Sequence[Any]) -> set[int]:
        """Positions that ``values`` need and nothing before did."""
        return set(needed(graph, [("", values)])) - self._chosen


def _graph(ways: Sequence[Sequence[Any]]) -> Graph | None:
    """The graph that the values of ``ways`` are in."""
    return next((x.graph for way in ways for x in way if isinstance(x, Node)), None)


def _count(graph: Graph, positions: set[int]) -> int:
    return sum(graph.keys[p][0] in _COUNTED for p in positions)
