"""Nodes of one graph copied into another, folded anew or as they are."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.ir.key import SIGNED, Key, plain_sum, signed_operands


def copied(graph: Graph, key: Key, copies: Mapping[int, Scalar]) -> Scalar:
    """What ``key`` of another graph is in ``graph``, where its operands are ``copies``."""
    op = key[0]
    if op == "mul":
        return graph.mul(copies[key[1]], copies[key[2]])
    if op == "add":
        other = copies[key[3]]
        return graph.add(copies[key[1]], other if key[2] > 0 else -other)
    if op == "scale":
        return graph.mul(copies[key[2]], key[1])
    if op == "input":
        return graph.input(*key[1])
    if op == "const":
        constant: Fraction = key[1]
        return constant
    if op in SIGNED:
        return graph.apply(op, [copies[p] * s for p, s in signed_operands(key)])
    operands: list[Any] = [copies[p] for p in key[1:]]
    return graph.apply(op, operands)


#: In the place of a position: a number.
_NUMBER = -1
#: Operations of which multiples are simpler.
_SCALED = ("scale", "const")


class Copies:
    """What positions of ``graph`` are in ``target``, folded anew as far as ``target`` folds."""

    __slots__ = ("_graph", "_numbers", "_place", "_sign", "_target")

    def __init__(self, graph: Graph, target: Graph) -> None:
        self._graph, self._target = graph, target
        #: By position of the graph the one in the target and the sign there.
        self._place, self._sign = [_NUMBER] * len(graph.keys), [1] * len(graph.keys)
        self._numbers: dict[int, Scalar] = {}

    def __getitem__(self, position: int) -> Scalar:
        place = self._place[position]
        if place == _NUMBER:
            return self._numbers[position]
        return Node(self._target, place, self._sign[position])

    def put(self, position: int, value: Scalar) -> None:
        """``value`` is what stands at ``position``."""
        if isinstance(value, Node):
            self._place[position], self._sign[position] = value.position, value.sign
        else:
            self._numbers[position] = value
        if position in self._graph.labels:
            self._target.label(value, self._graph.labels[position])

    def copy(self, positions: Iterable[int]) -> None:
        """Copy what stands at ``positions``, each behind those that it reads."""
        keys, reads, labels = self._graph.keys, self._graph.reads, self._graph.labels
        place, sign, target = self._place, self._sign, self._target
        own, fold, position_of = target.keys, target.fold, target.position
        for p in positions:
            key = keys[p]
            op = key[0]
            # Most are products and sums of which nothing can be folded.
            if op == "mul":
                _, i, j = key
                a, b = place[i], place[j]
                if a >= 0 <= b:
                    place[p] = position_of(("mul", a, b) if a <= b else ("mul", b, a))
                    sign[p] = sign[i] * sign[j]
                    if p in labels:
                        target.label(self[p], labels[p])
                    continue
            elif op == "add":
                _, i, relative, j = key
                a, b = place[i], place[j]
                if a >= 0 <= b and (not fold or plain_sum(own, a, b)):
                    first, second = sign[i], relative * sign[j]
                    if a > b:
                        a, b, first, second = b, a, second, first
                    place[p], sign[p] = position_of(("add", a, first * second, b)), first
                    if p in labels:
                        target.label(self[p], labels[p])
                    continue
            elif op == "scale":
                _, factor, i = key
                a = place[i]
                if a >= 0 and own[a][0] not in _SCALED:
                    place[p] = position_of(("scale", factor, a), ("scale", *factor.as_integer_ratio(), a))
                    sign[p] = sign[i]
                    if p in labels:
                        target.label(self[p], labels[p])
                    continue
            self.put(p, copied(target, key, {child: self[child] for child in reads[p]}))


def rearranged(graph: Graph, order: Sequence[int], outputs: Sequence[Scalar]) -> tuple[Graph, list[Scalar]]:
    """The positions ``order`` of ``graph``, each behind those that it reads, as a graph of their own, and
    ``outputs`` there."""
    target = Graph(fold=graph.fold)
    copies = Copies(graph, target)
    copies.copy(order)
    return target, [copies[v.position] * v.sign if isinstance(v, Node) else v for v in outputs]
