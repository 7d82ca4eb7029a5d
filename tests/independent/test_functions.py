"""Every function of the registry, of every effect of the catalogue: as in the reference, or refused.

What each function is compared with stands in :mod:`independent.answers` and :mod:`independent.checks`.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

import robodyn
from independent.answers import ANSWERS
from independent.arms import CONVENTIONS, RIGHT, Arm, arm, placed
from independent.cases import CASES, with_case
from independent.checks import CHECKS
from independent.matrix import EVERY, TOLERANCE, Outcome, compare, errors, outcomes, read, states
from independent.reference import Reference
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
    "stribeck_friction",
    "motor_coupling",
    "names, drives together",
}


def holds(found: list[Outcome]) -> None:
    assert not [outcome.text for outcome in found if outcome.fails]


def test_no_function_and_no_effect_is_left_out() -> None:
    assert set(FUNCTIONS) <= set(ANSWERS) | set(CHECKS)
    there = set()
    for name in CASES:
        shown = with_case(placed("RP", "mdh", 2), name)
        assert shown is not None
        lists = [shown.get("effects", ()), *(link.get("effects", ()) for link in shown["links"])]
        there |= {entry["effect"] for entries in lists for entry in entries}
    assert there == set(CATALOGUE)


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_the_reference_agrees_with_itself(convention: str) -> None:
    """Lagrange's torques are d'Alembert's reactions along the joints."""
    reference = Reference(placed("RPR", convention, 3))
    (at,) = states(reference.arm, 1, 0)
    del at["tau"]
    along = [
        (moment if link["joint"] == "revolute" else force)[2]
        for (force, moment), link in zip(reference.reactions, reference.links, strict=True)
    ]
    torques = reference.value("links", lambda: reference.of_links, **at)
    assert np.allclose(
        reference.value("along", lambda: ca.vertcat(*along), **at), torques, rtol=1e-12, atol=1e-12
    )


@pytest.mark.parametrize("case", representative(CASES, *QUICK))
def test_a_joint_with(case: str) -> None:
    """One joint, kinds and conventions by turns; what drives have no part in is in the next test."""
    turn = list(CASES).index(case)
    orders = ("R", "P", "RP") if turn % 2 else ("P", "R", "RP")
    found: list[Outcome] = []
    while not found:
        joints, *orders = orders  # type: ignore[assignment]
        found = outcomes(case, joints, CONVENTIONS[turn // 2 % 2], OF_DRIVES)
    holds(found)


@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize(("joints", "put"), representative([("PR", arm), ("RP", placed)], "RP"))
def test_a_rigid_arm(joints: str, convention: str, put: Callable[..., Arm]) -> None:
    """Also where the last link's frame is the tool, and where the base frame is the world."""
    holds(list(compare(put(joints, convention, 2), "rigid", EVERY, level="none")))


@pytest.mark.slow
@pytest.mark.parametrize("joints", ["R", "P", "RR", "PP", "RP", "PR", "RPR", "PRP", "RRRR"])
@pytest.mark.parametrize("case", CASES)
def test_many_arms_with(joints: str, case: str) -> None:
    """With what makes programs shorter, and inverse kinematics where there is a closed form."""
    functions = EVERY if len(joints) <= 3 else LONG
    holds([x for way in CONVENTIONS for x in outcomes(case, joints, way, functions, "fast")])


@pytest.mark.thorough
@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("case", ["rigid", "names, drives together"])
def test_what_a_compiler_makes_of_it(convention: str, case: str) -> None:
    """The same programs as C."""
    described = with_case(placed("RPR", convention, 3), case)
    assert described is not None
    names = tuple(name for name in ANSWERS if name in FUNCTIONS)
    kernel = robodyn.compile(read(described), functions=names, optimize="fast")
    reference = Reference(described)
    wrong = {}
    for at in states(described, 3, 7):
        for name in names:
            function = getattr(kernel, name)
            params = described.get("values") if function.parameters else None
            results = function(*(at[x] for x, _ in function.inputs), params=params)
            results = results if isinstance(results, tuple) else (results,)
            expected = [np.ravel(x) for x in ANSWERS[name](reference, at)]
            off = max(errors([np.ravel(x) for x in results], expected))
            if not off <= TOLERANCE:
                wrong[name] = off
    assert not wrong


#: Twists of an arm with a spherical wrist whose second and third axes are parallel.
WRIST = {"mdh": (0.3, -RIGHT, 0, RIGHT, -RIGHT, RIGHT), "sdh": (-RIGHT, 0, RIGHT, -RIGHT, RIGHT, 0.3)}


def six_joints(convention: str) -> Arm:
    """The last three axes meet; where the first or the last row is free, it is general."""
    described = placed("RRRRRR", convention, 6, WRIST[convention])
    wrist = described["links"][4:] if convention == "mdh" else described["links"][3:5]
    for link in wrist:
        link["a"] = 0
    described["links"][4]["d"] = 0
    return described


@pytest.mark.thorough
@pytest.mark.parametrize("convention", CONVENTIONS)
def test_six_joints(convention: str) -> None:
    names = (
        "inverse_kinematics",
        "nearest_inverse_kinematics",
        "forward_dynamics_derivatives",
        "link_poses",
        "regressor",
    )
    holds(list(compare(six_joints(convention), "rigid", names, level="none")))
