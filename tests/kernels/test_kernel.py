"""Kernels on numpy arrays: values, shapes, conversions, refusals; every way to build them."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from kernels.toys import PARAMS, states
from robodyn.errors import InputError, ToolError
from robodyn.kernels.kernel import Kernel, load
from robodyn.toolchain import library


@pytest.mark.parametrize("mode", ["api", "abi"])
@pytest.mark.parametrize("scalar", ["double", "float"])
@pytest.mark.parametrize("parameters", [False, True])
def test_values(mode: Any, scalar: Any, parameters: bool, toy: Callable[..., Any], expected: Any) -> None:
    """In C; Fortran's are compared with those of C in tests/emit/test_bits.py."""
    arm = toy(scalar=scalar, parameters=parameters)
    kernel = load(arm.signatures, arm.files, mode=mode)
    assert kernel.mode == mode
    options: dict[str, Any] = {"params": PARAMS} if parameters else {}
    want = expected(**PARAMS) if parameters else expected()
    tolerance = 1e-15 if scalar == "double" else 1e-6
    q, qd, qdd = states(7, kernel.dtype)
    tau = kernel.inverse_dynamics(q, qd, qdd, **options)
    assert tau.dtype == kernel.dtype
    np.testing.assert_allclose(tau, want.inverse_dynamics(q, qd, qdd), rtol=tolerance, atol=4 * tolerance)
    M = kernel.mass_matrix(q, **options)
    assert M.shape == (7, 2, 2)
    np.testing.assert_array_equal(M, want.mass_matrix(q))
    for k in range(7):  # one state at a time gives the same bits as a batch
        assert kernel.inverse_dynamics(q[k], qd[k], qdd[k], **options).tobytes() == tau[k].tobytes()
    assert kernel.mass_matrix(q[0], **options).shape == (2, 2)
    assert kernel.mass_matrix(q[:0], **options).shape == (0, 2, 2)


def test_what_a_kernel_says_of_itself(kernel: Kernel, tunable: Kernel) -> None:
    assert kernel.functions == ("inverse_dynamics", "gravity", "mass_matrix")
    assert (kernel.robot, kernel.scalar, kernel.language, kernel.parameters) == ("toy", "double", "c", ())
    assert tunable.parameters == ("inertia", "bend")
    assert "q: [2] or [N, 2], double; joint positions, rad or m" in str(kernel.mass_matrix.__doc__)
    assert "M: [2, 2] or [N, 2, 2]" in str(kernel.mass_matrix.__doc__)
    assert "params: run-time parameters, SI units: inertia, bend" in str(tunable.gravity.__doc__)
    assert repr(kernel.gravity) == "<toy.gravity(q) -> tau [2]>"
    assert "toy: inverse_dynamics, gravity" in repr(kernel)
    assert "gravity" in dir(kernel)
    with pytest.raises(AttributeError, match="no 'levity'; it has inverse_dynamics, gravity, mass_matrix"):
        _ = kernel.levity


def test_by_name(kernel: Kernel) -> None:
    q, qd, qdd = states(None)
    want = kernel.inverse_dynamics(q, qd, qdd)
    np.testing.assert_array_equal(kernel.inverse_dynamics(qdd=qdd, qd=qd, q=q), want)
    np.testing.assert_array_equal(kernel.inverse_dynamics(q, qdd=qdd, qd=qd), want)
    for arguments, named, message in (
        ((q,), {}, "no qd, no qdd"),
        ((q, qd, qdd, q), {}, "4 arrays"),
        ((q, qd, qdd), {"q": q}, "q twice"),
        ((q, qd), {"qqd": qdd}, "unknown qqd, no qdd"),
    ):
        with pytest.raises(InputError, match=f"arguments do not fit; found {message}; expected q, qd, qdd"):
            kernel.inverse_dynamics(*arguments, **named)


@pytest.mark.parametrize(
    "value",
    [
        [1, 2],
        (1.0, 2),
        [[1, 2]],
        [np.float32(1), 2],
        range(1, 3),
        np.array([1, 2], np.int64),
        np.array([1, 2], np.uint8),
        np.array([1, 2], np.float16),
        np.array([1, 2], np.longdouble),
        np.array([1, 2], ">f8"),
        np.array([1.0, 9.0, 2.0, 9.0])[::2],
        np.array([[1.0, 2.0], [3.0, 4.0]], order="F")[:1],
        np.array([[1.0, 2.0], [3.0, 4.0]]).T[:, ::-1][:1, ::-1].copy()[:, ::-1] * 0 + [[1.0, 2.0]],
        np.frombuffer(b"x" + np.array([1.0, 2.0]).tobytes(), np.uint8)[1:].view(np.float64),
    ],
    ids=str,
)
@pytest.mark.parametrize("scalar", ["double", "float"])
def test_real_numbers_of_any_kind_are_taken(value: Any, scalar: Any, toy: Callable[..., Any]) -> None:
    arm = toy(scalar=scalar)
    kernel = load(arm.signatures, arm.files)
    M = kernel.mass_matrix(value)
    assert M.reshape(2, 2).tolist() == [[1.0, 1.0], [2.0, 4.0]]


