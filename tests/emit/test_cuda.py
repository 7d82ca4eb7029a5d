"""CUDA on the host: its kernels, run thread by thread as C++, give the bits of the C; nvcc takes them."""

from __future__ import annotations

import ctypes
import shlex
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from emit.angles import TYPES, of_program
from emit.every_language import library
from emit.kernels import STRICT_CPP, in_single, made, robots, write
from emit.test_bits import DT, arrays, own_cache, parameters, run, same_bits
from emit.test_every_language import poses, roots, states
from robodyn import compile as compile_robot
from robodyn.emit.languages.cuda import LANES, NVCC
from robodyn.kernels.generate import Generated, Options, generate
from robodyn_testing import require_tool

__all__ = ["own_cache"]

#: What makes a kernel a function of C++ that is called once a thread.
SHIM = """
#include <stddef.h>
#define __global__
#define __launch_bounds__(threads)
struct place { unsigned int x; };
static place gridDim, blockDim, blockIdx, threadIdx;
#include "NAME.cu"
extern "C" void robodyn_thread(unsigned blocks, unsigned threads, unsigned block, unsigned thread)
{
    gridDim.x = blocks; blockDim.x = threads; blockIdx.x = block; threadIdx.x = thread;
}
"""
#: A grid that is smaller than a batch, and threads that are no whole block of states.
BLOCKS, THREADS = 3, 40


