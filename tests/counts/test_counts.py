"""Counts by the thesis's convention, budgets on them, and the thesis's figures set beside them."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from robodyn import InputError, load, program
from robodyn.counts import Count, count, parse_budget
from robodyn.counts.thesis import beside
from robodyn.ir import Input, Label, Operation, Program
from robodyn.optimize.programs import FORMULATIONS
from robodyn.robot import Comparison

A3X, LAM, Q = Input("a3_x", None), Input("lam3_12", None), Input("q", 0)


def counted(*operations: Operation) -> Count:
    return count(Program(operations, (("t", (len(operations) - 1,)),)))


def test_the_worked_line() -> None:
    """``fc3_x = 4.8*(a3_x - 0.07*lam3_12)`` is two multiplications and one addition."""
    found = counted(
        Operation("mul", (Fraction(7, 100), LAM)),
        Operation("sub", (A3X, 0)),
        Operation("mul", (Fraction(48, 10), 1), Label(3, "fc", "x")),
    )
    assert found == Count(mul=2, add=1)
    assert found.total == 3
    assert counted(Operation("mul", (Fraction(2), Q)), Operation("mul", (0, 0))) == Count(mul=2)
    assert str(found) == "2 multiplications, 1 addition = 3"


def test_every_operation_has_its_kind() -> None:
    kinds = {
        "mul": "mul", "add": "add", "sub": "add", "div": "div", "sqrt": "sqrt", "neg": "neg", "sin": "sincos",
        "cos": "sincos", "tanh": "other", "sign": "other",
    }  # fmt: skip
    for op, kind in kinds.items():
        args = (Q, Q) if op in ("mul", "add", "sub", "div") else (Q,)
        found = counted(Operation(op, args))
        assert found == Count(**{kind: 1})
        assert found.total == (kind in ("mul", "add", "div", "sqrt"))


def test_in_words_and_as_a_dictionary() -> None:
    found = Count(mul=5, add=4, div=2, sqrt=1, neg=3, sincos=6, other=7)
    assert str(found) == "5 multiplications, 4 additions, 2 divisions, 1 square root = 12"
    assert found.to_dict() == {
        "mul": 5, "add": 4, "div": 2, "sqrt": 1, "neg": 3, "sincos": 6, "other": 7, "total": 12,
    }  # fmt: skip


# --- budgets ----------------------------------------------------------------------------------------------


def test_a_budget_holds_up_to_its_limit() -> None:
    found = Count(mul=208, add=152, neg=9)
    assert parse_budget("mul=208,add=152,total=360").exceeded(found) == []
    assert parse_budget(" mul = 207 , neg=8 ").exceeded(found) == [
        "mul 208 is 1 over the budget of 207",
        "neg 9 is 1 over the budget of 8",
    ]
    assert parse_budget("total=0").exceeded(found) == ["total 360 is 360 over the budget of 0"]
    assert parse_budget("div=0,sqrt=0,sincos=0,other=0").exceeded(found) == []


@pytest.mark.parametrize(
    "text",
    [
        "", ",", "mul", "mul=", "=3", "mul=-1", "mul=1.5", "mul=1e3", "mul=ten", "multiplications=3",
        "mul=3,", "mul=3 add=4", "mul=3;add=4", "mul==3", "mul=３", "mul=1_000", "mul=9999999999", "Mul=3",
    ],
)  # fmt: skip
def test_what_is_no_budget(text: str) -> None:
    with pytest.raises(InputError, match=r"not a budget; found .*; expected KIND=NUMBER") as caught:
        parse_budget(text)
    assert "mul=208,add=152,total=360" in str(caught.value)


def test_a_kind_is_given_once() -> None:
    with pytest.raises(InputError, match="budget for mul given twice"):
        parse_budget("mul=3,add=1,mul=4")


# --- beside the thesis ------------------------------------------------------------------------------------


def test_every_verdict() -> None:
    robot = load("stanford_3dof")
    for found, verdict in (
        (Count(mul=48, add=33), "reproduced"),
        (Count(mul=33, add=48), "differs: the same total, split otherwise"),
        (Count(mul=40, add=32), "differs: 9 fewer (11.1 %)"),
        (Count(mul=48, add=34), "differs: 1 more (1.2 %)"),
    ):
        printed = beside(robot, "inverse_dynamics", found)
        assert printed is not None
        assert printed.verdict == verdict
        assert (printed.table, printed.row, printed.mul, printed.add, printed.total) == (
            "2.10", "stanford_3", 48, 33, 81,
        )  # fmt: skip
        assert printed.to_dict().keys() >= {"mul", "add", "note"}


def test_there_is_nothing_beside_what_the_thesis_does_not_have() -> None:
    robot = load("stanford_3dof")
    assert beside(robot, "gravity", Count()) is None
    assert beside(replace(robot, compare=None), "inverse_dynamics", Count()) is None
    for compare in (Comparison("2.11", "stanford_3"), Comparison("2.10", "scara")):
        assert beside(replace(robot, compare=compare), "inverse_dynamics", Count()) is None


# --- what must be shown -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "total", "mul"),
    [
        ("puma560_d2", 341, 208),
        ("stanford_d3", 248, 183),
        ("puma560_3dof_d3", 142, 84),
        ("stanford_3dof_d3", 72, 48),
    ],
)
def test_counts_beat_the_thesis(name: str, total: int, mul: int) -> None:
    found = count(program(load(name, warn=lambda _: None), "inverse_dynamics"))
    assert found.total <= total
    assert found.mul <= mul


def test_each_formulation_is_held_to_its_own_figure() -> None:
    """The thesis's own recursion to method I, Balafoutis's to VI; the others have no figure in the table."""
    robot, found = load("puma560_d2", warn=lambda _: None), Count(mul=200, add=100)
    printed = {
        name: None if (row := beside(robot, "inverse_dynamics", found, name)) is None else (row.mul, row.add)
        for name in FORMULATIONS
    }
    own = {"modified_newton_euler": (208, 152), "balafoutis": (277, 255)}
    assert printed == dict.fromkeys(FORMULATIONS) | own
    assert beside(load("stanford_3dof"), "inverse_dynamics", found, "balafoutis") is None
