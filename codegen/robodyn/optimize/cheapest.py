"""Of several ways to write each of some values those that together add the fewest operations to a graph."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from itertools import combinations, product
from typing import Any

from robodyn.dynamics.choosing import Ways
from robodyn.ir.graph import Graph, Node
from robodyn.ir.lowering import needed

#: What counts, as :mod:`robodyn.counts` has it; a division and a root like anything else.
_COUNTED = ("add", "mul", "scale", "div", "sqrt")
#: As many ways in all are tried two at a time; more of them one at a time.
_IN_PAIRS = 60


class Cheapest:
    """Chooses, and remembers what it chose: values that are needed already cost nothing again. A
    :class:`~robodyn.dynamics.choosing.Chooser`.

    Sets of operations are integers, a bit for each operation that was asked for.
    """

    __slots__ = ("_bits", "_chosen", "_needs")

    def __init__(self) -> None:
        self._chosen = 0
        self._bits = 0
        #: By position of the graph the operations that it needs, itself included.
        self._needs: dict[int, int] = {}

    def __call__(self, choices: Sequence[Ways]) -> list[Sequence[Any]]:
        """One of the ways of each of ``choices``: from the first of each, and from the last, and so on, one
        or two are exchanged while that saves operations. The first where nothing is a node of a graph."""
        graph = _graph(choices)
        if graph is None:
            return [ways[0] for ways in choices]
        self._extend(graph, choices)
        new = ~self._chosen
        needs = [[self._needed(way) & new for way in ways] for ways in choices]
        starts = range(max(map(len, choices)))
        ends = (_improved([min(k, len(ways) - 1) for ways in choices], needs) for k in starts)
        best = min(ends, key=lambda picks: _union(picks, needs).bit_count())
        self._chosen |= _union(best, needs)
        return [ways[k] for k, ways in zip(best, choices, strict=True)]

    def apart(self, ways: Sequence[Callable[[], Sequence[Any]]]) -> Sequence[Any]:
        """The values of the way that takes the fewest operations; of the first where there are no nodes."""
        before = self._chosen
        least: tuple[int, Sequence[Any], int] | None = None
        for way in ways:
            self._chosen = before
            values = way()
            graph = _graph([[values]])
            if graph is None:
                return values
            self._extend(graph, [[values]])
            operations = before | self._needed(values)
            total = operations.bit_count()
            if least is None or total < least[0]:
                least = total, values, operations
        if least is None:
            raise ValueError("there is no way to choose")
        _, values, self._chosen = least
        return values

    def _needed(self, values: Sequence[Any]) -> int:
        total = 0
        for x in values:
            if isinstance(x, Node):
                total |= self._needs[x.position]
        return total

    def _extend(self, graph: Graph, choices: Sequence[Ways]) -> None:
        """To all that ``choices`` need."""
        needs = self._needs
        for position in needed(graph, (("", way) for ways in choices for way in ways)):
            if position in needs:
                continue
            operations = 0
            for child in graph.reads[position]:
                operations |= needs[child]
            if graph.keys[position][0] in _COUNTED:
                operations |= 1 << self._bits
                self._bits += 1
            needs[position] = operations


def _improved(picks: list[int], needs: list[list[int]]) -> list[int]:
    """``picks`` after exchanges, while any saves operations."""
    cost = _union(picks, needs).bit_count()
    groups = [(i,) for i in range(len(needs))]
    pairs = list(combinations(range(len(needs)), 2)) if sum(map(len, needs)) <= _IN_PAIRS else []
    better = True
    while better:
        better = False
        for group in (*groups, *pairs):
            others = _union(picks, needs, without=group)
            for ways in product(*(range(len(needs[i])) for i in group)):
                operations = others
                for i, k in zip(group, ways, strict=True):
                    operations |= needs[i][k]
                total = operations.bit_count()
                if total < cost:
                    picks, cost, better = list(picks), total, True
                    for i, k in zip(group, ways, strict=True):
                        picks[i] = k
    return picks


def _union(picks: Sequence[int], needs: Sequence[Sequence[int]], without: Collection[int] = ()) -> int:
    """The operations of ``picks``, those of the choices ``without`` left out."""
    total = 0
    for i, (k, ways) in enumerate(zip(picks, needs, strict=True)):
        if i not in without:
            total |= ways[k]
    return total


def _graph(choices: Sequence[Ways]) -> Graph | None:
    """The graph that the values are in."""
    values = (x for ways in choices for way in ways for x in way)
    return next((x.graph for x in values if isinstance(x, Node)), None)
