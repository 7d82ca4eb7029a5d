"""Signs: compute each value with the sign that leaves few unary minuses, and keeps the sign that its
name has in the recursion where that costs nothing."""

from __future__ import annotations

from typing import Any

from robodyn.ir.graph import Graph, Node
from robodyn.ir.lowering import children, lower, needed
from robodyn.ir.program import Program
from robodyn.passes.replay import as_graph

#: Operations whose sign is free to choose.
_FREE = frozenset(("add", "scale", "mul", "div"))

#: How many reversed names a unary minus is worth.
_MINUS = 3


def negate(program: Program) -> Program:
    """``program`` with signs moved into subtractions and constants as far as they go."""
    graph, outputs = as_graph(program, fold=False)
    signs = _Signs(graph, outputs)
    # From the signs that the recursion's own names have, and from those that the graph happens to have.
    descents = [signs.descended(signs.of_names()), signs.descended([1] * len(graph.keys))]
    best = min(descents, key=lambda descent: descent[0])
    return lower(graph, outputs, {p: -1 for p in signs.positions if best[1][p] < 0})


class _Signs:
    """The sign with which each position is computed, improved one at a time until none gains."""

    def __init__(self, graph: Graph, outputs: list[tuple[str, list[Any]]]) -> None:
        keys = graph.keys
        self.keys = keys
        self.positions = needed(graph, outputs)
        self.reads = {p: tuple(dict.fromkeys(children(keys[p]))) for p in self.positions}
        self.users: dict[int, list[int]] = {p: [] for p in self.positions}
        for p, read in self.reads.items():
            for child in read:
                self.users[child].append(p)
        self.wanted: dict[int, list[int]] = {}
        for _, values in outputs:
            for value in values:
                if isinstance(value, Node):
                    self.wanted.setdefault(value.position, []).append(value.sign)
        self.named = {p: -1 if label.negative else 1 for p, label in graph.labels.items()}
        self.sign = [1] * len(keys)

    def of_names(self) -> list[int]:
        """The signs with which each quantity stands as its name says."""
        sign = [1] * len(self.keys)
        for p, own in self.named.items():
            if self.keys[p][0] in _FREE:
                sign[p] = own
        return sign

    def descended(self, start: list[int]) -> tuple[int, list[int]]:
        """Coordinate descent from ``start``: flip a sign where that saves something, or once where it
        costs nothing; then look at its neighbours. The cost reached, and the signs."""
        self.sign = sign = start
        queue = list(self.positions)
        waiting = set(queue)
        sidestepped: set[int] = set()
        flips = 0
        while queue and flips < 20 * len(self.positions):
            p = queue.pop()
            waiting.discard(p)
            if self.keys[p][0] not in _FREE:
                continue
            before = self._cost(p)
            if not before:
                continue
            sign[p] = -sign[p]
            after = self._cost(p)
            if after > before or (after == before and p in sidestepped):
                sign[p] = -sign[p]
                continue
            if after == before:
                sidestepped.add(p)
            flips += 1
            near = [*self.reads[p], *self.users[p]]
            near += [child for user in self.users[p] for child in self.reads[user]]
            for q in near:
                if q not in waiting:
                    waiting.add(q)
                    queue.append(q)
        return self._total(), sign

    def _total(self) -> int:
        total = sum(self._at(p) for p in self.positions)
        total += sum(_MINUS for p, signs in self.wanted.items() for sign in signs if sign != self.sign[p])
        return total + sum(sign != self.sign[p] for p, sign in self.named.items() if p in self.users)

    def _cost(self, p: int) -> int:
        """What the sign of ``p`` costs: minuses there, at what reads it and at outputs; and a little for a
        named quantity or a constant that stands with its sign reversed."""
        own = self.sign[p]
        total = self._at(p)
        for user in self.users[p]:
            total += self._at(user)
        for sign in self.wanted.get(p, ()):
            if sign != own:
                total += _MINUS
        if self.named.get(p, own) != own:
            total += 1
        return total

    def _at(self, p: int) -> int:
        """What computing ``p`` with its sign costs."""
        sign, key = self.sign, self.keys[p]
        op = key[0]
        if op == "add":
            own = sign[p]
            return _MINUS if own * sign[key[1]] < 0 and own * key[2] * sign[key[3]] < 0 else 0
        if op == "mul" or op == "div":
            return _MINUS if sign[p] * sign[key[1]] * sign[key[2]] < 0 else 0
        if op == "scale":
            return 1 if sign[p] * sign[key[2]] < 0 else 0
        if op in ("sqrt", "exp"):
            return _MINUS if key[2] != sign[key[1]] else 0
        if op == "pow":
            return _MINUS * (int(key[2] != sign[key[1]]) + int(key[4] != sign[key[3]]))
        if op in ("sin", "tanh", "sign"):
            return _MINUS if sign[key[1]] < 0 else 0
        return 0
