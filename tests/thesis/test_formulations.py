"""Formulations of earlier papers: exactly the torques of Newton-Euler, whatever the scalars are."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import ModuleType
from typing import Any

import pytest

from dynamics.direct import Recorder, State, exact_arm, values_of, with_named_numbers
from ir.programs import Point, every_value, exactly
from robodyn.dynamics.arm import Arm, Motion, build_arm, build_motion
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.vectors import Mark, unmarked
from robodyn.ir import Graph, Program
from robodyn.ir.lowering import lower
from robodyn.optimize.programs import exact, turned
from robodyn.passes import FRESH, run, units
from robodyn.robot import Robot
from robodyn.thesis.formulations import (
    balafoutis,
    kane,
    lagrange,
    lagrange_3x3,
    lagrange_4x4,
    newton_euler_base,
    orin,
)
from robodyn.thesis.logarithmic import doubling, logarithmic, tree
from robodyn.thesis.printed import bundled

Formulation = Callable[[Arm, Motion, Mark], list[Any]]
MODULES: tuple[ModuleType, ...] = (
    newton_euler_base, orin, balafoutis, kane, lagrange_3x3, lagrange_4x4, lagrange
)  # fmt: skip
FORMULATIONS: dict[str, Formulation] = {
    module.__name__.rpartition(".")[2]: getattr(module, module.__name__.rpartition(".")[2])
    for module in MODULES
}
ARMS = [exact_arm(seed, joints=1 + seed % 5, generic_angles=0.6, prismatic=0.35) for seed in range(100, 130)]

each = pytest.mark.parametrize("name", FORMULATIONS)


def draft(robot: Robot, name: str) -> Program:
    """The program of a formulation, no pass run yet."""
    graph = Graph()
    q, qd, qdd = ([graph.input(array, i) for i in range(robot.n)] for array in ("q", "qd", "qdd"))
    arm = build_arm(robot, exact, graph.input)
    motion = build_motion(arm, q, qd, qdd, lambda angle: turned(graph, q, angle), exact)
    return lower(graph, [("tau", FORMULATIONS[name](arm, motion, graph.label))])


@each
def test_torques_are_newton_eulers_fractions(name: str) -> None:
    for robot in ARMS if "lagrange" not in name else [arm for arm in ARMS if arm.n < 5]:
        state = State(robot, Point(3))
        motion = state.motion()
        assert FORMULATIONS[name](state.arm, motion, unmarked) == newton_euler(state.arm, motion), robot.name


@pytest.mark.parametrize(
    ("name", "own"),
    [
        ("kane", {"pw", "pv", "ao", "w"}),
        ("balafoutis", {"lam", "nc", "fw", "w"}),
        ("newton_euler_base", {"fb", "nb", "ncb", "E", "wb", "ab"}),
        ("orin", {"f", "n", "nc", "E", "wb", "ab"}),
    ],
)
def test_every_named_value_is_the_quantity_of_that_name(name: str, own: set[str]) -> None:
    state = State(bundled("stanford"), Point(4))
    recorder = Recorder()
    FORMULATIONS[name](state.arm, state.motion(), recorder.mark)
    made = run(draft(state.robot, name), FRESH)
    seen = set()
    for (_, _, label), value in zip(made.operations, every_value(made, state.at), strict=True):
        if label is not None and label.quantity not in ("c", "s"):
            values = recorder.values[label._replace(negative=False)]
            assert (-value if label.negative else value) in values, str(label)
            seen.add(label.quantity)
    # Sums in other units lose their names: those of the formulation are counted without that pass.
    plain = run(draft(state.robot, name), [one for one in FRESH if one is not units])
    seen |= {label.quantity for _, _, label in plain.operations if label is not None}
    assert seen >= own | {"tau"}


@each
def test_every_number_of_the_arm_may_be_given_at_run_time(name: str) -> None:
    robot = next(arm for arm in ARMS if arm.n == 2 and "prismatic" in {x.joint.kind for x in arm.links})
    described = with_named_numbers(robot)
    state = State(robot, Point(3))
    numbers = {**values_of(described, robot), **state.numbers()}
    found = exactly(draft(described, name), Point(3), numbers)["tau"]
    assert found == newton_euler(state.arm, state.motion())


# --- running totals -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("totals", [doubling, tree], ids=["doubling", "tree"])
def test_the_logarithmic_forms_are_newton_euler(totals: Any) -> None:
    """Any angles, full tensors, rotors and friction, revolute and prismatic joints."""
    for robot in ARMS:
        state = State(robot, Point(4))
        found = logarithmic(state.arm, state.motion(), run=totals)
        assert found == newton_euler(state.arm, state.motion()), robot.name


@pytest.mark.parametrize("totals", [doubling, tree], ids=["doubling", "tree"])
@pytest.mark.parametrize("n", range(18))
def test_running_totals_join_neighbours_in_order(totals: Any, n: int) -> None:
    joins = 0

    def join(a: tuple[str, int], b: tuple[str, int]) -> tuple[str, int]:
        nonlocal joins
        joins += 1
        return a[0] + b[0], 1 + max(a[1], b[1])

    text = "abcdefghijklmnopqrstuvwxyz"[:n]
    found = totals([(letter, 0) for letter in text], join)
    assert [total for total, _ in found] == [text[: i + 1] for i in range(n)]
    stages = max((stage for _, stage in found), default=0)
    if n > 1:
        least = math.ceil(math.log2(n))
        assert stages == least if totals is doubling else least <= stages <= 2 * least
        assert totals is doubling or joins < 2 * n
