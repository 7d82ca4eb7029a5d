"""The logarithmic forms: Newton-Euler's torques exactly, running totals by few stages."""

from __future__ import annotations

import math

import pytest

from dynamics.direct import State, exact_arm
from ir.programs import Point
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.thesis.formulations.logarithmic import Running, doubling, logarithmic, tree

RUNNING: tuple[Running, ...] = ("doubling", "tree")


@pytest.mark.parametrize("running", RUNNING)
@pytest.mark.parametrize("seed", range(400, 410))
def test_the_torques_are_those_of_newton_euler(seed: int, running: Running) -> None:
    """Any angles, full tensors, rotors and friction, revolute and prismatic joints, 1 to 7 of them."""
    state = State(exact_arm(seed, joints=1 + seed % 7), Point(seed))
    found = logarithmic(state.arm, state.motion(), running=running)
    assert found == newton_euler(state.arm, state.motion())


def test_the_arms_have_prismatic_joints_too() -> None:
    kinds = [
        link.joint.kind for seed in range(400, 410) for link in exact_arm(seed, joints=1 + seed % 7).links
    ]
    assert min(kinds.count("revolute"), kinds.count("prismatic")) >= 5


@pytest.mark.parametrize("run", [doubling, tree])
@pytest.mark.parametrize("n", range(18))
def test_running_totals_join_neighbours_in_order(run: object, n: int) -> None:
    joins = 0

    def join(a: tuple[str, int], b: tuple[str, int]) -> tuple[str, int]:
        nonlocal joins
        joins += 1
        return a[0] + b[0], 1 + max(a[1], b[1])

    text = "abcdefghijklmnopqrstuvwxyz"[:n]
    found = run([(letter, 0) for letter in text], join)  # type: ignore[operator]
    assert [totals for totals, _ in found] == [text[: i + 1] for i in range(n)]
    stages = max((stage for _, stage in found), default=0)
    if n > 1:
        least = math.ceil(math.log2(n))
        assert stages == least if run is doubling else least <= stages <= 2 * least
        if run is tree:
            assert joins < 2 * n
