"""Calls with arrays that need no conversion are answered in C; all others by Python, as they always were."""

from __future__ import annotations

import copy
import gc
import inspect
import pickle
import sys
import threading
import tracemalloc
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import robodyn
from kernels.toys import states
from robodyn.errors import InputError
from robodyn.ir.signature import Signature
from robodyn.kernels.function import Function
from robodyn.kernels.kernel import Kernel, load

#: What is not an array that a kernel of doubles can read as it stands, made of one.
OTHER: dict[str, Callable[[Any], Any]] = {
    "a list": lambda x: x.tolist(),
    "floats": lambda x: x.astype(np.float32),
    "integers": lambda x: x.astype(np.int64),
    "the other byte order": lambda x: x.astype(">f8"),
    "every other number": lambda x: np.repeat(x, 2)[::2],
    "backwards": lambda x: x[::-1].copy()[::-1],
    "out of line": lambda x: np.frombuffer(b"\0" + x.tobytes(), np.uint8)[1:].view(np.float64),
    "of a class of its own": lambda x: x.view(np.recarray),
    "many states": lambda x: np.array([x, 2 * x]),
}


@pytest.fixture
def slow(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of functions that Python answered, in kernels that are loaded from here on."""
    calls: list[str] = []
    plain = Function.__call__

    def noted(self: Function, *arrays: object, **named: Any) -> Any:
        calls.append(self.name)
        return plain(self, *arrays, **named)

    monkeypatch.setattr(Function, "__call__", noted)
    return calls


@pytest.mark.parametrize("scalar", ["double", "float"])
def test_one_state_in_arrays_of_the_kernels_type_is_answered_in_c(
    scalar: Any, slow: list[str], toy: Callable[..., Any]
) -> None:
    arm = toy(scalar=scalar)
    kernel, plain = (load(arm.signatures, arm.files, mode=mode) for mode in ("api", "abi"))
    given = [np.array(x, kernel.dtype) for x in states(None)]
    for name, count in (("inverse_dynamics", 3), ("gravity", 1), ("mass_matrix", 1)):
        found = getattr(kernel, name)(*given[:count])
        assert not slow
        want = getattr(plain, name)(*given[:count])
        assert slow.pop() == name
        assert (found.dtype, found.shape, found.tobytes()) == (want.dtype, want.shape, want.tobytes())
        assert found.flags.owndata
        assert found.flags.writeable
    frozen = given[0].copy()
    frozen.flags.writeable = False
    assert kernel.gravity(frozen).tobytes() == kernel.gravity(given[0]).tobytes()
    assert not slow


@pytest.mark.parametrize("what", OTHER)
def test_all_else_is_converted_by_python(what: str, slow: list[str], toy: Callable[..., Any]) -> None:
    arm = toy()
    kernel = load(arm.signatures, arm.files)
    q, qd, qdd = np.round(4 * states(None))
    other = OTHER[what](q)
    if what == "many states":
        given = [other, *(np.array([x, x]) for x in (qd, qdd))]
        want = np.array([kernel.inverse_dynamics(x, qd, qdd) for x in other])
    else:
        given, want = [other, qd, qdd], kernel.inverse_dynamics(q, qd, qdd)
    assert not slow
    np.testing.assert_array_equal(kernel.inverse_dynamics(*given), want)
    np.testing.assert_array_equal(kernel.inverse_dynamics(given[0], qd=given[1], qdd=given[2]), want)
    assert slow == ["inverse_dynamics"] * 2


@pytest.mark.parametrize(
    "call",
    [
        lambda f, q: f(),
        lambda f, q: f(q, q),
        lambda f, q: f(q, q, q, q),
        lambda f, q: f(q, q, q, qd=q),
        lambda f, q: f(q, q, q, velocity=q),
        lambda f, q: f(q[:1], q, q),
        lambda f, q: f(q, np.zeros(3), q),
        lambda f, q: f(q, q, q.reshape(2, 1)),
        lambda f, q: f(q, q, np.array(["a", "b"])),
        lambda f, q: f(q, q, q + 0j),
        lambda f, q: f(q, q, None),
        lambda f, q: f(np.ma.masked_array(q, [True, False]), q, q),
        lambda f, q: f(q, q, np.array([q, q])),
        lambda f, q: f(q, q, q, dt=0.1),
        lambda f, q: f(q, q, q, params={"m": 1.0}),
        lambda f, q: f(q, q, q, out=q),
        lambda f, q: f(q, q, q, out=np.broadcast_to(0.0, 2)),
        lambda f, q: f(q, q, q, out=np.zeros(4)[::2]),
    ],
)
def test_what_does_not_fit_is_refused_in_the_same_words(call: Any, toy: Callable[..., Any]) -> None:
    arm = toy()
    said = []
    for mode in ("api", "abi"):
        kernel = load(arm.signatures, arm.files, mode=mode)
        with pytest.raises(InputError) as refused:
            call(kernel.inverse_dynamics, np.ones(2))
        said.append(str(refused.value))
    assert said[0] == said[1]


def test_one_row_of_a_matrix_is_a_batch_as_it_is_for_python() -> None:
    """An input ``[1, 1]``, which only functions by other makers have."""
    header = "typedef double one_real;\nvoid one_twice(const one_real M[1], one_real tau[1]);\n"
    source = '#include "one.h"\nvoid one_twice(const one_real M[1], one_real tau[1]) { tau[0] = 2 * M[0]; }\n'
    signature = Signature("one", "twice", (("M", 1),), (("tau", 1),))
    for mode in ("api", "abi"):
        kernel = load([signature], {"one.h": header, "one.c": source}, mode=mode)
        assert kernel.twice(np.ones(1)).tolist() == [2.0]
        assert kernel.twice(np.ones((1, 1))).tolist() == [[2.0]]


def test_out_is_written_to(kernel: Kernel) -> None:
    q, out = states(None)[0], np.zeros(2)
    assert kernel.gravity(q, out=out) is out
    np.testing.assert_array_equal(out, kernel.gravity(q))


def test_nothing_leaks(kernel: Kernel) -> None:
    given = tuple(states(None))
    shared = (*given, kernel.inverse_dynamics, np.dtype(float), np.ndarray)

    def call() -> None:
        kernel.inverse_dynamics(*given)
        kernel.inverse_dynamics(given[0][::-1], *given[1:])
        with pytest.raises(InputError):
            kernel.inverse_dynamics(*given[:2])

    def size() -> int:
        gc.collect()
        return tracemalloc.get_traced_memory()[0]

    call()
    counts = [sys.getrefcount(x) for x in shared]
    tracemalloc.start()
    try:
        for _ in range(20):
            call()
        before = size()
        for _ in range(300):
            call()
        grown = size() - before
    finally:
        tracemalloc.stop()
    assert grown < 300 * 16  # less than the smallest object a call
    more = [sys.getrefcount(x) - count for x, count in zip(shared, counts, strict=True)]
    assert max(more) < 100  # others use numpy's types meanwhile


def test_kernels_themselves_go_away(toy: Callable[..., Any]) -> None:
    arm = toy()
    calls = type(load(arm.signatures, arm.files).gravity).__mro__[1]
    for _ in range(3):
        load(arm.signatures, arm.files)
    gc.collect()
    living = sum(issubclass(type(x), calls) for x in gc.get_objects())
    assert living == 0


WAIT = """#include "pause.h"
#include <time.h>
void pause_gravity(const pause_real q[1], pause_real tau[1])
{
    const volatile pause_real *flag = q;
    const clock_t start = clock();
    while (*flag == 0 && clock() - start < 20 * CLOCKS_PER_SEC) { }
    tau[0] = *flag;
}
"""


def test_python_goes_on_meanwhile(slow: list[str]) -> None:
    """The kernel waits for a number that another thread writes: it never would if the GIL were held."""
    header = "typedef double pause_real;\nvoid pause_gravity(const pause_real q[1], pause_real tau[1]);\n"
    signature = Signature("pause", "gravity", (("q", 1),), (("tau", 1),))
    kernel = load([signature], {"pause.h": header, "pause.c": WAIT})
    q, found = np.zeros(1), []
    thread = threading.Thread(target=lambda: found.append(kernel.gravity(q)))
    thread.start()
    q[0] = 1.0
    thread.join()
    assert found[0].tolist() == [1.0]
    assert not slow


@pytest.fixture(params=["no headers of numpy", "it does not load"])
def broken(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A machine on which the C of direct calls is not to be had."""
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr("robodyn.toolchain.library._loaded", {})
    if request.param == "no headers of numpy":
        monkeypatch.setattr(np, "get_include", lambda: str(tmp_path))
    else:
        monkeypatch.setattr("robodyn.toolchain.library.DIRECT", "robodyn_other")


@pytest.mark.usefixtures("broken")
def test_without_it_python_answers(slow: list[str], toy: Callable[..., Any], expected: Any) -> None:
    arm = toy()
    kernel = load(arm.signatures, arm.files)
    given = states(None)
    assert kernel.mode == "api"
    np.testing.assert_allclose(
        kernel.inverse_dynamics(*given), expected().inverse_dynamics(*given), rtol=1e-15
    )
    assert slow == ["inverse_dynamics"]


def test_headers_of_numpy_that_come_later_are_used(
    slow: list[str], toy: Callable[..., Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    arm, given = toy(), states(None)
    with monkeypatch.context() as without:
        without.setattr(np, "get_include", lambda: str(tmp_path))
        load(arm.signatures, arm.files, cache=tmp_path / "cache").inverse_dynamics(*given)
    assert slow.pop() == "inverse_dynamics"
    monkeypatch.setattr("robodyn.toolchain.library._loaded", {})  # as in the next process
    load(arm.signatures, arm.files, cache=tmp_path / "cache").inverse_dynamics(*given)
    assert not slow


def test_run_time_parameters_are_pythons(slow: list[str], toy: Callable[..., Any]) -> None:
    arm = toy(parameters=True)
    kernel = load(arm.signatures, arm.files)
    kernel.gravity(np.ones(2), params={"inertia": 1.0, "bend": 2.0})
    with pytest.raises(InputError, match="missing: inertia, bend"):
        kernel.gravity(np.ones(2))
    assert slow == ["gravity"] * 2


def test_a_function_is_still_what_it_says(kernel: Kernel) -> None:
    gravity = kernel.gravity
    assert isinstance(gravity, Function)
    assert repr(gravity) == "<toy.gravity(q) -> tau [2]>"
    assert copy.copy(gravity)(np.ones(2)).tobytes() == gravity(np.ones(2)).tobytes()
    assert list(inspect.signature(gravity).parameters) == ["arrays", "params", "out", "state", "dt", "named"]
    with pytest.raises(TypeError, match="that of a function already"):
        gravity.of("gravity", tuple, print)  # type: ignore[attr-defined]
    empty = type(gravity).__mro__[1]()
    with pytest.raises(TypeError, match="a kind of tuple"):
        empty.of("gravity", object, print)  # results would be written past its end
    with pytest.raises(TypeError, match="comes first"):
        empty(np.ones(2))


def test_several_results_have_names(slow: list[str]) -> None:
    kernel = robodyn.compile("puma560_3dof", functions=["inverse_dynamics_derivatives"], optimize="fast")
    q, qd, qdd = np.random.default_rng(3).normal(size=(3, 3))
    found = kernel.inverse_dynamics_derivatives(q, qd, qdd)
    assert not slow
    assert found._fields == ("dtau_dq", "dtau_dqd")
    want = kernel.inverse_dynamics_derivatives(list(q), qd, qdd)
    assert type(want) is type(found)
    for one, other in zip(found, want, strict=True):
        assert one.tobytes() == other.tobytes()
    np.testing.assert_array_equal(found.dtau_dqd, found[1])
    again = pickle.loads(pickle.dumps(found))
    assert again._fields == found._fields
    assert again.dtau_dq.tobytes() == found.dtau_dq.tobytes()
