"""Inverse kinematics in every language: compilers are content, and the bits are those of the program."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from emit.kernels import STRICT, STRICT_FORTRAN, write
from emit.modules import Module
from robodyn.certify import eva
from robodyn.certify.plan import run
from robodyn.emit.batch import batch_files
from robodyn.emit.languages.fortran import LANGUAGE
from robodyn.emit.render import environment
from robodyn.firmware.digest import kernel_sine, outputs
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn_testing import require_tool

FUNCTIONS = ("inverse_kinematics", "nearest_inverse_kinematics")
_PLAIN = ("-O2", "-ffp-contract=off", "-shared", "-fPIC")


def library(folder: Path, source: str, *command: str) -> ctypes.CDLL:
    subprocess.run([*command, *_PLAIN, source, "-o", f"{source}.so", "-lm"], cwd=folder, check=True)
    return ctypes.CDLL(str(folder / f"{source}.so"))


def pointers(arrays: list[Any]) -> list[ctypes.c_void_p]:
    return [a.ctypes.data_as(ctypes.c_void_p) for a in arrays]


@pytest.mark.thorough
@pytest.mark.parametrize(("name", "scalar"), [("puma560", "double"), ("ur5", "float"), ("iiwa", "double")])
def test_every_language_gives_the_bits_of_the_program(name: str, scalar: str, tmp_path: Path) -> None:
    options = Options(trig="builtin", scalar=scalar, functions=FUNCTIONS)  # type: ignore[arg-type]
    generated = generate(load(name, warn=lambda _: None), options)
    write(tmp_path, generated.files(("c", "fortran")))
    write(tmp_path, batch_files(generated.unit))
    gcc, gfortran = require_tool("gcc"), require_tool("gfortran")
    c, batch = (library(tmp_path, f"{name}{end}.c", gcc, *STRICT) for end in ("", "_batch"))
    fortran = library(tmp_path, f"{name}.f90", gfortran, *STRICT_FORTRAN)
    random, real = np.random.default_rng(1), np.float64 if scalar == "double" else np.float32
    turns = np.linalg.qr(random.normal(size=(200, 3, 3)))[0]
    turns *= np.linalg.det(turns)[:, None, None]
    T = np.concatenate([turns, random.uniform(-0.6, 0.6, (200, 3, 1))], axis=2).reshape(200, 12).astype(real)
    for signature, program in generated.unit.functions:
        near = random.uniform(-3, 3, (200, signature.inputs[1][1])).astype(real)
        inputs = {"T": T, "q_near": near}
        expected = outputs(program, inputs, {}, scalar, kernel_sine(scalar))  # type: ignore[arg-type]
        assert np.isfinite(expected).all()
        sizes = [size for _, size in signature.outputs]
        for one, symbol in ((c, signature.symbol), (fortran, LANGUAGE.compiled.symbol(signature))):  # type: ignore[union-attr]
            for k in range(200):
                results = [np.empty(size, real) for size in sizes]
                getattr(one, symbol)(*pointers([T[k], near[k], *results]))
                assert np.concatenate(results).tobytes() == expected[k].tobytes()
        results = [np.empty((200, size), real) for size in sizes]
        getattr(batch, f"{signature.symbol}_batch_rows")(ctypes.c_size_t(200), *pointers([T, near, *results]))
        assert np.concatenate(results, axis=1).tobytes() == expected.tobytes()
        if scalar == "double":
            module = Module(generated, tmp_path)
            assert module.run(signature.function, inputs, {}, 0.0).tobytes() == expected.tobytes()


@pytest.mark.thorough
def test_eva_looks_at_every_turn_of_the_loop(tmp_path: Path) -> None:
    """Of twenty arctangents, which are written one by one before they are read."""
    options = Options(trig="builtin", functions=FUNCTIONS[:1])
    generated = generate(load("puma560", warn=lambda _: None), options)
    write(tmp_path, generated.files(("c",)))
    context = eva.driver_context("puma560", generated.signatures)
    driver = environment().get_template("prove/eva_driver.c.j2").render(context)
    (tmp_path / "driver.c").write_text(driver, encoding="utf-8")
    command = [require_tool("frama-c"), *eva.OPTIONS, "puma560.c", "driver.c"]
    analysis = eva.read(run(command, tmp_path, 300), 300)
    assert analysis.proved, analysis.reason
