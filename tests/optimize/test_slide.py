"""Frames of sliding links beside the centre of mass: the same functions, in fewer operations."""

from __future__ import annotations

import pytest

from robodyn.counts import count
from robodyn.dynamics.arm import build_arm
from robodyn.dynamics.equality import same_in_field
from robodyn.ir.graph import Graph
from robodyn.optimize import programs
from robodyn.optimize.fast import centred
from robodyn.optimize.programs import Choice, build
from robodyn.robot import read_text

#: A slide with a parallel joint behind it, upside down, and an axis across before it.
ARM = """\
name: reaching
links:
  - {{joint: revolute, d: 0.3, mass: 3, com: [0.1, 0.2, 0.3], inertia: {{xx: 0.1, yy: 0.12, zz: 0.09}}}}
  - {{joint: revolute, a: 0.3, alpha: pi/2, mass: 2, com: [0.1, 0, 0.2]}}
  - {{joint: prismatic, alpha: {across}, a: 0.2, mass: {mass}, com: [0, 0, 0.1]}}
  - {{joint: revolute, alpha: {behind}, mass: 1.5, d: 0.1, com: [0.02, 0, 0.07]}}
"""
FUNCTIONS = ("gravity", "potential_energy", "kinetic_energy", "momentum_observer_term", "mass_matrix")


def text(across: str = "pi/2", behind: str = "pi", mass: str = "1") -> str:
    return ARM.format(across=across, behind=behind, mass=mass)


@pytest.mark.parametrize("function", FUNCTIONS)
def test_the_function_is_the_same_and_takes_no_more(function: str, monkeypatch: pytest.MonkeyPatch) -> None:
    robot = read_text(text())
    moved = build(robot, function, Choice())
    assert same_in_field(robot, function, moved)
    monkeypatch.setattr(programs, "centred", lambda arm: arm)
    assert count(moved).total <= count(build(robot, function, Choice())).total


def test_it_saves_operations(monkeypatch: pytest.MonkeyPatch) -> None:
    robot = read_text(text())
    moved = count(build(robot, "momentum_observer_term", Choice())).total
    monkeypatch.setattr(programs, "centred", lambda arm: arm)
    assert moved < count(build(robot, "momentum_observer_term", Choice())).total


@pytest.mark.parametrize("other", [{"across": "0"}, {"behind": "pi/2"}, {"mass": "load"}])
def test_where_it_would_make_an_offset_frames_stay(other: dict[str, str]) -> None:
    arm = build_arm(read_text(text(**other)), lambda x: x, Graph().input)
    assert centred(arm) is arm
