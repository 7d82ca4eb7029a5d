"""Batches: the bits of the scalar kernel whatever the width, layouts, threads, and what is refused."""

from __future__ import annotations

import itertools
import multiprocessing
import pickle
import threading
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import robodyn
from emit.kernels import robots
from robodyn.emit.batch import STREAMED
from robodyn.errors import InputError
from robodyn.ir.signature import Signature
from robodyn.kernels.kernel import Kernel, load
from robodyn.toolchain.compiler import C_FLAGS
from robodyn_testing import covering, representative, require_machine, require_tool
from robodyn_testing.random_robots import random_states

Array = NDArray[Any]

#: Bytes of the widest vectors; 0 is the C for other compilers. A processor without AVX-512 runs 64 as 32.
WIDTHS = (0, 16, 32, 64)
#: No state, fewer than a vector has lanes, a block and one more or less, a tile and a bit, a chunk and a bit.
COUNTS = (0, 1, 3, 7, 8, 9, 16, 17, 31, 33, 70, 1027)
ROBOTS = ("puma560", "stanford_3dof", "tool", "lift", "effects_rubbing", "effects_sliding")
#: Where all functions are tried: the batch of each is compiled for itself.
EVERY = (("tool", "double"), ("stanford_3dof", "float"))
#: Widths and types, all functions of two arms, run-time parameters; in CI all arms.
QUICK = (
    ("tool", "double", 0),
    ("stanford_3dof", "float", 16),
    ("lift", "double", 64),
)
IN_CI = (
    ("puma560", "double", 0),
    ("tool", "double", 32),
    ("effects_rubbing", "float", 0),
    ("effects_sliding", "float", 32),
)
ALL = itertools.product(ROBOTS, ["double", "float"], WIDTHS)
CASES = representative(representative(ALL, *QUICK, *IN_CI, rest="slow"), *QUICK)


@cache
def kernel(name: str, scalar: str = "double", width: int | None = None, **options: Any) -> Kernel:
    """The kernel of a robot with its own sine and cosine; batches with vectors of ``width`` bytes at most."""
    flags = () if width is None else (f"-D{name.upper()}_BATCH_BYTES={width}",)
    return robodyn.compile(
        robots()[name],
        scalar=scalar,
        cc=require_tool("gcc"),
        flags=(*C_FLAGS, *flags),
        **{"mode": "abi", "trig": "builtin", **options},
    )


def states(name: str, count: int) -> dict[str, Array]:
    q, qd, qdd = random_states(robots()[name], count, 5)
    tau = np.random.default_rng(5).uniform(-50, 50, q.shape)
    return {"q": q, "qd": qd, "qdd": qdd, "tau": tau}


def parameters(name: str) -> dict[str, float] | None:
    return {parameter: 0.25 + 0.0625 * k for k, parameter in enumerate(robots()[name].parameters)} or None


def inputs(made: Kernel, function: str, given: Mapping[str, Array]) -> list[Array]:
    return [given[array].astype(made.dtype) for array, _ in made.signatures[function].inputs]


def assert_same_bits(found: Array, wanted: Array) -> None:
    """NaN for NaN, else bit for bit: a NaN's own bits depend on the order of operands."""
    assert found.dtype == wanted.dtype
    assert found.shape == wanted.shape
    nan = np.isnan(wanted)
    assert (np.isnan(found) == nan).all()
    assert np.ascontiguousarray(found)[~nan].tobytes() == np.ascontiguousarray(wanted)[~nan].tobytes()


@pytest.mark.parametrize(("name", "scalar", "width"), CASES)
def test_bits_are_those_of_the_scalar_kernel(name: str, scalar: str, width: int) -> None:
    scalars, made = kernel(name, scalar), kernel(name, scalar, width)
    for function in scalars.functions if (name, scalar) in EVERY else ("inverse_dynamics",):
        for count in COUNTS:
            given = inputs(made, function, states(name, count))
            wanted = getattr(scalars, function)(*given, params=parameters(name))
            assert count < 100 or np.isfinite(wanted).all()
            found = made.batch(*given, function=function, params=parameters(name))
            assert found.flags.c_contiguous
            assert_same_bits(found, wanted)
            turned = [np.asfortranarray(array) for array in given]
            found = made.batch(*turned, function=function, params=parameters(name))
            assert count < 2 or np.moveaxis(found, 0, -1).flags.c_contiguous
            assert_same_bits(found, wanted)


