"""Firmware folders for tests: made once a robot and type, written, compiled and run."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any, Final

import numpy as np

from robodyn.emit.languages import compiled_language
from robodyn.firmware import Folder, firmware, firmware_options, targets_named
from robodyn.firmware.measure import FLAGS
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import Robot, load, read_text
from robodyn.targets import Target
from robodyn_testing import require_machine, require_tool

STRICT: Final = (
    "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wdouble-promotion", "-Werror",
)  # fmt: skip
STRICT_FORTRAN: Final = ("-std=f2018", "-Wall", "-Wextra", "-Werror")
SCALARS: Final = ("float", "double")

#: An arm with run-time parameters, a prismatic joint, friction and limits.
TOOL: Final = """
name: tool
links:
  - {joint: revolute, mass: 3, com: [0.1, 0, 0.2], inertia: {xx: 0.1, yy: 0.2, zz: 0.25}}
  - joint: revolute
    alpha: pi/2
    a: a_2
    mass: 2
    com: [0.2, 0.1, 0.1]
    inertia: {xx: 1, yy: 1, zz: 1.1}
    limits: {position: [-0.5, 1.25], velocity: 2, acceleration: 7}
  - {joint: prismatic, alpha: 0.7, d: 0.1, mass: m_tool, com: [0.1, 0, -0.05], friction: {coulomb: c_3}}
"""


def require_firmware_tools(target: Target) -> None:
    """Skip the test (fail it in CI) where a tool is missing that builds and runs an image for ``target``."""
    assert target.board is not None
    tools = target.board.architecture
    for tool in (tools.compiler, tools.nm, tools.size, tools.emulator):
        require_tool(tool.name)


def robot(name: str) -> Robot:
    """``tool``, or a bundled robot."""
    return read_text(TOOL, warn=lambda _: None) if name == "tool" else load(name, warn=lambda _: None)


@cache
def made(name: str, scalar: str, functions: tuple[str, ...] = ()) -> Generated:
    """The kernels of a folder."""
    options = Options(functions=functions or None)
    return generate(robot(name), firmware_options(options, (), scalar=scalar))  # type: ignore[arg-type]


@cache
def folder(name: str, scalar: str, functions: tuple[str, ...] = ()) -> Folder:
    """A folder for all targets, C and Fortran."""
    return firmware(made(name, scalar, functions), targets_named(()))


def write(where: Path, files: Mapping[str, str]) -> Path:
    """Write ``files`` into ``where``."""
    for file, text in files.items():
        (where / file).write_text(text, encoding="utf-8", newline="\n")
    return where


def run(command: Sequence[str], where: Path) -> tuple[int, str]:
    """Exit status and all that was said."""
    done = subprocess.run(command, cwd=where, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def host(gcc: str, name: str, where: Path, *flags: str) -> tuple[int, str]:
    """The C self-test of the folder ``where`` on this computer."""
    sources = [f"{name}.c", f"{name}_selftest.c", f"{name}_selftest_main.c"]
    code, said = run([gcc, "-std=c99", *FLAGS, *flags, *sources, "-o", "selftest"], where)
    assert code == 0, said
    return run([str(where / "selftest")], where)


def fortran(gfortran: str, name: str, where: Path) -> tuple[int, str]:
    """The Fortran self-test on this computer."""
    flags = compiled_language("fortran")[1].flags
    code, said = run([gfortran, *flags, f"{name}.f90", f"{name}_selftest.f90", "-o", "fortran"], where)
    assert code == 0, said
    return run([str(where / "fortran")], where)


def digests(said: str) -> dict[str, tuple[int, int]]:
    """Digests by function: the one found, and the one expected."""
    found = re.findall(r"^(\w+) digest ([0-9a-fA-F]+) expected ([0-9a-fA-F]+)", said, re.M)
    return {function: (int(one, 16), int(other, 16)) for function, one, other in found}


def in_extended_precision(program: Program, inputs: Mapping[Input, Any]) -> Any:
    """The output of ``program`` at ``inputs`` ``[N]``, ``[N, size]``, in more digits than doubles have."""
    require_machine(np.finfo(np.longdouble).nmant >= 60, "extended precision in numpy")
    functions = {"sin": np.sin, "cos": np.cos, "sqrt": np.sqrt, "abs": np.abs, "sign": np.sign,
                 "atan2": np.arctan2}  # fmt: skip

    def number(x: Fraction) -> Any:
        return np.longdouble(x.numerator) / np.longdouble(x.denominator)

    extended = {name: x.astype(np.longdouble) for name, x in inputs.items()}
    count = len(next(iter(extended.values())))
    ((_, elements),) = evaluate(program, extended, constant=number, functions=functions).items()
    return np.stack([np.broadcast_to(x, count) for x in elements], axis=1)