def blocked(rows: NDArray[Any]) -> NDArray[Any]:
    """States [N, n] in blocks of lanes; what lies behind the last state is NaN."""
    count, size = rows.shape
    padded = np.full((-(-count // LANES) * LANES, size), np.nan, rows.dtype)
    padded[:count] = rows
    return np.ascontiguousarray(padded.reshape(-1, LANES, size).transpose(0, 2, 1))


def unblocked(blocks: NDArray[Any], count: int) -> NDArray[Any]:
    """The states of :func:`blocked`; what lies behind them has to be NaN still."""
    rows = blocks.transpose(0, 2, 1).reshape(-1, blocks.shape[1])
    assert np.isnan(rows[count:]).all()
    return np.ascontiguousarray(rows[:count])


class Threads:
    """Kernels of CUDA as a library of the host."""

    def __init__(self, generated: Generated, folder: Path) -> None:
        write(folder, generated.files(("cuda",)))
        name = generated.unit.robot.name
        (folder / "host.cpp").write_text(SHIM.replace("NAME", name), encoding="ascii")
        command = (require_tool("g++"), *STRICT_CPP, "-O1", "-ffp-contract=off")
        self.built = library(folder, "host.cpp", *command)
        self.signatures = {s.function: s for s in generated.signatures}

    def run(self, function: str, inputs: dict[str, Any], given: dict[str, float], dt: float) -> NDArray[Any]:
        """The results [N, size] at ``inputs``; a function that remembers is called at rest first."""
        signature = self.signatures[function]
        real = TYPES[signature.scalar]
        rows = [np.asarray(inputs[array], real) for array, _ in signature.inputs]
        count = len(rows[0])
        before = [blocked(each) for each in rows]
        results = [blocked(np.full((count, size), np.nan, real)) for _, size in signature.outputs]
        members = np.array([given[name] for name in signature.parameters], real)
        memory = [blocked(np.zeros((count, len(signature.states)), real))] if signature.states else []
        pointers = [*before, *results, *([members] if signature.parameters else []), *memory]
        number = ctypes.c_float if signature.scalar == "float" else ctypes.c_double
        kernel = getattr(self.built, f"{signature.symbol}_blocks")
        kernel.argtypes = [ctypes.c_size_t, *[ctypes.c_void_p] * len(pointers), *[number] * len(memory)]
        for step in (0.0, dt) if memory else (dt,):
            for k in range(BLOCKS * THREADS):
                self.built.robodyn_thread(BLOCKS, THREADS, *divmod(k, THREADS))
                kernel(count, *(each.ctypes.data for each in pointers), *([step] if memory else []))
        return np.concatenate([unblocked(each, count) for each in results], axis=1)


@pytest.mark.parametrize(
    ("name", "scalar"), [("tool", "float"), ("effects_remembering", "double"), ("rubbing", "double")]
)
def test_kernels_give_the_bits_of_the_c(name: str, scalar: str, tmp_path: Path) -> None:
    """1,000 states, the last block not full; run-time parameters, and memory, each state its own."""
    generated = made(name, "builtin")
    threads = Threads(in_single(generated) if scalar == "float" else generated, tmp_path)
    c = compile_robot(robots()[name], scalar=scalar, trig="builtin", cc=require_tool("gcc"), mode="abi")
    inputs = arrays(name)
    for function in c.functions:
        remembers = bool(c.signatures[function].states)
        some = {array: x[:40] for array, x in inputs.items()} if remembers else inputs
        found = threads.run(function, some, parameters(name) or {}, DT)
        if remembers:  # each state by itself: at rest, and once more
            each = [{array: x[k : k + 1] for array, x in some.items()} for k in range(40)]
            expected = np.concatenate([run(c, function, rows, name) for rows in each])
        else:
            expected = run(c, function, some, name)
        assert np.isfinite(found).all()
        assert same_bits(found, expected.reshape(found.shape)), function


def test_solutions_roots_and_arctangents(tmp_path: Path) -> None:
    """Inverse kinematics with its list, whose rows are those of the branches, and a step that is repeated."""
    options = Options(trig="builtin", functions=("inverse_kinematics", "nearest_inverse_kinematics"))
    generated = generate(robots()["puma560"], options)
    cc = require_tool("gcc")
    c = compile_robot(robots()["puma560"], trig="builtin", functions=options.functions, cc=cc, mode="abi")
    inputs = poses(6)
    (tmp_path / "ik").mkdir()
    threads = Threads(generated, tmp_path / "ik")
    for function in c.functions:
        expected = getattr(c, function)(inputs["T"], inputs["q_near"])
        parts = [np.asarray(part, float).reshape(200, -1) for part in expected]
        assert same_bits(threads.run(function, inputs, {}, 0.0), np.concatenate(parts, axis=1))
    for rows in (1, 3):
        folder = tmp_path / str(rows)
        folder.mkdir()
        q = states()
        repeated = of_program(roots(20, rows), "double")
        found = Threads(repeated, folder).run("gravity", {"q": q}, {}, 0.0)
        np.testing.assert_allclose(found, q * np.sqrt(1 + np.abs(q[:, :rows])), rtol=1e-6)


def test_sines_of_the_library_come_from_one_call() -> None:
    for generated, called in (
        (made("puma560"), "sincos(q[1], &sines["),
        (in_single(made("puma560")), "sincosf(q[1], &sines["),
    ):
        text = generated.files(("cuda",))["puma560.cuh"]
        assert called in text
        assert not any(word in text for word in (" sin(", " cos(", "volatile"))


@pytest.mark.slow
@pytest.mark.parametrize(("name", "trig"), [("tool", "builtin"), ("effects_remembering", "libm")])
def test_nvcc_has_nothing_to_say(name: str, trig: str, tmp_path: Path) -> None:
    """For the oldest and the newest GPU of those that the benchmarks look at."""
    nvcc = NVCC.command() or (require_tool(NVCC.name),)
    write(tmp_path, in_single(made(name, trig)).files(("cuda",)))
    for arch in ("sm_80", "sm_90"):
        flags = f"-arch={arch} -cubin -Werror all-warnings -Xcompiler -Wall,-Wextra {name}.cu -o {arch}.cubin"
        done = subprocess.run([*nvcc, *shlex.split(flags)], cwd=tmp_path, capture_output=True, text=True)
        assert (done.returncode, done.stdout + done.stderr) == (0, "")