@pytest.mark.parametrize(("scalar", "width"), covering(["double", "float"], representative(WIDTHS, 64, 32)))
@pytest.mark.thorough
def test_no_number_and_huge_angles(scalar: str, width: int) -> None:
    """NaN, infinity and angles beyond the sine's range give what the scalar kernel gives, lane by lane."""
    scalars, made = kernel("puma560", scalar), kernel("puma560", scalar, width)
    limit = 411773.0 if scalar == "double" else 6433.0
    tiny, huge = np.finfo(made.dtype).smallest_subnormal, np.finfo(made.dtype).max
    odd = [0.0, -0.0, np.nan, np.inf, -np.inf, 1e3, -limit, limit, 2 * limit, 1e19, 1e38, tiny, -tiny, huge]
    rng = np.random.default_rng(3)
    given = [rng.choice([*odd, *rng.uniform(-4, 4, 60)], (701, 6)).astype(made.dtype) for _ in range(3)]
    wanted = scalars.inverse_dynamics(*given)
    assert np.isnan(wanted).any()
    assert np.isfinite(wanted).any()
    assert_same_bits(made.batch(*given), wanted)
    assert_same_bits(made.batch(*map(np.asfortranarray, given)), wanted)


@pytest.mark.parametrize("threads", [1, 2])
def test_results_that_go_past_the_caches(threads: int) -> None:
    """Of so many states that they are written so, row by row and column by column, wherever arrays begin."""
    made = kernel("puma560")
    count = threads * (STREAMED // (36 * 8) + 77)
    (q,) = inputs(made, "mass_matrix", states("puma560", count))
    wanted = made.mass_matrix(q)
    for odd in (0, 1):
        memory = np.full(count * 36 + 8 + odd, 7.0)
        begin = (-memory.ctypes.data // 8) % 8 + odd
        rows = memory[begin:][: count * 36].reshape(count, 6, 6)
        columns = memory[begin:][: count * 36].reshape(6, 6, count).transpose(2, 0, 1)
        for given, out in ((q, rows), (np.asfortranarray(q), columns)):
            out[:] = np.nan
            made.batch(given, function="mass_matrix", out=out, threads=threads)
            assert_same_bits(out, wanted)
            assert (np.delete(memory, np.s_[begin : begin + count * 36]) == 7.0).all()


def test_given_sines() -> None:
    """The batch reads ``sc``, in the layout of the kernel that holds all functions."""
    made = kernel("puma560", trig="given")
    length = dict(made.signatures["mass_matrix"].inputs)["sc"]
    sc = np.random.default_rng(0).uniform(-1, 1, (37, length))
    assert_same_bits(made.batch(sc, function="mass_matrix"), made.mass_matrix(sc))


# --- arrays -------------------------------------------------------------------------------------------------


def test_layouts_and_types() -> None:
    """Whatever can be read as [N, n] gives the same; the result has the layout of the inputs."""
    made = kernel("puma560")
    q, qd, qdd = (states("puma560", 50)[array] for array in ("q", "qd", "qdd"))
    wanted = made.batch(q, qd, qdd)
    turned = np.asfortranarray
    mixed = made.batch(turned(q), qd, np.repeat(qdd, 2, 0)[::2])
    assert mixed.flags.c_contiguous
    for found in (
        mixed,
        made.batch(q.tolist(), qd, turned(qdd)),
        made.batch(q.astype(np.float32), qd[::-1][::-1], turned(qdd)),  # numbers of single precision
        made.batch(qdd=qdd, qd=qd, q=q),
        made.batch(np.broadcast_to(q, q.shape), qd, qdd.astype(">f8")),
    ):
        assert_same_bits(found, wanted)
    unaligned = np.frombuffer(b"x" + q.tobytes(), np.uint8)[1:].view(np.float64).reshape(q.shape)
    assert_same_bits(made.batch(unaligned, qd, qdd), wanted)


def test_out() -> None:
    made = kernel("puma560")
    given = inputs(made, "inverse_dynamics", states("puma560", 50))
    wanted = made.batch(*given)
    for out in (np.empty((50, 6)), np.empty((6, 50)).T, np.empty((100, 6))[20:70]):
        assert made.batch(*given, out=out) is out
        assert_same_bits(out, wanted)
    M = np.empty((6, 6, 50)).transpose(2, 0, 1)
    made.batch(given[0], function="mass_matrix", out=M)
    assert_same_bits(M, made.mass_matrix(given[0]))
    around = np.full((60, 6), 7.0)
    made.batch(*given, out=around[5:55])
    assert (around[:5] == 7.0).all()
    assert (around[55:] == 7.0).all()


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        (
            {"q": np.zeros(6)},
            r"q is not a batch of states; found \[6\]; expected \[N, 6\]; .*inverse_dynamics",
        ),
        ({"q": np.zeros((4, 5))}, r"q is not a batch of states; found \[4, 5\]; expected \[N, 6\]"),
        ({"q": np.zeros((1, 4, 6))}, r"found \[1, 4, 6\]"),
        ({"q": np.zeros((5, 6))}, r"the same number of states; found q \[5, 6\], qd \[4, 6\]"),
        ({"q": np.zeros((4, 6), complex)}, "q is not an array of real numbers; found complex"),
        ({"q": [[1.0], [2.0, 3.0]]}, "q is not an array of numbers"),
        ({"out": np.empty((4, 5))}, r"out cannot take tau; found float64 \[4, 5\]"),
        ({"out": np.empty((4, 6), np.float32)}, r"found float32 \[4, 6\]; expected float64 \[4, 6\]"),
        ({"out": np.empty((4, 12))[:, ::2]}, "found an array with gaps"),
        ({"out": np.empty((8, 6))[::2]}, "found an array with gaps"),
        ({"out": np.broadcast_to(0.0, (4, 6))}, "found an array with gaps"),
        ({"out": [1.0]}, "found list"),
        ({"threads": 0}, "threads is not a number of threads; found 0; expected 1 or more"),
        ({"threads": 1.5}, "threads is not a number of threads; found 1.5"),
        ({"params": {"mass": 1.0}}, "unknown: mass"),
        ({"function": "levity"}, "no function 'levity'; expected inverse_dynamics or gravity"),
        ({"speed": np.zeros((4, 6))}, "unknown speed"),
    ],
)
def test_what_does_not_fit_is_said(changed: dict[str, Any], said: str) -> None:
    given = {"q": np.zeros((4, 6)), "qd": np.zeros((4, 6)), "qdd": np.zeros((4, 6))}
    with pytest.raises(InputError, match=said):
        kernel("puma560").batch(**{**given, **changed})


