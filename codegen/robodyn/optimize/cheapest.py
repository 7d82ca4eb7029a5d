"""Of several ways to write each of some values those that together add the fewest operations to a graph."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import combinations, product
from typing import Any

from robodyn.dynamics.state import Ways
from robodyn.ir.graph import Graph, Node

#: What counts, as :mod:`robodyn.counts` has it; a division and a root like anything else.
_COUNTED = ("add", "mul", "scale", "div", "sqrt")
#: As many ways in all are tried two at a time; more of them one at a time.
_IN_PAIRS = 60


class Cheapest:
    """Chooses, and remembers what it chose: values that are needed already cost nothing again. A
    :class:`~robodyn.dynamics.state.Chooser`.

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
        needs, reads = self._needs, graph.reads
        stack = [x.position for ways in choices for way in ways for x in way if isinstance(x, Node)]
        new: set[int] = set()
        while stack:
            position = stack.pop()
            if position not in needs and position not in new:
                new.add(position)
                stack += reads[position]
        for position in sorted(new):
            operations = 0
            for child in reads[position]:
                operations |= needs[child]
            if graph.keys[position][0] in _COUNTED:
                operations |= 1 << self._bits
                self._bits += 1
            needs[position] = operations


def _improved(picks: list[int], needs: list[list[int]]) -> list[int]:
    """``picks`` after exchanges, while any saves operations."""
    picks = list(picks)
    cost = _union(picks, needs).bit_count()
    pairs = list(combinations(range(len(needs)), 2)) if sum(map(len, needs)) <= _IN_PAIRS else []
    better = True
    while better:
        better = False
        for i, others in _others(picks, needs):
            for k, operations in enumerate(needs[i]):
                total = (others | operations).bit_count()
                if total < cost:
                    picks[i], cost, better = k, total, True
        for i, j in pairs:
            others = _union(picks, needs, without=(i, j))
            for k, l in product(range(len(needs[i])), range(len(needs[j]))):
                total = (others | needs[i][k] | needs[j][l]).bit_count()
                if total < cost:
                    picks[i], picks[j], cost, better = k, l, total, True
    return picks


def _others(picks: Sequence[int], needs: Sequence[Sequence[int]]) -> Iterator[tuple[int, int]]:
    """Each choice, with the operations of all others as ``picks`` have them when it comes to that."""
    after = [0]
    for k, ways in zip(reversed(picks), reversed(needs), strict=True):
        after.append(after[-1] | ways[k])
    before = 0
    for i, ways in enumerate(needs):
        after.pop()
        yield i, before | after[-1]
        before |= ways[picks[i]]


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
