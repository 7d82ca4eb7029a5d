"""Signs: compute each value with the sign that leaves few unary minuses, and keeps the sign that its
name has in the recursion where that costs nothing."""

from __future__ import annotations

from typing import Any

from robodyn.ir.graph import Graph, Node
from robodyn.ir.key import ODD, SIGNED, signed_operands
from robodyn.ir.lowering import lower, needed
from robodyn.ir.program import Program
from robodyn.passes.replay import as_graph

#: Operations whose sign is free to choose.
_FREE = frozenset(("add", "scale", "mul", "div", *ODD))

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
        self.free = [p for p in self.positions if keys[p][0] in _FREE]
        self.is_free = bytearray(len(keys))
        self.users: list[list[int]] = [[] for _ in keys]
        self.reads = graph.reads
        for p in self.free:
            self.is_free[p] = 1
        for p in self.positions:
            for child in dict.fromkeys(graph.reads[p]):
                self.users[child].append(p)
        labels = graph.labels
        self.named = {p: -1 if labels[p].negative else 1 for p in self.positions if p in labels}
        self.sign = [1] * len(keys)
        #: What a sign, 1 or -1 (the last), of a position costs at outputs, and a little for a named quantity
        #: that stands with its sign reversed.
        self.own: tuple[list[int], ...] = ([], [0] * len(keys), [0] * len(keys))
        for _, values in outputs:
            for value in values:
                if isinstance(value, Node):
                    self.own[-value.sign][value.position] += _MINUS
        for p, sign in self.named.items():
            self.own[-sign][p] += 1

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
        own, users, reads = self.own, self.users, self.reads
        at = [0] * len(self.keys)
        for p in self.positions:  # a free operation on values with their own signs costs nothing
            if sign[p] < 0:
                at[p] = self._at(p)
                for q in users[p]:
                    at[q] = self._at(q)
            elif not self.is_free[p]:
                at[p] = self._at(p)
        queue = list(self.free)
        waiting = bytearray(self.is_free)
        sidestepped: set[int] = set()
        flips = 0
        while queue and flips < 20 * len(self.positions):
            p = queue.pop()
            waiting[p] = 0
            before = at[p] + own[sign[p]][p]
            for q in users[p]:
                before += at[q]
            if not before:
                continue
            sign[p] = -sign[p]
            touched = [p, *users[p]]
            costs = [at[q] for q in touched]
            for q in touched:
                at[q] = self._at(q)
            after = sum([at[q] for q in touched]) + own[sign[p]][p]
            if after > before or (after == before and p in sidestepped):
                sign[p] = -sign[p]
                for q, cost in zip(touched, costs, strict=True):
                    at[q] = cost
                continue
            if after == before:
                sidestepped.add(p)
            flips += 1
            near = [child for user in users[p] for child in reads[user]]
            for q in (*reads[p], *users[p], *near):
                if self.is_free[q] and not waiting[q]:
                    waiting[q] = 1
                    queue.append(q)
        return sum(at) + sum([own[sign[p]][p] for p in self.positions]), sign

    def _at(self, p: int) -> int:
        """What computing ``p`` with its sign costs: minuses there, and a little for a constant that stands
        with its sign reversed."""
        sign, key = self.sign, self.keys[p]
        op = key[0]
        if op == "add":
            own = sign[p]
            return _MINUS if own * sign[key[1]] < 0 and own * key[2] * sign[key[3]] < 0 else 0
        if op == "mul" or op == "div":
            return _MINUS if sign[p] * sign[key[1]] * sign[key[2]] < 0 else 0
        if op == "scale":
            return 1 if sign[p] * sign[key[2]] < 0 else 0
        if op in SIGNED:
            against = [q for q, s in signed_operands(key, sign[p]) if s != sign[q]]
            return _MINUS * len([q for q in against if self.keys[q][0] != "const"])
        if op in ("sin", "tanh", "sign"):
            return _MINUS if sign[key[1]] < 0 else 0
        return 0