def test_out_is_not_an_input() -> None:
    made = kernel("puma560")
    given = inputs(made, "inverse_dynamics", states("puma560", 9))
    with pytest.raises(InputError, match="memory that qdd lies in"):
        made.batch(*given, out=given[2])
    frozen = np.empty((9, 6))
    frozen.flags.writeable = False
    with pytest.raises(InputError, match="a read-only array"):
        made.batch(*given, out=frozen)


def test_memory_is_refused() -> None:
    made = kernel("effects_remembering")
    assert made.signatures["inverse_dynamics"].states
    zero = np.zeros((4, robots()["effects_remembering"].n))
    with pytest.raises(InputError, match=r"remembers between calls.*call kernel.inverse_dynamics with dt"):
        made.batch(zero, zero, zero)


def test_a_kernel_of_files_alone_has_no_batch(toy: Any) -> None:
    arm = toy()
    with pytest.raises(InputError, match=r"loaded from files that hold no batch; .*robodyn.compile"):
        load(arm.signatures, arm.files).batch(np.zeros((1, 2)), np.zeros((1, 2)), np.zeros((1, 2)))


def test_batches_travel() -> None:
    made = kernel("puma560")
    again = pickle.loads(pickle.dumps(made))
    given = inputs(made, "gravity", states("puma560", 20))
    assert_same_bits(again.batch(*given, function="gravity"), made.batch(*given, function="gravity"))


