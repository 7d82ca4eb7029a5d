"""Functions with several results in Python: tuples, arrays to write to, workspaces, batches, Fortran."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import robodyn
from robodyn import Options
from robodyn.emit.parallel import schedule_files
from robodyn.errors import InputError
from robodyn.ir import graph
from robodyn.kernels import kernel as kernels
from robodyn.kernels.generate import generate
from robodyn.optimize import merging
from robodyn.robot import load
from robodyn.schedule import Machine, solve
from robodyn.schedule.cutting import cut

NAMES = ("forward_kinematics", "link_poses", "jacobian")
N = 5


@pytest.fixture(scope="module")
def kernel(tmp_path_factory: pytest.TempPathFactory) -> kernels.Kernel:
    cache = tmp_path_factory.mktemp("cache")
    return robodyn.compile("stanford_3dof", functions=NAMES, trig="builtin", mode="abi", cache=cache)


@pytest.fixture
def q() -> NDArray[np.float64]:
    return np.random.default_rng(4).uniform(-1, 1, (N, 3))


def same(one: Any, other: Any) -> bool:
    return len(one) == len(other) and all(np.array_equal(x, y) for x, y in zip(one, other, strict=True))


def test_results_are_a_tuple_each_of_its_shape(kernel: kernels.Kernel, q: NDArray[np.float64]) -> None:
    pose = kernel.forward_kinematics(q)
    assert pose.shape == (N, 3, 4)
    places, turns = kernel.link_poses(q)
    assert (places.shape, turns.shape) == ((N, 3, 3), (N, 3, 3, 3))
    assert kernel.jacobian(q).shape == (N, 6, 3)
    assert same(kernel.link_poses(q[2]), (places[2], turns[2]))
    assert np.allclose(turns @ turns.swapaxes(2, 3), np.eye(3), atol=1e-15)
    # The robot has no tool of its own.
    assert np.array_equal(np.dstack([turns[:, -1], places[:, -1, :, None]]), pose)
    assert "link_positions: [3, 3] or [N, 3, 3], double; origins of the links in the world, m" in str(
        kernel.link_poses.__doc__
    )


def test_they_are_written_to_arrays(kernel: kernels.Kernel, q: NDArray[np.float64]) -> None:
    out = np.empty((N, 3, 3)), np.empty((N, 3, 3, 3))
    returned = kernel.link_poses(q, out=out)
    assert returned[0] is out[0]
    assert returned[1] is out[1]
    assert same(out, kernel.link_poses(q))
    with pytest.raises(InputError, match=r"link_rotations.*\[5, 3, 3\]"):
        kernel.link_poses(q, out=(out[0], out[0]))
    with pytest.raises(InputError, match="out does not fit; expected 2 arrays: link_positions"):
        kernel.link_poses(q, out=out[0])
    with pytest.raises(InputError, match="found memory that link_positions lies in"):
        kernel.link_poses(q, out=(out[1].reshape(-1)[: N * 9].reshape(N, 3, 3), out[1]))


def test_batches_write_to_arrays_of_one_order(kernel: kernels.Kernel, q: NDArray[np.float64]) -> None:
    expected = kernel.link_poses(q)
    last = np.moveaxis(np.empty((3, 3, N)), -1, 0), np.moveaxis(np.empty((3, 3, 3, N)), -1, 0)
    for columns in (q, np.asfortranarray(q)):
        assert same(kernel.batch(columns, function="link_poses"), expected)
        assert same(kernel.batch(columns, function="link_poses", out=last), expected)
        last[1][:] = np.nan
    with pytest.raises(InputError, match="one order for all"):
        kernel.batch(q, function="link_poses", out=(last[0], np.empty((N, 3, 3, 3))))


def test_a_schedule_refuses_several_results() -> None:
    ((interface, program),) = generate(load("stanford_3dof"), Options(("link_poses",))).unit.functions
    tasks = cut(program, 3)
    timetable = solve(tasks.graph, Machine(2), "critical-path").timetable
    with pytest.raises(
        InputError, match="has several results, and is not emitted in parallel; found link_positions, "
    ):
        schedule_files(load("stanford_3dof"), interface, tasks, timetable)


# Functions that are too large for any compiler are refused before they take all memory.


@pytest.fixture
def small_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """More than the torques of three joints take, and less than their derivatives."""
    for module in (graph, merging):
        monkeypatch.setattr(module, "MOST_POSITIONS", 400)


@pytest.mark.usefixtures("small_limit")
def test_a_function_that_is_too_large_is_refused_by_its_name() -> None:
    with pytest.raises(InputError) as refused:
        generate(load("puma560_3dof"), Options(("inverse_dynamics", "forward_dynamics_derivatives")))
    assert "forward_dynamics_derivatives" in refused.value.what
    assert (refused.value.found or "").startswith("3 joints, more than ")
    assert refused.value.remedy


@pytest.mark.usefixtures("small_limit")
def test_of_all_functions_those_that_are_too_large_are_left_out() -> None:
    generated = generate(load("puma560_3dof"), Options(("all",), optimize="fast"))
    assert "inverse_dynamics" in generated.counts
    assert "3 joints" in generated.left_out["forward_dynamics_derivatives"]
