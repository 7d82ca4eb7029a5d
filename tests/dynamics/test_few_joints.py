"""Arms of fewer than six joints: every branch of a pose, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.dynamics.inverse import Inverse
from robodyn.simulate.poses import PoseSolver
from robodyn_testing.few_joints import ARMS, Floats, apart, arm, drawn, least_motion, poses, searched

QUICK = ("scara", "desktop", "rail")
NAMES = [name if name in QUICK else pytest.param(name, marks=pytest.mark.thorough) for name in ARMS]
#: The least singular value of the Jacobian below which a pose counts as singular: positions are compared to
#: as much, and where branches meet they are known to the root of rounding.
_SINGULAR = 1e-6


def solved(name: str, T: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """Solutions ``[N, b, n]`` and which ``[N, b]`` are said to exist."""
    solver = PoseSolver(arm(name))
    assert isinstance(solver.solver, Inverse)
    answers = solver.solve(T[:, :3])
    rows = np.array([[x.q for x in each.solutions] for each in answers])
    return rows, np.array([[x.exists for x in each.solutions] for each in answers])


def missing(name: str, count: int) -> Floats:
    """Positions of so many poses that are among the solutions of none. Every solution closes, and no two are
    the same."""
    q = drawn(name, count)
    T = poses(name, q)
    rows, exists = solved(name, T)
    size = 1 + np.abs(T[:, :3, 3]).max()
    for branch in range(rows.shape[1]):
        here = exists[:, branch]
        missed = np.abs(poses(name, rows[here, branch]) - T[here]).max(initial=0.0)
        assert missed < 1e-12 * size
        for other in range(branch):
            both = here & exists[:, other]
            assert (apart(name, rows[both, branch], rows[both, other]) > 1e-7).all()
    among = ((apart(name, rows, q[:, None]) < 1e-6) & exists).any(axis=1)
    return q[~among]


@pytest.mark.parametrize("name", NAMES)
def test_the_positions_of_a_pose_are_among_its_solutions_which_close_and_differ(name: str) -> None:
    assert (least_motion(name, missing(name, 300)) < _SINGULAR).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", ARMS)
def test_they_are_so_in_ten_thousand_poses(name: str) -> None:
    assert (least_motion(name, missing(name, 10_000)) < _SINGULAR).all()


@pytest.mark.parametrize("name", NAMES)
def test_a_search_from_many_places_finds_nothing_else(name: str) -> None:
    T = poses(name, drawn(name, 3, seed=5))
    rows, exists = solved(name, T)
    for pose, every, there in zip(T, rows, exists, strict=True):
        found = searched(name, pose)
        assert found
        for q in found:
            assert apart(name, every[there], q).min() < 1e-5


@pytest.mark.parametrize("name", ["scara", "scara_slide_first"])
def test_a_scara_takes_place_and_angle_of_a_pose_that_is_tilted_and_says_by_how_much(name: str) -> None:
    from robodyn import compile

    kernel = compile(arm(name), functions=["inverse_kinematics"])
    T = poses(name, drawn(name, 50))
    tilt = 0.2
    c, s = np.cos(tilt), np.sin(tilt)
    T[:, :3, :3] = np.array([[1, 0, 0], [0, c, -s], [0, s, c]]) @ T[:, :3, :3]
    answer = kernel.inverse_kinematics(T)
    assert not answer.exists.any()
    assert not answer.solution_count.any()
    near = answer.placed > 0
    assert near.any(axis=1).mean() > 0.9
    for k in range(near.shape[1]):
        here = near[:, k]
        missed = np.abs(poses(name, answer.solutions[here, k])[:, :3, 3] - T[here, :3, 3]).max()
        assert missed < 1e-12
        np.testing.assert_allclose(answer.off[here, k], tilt, atol=1e-12)
