"""Workspaces for control loops, and threads."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

from kernels.toys import PARAMS
from robodyn.errors import InputError
from robodyn.kernels.kernel import Kernel, load


@pytest.fixture(params=["api", "abi"])
def mode(request: pytest.FixtureRequest) -> Any:
    return request.param


def build(toy: Callable[..., Any], mode: Any, **options: Any) -> Kernel:
    arm = toy(**options)
    return load(arm.signatures, arm.files, mode=mode)


@pytest.mark.parametrize("scalar", ["double", "float"])
def test_a_workspace_computes_what_the_kernel_does(mode: Any, scalar: Any, toy: Callable[..., Any]) -> None:
    kernel = build(toy, mode, scalar=scalar)
    ws = kernel.workspace()
    tau = ws.tau
    for q, qd, qdd in np.random.default_rng(0).normal(size=(20, 3, 2)).astype(kernel.dtype):
        ws.q[:], ws.qd[:], ws.qdd[:] = q, qd, qdd
        assert ws() is None
        assert tau.tobytes() == kernel.inverse_dynamics(q, qd, qdd).tobytes()
    assert ws.q.dtype == kernel.dtype
    assert ws.q.ctypes.data % 64 == 0


def test_parameters(mode: Any, toy: Callable[..., Any]) -> None:
    kernel = build(toy, mode, parameters=True)
    q = np.array([1.0, 2.0])
    ws = kernel.workspace("gravity", PARAMS)
    ws.q[:] = q
    ws()
    np.testing.assert_array_equal(ws.tau, kernel.gravity(q, params=PARAMS))
    ws.params["bend"] = 4.0
    ws()
    np.testing.assert_array_equal(ws.tau, kernel.gravity(q, params={**PARAMS, "bend": 4.0}))
    ws.params = {"bend": 1.0, "inertia": 2.0}
    ws()
    np.testing.assert_array_equal(ws.tau, kernel.gravity(q, params={"inertia": 2.0, "bend": 1.0}))
    assert (float(ws.params["inertia"]), float(ws.params["bend"])) == (2.0, 1.0)
    with pytest.raises(InputError, match="missing: inertia"):
        ws.params = {"bend": 1.0}
    with pytest.raises(InputError, match="unknown: bent"):
        kernel.workspace("gravity", {**PARAMS, "bent": 1.0})


def test_what_was_not_set_is_not_taken_for_a_number(mode: Any, toy: Callable[..., Any]) -> None:
    ws = build(toy, mode, parameters=True).workspace("gravity")
    assert np.isnan(ws.tau).all()
    ws.q = 1.0
    ws()
    assert np.isnan(ws.tau).all()
    with pytest.raises(InputError, match="unknown: bend"):
        build(toy, mode).workspace("gravity", {"bend": 1.0})


def test_arrays_cannot_be_lost(toy: Callable[..., Any]) -> None:
    kernel = build(toy, "auto")
    ws = kernel.workspace()
    bound = ws.q
    ws.q = np.array([1.0, 2.0])
    ws.q += 1.0
    assert ws.q is bound
    assert bound.tolist() == [2.0, 3.0]
    with pytest.raises(ValueError, match="broadcast"):
        ws.q = [1.0, 2.0, 3.0]
    with pytest.raises(AttributeError, match="no 'speed'; it has q, qd, qdd, tau"):
        ws.speed = 1.0
    with pytest.raises(AttributeError, match="no 'M'; it has q, qd, qdd, tau"):
        _ = ws.M
    with pytest.raises(TypeError, match="make another"):
        pickle.dumps(ws)
    with pytest.raises(InputError, match="no function 'levity'; expected inverse_dynamics or gravity"):
        kernel.workspace("levity")
    assert repr(ws) == "<Workspace of toy.inverse_dynamics: q, qd, qdd, tau>"


def test_threads_share_a_kernel(mode: Any, toy: Callable[..., Any]) -> None:
    kernel = build(toy, mode)
    rng = np.random.default_rng(0)
    jobs = [rng.normal(size=(3, 2000, 2)) for _ in range(8)]
    want = [kernel.inverse_dynamics(*job) for job in jobs]

    def work(job: Any) -> tuple[Any, Any]:
        batch = kernel.inverse_dynamics(*job)
        ws, single = kernel.workspace(), np.empty_like(batch)
        for k in range(0, len(single), 10):
            ws.q[:], ws.qd[:], ws.qdd[:] = job[0][k], job[1][k], job[2][k]
            ws()
            single[k] = ws.tau
        return batch, single[::10]

    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(work, jobs))
    for (batch, single), right in zip(found, want, strict=True):
        np.testing.assert_array_equal(batch, right)
        np.testing.assert_array_equal(single, right[::10])
