"""Choosing among ways to write the same: what is needed already is free, what was only tried is not."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from robodyn.counts import count
from robodyn.ir.field import Field
from robodyn.ir.graph import Graph
from robodyn.kernels.generate import Options, program
from robodyn.optimize.cheapest import Cheapest
from robodyn.optimize.merging import MergingGraph
from robodyn.optimize.tally import Circle, Tally
from robodyn.robot.bundled import load


def test_what_was_tried_in_vain_is_not_free() -> None:
    graph, cheapest = Graph(), Cheapest()
    x, y = (graph.input("q", i) for i in range(2))
    product, total = [x * y * y], [x + y]

    def dear() -> list[object]:
        (values,) = cheapest([[product]])
        return list(values)

    assert cheapest.apart([dear, lambda: total]) == total
    # x y y would be free had it been chosen; now x + y is.
    assert cheapest([[product, total]]) == [total]


def test_ways_see_what_was_chosen_before() -> None:
    graph, cheapest = Graph(), Cheapest()
    x, y = (graph.input("q", i) for i in range(2))
    (before,) = cheapest([[[x * y]]])
    assert cheapest.apart([lambda: [x + y], lambda: [x * y]]) == before


def test_numbers_are_computed_the_first_way() -> None:
    def second() -> list[object]:
        raise AssertionError("numbers take no operations: there is nothing to compare")

    assert Cheapest().apart([lambda: [0.5], second]) == [0.5]


@pytest.mark.parametrize(
    ("robot", "function", "rival"),
    [
        ("stanford", "forward_kinematics", 59),
        ("iiwa", "forward_kinematics", 104),
        ("iiwa", "tool_jacobian", 113),
        ("puma560", "jacobian", 48),  # directions from sections nearby
    ],
)
def test_two_rows_of_a_rotation_suffice(robot: str, function: str, rival: int) -> None:
    """Fewer operations than the best of the other tools takes (``docs/function-counts.md``): all three rows
    multiplied up are as many as theirs."""
    assert fast(robot, function) < rival


def fast(robot: str, function: str) -> int:
    arm = load(robot, warn=lambda _: None)
    return count(program(arm, function, Options((function,), optimize="fast"))).total


# Nodes of equal value are one, whatever way they were come by; others are not.


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
