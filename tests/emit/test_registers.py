"""The order for registers: the same bits, results in place of inputs, and instructions as few as is said."""

from __future__ import annotations

import importlib.util
import itertools
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn.ir.fingerprint import fingerprint
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.kernels.kernel import load as compiled
from robodyn.passes.registers import registers
from robodyn.robot import load
from robodyn.robot.values import circle_point
from robodyn_testing import covering, representative, require_module, require_tool

ROBOTS = ("puma560", "stanford", "puma560_3dof")


def made(robot: str, **options: Any) -> Generated:
    return generate(load(robot, warn=lambda _: None), Options(**options))


@pytest.mark.parametrize(("robot", "available"), covering(ROBOTS, [8, 100]))
def test_the_pass_changes_nothing_but_the_order(robot: str, available: int) -> None:
    for _, program in made(robot, order="recursion").unit.functions:
        ordered = registers(program, available)
        assert sorted(op.op for op in ordered.operations) == sorted(op.op for op in program.operations)
        assert fingerprint(ordered, 1, circle_point) == fingerprint(program, 1, circle_point)


@pytest.mark.parametrize("robot", representative(ROBOTS, "stanford"))
@pytest.mark.parametrize("trig", ["builtin", "given"])
@pytest.mark.parametrize("place", ["qd", "qdd", "q"])
def test_torques_may_take_the_place_of_an_input(robot: str, trig: str, place: str) -> None:
    cffi = require_module("cffi")
    if trig == "given" and place == "q":
        return
    found = made(robot, trig=trig, functions=("inverse_dynamics",))
    kernel = compiled(found.signatures, found.files(("c",)), mode="abi")
    (interface,) = found.signatures
    ffi = cffi.FFI()
    pointers = ", ".join(["double *"] * (len(interface.inputs) + 1))
    ffi.cdef(f"void {interface.symbol}({pointers});")
    function = getattr(ffi.dlopen(str(kernel.path)), interface.symbol)
    random = np.random.default_rng(5)
    arrays = {name: random.uniform(-1, 1, size) for name, size in interface.inputs}
    expected = kernel.inverse_dynamics(*arrays.values())
    pointer = {name: ffi.from_buffer("double *", array) for name, array in arrays.items()}
    function(*pointer.values(), pointer[place])
    assert arrays[place].tobytes() == expected.tobytes()


def _benchmark() -> Any:
    path = Path(__file__).parents[2] / "benchmarks" / "instructions.py"
    spec = importlib.util.spec_from_file_location("instructions", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("trig", "scalar"),
    representative(
        itertools.product(["builtin", "given"], ["double", "float"]), ("builtin", "double"), rest="slow"
    ),
)
def test_a_call_takes_no_more_instructions_than_allowed(trig: str, scalar: str) -> None:
    require_tool("valgrind")
    require_tool("gcc")
    benchmark = _benchmark()
    assert benchmark.measure("puma560", trig, scalar, "x86-64-v3").call <= benchmark.CEILINGS[trig]
