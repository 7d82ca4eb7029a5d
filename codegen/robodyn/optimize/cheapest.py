"""Of several ways to write each of some values those that together add the fewest operations to a graph."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations, product
from typing import Any

from robodyn.dynamics.choosing import Ways
from robodyn.ir.graph import Graph, Node
from robodyn.ir.lowering import children

#: What counts, as :mod:`robodyn.counts` has it; a division and a root like anything else.
_COUNTED = ("add", "mul", "scale", "div", "sqrt")
#: As many ways in all are tried two at a time; more of them one at a time.
_IN_PAIRS = 120


class Cheapest:
    """Chooses, and remembers what it chose: values that are needed already cost nothing again. A
    :class:`~robodyn.dynamics.choosing.Chooser`.

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
        # Beside what is chosen already, and of what counts only.
        new = [[way & self._counted & ~self._chosen for way in ways] for ways in needs]
        starts = range(max(map(len, choices)))
        ends = (_improved([min(k, len(ways) - 1) for ways in choices], new) for k in starts)
        picks = min(ends, key=lambda picks: _joined(picks, new).bit_count())
        for k, ways in zip(picks, needs, strict=True):
            self._chosen |= ways[k]
        return [ways[k] for k, ways in zip(picks, choices, strict=True)]

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
            self._extend(graph)
            needed = before | self._needed(values)
            cost = (needed & self._counted).bit_count()
            if least is None or cost < least[0]:
                least = cost, values, needed
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

    def _extend(self, graph: Graph) -> None:
        """To the positions that ``graph`` has by now."""
        for position in range(len(self._needs), len(graph.keys)):
            key, bit = graph.keys[position], 1 << position
            if key[0] in _COUNTED:
                self._counted |= bit
            for child in children(key):
                bit |= self._needs[child]
            self._needs.append(bit)


def _improved(picks: list[int], needs: list[list[int]]) -> list[int]:
    """``picks`` after exchanges, while any saves operations."""
    cost = _joined(picks, needs).bit_count()
    count = len(needs)
    pairs = list(combinations(range(count), 2)) if sum(map(len, needs)) <= _IN_PAIRS else []
    better = True
    while better:
        better = False
        for group in (*((i,) for i in range(count)), *pairs):
            rest = 0
            for i, k in enumerate(picks):
                if i not in group:
                    rest |= needs[i][k]
            for ways in product(*(range(len(needs[i])) for i in group)):
                total = rest
                for i, k in zip(group, ways, strict=True):
                    total |= needs[i][k]
                if total.bit_count() < cost:
                    cost, better = total.bit_count(), True
                    for i, k in zip(group, ways, strict=True):
                        picks[i] = k
    return picks


def _joined(picks: Sequence[int], needs: Sequence[Sequence[int]]) -> int:
    """What all ``picks`` together need."""
    total = 0
    for k, ways in zip(picks, needs, strict=True):
        total |= ways[k]
    return total


def _graph(choices: Sequence[Ways]) -> Graph | None:
    """The graph that the values are in."""
    values = (x for ways in choices for way in ways for x in way)
    return next((x.graph for x in values if isinstance(x, Node)), None)
