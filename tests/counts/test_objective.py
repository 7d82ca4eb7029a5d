"""What a search makes small, counted by hand on programs of a few lines."""

from __future__ import annotations

from fractions import Fraction

import pytest

from robodyn import InputError, load
from robodyn.counts import count
from robodyn.counts.objective import Objective, operations_of
from robodyn.ir import Input, Operation, Program
from robodyn.optimize.fast import suited_variant
from robodyn.optimize.programs import Choice, build
from robodyn.search.space import Candidates, Space
from robodyn.targets import TARGETS

X, Y, Q = Input("qd", 0), Input("qd", 1), Input("q", 0)

#: ``c x + 2 y`` and ``-(c x)``: the product c x serves twice and does not fuse, 2 y does.
LINES = (
    Operation("cos", (Q,)),
    Operation("mul", (0, X)),
    Operation("mul", (Fraction(2), Y)),
    Operation("sub", (1, 2)),
    Operation("neg", (1,)),
)
PROGRAM = Program(LINES, (("tau", (3, 4)),))


def test_operations_by_hand() -> None:
    found = operations_of(PROGRAM)
    assert found.counts == {"cos": 1, "mul": 2, "add": 1}
    assert (found.total, found.fused) == (3, 1)
    assert found.depth == 2


def test_an_addition_fuses_with_one_product() -> None:
    both = (Operation("mul", (X, X)), Operation("mul", (X, Y)), Operation("add", (0, 1)))
    assert operations_of(Program(both, (("tau", (2,)),))).fused == 1
    assert operations_of(Program(both, (("tau", (2, 0, 1)),))).fused == 0  # outputs are uses


@pytest.mark.parametrize(
    ("objective", "cost"),
    [
        (Objective(), 3),
        (Objective("mul"), 2),
        (Objective("fma"), 2),
        (Objective("depth"), 2),
        (Objective("sincos"), 1),
        (Objective("weighted", "cortex-m4"), 3 + TARGETS["cortex-m4f"].costs.sincos),
        (Objective("weighted", "x86-64-v3"), 2 + TARGETS["x86-64-v3"].costs.sincos),
    ],
    ids=lambda value: str(value),
)
def test_costs_by_hand(objective: Objective, cost: float) -> None:
    """Of equals the one with fewer operations costs less, by less than one operation."""
    assert cost <= objective.cost(operations_of(PROGRAM)) < cost + 0.5


@pytest.mark.parametrize(
    ("name", "target"), [("speed", ""), ("weighted", ""), ("weighted", "z80"), ("total", "cortex-m4")]
)
def test_an_objective_must_be_known(name: str, target: str) -> None:
    with pytest.raises(InputError, match=r"unknown (objective|target)"):
        Objective(name, target)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", ["puma560_3dof_d3", "stanford_d3"])
def test_a_tally_and_its_program_cost_the_same(name: str) -> None:
    robot = load(name, warn=lambda _: None)
    variant = suited_variant(Space(robot).arm)
    made = build(robot, "inverse_dynamics", Choice(variant=variant))
    for objective in (Objective("mul"), Objective("sincos"), Objective("weighted", "cortex-m4")):
        cost = Candidates(robot, objective).cost(variant)
        assert cost == pytest.approx(objective.cost(operations_of(made)), abs=1e-9)
    assert operations_of(made).total == count(made).total
