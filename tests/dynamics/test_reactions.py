"""Force and moment in every joint: Pinocchio's, by hand, and what drives and wrenches make of them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import robodyn
from dynamics.test_wrenches import with_tool
from robodyn import Options, program
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.ir import Input
from robodyn.ir.evaluate import evaluate
from robodyn.robot import Robot, read_text
from robodyn.verify import Reference
from robodyn.verify.free_bodies import joint_reactions
from robodyn_testing import require_module, sampled
from robodyn_testing.random_robots import random_robot, random_states

PUSHED = "joint_reactions_with_wrench"

PENDULUM = """\
name: pendulum
gravity: [0, 0, -9.81]
links:
  - joint: revolute
    alpha: pi/2
    mass: 2
    com: [0.5, 0, 0.1]
    motor_inertia: 7
    friction: {viscous: 3, coulomb: 4}
"""


def reactions(robot: Robot, name: str = "joint_reactions", **at: Any) -> Any:
    """``[n, 6]`` at one state."""
    inputs = {Input(array, i): float(x) for array, xs in at.items() for i, x in enumerate(xs)}
    (row,) = evaluate(program(robot, name, Options((name,))), inputs, constant=float).values()
    return np.reshape(np.array(row, float), (robot.n, 6))


@pytest.mark.parametrize("seed", sampled(range(40), every=20))
def test_they_are_pinocchios(seed: int) -> None:
    pin = require_module("pinocchio")
    from peers.pinocchio_peer import pinocchio_model

    robot = with_tool(random_robot(seed))
    assert robot.tool is not None
    model = pinocchio_model(robot)
    model.armature = np.zeros(robot.n)
    place = np.array([float(x) for x in robot.tool.xyz])
    tool = pin.SE3(np.array(robot.tool.rotation, float), place)
    data = model.createData()
    for q, qd, qdd in zip(*random_states(robot, 2, 1), strict=True):
        wrench = np.random.default_rng(seed).uniform(-5, 5, 6)
        pin.forwardKinematics(model, data, q)
        turned = pin.SE3((data.oMi[robot.n] * tool).rotation.T, np.zeros(3))
        for name, push in (("joint_reactions", np.zeros(6)), (PUSHED, wrench)):
            own = tool.act(turned.act(pin.Force(push)))  # along the tool's axes, then the last link's
            forces = pin.StdVec_Force()
            for joint in range(robot.n + 1):
                forces.append(own if joint == robot.n else pin.Force.Zero())
            pin.rnea(model, data, q, qd, qdd, forces)
            expected = np.array([data.f[i + 1].vector for i in range(robot.n)])
            given = {"q": q, "qd": qd, "qdd": qdd} | ({"w": push} if name == PUSHED else {})
            largest = max(1.0, np.abs(expected).max())
            np.testing.assert_allclose(reactions(robot, name, **given), expected, atol=1e-11 * largest)


def test_a_pendulum_by_hand() -> None:
    """A mass of 2 kg, 0.5 m along x and 0.1 m along the axis, which lies level: 30 degrees up, 2 rad/s and
    3 rad/s^2. Rotor and friction turn between link and motor."""
    up, g, m, r = np.pi / 6, 9.81, 2.0, 0.5
    along = m * (-r * 2.0**2 + g * np.sin(up))
    across = m * (r * 3.0 + g * np.cos(up))
    expected = [along, across, 0, -0.1 * across, 0.1 * along, r * across]
    robot = read_text(PENDULUM)
    np.testing.assert_allclose(reactions(robot, q=[up], qd=[2.0], qdd=[3.0])[0], expected, atol=1e-12)
    pushed = reactions(robot, PUSHED, q=[up], qd=[2.0], qdd=[3.0], w=[0, 0, 5.0, 0, 7.0, 0])
    lifted = np.array([5 * np.sin(up), 5 * np.cos(up), 0, 0, 0, -7.0])  # the world's y is the axis backwards
    np.testing.assert_allclose(pushed[0], expected - lifted, atol=1e-12)


def test_the_torque_is_along_the_joint_and_drives_add_the_rest() -> None:
    """Motors and springs pass through joints, so that nothing of them changes what passes in all."""
    q, qd, qdd = np.random.default_rng(3).uniform(-1, 1, (3, 6))
    robot = robodyn.load("stanford", warn=lambda _: None)
    rows = reactions(robot, q=q, qd=qd, qdd=qdd)
    along = [
        row[5 if link.joint.kind == "revolute" else 2] for row, link in zip(rows, robot.links, strict=True)
    ]
    behind = Reference(replace(robot, torque_side="link")).inverse_dynamics(q, qd, qdd)
    np.testing.assert_allclose(along, behind, rtol=0, atol=1e-12 * np.abs(behind).max())
    springs = "{effect: spring, stiffness: 40}, {effect: joint_elasticity, stiffness: 900}"
    text = f"    effects: [{springs}]\n"
    bare = reactions(read_text(PENDULUM), q=[0.4], qd=[2.0], qdd=[3.0])
    assert (reactions(read_text(PENDULUM + text), q=[0.4], qd=[2.0], qdd=[3.0]) == bare).all()


def test_both_references_agree() -> None:
    """Recursion and free bodies of ``verify``, which share nothing, in floats and in Fractions."""
    robot = with_tool(random_robot(5, joints=4, degenerate=0.0))
    q, qd, qdd = random_states(robot, 3, 2)
    w = np.random.default_rng(5).uniform(-5, 5, (3, 6))
    recursion = Reference(robot)._rigid(q, qd, qdd, np.array([float(g) for g in robot.base_gravity]), w)
    expected = np.concatenate([recursion.f, recursion.n], axis=-1)
    for exact in (False, True):
        ours = joint_reactions(robot, q, qd, qdd, w, exact=exact).astype(float)
        np.testing.assert_allclose(ours, expected, rtol=0, atol=1e-12 * np.abs(expected).max())


@pytest.mark.parametrize("element", [0, 4])
def test_no_program_leaves_that_is_something_else(element: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """A force that is twice what it should be, and a moment."""
    right = FUNCTIONS["joint_reactions"]

    def wrong(at: Any) -> list[Any]:
        rows = list(right.outputs(at))
        rows[element] = 2 * rows[element]
        return rows

    monkeypatch.setitem(FUNCTIONS, "joint_reactions", replace(right, outputs=wrong))
    with pytest.raises(AssertionError, match="differs from plain Newton-Euler"):
        program(read_text(PENDULUM), "joint_reactions", Options(("joint_reactions",)))
