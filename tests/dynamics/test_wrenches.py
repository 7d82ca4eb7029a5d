"""A wrench on the tool: on the command line, through drives, in C and in firmware."""

from __future__ import annotations

import json

import numpy as np
import pytest

from robodyn import InputError, Options, compile, load
from robodyn.dynamics.functions import function_named
from robodyn.firmware.options import firmware_options
from robodyn.kernels.generate import generate
from robodyn.robot import read_text
from robodyn_cli.main import main

FUNCTIONS = (
    "wrench_torques",
    "inverse_dynamics",
    "inverse_dynamics_with_wrench",
    "forward_dynamics_with_wrench",
)


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
