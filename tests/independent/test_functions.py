"""Every function of the registry, of every effect of the catalogue: as in the reference, or refused.

What each function is compared with stands in :mod:`independent.answers` and :mod:`independent.checks`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import pytest

from independent.answers import ANSWERS
from independent.arms import CONVENTIONS, Arm, arm, placed
from independent.cases import CASES, with_case
from independent.checks import CHECKS
from independent.matrix import EVERY, Outcome, compare, outcomes
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.effects.catalogue import CATALOGUE
from robodyn_testing import representative

pytestmark = pytest.mark.filterwarnings("ignore::robodyn.robot.reader.DoubtfulRobot")

OF_DRIVES = tuple(name for name in EVERY if name not in FUNCTIONS or FUNCTIONS[name].drives)
LONG = tuple(name for name in EVERY if "kinematics" not in name or name.startswith("forward_kinematics"))

#: What is tried at every change: one effect of each place in a drive, and run-time names.
QUICK = {
    "spring",
    "load_dependent_friction, journal",
    "joint_elasticity",
    "transmission_loss, cubic",
    "friction, smooth",
    "stribeck_friction",
    "motor_coupling",
    "names, drives together",
}


def failures(outcomes: Iterable[Outcome]) -> list[str]:
    return [outcome.text for outcome in outcomes if outcome.fails]


def test_no_function_and_no_effect_is_left_out() -> None:
    assert set(FUNCTIONS) <= set(ANSWERS) | set(CHECKS)
    there = set()
    for name in CASES:
        shown = with_case(placed("RP", "mdh", 2), name)
        assert shown is not None
        lists = [shown.get("effects", ()), *(link.get("effects", ()) for link in shown["links"])]
        there |= {entry["effect"] for entries in lists for entry in entries}
    assert there == set(CATALOGUE)


@pytest.mark.parametrize("case", representative(CASES, *QUICK, rest="slow"))
def test_a_joint_with(case: str) -> None:
    """One joint, kinds and conventions by turns; what drives have no part in is in the next test."""
    turn = list(CASES).index(case)
    orders = ("R", "P", "RP") if turn % 2 else ("P", "R", "RP")
    found: list[Outcome] = []
    while not found:
        joints, *orders = orders  # type: ignore[assignment]
        found = outcomes(case, joints, CONVENTIONS[turn // 2 % 2], OF_DRIVES)
    assert failures(found) == []


@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize(("joints", "put"), representative([("PR", arm), ("RP", placed)], "RP"))
def test_a_rigid_arm(joints: str, convention: str, put: Callable[..., Arm]) -> None:
    """Also where the last link's frame is the tool, and where the base frame is the world."""
    assert failures(compare(put(joints, convention, 2), "rigid", EVERY, level="none")) == []


@pytest.mark.slow
@pytest.mark.parametrize("joints", ["R", "P", "RR", "PP", "RP", "PR", "RPR", "PRP", "RRRR"])
@pytest.mark.parametrize("case", CASES)
def test_many_arms_with(joints: str, case: str) -> None:
    """With what makes programs shorter, and inverse kinematics where there is a closed form."""
    functions = EVERY if len(joints) <= 3 else LONG
    for way in CONVENTIONS:
        assert failures(outcomes(case, joints, way, functions, "fast")) == []
