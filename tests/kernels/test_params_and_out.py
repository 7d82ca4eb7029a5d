"""Run-time parameters, and arrays to write to."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from kernels.toys import PARAMS, states
from robodyn.errors import InputError
from robodyn.kernels.kernel import Kernel


def test_params(tunable: Kernel) -> None:
    q, qd, qdd = states(None)
    tau = tunable.inverse_dynamics(q, qd, qdd, params=PARAMS)
    backwards = dict(reversed(PARAMS.items()))
    np.testing.assert_array_equal(tunable.inverse_dynamics(q, qd, qdd, params=backwards), tau)
    exact: dict[str, Any] = {"inertia": Fraction(1, 2), "bend": np.float32(-1.5)}
    np.testing.assert_array_equal(tunable.inverse_dynamics(q, qd, qdd, params=exact), tau)
    unknown = tunable.gravity(q, params={"inertia": 1, "bend": float("nan")})
    assert np.isnan(unknown).all()
    assert np.isinf(tunable.gravity([1.0, 1.0], params={"inertia": 1, "bend": 10**400})).all()


@pytest.mark.parametrize(
    ("params", "message"),
    [
        (None, "missing: inertia, bend; expected numbers for inertia, bend"),
        ({}, "missing: inertia, bend"),
        ({"inertia": 1.0}, "missing: bend"),
        ({"inertia": 1.0, "bend": 1.0, "Bend": 2.0}, "unknown: Bend"),
        ({"inertia": 1.0, "bnd": 1.0}, "missing: bend; unknown: bnd"),
        ({"inertia": "1", "bend": 1.0}, "parameter inertia is not a number; found '1'"),
        ({"inertia": True, "bend": 1.0}, "parameter inertia is not a number; found True"),
        ({"inertia": None, "bend": 1.0}, "found None"),
        ({"inertia": 1j, "bend": 1.0}, "found 1j"),
        ([1.0, 2.0], "params is not a mapping; found list"),
    ],
    ids=repr,
)
def test_params_that_do_not_fit(params: Any, message: str, tunable: Kernel) -> None:
    with pytest.raises(InputError, match=message):
        tunable.gravity([0.0, 0.0], params=params)


def test_params_of_a_kernel_that_has_none(kernel: Kernel) -> None:
    assert kernel.gravity([0.0, 0.0], params={}).tolist() == [0.0, 0.0]
    with pytest.raises(InputError, match="unknown: mass; expected none: there are no run-time parameters"):
        kernel.gravity([0.0, 0.0], params={"mass": 1.0})


def test_out(kernel: Kernel) -> None:
    q, qd, qdd = states(5)
    out = np.full((5, 2), 7.0)
    assert kernel.inverse_dynamics(q, qd, qdd, out=out) is out
    np.testing.assert_array_equal(out, kernel.inverse_dynamics(q, qd, qdd))
    matrix = np.empty((2, 2))
    assert kernel.mass_matrix(q[0], out=matrix) is matrix
    neighbour = np.zeros(4)
    kernel.gravity(neighbour[:2], out=neighbour[2:])


@pytest.mark.parametrize(
    ("out", "message"),
    [
        (np.empty(4), r"found float64 \[4\]; expected float64 \[2, 2\], contiguous and writable"),
        (np.empty((2, 2), np.float32), r"found float32 \[2, 2\]"),
        (np.empty((2, 2), ">f8"), r"found >f8 \[2, 2\]"),
        (np.empty((2, 4))[:, ::2], "found an array with gaps"),
        (np.empty((2, 2), order="F"), "found an array with gaps"),
        (np.broadcast_to(np.zeros(2), (2, 2)), "found an array with gaps"),
        (np.frombuffer(b"\0" * 32).reshape(2, 2), "found a read-only array"),
        ([[0.0, 0.0], [0.0, 0.0]], "found list"),
        (bytearray(32), "found bytearray"),
    ],
    ids=["shape", "type", "order of bytes", "slice", "fortran", "broadcast", "read-only", "list", "bytes"],
)
def test_out_that_does_not_fit(out: Any, message: str, kernel: Kernel) -> None:
    with pytest.raises(InputError, match=message):
        kernel.mass_matrix([1.0, 2.0], out=out)


def test_out_must_not_lie_in_an_input(kernel: Kernel) -> None:
    memory = np.zeros(8)
    q, qd, qdd = memory[:2], memory[2:4], memory[4:6]
    for out, name in ((q, "q"), (memory[3:5], "qd")):
        with pytest.raises(InputError, match=f"found memory that {name} lies in"):
            kernel.inverse_dynamics(q, qd, qdd, out=out)
    strided = memory[::4]
    with pytest.raises(InputError, match="found memory that q lies in"):
        kernel.gravity(strided, out=memory[4:6])
    kernel.gravity(strided, out=memory[5:7])
