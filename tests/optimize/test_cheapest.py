"""Choosing among ways to write the same: what is needed already is free, what was only tried is not."""

from __future__ import annotations

import pytest

from robodyn.counts import count
from robodyn.ir.graph import Graph
from robodyn.kernels.generate import Options, program
from robodyn.optimize.cheapest import Cheapest
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
    ],
)
def test_two_rows_of_a_rotation_suffice(robot: str, function: str, rival: int) -> None:
    """Fewer operations than the best of the other tools takes (``docs/function-counts.md``): all three rows
    multiplied up are as many as theirs."""
    assert fast(robot, function) < rival


def test_directions_from_sections_nearby() -> None:
    """With each axis multiplied up with its section's it is 48."""
    assert fast("puma560", "jacobian") < 48


def fast(robot: str, function: str) -> int:
    arm = load(robot, warn=lambda _: None)
    return count(program(arm, function, Options((function,), optimize="fast"))).total
