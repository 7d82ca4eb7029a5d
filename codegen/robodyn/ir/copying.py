"""Nodes of one graph copied into another, which folds them anew."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from robodyn.ir.graph import Graph, Key, Scalar


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
