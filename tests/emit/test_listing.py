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
from robodyn_testing.few_joints import arm, drawn, poses

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


def test_of_an_arm_of_few_joints_a_flag_says_that_the_place_is_reached(tmp_path: Path) -> None:
    written = generate(arm("scara"), OPTIONS).files(("c",))
    write(tmp_path, written)
    assert "#define SCARA_IK_PLACED 8\n" in written["scara.h"]
    command = [require_tool("gcc"), *STRICT, "-O1", "-shared", "-fPIC", "scara.c", "-o", "kernel.so", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    listed = ctypes.CDLL(str(tmp_path / "kernel.so")).scara_inverse_kinematics
    c, s = np.cos(0.1), np.sin(0.1)
    tilted = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    for T in poses("scara", drawn("scara", 10))[:, :3]:
        for tilt, count, expected in ((np.eye(3), 2, 1 + 8), (tilted, 0, 8)):
            pose = np.column_stack([tilt @ T[:, :3], T[:, 3]])
            Q, flags = np.zeros((2, 4)), np.zeros(2, np.intc)
            arrays = (np.ascontiguousarray(pose), Q, flags)
            assert listed(*(a.ctypes.data_as(ctypes.c_void_p) for a in arrays)) == count
            assert sorted(flags // 16) == [0, 1]
            assert (flags & expected == expected).all() or not count
            assert not (flags & 1).any() or count
