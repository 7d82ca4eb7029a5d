"""Force and moment in every joint, and a wrench on the tool: Pinocchio's, by hand, through drives."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import robodyn
from robodyn import InputError, Options, compile, load, program
from robodyn.dynamics.functions import function_named
from robodyn.firmware.options import firmware_options
from robodyn.ir import Input
from robodyn.ir.evaluate import evaluate
from robodyn.kernels.generate import generate
from robodyn.robot import Robot, read_text
from robodyn.verify import Reference
from robodyn_cli.main import main
from robodyn_testing import require_module, sampled
from robodyn_testing.random_robots import random_robot, random_states

TOOL = read_text(
    "name: tool\ntool: {xyz: [0.1, -0.2, 0.3], rpy: [0.4, -0.5, 1.1]}\nlinks: [{joint: revolute, mass: 1}]"
).tool
PUSHED, WITH = "joint_reactions_with_wrench", "inverse_dynamics_with_wrench"
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
FUNCTIONS = (
    "wrench_torques",
    "inverse_dynamics",
    "inverse_dynamics_with_wrench",
    "forward_dynamics_with_wrench",
)


def with_tool(robot: Robot) -> Robot:
    return replace(robot, tool=TOOL)


def results(robot: Robot, name: str, **at: Any) -> Any:
    """``[n, 6]`` or ``[n, 1]`` at one state."""
    inputs = {Input(array, i): float(x) for array, xs in at.items() for i, x in enumerate(xs)}
    made = program(robot, name, Options((name,), optimize="fast"))
    (row,) = evaluate(made, inputs, constant=float).values()
    return np.reshape(np.array(row, float), (robot.n, -1))


@pytest.mark.parametrize("seed", sampled(range(40), every=10, rest="slow"))
def test_as_pinocchio_has_external_forces(seed: int) -> None:
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
        at = {"q": q, "qd": qd, "qdd": qdd}
        torques = []
        for name, push in (("joint_reactions", np.zeros(6)), (PUSHED, wrench)):
            own = tool.act(turned.act(pin.Force(push)))  # along the tool's axes, then the last link's
            forces = pin.StdVec_Force()
            for joint in range(robot.n + 1):
                forces.append(own if joint == robot.n else pin.Force.Zero())
            torques.append(np.array(pin.rnea(model, data, q, qd, qdd, forces)))
            expected = np.array([data.f[i + 1].vector for i in range(robot.n)])
            largest = max(1.0, np.abs(expected).max())
            ours = results(robot, name, **at, **({"w": push} if name == PUSHED else {}))
            np.testing.assert_allclose(ours.reshape(robot.n, 6), expected, atol=1e-11 * largest)
        free, pushed = results(robot, "inverse_dynamics", **at), results(robot, WITH, **at, w=wrench)
        largest = max(1.0, np.abs(free).max(), np.abs(torques).max())
        gained = torques[1] - torques[0]
        np.testing.assert_allclose((pushed - free).ravel(), gained, atol=1e-11 * largest)
        ours = results(robot, "wrench_torques", q=q, w=wrench).ravel()
        np.testing.assert_allclose(-ours, gained, atol=1e-11 * largest)


def test_a_pendulum_by_hand() -> None:
    """A mass of 2 kg, 0.5 m along x and 0.1 m along the axis, which lies level: 30 degrees up, 2 rad/s and
    3 rad/s^2. Rotor and friction turn between link and motor."""
    up, g, m, r = np.pi / 6, 9.81, 2.0, 0.5
    along = m * (-r * 2.0**2 + g * np.sin(up))
    across = m * (r * 3.0 + g * np.cos(up))
    expected = [along, across, 0, -0.1 * across, 0.1 * along, r * across]
    robot = read_text(PENDULUM)
    np.testing.assert_allclose(
        results(robot, "joint_reactions", q=[up], qd=[2.0], qdd=[3.0])[0], expected, atol=1e-12
    )
    pushed = results(robot, PUSHED, q=[up], qd=[2.0], qdd=[3.0], w=[0, 0, 5.0, 0, 7.0, 0])
    lifted = np.array([5 * np.sin(up), 5 * np.cos(up), 0, 0, 0, -7.0])  # the world's y is the axis backwards
    np.testing.assert_allclose(pushed[0], expected - lifted, atol=1e-12)


def test_the_torque_is_along_the_joint_and_drives_add_the_rest() -> None:
    """Motors and springs pass through joints, so that nothing of them changes what passes in all."""
    q, qd, qdd = np.random.default_rng(3).uniform(-1, 1, (3, 6))
    robot = robodyn.load("stanford", warn=lambda _: None)
    rows = results(robot, "joint_reactions", q=q, qd=qd, qdd=qdd)
    along = [
        row[5 if link.joint.kind == "revolute" else 2] for row, link in zip(rows, robot.links, strict=True)
    ]
    behind = Reference(replace(robot, torque_side="link")).inverse_dynamics(q, qd, qdd)
    np.testing.assert_allclose(along, behind, rtol=0, atol=1e-12 * np.abs(behind).max())
    springs = "{effect: spring, stiffness: 40}, {effect: joint_elasticity, stiffness: 900}"
    text = f"    effects: [{springs}]\n"
    bare = results(read_text(PENDULUM), "joint_reactions", q=[0.4], qd=[2.0], qdd=[3.0])
    assert (
        results(read_text(PENDULUM + text), "joint_reactions", q=[0.4], qd=[2.0], qdd=[3.0]) == bare
    ).all()


def test_the_command_line_takes_the_functions_with_a_wrench(capsys: pytest.CaptureFixture[str]) -> None:
    flops = ["flops", "puma560_3dof", "--wrench"]
    assert main([*flops, "--functions", "bias,mass_matrix", "--json"]) == 0
    counted = json.loads(capsys.readouterr().out)
    assert [row["function"] for row in counted] == ["bias_with_wrench", "mass_matrix"]
    assert main([*flops, "--functions", "gravity", "--fuse", "bias,mass_matrix"]) == 0
    assert "bias_with_wrench_and_mass_matrix" in capsys.readouterr().out


def test_drives_that_remember_are_in_their_steady_form() -> None:
    """Their step is the inverse dynamics' own: with a wrench they are as they are at rest in their states."""
    text = """
name: remembering
links:
  - {joint: revolute, mass: 2, com: [0.1, 0, 0.1], motor_inertia: 0.1, effects: [
      {effect: presliding_hysteresis, level: 1.0, stiffness: 100.0}]}
  - {joint: revolute, alpha: pi/2, a: 0.3, mass: 2, com: [0.1, 0, 0.1]}
"""
    kernel = compile(read_text(text), functions=FUNCTIONS[:3])
    random = np.random.default_rng(2)
    q, qd, qdd, w = (random.uniform(-1, 1, (4, size)) for size in (2, 2, 2, 6))
    free = kernel.inverse_dynamics_with_wrench(q, qd, qdd, 0 * w)
    pushed = kernel.inverse_dynamics_with_wrench(q, qd, qdd, w)
    np.testing.assert_allclose(free - pushed, kernel.wrench_torques(q, w), atol=1e-12)


def test_in_c_they_are_called_like_those_without() -> None:
    alone = generate(load("puma560_3dof"), Options(("inverse_dynamics_with_wrench",), optimize="fast"))
    header = " ".join(alone.files(["c"])["puma560_3dof.h"].split()).replace("puma560_3dof_real", "real")
    arguments = "q[3], qd[3], qdd[3], w[6]".replace(", ", ", const real ")
    assert f"inverse_dynamics( const real {arguments}, real tau[3]);" in header
    both = generate(
        load("puma560_3dof"), Options(("inverse_dynamics", "inverse_dynamics_with_wrench"), optimize="fast")
    )
    assert "puma560_3dof_inverse_dynamics_with_wrench(" in both.files(["c"])["puma560_3dof.h"]


def test_firmware_has_no_limits_of_a_wrench() -> None:
    with pytest.raises(InputError, match="no firmware tests bias_with_wrench; found its input w,"):
        firmware_options(Options(("bias_with_wrench",)), ("cortex-m4f",))
    everything = firmware_options(Options(("all",)), ("cortex-m4f",)).function_names
    assert "gravity" in everything
    assert not [name for name in everything if "w" in function_named(name).input_names]
