"""Projects that use a package: the numbers that its functions must give, and programs that call them.

A program reads the inputs of every function at every state from stdin, one after another, and prints the
results in the same order.
"""

from __future__ import annotations

import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.kernels.generate import Options, generate, program
from robodyn.packages import Package, Routine, package
from robodyn.robot import load
from robodyn_cli.main import main

STATES = 5
#: An arm with friction and a run-time parameter, in capitals.
UPPER_CASE = """\
name: UPPER_case
links:
- {joint: revolute, alpha: 0.3, mass: 3, com: [1, 0, 0.5], friction: {viscous: 2}}
- {joint: prismatic, alpha: 1, mass: m_tool, com: [0.1, 0, 0.2], motor_inertia: 1}
"""
#: A maintainer whose name XML has to escape, METADATA to quote, and no file to write in ASCII.
MAINTAINER = "Ø. O'Brien & Søns <o.brien+arm@example.org>"
#: Relative to the largest result of a function; of float.
TOLERANCE = {"double": 1e-11, "float": 2e-5}


@dataclass(frozen=True, slots=True)
class Case:
    """A function with inputs ``[states, inputs]`` and the results ``[states, results]`` that it must give."""

    routine: Routine
    inputs: NDArray[np.float64]
    expected: NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Consumer:
    """What a program that uses a package is fed with, and what it has to print."""

    package: Package
    parameters: Mapping[str, float] = field(default_factory=dict)
    cases: Sequence[Case] = ()

    @property
    def stdin(self) -> str:
        """The inputs."""
        rows = (row for case in self.cases for row in case.inputs)
        return "\n".join(" ".join(repr(float(x)) for x in row) for row in rows) + "\n"

    def check(self, stdout: str) -> None:
        """Hold what a program has printed to what is expected."""
        results = np.array([float(word) for word in stdout.split()])
        sizes = [case.expected.size for case in self.cases]
        assert results.size == sum(sizes) > 0
        for case, part in zip(self.cases, np.split(results, np.cumsum(sizes)[:-1]), strict=True):
            error = np.abs(part.reshape(case.expected.shape) - case.expected).max()
            largest = np.abs(case.expected).max()
            assert error <= TOLERANCE[self.package.scalar] * max(1.0, largest), case.routine.symbol


def consumer(
    robot: str,
    form: str,
    options: Options | None = None,
    *,
    version: str = "1.2.3",
    license: str | None = None,
    maintainer: str | None = None,
    parameters: Mapping[str, float] | None = None,
) -> Consumer:
    """Somebody who uses the package of ``robot`` (a name or a path) in the format ``form``.

    What is expected is the recursion of the book, not optimised, evaluated in Python.
    """
    packed = package(
        generate(load(robot), options), form, version=version, license=license, maintainer=maintainer
    )
    assert not packed.states, "the programs here remember nothing"
    values = dict(parameters or {})
    random = np.random.default_rng(0)
    cases = []
    for signature, routine in zip(packed.generated.signatures, packed.routines, strict=True):
        plain = program(packed.robot, signature.function, Options(optimize="none"))
        inputs = random.uniform(-1, 1, (STATES, sum(array.size for array in routine.inputs)))
        names = [Input(array.name, i) for array in routine.inputs for i in range(array.size)]
        rows = []
        for row in inputs:
            at = dict(zip(names, map(float, row), strict=True))
            results = evaluate(plain, {**at, **{Input(name, None): x for name, x in values.items()}})
            rows.append([float(x) for array in routine.outputs for x in results[array.name]])
        cases.append(Case(routine, inputs, np.array(rows)))
    return Consumer(packed, values, cases)


def loaded_arm(folder: Path, name: str) -> Path:
    """The description of an arm called ``name`` in ``folder``: two joints, and the parameter ``m_tool``."""
    path = folder / "arm.yaml"
    path.write_text(
        f"name: {name}\nlinks:\n- {{joint: revolute, alpha: pi/2, mass: m_tool, com: [0.1, 0.2, 0]}}\n"
        "- {joint: prismatic, alpha: 1, mass: 2, com: [0.1, 0, 0.2], motor_inertia: 1}\n"
    )
    return path


