"""Of several ways to write each of some values those that together add the fewest operations to a graph."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, product
from typing import Any

from robodyn.ir.graph import Graph, Node
from robodyn.ir.lowering import children

#: What counts, as :mod:`robodyn.counts` has it; a division and a root like anything else.
_COUNTED = ("add", "mul", "scale", "div", "sqrt")
#: As many ways in all are tried two at a time; more of them one at a time.
_IN_PAIRS = 120

Ways = Sequence[Sequence[Any]]


class Cheapest:
    """Chooses, and remembers what it chose: values that are needed already cost nothing again.

    Sets of operations are integers, a bit for each position of the graph.
    """

    __slots__ = ("_chosen", "_counted", "_needs")

    def __init__(self) -> None:
        self._chosen = 0
        self._counted = 0
        #: What each position needs, itself included.
        self._needs: list[int] = []

    def __call__(self, choices: Sequence[Ways]) -> list[Sequence[Any]]:
        """One of the ways of each of ``choices``: from the first of each, and from the last, and so on, one
        or two are exchanged while that saves operations. The first where nothing is a node of a graph."""
        graph = _graph(choices)
        if graph is None:
            return [ways[0] for ways in choices]
        self._extend(graph)
        needs = [[self._needed(way) for way in ways] for ways in choices]
        starts = range(max(map(len, choices)))
        ends = (self._improved([min(k, len(ways) - 1) for ways in choices], needs) for k in starts)
        best = min(ends, key=lambda picks: self._cost(picks, needs))
        for k, ways in zip(best, needs, strict=True):
            self._chosen |= ways[k]
        return [ways[k] for k, ways in zip(best, choices, strict=True)]

    def _improved(self, picks: list[int], needs: list[list[int]]) -> list[int]:
        """``picks`` after exchanges, while any saves operations."""
        cost = self._cost(picks, needs)
        groups = [(i,) for i in range(len(needs))]
        pairs = list(combinations(range(len(needs)), 2)) if sum(map(len, needs)) <= _IN_PAIRS else []
        better = True
        while better:
            better = False
            for group in (*groups, *pairs):
                for ways in product(*(range(len(needs[i])) for i in group)):
                    other = list(picks)
                    for i, k in zip(group, ways, strict=True):
                        other[i] = k
                    total = self._cost(other, needs)
                    if total < cost:
                        picks, cost, better = other, total, True
        return picks

    def _cost(self, picks: list[int], needs: list[list[int]]) -> int:
        """Operations of ``picks`` beside those chosen before."""
        total = self._chosen
        for k, ways in zip(picks, needs, strict=True):
            total |= ways[k]
        return (total & self._counted).bit_count()

    def _needed(self, values: Sequence[Any]) -> int:
        total = 0
        for x in values:
            if isinstance(x, Node):
                total |= self._needs[x.position]
        return total

    def _extend(self, graph: Graph) -> None:
        """To the positions that ``graph`` has by now."""
        for position in range(len(self._needs), len(graph.keys)):
            key, bit = graph.keys[position], 1 << position
            if key[0] in _COUNTED:
                self._counted |= bit
            for child in children(key):
                bit |= self._needs[child]
            self._needs.append(bit)


def _graph(choices: Sequence[Ways]) -> Graph | None:
    """The graph that the values are in."""
    values = (x for ways in choices for way in ways for x in way)
    return next((x.graph for x in values if isinstance(x, Node)), None)
