"""Solutions as a list: those that exist in front, in the order of the branches, and their flags."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path

import numpy as np
import pytest

import robodyn
from emit.kernels import STRICT, write
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn_testing import require_tool

NAMES = ("forward_kinematics", "inverse_kinematics")
OPTIONS = Options(functions=NAMES, trig="builtin")


@pytest.mark.parametrize("name", [pytest.param("ur5", marks=pytest.mark.thorough), "panda"])
def test_solutions_that_exist_stand_in_front(name: str, tmp_path: Path) -> None:
    robot = load(name, warn=lambda _: None)
    write(tmp_path, generate(robot, OPTIONS).files(("c",)))
    command = [require_tool("gcc"), *STRICT, "-O1", "-shared", "-fPIC", f"{name}.c", "-o", "kernel.so", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    listed = getattr(ctypes.CDLL(str(tmp_path / "kernel.so")), f"{name}_inverse_kinematics")
    kernel = robodyn.compile(name, functions=NAMES)
    redundant = robot.n > 6
    random, lengths = np.random.default_rng(1), set()
    for k in range(40):
        q = random.uniform(-2.5, 2.5, robot.n)
        T = np.array(kernel.forward_kinematics(q))
        T[:, 3] *= 1.0 if k % 2 else 1.4
        near = q if redundant else np.zeros(robot.n)
        expected = kernel.inverse_kinematics(T, near)
        Q, flags = np.full((8, robot.n), np.nan), np.full(8, -1, np.intc)
        arrays = [T, near, Q, flags] if redundant else [T, Q, flags]
        count = listed(*(a.ctypes.data_as(ctypes.c_void_p) for a in arrays))
        lengths.add(count)
        exists = expected.exists > 0
        order = np.concatenate([np.flatnonzero(exists), np.flatnonzero(~exists)])
        assert count == exists.sum()
        np.testing.assert_array_equal(flags >> 3, order)
        bits = exists + 2 * (expected.within > 0) + 4 * (expected.singular > 0)
        np.testing.assert_array_equal(flags & 7, bits[order])
        np.testing.assert_allclose(Q, expected.solutions[order], atol=1e-6)
    assert len(lengths) > 2
