"""C, Fortran and the program itself give the same bits, state by state."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from emit.kernels import made, robots
from robodyn import compile as compile_robot
from robodyn.ir import Input
from robodyn.ir.evaluate import evaluate
from robodyn.passes.trig_given import describe, given_layout
from robodyn_testing import covering, representative, require_tool, sampled
from robodyn_testing.random_robots import random_states

STATES = 1000
DT = 0.0625
NAMES = ("puma560", "stanford", "smooth", "tool", "random_65", "effects_smooth", "effects_remembering")


@pytest.fixture(autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Compiled kernels of these tests stay out of the user's cache; one folder for the whole run."""
    folder = tmp_path_factory.getbasetemp() / "robodyn-cache"
    monkeypatch.setenv("ROBODYN_CACHE", str(folder))
    return folder


def arrays(name: str, states: int = STATES) -> dict[str, NDArray[np.float64]]:
    """Random inputs; every number is one of single precision."""
    q, qd, qdd = random_states(robots()[name], states, 11)
    rng = np.random.default_rng(12)
    tau = rng.uniform(-50, 50, q.shape).astype(np.float32).astype(np.float64)
    return {"q": q, "qd": qd, "qdd": qdd, "tau": tau}


def parameters(name: str) -> dict[str, float] | None:
    names = robots()[name].parameters
    return {parameter: 0.25 + 0.0625 * k for k, parameter in enumerate(names)} or None


def run(kernel: Any, function: str, inputs: dict[str, NDArray[np.float64]], name: str) -> NDArray[Any]:
    given = [inputs[array].astype(kernel.dtype) for array, _ in kernel.signatures[function].inputs]
    dt = DT if kernel.signatures[function].states else None
    result: NDArray[Any] = getattr(kernel, function)(*given, params=parameters(name), dt=dt)
    return result


def same_bits(one: NDArray[Any], other: NDArray[Any]) -> bool:
    return one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()


@pytest.mark.parametrize(
    ("name", "scalar"), covering(sampled(NAMES, every=5, rest="slow"), ["double", "float"])
)
def test_c_and_fortran_give_the_same_bits(name: str, scalar: str) -> None:
    gcc, gfortran = require_tool("gcc"), require_tool("gfortran")
    robot, inputs = robots()[name], arrays(name)
    c = compile_robot(robot, scalar=scalar, cc=gcc, mode="abi")
    fortran = compile_robot(robot, scalar=scalar, language="fortran", cc=gcc, fc=gfortran)
    assert c.functions == fortran.functions == tuple(made(name).counts)
    for function in c.functions:
        one, other = (run(kernel, function, inputs, name) for kernel in (c, fortran))
        assert np.isfinite(one).all()
        assert len(np.unique(one, axis=0)) > STATES // 2 or function == "mass_matrix"
        assert same_bits(one, other), function


@pytest.mark.parametrize("name", sampled(NAMES, every=3, rest="slow"))
def test_compiled_c_does_what_the_program_says_to_the_bit(name: str) -> None:
    """The program, run in Python: the same operations in the same order, so the same roundings."""
    kernel = compile_robot(robots()[name], cc=require_tool("gcc"), mode="abi")
    inputs = arrays(name, 40)
    numbers = parameters(name) or {}
    for interface, program in made(name).unit.functions:
        if interface.states:
            steps(kernel, interface, program, inputs, numbers)
            continue
        found = run(kernel, interface.function, inputs, name).reshape(40, -1)
        for k in range(40):
            state = {Input(array, i): float(v) for array, x in inputs.items() for i, v in enumerate(x[k])}
            state |= {Input(parameter, None): v for parameter, v in numbers.items()}
            (expected,) = evaluate(program, state).values()
            assert found[k].tobytes() == np.array(expected, dtype=np.float64).tobytes()


def steps(kernel: Any, interface: Any, program: Any, inputs: Any, numbers: dict[str, float]) -> None:
    """One state after another: the first call at rest, then each from the memory that the last one left."""
    memory = np.zeros(len(interface.states))
    for k in range(-1, 40):
        rows = {array: x[max(k, 0)] for array, x in inputs.items() if array != "tau"}
        state = {Input(array, i): float(v) for array, x in rows.items() for i, v in enumerate(x)}
        state |= {Input("state", i): float(v) for i, v in enumerate(memory)}
        state |= {Input("dt", 0): DT if k >= 0 else 0.0}
        state |= {Input(parameter, None): v for parameter, v in numbers.items()}
        tau = kernel.inverse_dynamics(*rows.values(), params=numbers, state=memory, dt=DT if k >= 0 else 0.0)
        expected = evaluate(program, state)
        assert tau.tobytes() == np.array(expected["tau"], dtype=np.float64).tobytes()
        assert memory.tobytes() == np.array(expected["state"], dtype=np.float64).tobytes()


@pytest.mark.parametrize("name", representative(["stanford", "tool"], "tool", rest="slow"))
def test_given_sines_give_the_same_bits(name: str) -> None:
    """The caller computes what the header lists, and gets what the kernel would have computed."""
    cc = require_tool("gcc")
    plain, given = (compile_robot(robots()[name], trig=t, cc=cc, mode="abi") for t in ("libm", "given"))
    inputs = arrays(name)
    layout = given_layout([program for _, program in made(name).unit.functions])
    assert made(name, "given").unit.sc == tuple(map(describe, layout))
    columns = []
    for kind, terms, constant in layout:
        total = np.zeros(STATES)
        for x, multiple in terms:  # in the kernel's order: no other sum has its bits
            total = total + float(multiple) * inputs["q"][:, x.index]
        total = total + float(constant)
        element = {"cos": math.cos, "sin": math.sin, "q": float}[kind]  # numpy's own sine has other bits
        columns.append(np.array([element(float(x)) for x in total]))
    inputs["sc"] = np.stack(columns, axis=1)
    for function in plain.functions:
        one, two = (run(kernel, function, inputs, name) for kernel in (plain, given))
        assert same_bits(one, two), function


def test_the_sign_of_nothing_is_nothing() -> None:
    """At rest exact friction is 0, in both languages; a velocity that is no number is none afterwards."""
    cc, fc = require_tool("gcc"), require_tool("gfortran")
    robot = robots()["rubbing"]
    kernels = (
        compile_robot(robot, cc=cc, mode="abi"),
        compile_robot(robot, language="fortran", cc=cc, fc=fc, mode="abi"),
    )
    for kernel in kernels:
        found = kernel.bias([[0.0]] * 5, [[0.0], [-0.0], [1e-300], [-1e-300], [2.0]])
        assert found[:, 0].tolist() == [0.0, 0.0, 1.5, -1.5, 5.5]
        assert np.isnan(kernel.bias([0.0], [np.nan])).all()