@pytest.mark.filterwarnings("error")
def test_a_double_beyond_single_precision_is_infinite(toy: Callable[..., Any]) -> None:
    arm = toy(scalar="float")
    assert load(arm.signatures, arm.files).mass_matrix([1e300, 1 / 3])[0, 1] == np.inf


@pytest.mark.filterwarnings("error")
def test_nan_and_infinity_pass_through(kernel: Kernel) -> None:
    tau = kernel.gravity([[np.nan, 1.0], [1.0, np.inf], [1.0, 1.0]])
    assert np.isnan(tau).tolist() == [[True, False], [False, True], [False, False]]


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (1.0, r"q has the wrong shape; found \[\]; expected \[2\] or \[N, 2\]"),
        ([1.0], r"q has the wrong shape; found \[1\]"),
        ([1.0, 2.0, 3.0], r"found \[3\]"),
        (np.zeros((2, 3)), r"found \[2, 3\]"),
        (np.zeros((1, 1, 2)), r"found \[1, 1, 2\]"),
        ([[1.0, 2.0], [3.0]], "q is not an array of numbers"),
        ([1.0, 2j], "q is not an array of real numbers; found complex numbers"),
        (["1", "2"], "found text"),
        ("12", "found text"),
        (b"12", "found bytes"),
        ([True, False], "found booleans"),
        ([None, 1.0], "found Python objects"),
        ([Fraction(1, 2), Decimal(1)], "found Python objects"),
        ([2**70, 1], "found Python objects"),
        (None, "found Python objects"),
        (np.array(["2020-01-01", "2020-01-02"], "M8[D]"), "found datetime64"),
        (np.zeros(2, [("x", float)]), "not an array of real numbers"),
        (np.ma.masked_array([1.0, 2.0], [True, False]), "q is a masked array"),
    ],
    ids=repr,
)
def test_what_is_refused(value: Any, message: str, kernel: Kernel) -> None:
    with pytest.raises(InputError, match=rf"toy\.gravity: .*{message}") as caught:
        kernel.gravity(value)
    assert caught.value.exit_code == 2


def test_states_must_agree(kernel: Kernel) -> None:
    q, qd, qdd = states(4)
    for other in (qd[0], qd[:3]):
        with pytest.raises(InputError, match=r"same number of states; found q \[4, 2\], qd \["):
            kernel.inverse_dynamics(q, other, qdd)


def test_a_kernel_can_be_sent_to_another_process(kernel: Kernel) -> None:
    other = pickle.loads(pickle.dumps(kernel))
    assert other.path == kernel.path
    np.testing.assert_array_equal(other.gravity([1.0, 2.0]), kernel.gravity([1.0, 2.0]))


def test_without_python_headers(toy: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(library, "_headers", lambda: False)
    arm = toy(name="headless")
    assert load(arm.signatures, arm.files).mode == "abi"
    with pytest.raises(ToolError, match=r"Python's headers are missing.*python3-dev"):
        load(arm.signatures, arm.files, mode="api")


def test_headers_that_do_not_compile(toy: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: Any) -> str:
        raise library._BindingError("no")

    monkeypatch.setattr(library, "_binding", refuse)
    arm = toy(name="heedless")
    assert load(arm.signatures, arm.files).mode == "abi"
    with pytest.raises(ToolError):
        load(arm.signatures, arm.files, mode="api")


def test_files_that_are_not_those_of_the_signatures(toy: Callable[..., Any]) -> None:
    arm, other = toy(), toy(name="other", scalar="float")
    with pytest.raises(InputError, match="one signature at least"):
        load([], arm.files)
    with pytest.raises(InputError, match="one robot; found other, toy"):
        load([*arm.signatures, *other.signatures], arm.files)
    with pytest.raises(InputError, match=r"twice; found inverse_dynamics, gravity, mass_matrix, gravity"):
        load([*arm.signatures, arm.signatures[1]], arm.files)
    with pytest.raises(InputError, match=r"no header; found other\.h.*expected toy\.h"):
        load(arm.signatures, other.files)
    with pytest.raises(InputError, match="no Fortran among the emitted files"):
        load(arm.signatures, {"toy.c": ""}, language="fortran")
    with pytest.raises(InputError, match=r"impossible path; found '\.\./toy\.c'"):
        load(arm.signatures, {**arm.files, "../toy.c": ""})


def test_files_in_folders(toy: Callable[..., Any]) -> None:
    arm = toy()
    files = {f"c/{path}": text for path, text in arm.files.items()}
    assert load(arm.signatures, files).gravity([0.0, 0.0]).tolist() == [0.0, 0.0]
