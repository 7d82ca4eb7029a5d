"""Newton-Euler along the base's axes and Orin's mixed frames: exactly the torques of Newton-Euler."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics.direct import NO_SHRINKING, Recorder, State, exact_arm
from ir.programs import Point, every_value
from robodyn import Options, load, program
from robodyn.counts.general import general_count
from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.transforms import IDENTITY_3, product, transposed
from robodyn.dynamics.vectors import Mark, unmarked
from robodyn.ir import Label
from robodyn.ir.fingerprint import fingerprint
from robodyn.robot import Robot
from robodyn.robot.values import circle_point
from robodyn.thesis.formulations import newton_euler_base as base_module
from robodyn.thesis.formulations import orin as orin_module
from robodyn.thesis.formulations.base_frame import motion_in_base, turned
from robodyn.thesis.formulations.newton_euler_base import inertia_in_base, newton_euler_base
from robodyn.thesis.formulations.orin import orin
from robodyn.verify.exact import exact_torque

Formulation = Callable[[Arm, Motion, Mark], list[Any]]
ARMS = [exact_arm(seed, joints=1 + seed % 5, generic_angles=0.6, prismatic=0.35) for seed in range(200, 215)]

both = pytest.mark.parametrize("formulation", [newton_euler_base, orin], ids=lambda f: f.__name__)


def bundled(name: str) -> Robot:
    return load(name, warn=lambda _: None)


@both
@settings(deadline=None, max_examples=25, phases=NO_SHRINKING)
@given(st.integers(0, 10**6), st.integers(1, 6), st.integers(0, 10**6))
def test_torques_are_newton_eulers_fractions(formulation: Formulation, seed: int, n: int, point: int) -> None:
    state = State(exact_arm(seed, joints=n, generic_angles=0.4, prismatic=0.35), Point(point))
    motion = state.motion()
    assert formulation(state.arm, motion, unmarked) == newton_euler(state.arm, motion)


@both
@pytest.mark.parametrize("name", ["puma560", "stanford", "ur5", "tx40"])
def test_programs_mean_what_the_kernel_means(name: str, formulation: Formulation) -> None:
    robot = bundled(name)
    options = Options(formulation=formulation.__name__)
    found, kernel = program(robot, "inverse_dynamics", options), program(robot, "inverse_dynamics")
    assert fingerprint(found, 5, circle_point) == fingerprint(kernel, 5, circle_point)


@both
def test_every_named_value_is_the_quantity_of_that_name(formulation: Formulation) -> None:
    state = State(bundled("stanford"), Point(4))
    recorder = Recorder()
    formulation(state.arm, state.motion(), recorder.mark)
    made = program(state.robot, "inverse_dynamics", Options(formulation=formulation.__name__))
    seen = set()
    for (_, _, label), value in zip(made.operations, every_value(made, state.at), strict=True):
        if label is not None and label.quantity not in ("c", "s"):
            known = recorder.values[label._replace(negative=False)]
            assert (-value if label.negative else value) in known, str(label)
            seen.add(label.quantity)
    own = {"fb", "nb", "ncb"} if formulation is newton_euler_base else {"f", "n", "nc"}
    assert seen >= own | {"E", "wb", "ab", "tau"}


# --- that each is what it is called -------------------------------------------------------------------------


@pytest.mark.parametrize("robot", ARMS, ids=lambda robot: robot.name)
def test_motion_in_the_base_is_that_of_the_links_turned(robot: Robot) -> None:
    """Velocities and accelerations of the recursion in link frames, each turned into the base."""
    state = State(robot, Point(6))
    recorder = Recorder()
    newton_euler(state.arm, state.motion(), recorder.mark)

    def in_link(link: int, quantity: str) -> tuple[Any, Any, Any]:
        x, y, z = (recorder.values[Label(link, quantity, axis)][0] for axis in "xyz")
        return x, y, z

    for i, at in enumerate(motion_in_base(state.arm, state.motion(), unmarked), 1):
        assert product(at.E, transposed(at.E)) == IDENTITY_3
        for found, quantity in ((at.w, "w"), (at.alpha, "alpha"), (at.a, "a")):
            assert found == turned(at.E, in_link(i, quantity)), (i, quantity)


def test_orins_forces_are_along_the_links() -> None:
    """His forces and moments are those of the recursion in link frames, component by component."""
    state = State(ARMS[4], Point(6))
    book, mixed = Recorder(), Recorder()
    newton_euler(state.arm, state.motion(), book.mark)
    orin(state.arm, state.motion(), mixed.mark)
    for label, values in book.values.items():
        if label.quantity in ("fc", "nc", "f", "n", "w", "alpha", "a", "ac"):
            assert mixed.values[label] == values, str(label)


def test_an_inertia_turned_keeps_its_meaning() -> None:
    """``E I E^T`` takes ``E u`` to ``E I u``."""
    state = State(ARMS[4], Point(9))
    for at, body in zip(motion_in_base(state.arm, state.motion(), unmarked), state.arm.bodies, strict=True):
        for u in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (2, -3, 5)):
            assert inertia_in_base(at.E, body.inertia).times(turned(at.E, u)) == turned(
                at.E, body.inertia.times(u)
            )


@both
def test_torques_are_those_of_virtual_work(formulation: Formulation) -> None:
    """The oracle shares no equation with the recursions."""
    from fractions import Fraction

    from robodyn.ir import Input
    from robodyn.ir.evaluate import evaluate_exact

    robot = ARMS[3]
    state = State(robot, Point(2))
    q = [Fraction(k, 7) for k in range(1, robot.n + 1)]
    numbers = state.numbers() | {Input("q", i): x for i, x in enumerate(q)}
    points = {Input("q", i): circle_point(x) for i, x in enumerate(q)}
    made = program(robot, "inverse_dynamics", Options(formulation=formulation.__name__))
    found = evaluate_exact(made, numbers, points, circle_point)["tau"]
    expected = exact_torque(robot, q, state.given["qd"], state.given["qdd"])
    largest = max(map(abs, expected))
    assert all(abs(x - y) < Fraction(1, 10**24) * largest for x, y in zip(found, expected, strict=True))


# --- what they cost ---------------------------------------------------------------------------------------


def test_link_frames_save_what_turning_takes() -> None:
    """For any arm: the base's frame costs most, mixed frames less, link frames least; all linear in n."""

    def totals(formulation: Formulation) -> list[int]:
        return [general_count(formulation, n, dense=True).total for n in (3, 4, 5, 6)]

    base, mixed, link = totals(newton_euler_base), totals(orin), totals(newton_euler)
    assert base[-1] > mixed[-1] > link[-1]
    for costs in (base, mixed, link):
        assert len(set(np.diff(costs).tolist())) == 1


# --- that slips are noticed ---------------------------------------------------------------------------------


@pytest.mark.parametrize("slip", ["inertia", "turned", "origin"])
def test_a_slip_is_noticed(slip: str, monkeypatch: pytest.MonkeyPatch) -> None:
    formulation: Formulation = orin if slip == "origin" else newton_euler_base
    if slip == "inertia":  # not turned: what a link's frame has in the base's
        monkeypatch.setattr(base_module, "inertia_in_base", lambda E, inertia: inertia)
    elif slip == "turned":
        monkeypatch.setattr(base_module, "turned", lambda E, u: turned(transposed(E), u))
    else:
        monkeypatch.setattr(orin_module, "origin", lambda body, d: (body.a, body.sin_alpha * d, d))
    state = State(bundled("puma560"), Point(2))
    assert formulation(state.arm, state.motion(), unmarked) != newton_euler(state.arm, state.motion())
