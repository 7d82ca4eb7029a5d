"""Nodes of equal value are one, whatever way they were come by; others are not."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.ir.field import Field
from robodyn.optimize.merging import MergingGraph
from robodyn.optimize.tally import Circle, Tally


def test_equal_values_are_one_node() -> None:
    graph = MergingGraph(Field("here"))
    x, y = graph.input("qd", 0), graph.input("qd", 1)
    assert (x + y) * (x - y) == x * x - y * y
    assert (x + y) * Fraction(1, 3) == x * Fraction(1, 3) + y * Fraction(1, 3)
    assert x * y - y * x == 0
    assert (x - y) * (x - y) == (y - x) * (y - x)
    assert x * y != x + y


def test_sines_and_cosines_obey_the_addition_theorems() -> None:
    graph = MergingGraph(Field("here"))
    p, q = graph.input("q", 0), graph.input("q", 1)
    c, s, e, f = graph.cos(p), graph.sin(p), graph.cos(q), graph.sin(q)
    assert c * c + s * s == 1
    total, difference = graph.cos(p + q), graph.cos(p - q)
    assert total == c * e - s * f
    assert difference == c * e + s * f
    assert total != difference
    assert graph.sin(p - q) == s * e - c * f


def test_a_tally_says_the_same() -> None:
    tally = Tally(Circle())
    x, y = tally.input("qd", 0), tally.input("qd", 1)

    def cost(*outputs: Any) -> int:
        return len([p for p in tally.needed(outputs) if tally.entries[p][1]])

    assert cost(x * y + x * x) == 3
    assert (x * y - y * x, x - x, x * 0) == (0, 0, 0)
    assert cost((x * 3) * 5) == cost((x + 2) + 3) == 1  # k (l x) = (k l) x, (x + k) + l = x + (k + l)
    assert cost(x * 3 + x * 4) == 1
    assert cost(x * x - y * y, (x + y) * (x - y)) == cost(x * x - y * y)