def write(folder: Path, files: Mapping[str, str | bytes]) -> Path:
    """``files`` in ``folder``."""
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8"))
    return folder


def packaged(folder: Path, robot: str, form: str, *options: str) -> Path:
    """The package that ``robodyn package`` writes into ``folder``, of a ``robot`` by its name or its text."""
    if "\n" in robot:
        robot = str(write(folder.parent, {"arm.yaml": robot}) / "arm.yaml")
    assert main(["package", robot, "--as", form, "-o", str(folder), *options]) == 0
    return folder


def run(
    *command: str | Path, cwd: Path, stdin: str = "", environment: Mapping[str, str] | None = None
) -> str:
    """The stdout of ``command`` in ``cwd``, which must end in 0."""
    done = subprocess.run(
        [*command], cwd=cwd, env=environment, input=stdin, capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def c_program(consumer: Consumer) -> str:
    """The program in C, which is valid C++ too."""
    name = consumer.package.robot.name
    read = "float" if consumer.package.scalar == "float" else "double"
    lines = []
    for case in consumer.cases:
        routine = case.routine
        body = [f"{name}_real {array.name}[{array.size}];" for array in (*routine.inputs, *routine.outputs)]
        body += [f"get({array.name}, {array.size});" for array in routine.inputs]
        arguments = [array.name for array in (*routine.inputs, *routine.outputs)]
        arguments += ["&parameters"] if consumer.package.parameters else []
        body.append(f"{routine.symbol}({', '.join(arguments)});")
        body += [f"put({array.name}, {array.size});" for array in routine.outputs]
        lines.append(f"for (k = 0; k < {STATES}; ++k) {{ {' '.join(body)} }}")
    values = ", ".join(repr(consumer.parameters[p]) for p in consumer.package.parameters)
    parameters = f"{name}_params parameters = {{ {values} }};" if values else ""
    return f"""\
#include <{name}.h>
#include <stdio.h>
#include <stdlib.h>
static void get({name}_real *x, int n) {{
    int i;
    for (i = 0; i < n; ++i) {{
        double number;
        if (scanf("%lf", &number) != 1) exit(1);
        x[i] = ({read})number;
    }}
}}
static void put(const {name}_real *x, int n) {{
    int i;
    for (i = 0; i < n; ++i) printf("%.17g\\n", (double)x[i]);
}}
int main(void) {{
    int k;
    {parameters}
    {chr(10).join(lines)}
    return 0;
}}
"""


def fortran_program(consumer: Consumer) -> str:
    """The program in Fortran."""
    packed = consumer.package
    declared, called = [], []
    for k, case in enumerate(consumer.cases):
        routine = case.routine
        arrays = (*routine.inputs, *routine.outputs)
        declared += [f"real(rk) :: {array.name}_{k}({array.size})" for array in arrays]
        names = [f"{array.name}_{k}" for array in arrays]
        names += ["parameters"] if packed.parameters else []
        called += [
            f"do k = 1, {STATES}",
            f"read (*, *) {', '.join(f'{array.name}_{k}' for array in routine.inputs)}",
            f"call {routine.symbol}({', '.join(names)})",
            *(f"print '(es26.17e3)', {array.name}_{k}" for array in routine.outputs),
            "end do",
        ]
    if packed.parameters:
        declared.append(f"type({packed.robot.name}_params) :: parameters")
        called[:0] = [f"parameters%{name} = {value!r}_rk" for name, value in consumer.parameters.items()]
    kind = "c_float" if packed.scalar == "float" else "c_double"
    lines = [
        "program consumer",
        f"use, intrinsic :: iso_c_binding, only: rk => {kind}",
        f"use {packed.name}",
        "implicit none",
        "integer :: k",
        *declared,
        *called,
        "end program",
    ]
    return "\n".join(lines) + "\n"
