"""Inverse kinematics in Python: solutions by name, of one pose and of many."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

import robodyn
from robodyn.kernels.kernel import Kernel
from robodyn.kernels.results import NearestSolution, Solutions
from robodyn.robot import load
from robodyn.simulate.poses import PoseSolver

Q = np.random.default_rng(5).uniform(-1, 1, (7, 6))


T = PoseSolver(load("ur5")).pose(Q)


@pytest.fixture(scope="module")
def kernel() -> Kernel:
    return robodyn.compile("ur5", functions=["inverse_kinematics"])


@pytest.fixture(scope="module")
def nearest() -> Kernel:
    return robodyn.compile("ur5", functions=["nearest_inverse_kinematics"])


def test_one_pose(kernel: Kernel) -> None:
    answer = kernel.inverse_kinematics(T[0])
    assert isinstance(answer, Solutions)
    for other in (kernel.inverse_kinematics(T[0].tolist()), kernel.inverse_kinematics(T[0], np.zeros(6))):
        for one, two in zip(answer, other, strict=True):  # without a reference: as if that were zero
            assert one.tobytes() == two.tobytes()
    assert answer.solutions.shape == (8, 6)
    assert answer.exists.shape == answer.within.shape == answer.singular.shape == (8,)
    assert answer.exists.dtype == answer.within.dtype == answer.singular.dtype == np.bool_
    assert answer.solution_count.shape == ()
    assert answer.solution_count.dtype == np.int64
    reached = answer.reached
    assert isinstance(reached, np.ndarray)
    assert len(reached) == answer.solution_count == answer.exists.sum() >= 2
    assert min(np.abs(row - Q[0]).max() for row in reached) < 1e-9
    poses = PoseSolver(load("ur5")).pose(reached)
    np.testing.assert_allclose(poses, np.broadcast_to(T[0], poses.shape), atol=1e-14)
    assert np.array_equal(answer.allowed, reached)


def test_many_poses(kernel: Kernel) -> None:
    answer = kernel.inverse_kinematics(T, Q[0])
    assert answer.solutions.shape == (7, 8, 6)
    assert [len(rows) for rows in answer.reached] == answer.solution_count.tolist()
    assert kernel.inverse_kinematics(T).solutions.shape == (7, 8, 6)


def test_in_arrays_of_the_callers_flags_are_numbers(kernel: Kernel) -> None:
    answer = kernel.inverse_kinematics(T[0])
    out = [np.empty(x.shape) for x in answer]
    same: Any = kernel.inverse_kinematics(T[0], out=out)
    assert same.exists is out[1]
    for one, two in zip(answer, same, strict=True):
        np.testing.assert_array_equal(one, two)
    for name in ("reached", "allowed"):
        np.testing.assert_array_equal(getattr(same, name), getattr(answer, name))
    assert type(pickle.loads(pickle.dumps(answer))) is Solutions


def test_a_pose_that_is_no_number_has_no_solution(kernel: Kernel) -> None:
    """By the kernel's own call and through Python, of one pose and of many: NaN is not true."""
    one, three = T[0] * np.nan, T[:3] * np.nan
    answers: list[Any] = [kernel.inverse_kinematics(x) for x in (one, one.tolist(), three)]
    answers.append(kernel.batch(three, function="inverse_kinematics"))
    for answer in answers:
        assert not answer.exists.any()
        assert not answer.solution_count.any()


@pytest.mark.thorough
def test_the_nearest(kernel: Kernel, nearest: Kernel) -> None:
    answer = nearest.nearest_inverse_kinematics(T, Q + 0.01)
    assert isinstance(answer, NearestSolution)
    np.testing.assert_allclose(answer.solution, Q, atol=1e-9)
    every = kernel.inverse_kinematics(T, Q)
    rows = every.solutions[np.arange(7), answer.branch]
    np.testing.assert_allclose(rows, Q, atol=1e-9)


@pytest.mark.thorough
def test_a_workspace(nearest: Kernel) -> None:
    work = nearest.workspace("nearest_inverse_kinematics")
    work.T[:] = T[1]
    work.q_near[:] = Q[1]
    work()
    np.testing.assert_allclose(work.solution, Q[1], atol=1e-9)
    assert work.solution_exists == 1
