"""Nodes of one graph copied into another, folded anew or as they are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.ir.key import Key


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
    if op in ("sqrt", "exp"):
        return graph.apply(op, [copies[key[1]] * key[2]])
    if op == "pow":
        return graph.pow(copies[key[1]] * key[2], copies[key[3]] * key[4])
    operands: list[Any] = [copies[p] for p in key[1:]]
    return graph.apply(op, operands)


def rearranged(graph: Graph, order: Sequence[int], outputs: Sequence[Scalar]) -> tuple[Graph, list[Scalar]]:
    """The positions ``order`` of ``graph``, each behind those that it reads, as a graph of their own, and
    ``outputs`` there. What could be folded is already.
    """
    target = Graph(fold=graph.fold)
    keys, labels = graph.keys, graph.labels
    place, sign = [0] * len(keys), [1] * len(keys)

    def copy(p: int) -> Scalar:
        """What stands at ``p``, in the new graph."""
        return keys[p][1] if keys[p][0] == "const" else Node(target, place[p], sign[p])

    for p in order:
        key = keys[p]
        op = key[0]
        if op == "mul":
            _, i, j = key
            own, i, j = sign[i] * sign[j], place[i], place[j]
            product = ("mul", i, j) if i <= j else ("mul", j, i)
            place[p], sign[p] = target.append(product, product), own
        elif op == "add" and keys[key[1]][0] != "const" != keys[key[3]][0]:
            _, i, relative, j = key
            first, second, i, j = sign[i], relative * sign[j], place[i], place[j]
            if i > j:
                i, j, first, second = j, i, second, first
            total = ("add", i, first * second, j)
            place[p], sign[p] = target.append(total, total), first
        elif op == "const":
            continue  # made where it is read
        else:
            node = copied(target, key, {child: copy(child) for child in graph.reads[p]})
            assert isinstance(node, Node)
            place[p], sign[p] = node.position, node.sign
        if p in labels:
            target.label(copy(p), labels[p])
    return target, [copy(v.position) * v.sign if isinstance(v, Node) else v for v in outputs]