# --- threads ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize("threads", [2, 3, 7])
def test_threads_share_the_work_and_give_the_same(threads: int, turned: bool) -> None:
    made = kernel("puma560")
    for count in (4095, 4096, 10007):
        given = inputs(made, "inverse_dynamics", states("puma560", count))
        wanted = made.inverse_dynamics(*given)
        given = [np.asfortranarray(array) if turned else array for array in given]
        assert_same_bits(made.batch(*given, threads=threads), wanted)


_WAIT_H = "typedef double wait_real;\nvoid wait_gravity(const wait_real q[1], wait_real tau[1]);\n"
_WAIT_C = '#include "wait.h"\nvoid wait_gravity(const wait_real q[1], wait_real tau[1]) { tau[0] = q[0]; }\n'
_WAIT_BATCH_H = """#include <stddef.h>
#include "wait.h"
void wait_gravity_batch(size_t count, size_t block, const wait_real *q, wait_real *tau);
"""
_WAIT_BATCH_C = """#include "wait_batch.h"
#include <time.h>
/* Says in tau[0] that it has begun, and waits for a number at tau[q[0]]. */
void wait_gravity_batch(size_t count, size_t block, const wait_real *q, wait_real *tau)
{
    const volatile wait_real *other = tau + (ptrdiff_t)q[0];
    volatile wait_real *mine = tau;
    const clock_t start = clock();
    *mine = 1.0;
    while (*other == 0.0 && clock() - start < 20 * CLOCKS_PER_SEC) { }
    tau[count - 1] = *other;
    (void)block;
}
"""


@dataclass(frozen=True)
class Waiting:
    """Batches that wait for one another."""

    def __call__(self, function: str) -> dict[str, str]:
        assert function == "gravity"
        return {"wait.h": _WAIT_H, "wait_batch.h": _WAIT_BATCH_H, "wait_batch.c": _WAIT_BATCH_C}


@pytest.fixture(params=["api", "abi"])
def waiting(request: pytest.FixtureRequest) -> Kernel:
    signature = Signature("wait", "gravity", (("q", 1),), (("tau", 1),))
    return load([signature], {"wait.h": _WAIT_H, "wait.c": _WAIT_C}, mode=request.param, batch=Waiting())


def test_parts_run_at_the_same_time(waiting: Kernel) -> None:
    """The first part waits for the second to begin, and the second for the first."""
    count = 4096
    q, tau = np.zeros((count, 1)), np.zeros((count, 1))
    q[0], q[count // 2] = count // 2, -count // 2
    waiting.batch(q, function="gravity", out=tau, threads=2)
    assert tau[count // 2 - 1, 0] == 1.0
    assert tau[-1, 0] == 1.0


def test_python_goes_on_while_a_batch_runs(waiting: Kernel) -> None:
    """The batch waits for a number that another thread writes: it never would if the GIL were held."""
    q, tau = np.full((8, 1), 3.0), np.zeros((8, 1))
    thread = threading.Thread(target=lambda: waiting.batch(q, function="gravity", out=tau))
    thread.start()
    while tau[0, 0] == 0.0 and thread.is_alive():
        pass
    tau[3, 0] = 5.0
    thread.join()
    assert tau[-1, 0] == 5.0


def _in_a_child(given: list[Array]) -> Array:
    tau: Array = kernel("puma560").batch(*given, threads=2)
    return tau


def test_a_forked_child_makes_threads_of_its_own() -> None:
    require_machine("fork" in multiprocessing.get_all_start_methods(), "a system that forks")
    made = kernel("puma560")
    given = inputs(made, "inverse_dynamics", states("puma560", 5000))
    wanted = made.batch(*given, threads=2)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # of Python 3.12: threads and fork
        with multiprocessing.get_context("fork").Pool(1) as pool:
            found = pool.apply_async(_in_a_child, (given,)).get(timeout=60)
    assert_same_bits(found, wanted)
