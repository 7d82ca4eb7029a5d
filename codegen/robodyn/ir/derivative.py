"""Derivatives of nodes by inputs, as nodes of the same graph: forward mode, exact."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.ir.lowering import needed
from robodyn.ir.program import Input

#: Added to a root or a sum of squares in a denominator: where the sum is zero, so is the derivative of its
#: root taken, and that of the angle of a point.
_TINY = Fraction(1, 10**150)


def jacobian(graph: Graph, outputs: Sequence[Scalar], inputs: Sequence[Input]) -> list[list[Scalar]]:
    """``d outputs_i / d inputs_j`` as rows [i][j].

    Where ``|x|`` and ``sgn x`` have no derivative, that of ``|x|`` is 0, and that of ``sgn x`` is 0
    everywhere. What is selected has the derivative of what it is selected from, wherever the border lies.

    Raises
    ------
    ValueError: an exponent of ``pow`` depends on an input.
    """
    order = needed(graph, [("", list(outputs))])
    columns = [_tangents(graph, order, {x: 1}) for x in inputs]
    return [[_slope(value, tangents) for tangents in columns] for value in outputs]


def directional(graph: Graph, outputs: Sequence[Scalar], seeds: Mapping[Input, Scalar]) -> list[Scalar]:
    """The derivatives of ``outputs`` where inputs change at the rates ``seeds``, others not at all.

    Raises
    ------
    ValueError: an exponent of ``pow`` depends on such an input.
    """
    tangents = _tangents(graph, needed(graph, [("", list(outputs))]), seeds)
    return [_slope(value, tangents) for value in outputs]


def _slope(value: Scalar, tangents: Mapping[int, Any]) -> Any:
    return tangents.get(value.position, 0) * value.sign if isinstance(value, Node) else 0


def _tangents(graph: Graph, order: Sequence[int], seeds: Mapping[Input, Scalar]) -> dict[int, Scalar]:
    """The derivatives of positions that depend on inputs with ``seeds``; others are left out."""
    tangents: dict[int, Any] = {}
    for position in order:
        tangent = _tangent(graph, position, seeds, tangents)
        if not _is_zero(tangent):
            tangents[position] = tangent
    return tangents


def _is_zero(value: Any) -> bool:
    return not isinstance(value, Node) and value == 0


def _tangent(graph: Graph, position: int, seeds: Mapping[Input, Scalar], known: dict[int, Any]) -> Any:
    key = graph.keys[position]
    op = key[0]

    def at(p: int) -> Node:
        return Node(graph, p, 1)

    def slope(p: int) -> Any:
        return known.get(p, 0)

    if op == "input":
        return seeds.get(key[1], 0)
    if op == "const":
        return 0
    if op == "add":
        return slope(key[1]) + key[2] * slope(key[3])
    if op == "scale":
        return key[1] * slope(key[2])
    if op == "mul":
        return slope(key[1]) * at(key[2]) + at(key[1]) * slope(key[2])
    if op == "div":
        return graph.div(slope(key[1]) - at(position) * slope(key[2]), at(key[2]))
    if op == "atan2":
        _, y, _, x, sign = key
        above = sign * (at(x) * slope(y) - at(y) * slope(x))
        return graph.div(above, at(x) * at(x) + at(y) * at(y) + _TINY)
    if op == "select":
        _, condition, sign, a, _, b, relative = key
        return graph.select(sign * at(condition), slope(a), relative * slope(b))
    if op == "pow" and key[3] in known:
        raise ValueError("an exponent depends on an input")
    inner, value = slope(key[1]), at(position)
    if _is_zero(inner) or op == "sign":
        return 0
    if op == "pow":
        base, exponent = key[2] * at(key[1]), _number(graph, key[3], key[4])
        return exponent * graph.pow(base, exponent - 1) * (key[2] * inner)
    if op == "sqrt":
        return graph.div(key[2] * inner, 2 * value + _TINY)
    outer: dict[str, Callable[[], Any]] = {
        "sin": lambda: graph.cos(at(key[1])),
        "cos": lambda: -graph.sin(at(key[1])),
        "tanh": lambda: 1 - value * value,
        "abs": lambda: graph.sign(at(key[1])),
        "exp": lambda: key[2] * value,
    }
    return outer[op]() * inner


def _number(graph: Graph, position: int, sign: int) -> Any:
    """A constant as itself, else its node."""
    key = graph.keys[position]
    return sign * key[1] if key[0] == "const" else Node(graph, position, sign)
