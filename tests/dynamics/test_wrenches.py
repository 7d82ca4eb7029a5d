"""A wrench on the tool: as Pinocchio has external forces, through drives, by the command line."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from robodyn import InputError, Options, compile, load, program
from robodyn.counts import count
from robodyn.dynamics.functions import function_named
from robodyn.firmware.options import firmware_options
from robodyn.ir import Input
from robodyn.ir.evaluate import evaluate
from robodyn.kernels.generate import generate
from robodyn.robot import Robot, read_text
from robodyn_cli.main import main
from robodyn_testing import require_module, sampled
from robodyn_testing.random_robots import random_robot, random_states

TOOL = read_text(
    "name: tool\ntool: {xyz: [0.1, -0.2, 0.3], rpy: [0.4, -0.5, 1.1]}\nlinks: [{joint: revolute, mass: 1}]"
).tool
FUNCTIONS = (
    "wrench_torques",
    "inverse_dynamics",
    "inverse_dynamics_with_wrench",
    "forward_dynamics_with_wrench",
)


def with_tool(robot: Robot) -> Robot:
    return replace(robot, tool=TOOL)


@pytest.mark.parametrize("seed", sampled(range(40), every=20))
def test_as_pinocchio_has_external_forces(seed: int) -> None:
    pin = require_module("pinocchio")
    from peers.pinocchio_peer import pinocchio_model

    robot = with_tool(random_robot(seed))
    assert robot.tool is not None
    model = pinocchio_model(robot)
    place = np.array([float(x) for x in robot.tool.xyz])
    tool = pin.SE3(np.array(robot.tool.rotation, float), place)
    data = model.createData()
    made = [program(robot, name, Options(optimize="fast")) for name in FUNCTIONS[:3]]
    for q, qd, qdd in zip(*random_states(robot, 3, 1), strict=True):
        wrench = np.random.default_rng(seed).uniform(-5, 5, 6)
        state = {"q": q, "qd": qd, "qdd": qdd, "w": wrench}
        inputs = {Input(a, i): float(x) for a, array in state.items() for i, x in enumerate(array)}
        torques, free, pushed = (
            np.array([x for row in evaluate(one, inputs, constant=float).values() for x in row], float)
            for one in made
        )
        pin.forwardKinematics(model, data, q)
        turned = pin.SE3((data.oMi[robot.n] * tool).rotation.T, np.zeros(3))
        own = tool.act(turned.act(pin.Force(wrench)))  # along the tool's axes, then the last link's
        forces = pin.StdVec_Force()
        for joint in range(robot.n + 1):
            forces.append(own if joint == robot.n else pin.Force.Zero())
        expected = pin.rnea(model, data, q, qd, qdd, forces) - pin.rnea(model, data, q, qd, qdd)
        largest = max(1.0, np.abs(free).max(), np.abs(expected).max())
        np.testing.assert_allclose(-torques, expected, atol=1e-11 * largest)
        np.testing.assert_allclose(pushed - free, expected, atol=1e-11 * largest)


def test_accelerations_undo_torques() -> None:
    robot = with_tool(load("puma560"))
    kernel = compile(robot, functions=FUNCTIONS)
    q, qd, qdd, wrench = np.random.default_rng(4).uniform(-1, 1, (4, 9, 6))
    tau = kernel.inverse_dynamics_with_wrench(q, qd, qdd, wrench)
    np.testing.assert_allclose(kernel.forward_dynamics_with_wrench(q, qd, tau, wrench), qdd, atol=1e-9)
    free = kernel.inverse_dynamics(q, qd, qdd)
    np.testing.assert_allclose(tau, free - kernel.wrench_torques(q, wrench), atol=1e-11)


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


@pytest.mark.parametrize("options", [Options(), Options(optimize="fast")], ids=["record", "fast"])
def test_a_wrench_costs_what_its_torques_cost(options: Options) -> None:
    robot = load("panda")
    alone = count(program(robot, "wrench_torques", options)).total
    for name in ("gravity", "bias", "inverse_dynamics"):
        free, pushed = (count(program(robot, f, options)).total for f in (name, f"{name}_with_wrench"))
        assert pushed <= free + alone + robot.n, name


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
