"""The program that checks and times kernels on a GPU: sources, values of the C, and with nvcc the program."""

from __future__ import annotations

import os
import shutil
import subprocess
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

import robodyn
from robodyn.emit.languages.cuda import NVCC
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import load

ARMS: Final = ("puma560", "panda")
SCALARS: Final = ("float", "double")
#: States that are checked: no whole number of blocks.
STATES: Final = 200
#: How long the program may measure [s].
SECONDS: Final = 50.0
#: Sizes of the numbers of an input, where they are not angles within half a turn.
_SIZES: Final = {"qd": 2.0, "qdd": 5.0, "tau": 50.0, "w": 20.0, "pi": 1.0}
_RUN: Final = '#!/bin/sh\ncd "$(dirname "$0")" && ./roofline values.bin > "${1:-figures.json}"\n'


@cache
def kernels(arm: str, scalar: str) -> Generated:
    """All functions of an arm; its name says of which type its numbers are."""
    robot = replace(load(arm, warn=lambda _: None), name=f"{arm}_{scalar}")
    return generate(robot, Options(functions=("all",), trig="builtin", scalar=scalar))  # type: ignore[arg-type]


def write(folder: Path, processes: int | None = None) -> list[str]:
    """The sources, and ``values.bin``; the names of those with kernels, fused and (``_exact``) not fused."""
    folder.mkdir(parents=True, exist_ok=True)
    of = [(folder, arm, scalar) for arm in ARMS for scalar in SCALARS]
    with ProcessPoolExecutor(processes) as pool:
        parts = list(pool.map(_part, *zip(*of, strict=True)))
    declared = [line for lines, _, _, _ in parts for line in lines]
    arms = ", ".join(arm for _, arm, _, _ in parts)
    head = (
        f"#define STATES {STATES}\n#define SECONDS {SECONDS}\n"
        "struct Function { const char *name; int inputs, outputs, sizes[16]; };\n"
        "struct Arm { const char *name, *scalar; size_t real; int count; const Function *functions;\n"
        "    const void *const *kernels, *const *exact; };\n"
    )
    text = "\n".join([*declared, f"static const Arm arms[] = {{{arms}}};"])
    (folder / "arms.h").write_text(f"{head}{text}\n", encoding="ascii")
    shutil.copy(Path(__file__).with_name("roofline.cu"), folder)
    (folder / "values.bin").write_bytes(b"".join(values for _, _, values, _ in parts))
    (folder / "run.sh").write_text(_RUN, encoding="ascii")
    (folder / "run.sh").chmod(0o755)
    return [source for _, _, _, sources in parts for source in sources]


def _part(folder: Path, arm: str, scalar: str) -> tuple[list[str], str, bytes, list[str]]:
    """Of one arm the sources, written; its lines of ``arms.h``, its entry there, values, and the sources."""
    generated = kernels(arm, scalar)
    name = generated.unit.robot.name
    declared, sources = [], []
    files = generated.files(("cuda",))
    for called in (name, f"{name}_exact"):
        for file, text in files.items():
            (folder / file.replace(name, called)).write_text(text.replace(name, called), encoding="ascii")
        symbols = [s.symbol.replace(name, called) for s in generated.signatures]
        stubs = ", ".join(f"(const void *){symbol}_blocks" for symbol in symbols)
        table = f"extern const void *const {called}_kernels[]"
        (folder / f"{called}_table.cu").write_text(
            f'#include "{called}.cu"\n{table};\n{table.removeprefix("extern ")} = {{{stubs}}};\n',
            encoding="ascii",
        )
        declared.append(f"{table};")
        sources.append(f"{called}_table.cu")
    rows = [_row(s.called, s.inputs, s.outputs) for s in generated.signatures]
    declared.append(f"static const Function {name}_functions[] = {{{', '.join(rows)}}};")
    names = f"{name}_functions, {name}_kernels, {name}_exact_kernels"
    entry = f'{{"{arm}", "{scalar}", sizeof({scalar}), {len(rows)}, {names}}}'
    values = b"".join(each.tobytes() for each in _values(arm, scalar, generated))
    return declared, entry, values, sources


def _row(name: str, inputs: tuple[tuple[str, int], ...], outputs: tuple[tuple[str, int], ...]) -> str:
    sizes = ", ".join(str(size) for _, size in (*inputs, *outputs))
    return f'{{"{name}", {len(inputs)}, {len(outputs)}, {{{sizes}}}}}'


def _values(arm: str, scalar: str, generated: Generated) -> list[NDArray[Any]]:
    """Of each function inputs at the states, and what the C gives there."""
    functions = tuple(signature.function for signature in generated.signatures)
    kernel = robodyn.compile(arm, functions=functions, trig="builtin", scalar=scalar)
    random = np.random.default_rng(7)
    given: dict[str, NDArray[Any]] = {}
    for signature in generated.signatures:
        for array, size in signature.inputs:
            if array not in given:
                size_of = _SIZES.get(array, 3.0)
                given[array] = random.uniform(-size_of, size_of, (STATES, size)).astype(kernel.dtype)
    given["T"] = np.ascontiguousarray(kernel.forward_kinematics(given["q"])).reshape(STATES, 12)
    values = []
    for signature in generated.signatures:
        inputs = [given[array] for array, _ in signature.inputs]
        results = getattr(kernel, signature.function)(*inputs)
        parts = results if isinstance(results, tuple) else (results,)
        outputs = [np.asarray(part).astype(kernel.dtype).reshape(STATES, -1) for part in parts]
        assert [part.shape[1] for part in outputs] == [size for _, size in signature.outputs]
        values += [*inputs, *outputs]
    return values


def build(folder: Path, processes: int | None = None, arch: str = "sm_90") -> None:
    """Write the program and compile it.

    Raises
    ------
    subprocess.CalledProcessError: nvcc does not take it.
    """
    nvcc = NVCC.command() or (NVCC.needed(),)
    compiled = []
    for source in [*write(folder, processes), "roofline.cu"]:
        exact = ["-fmad=false"] if "_exact_" in source else []
        compiled.append([*nvcc, f"-arch={arch}", "-O3", *exact, "-c", source, "-o", f"{source}.o"])

    def run(command: list[str]) -> None:
        subprocess.run(command, cwd=folder, check=True)

    with ThreadPoolExecutor(processes or os.cpu_count()) as pool:
        list(pool.map(run, compiled))
    objects = [command[-1] for command in compiled]
    run(
        [
            *nvcc,
            f"-arch={arch}",
            "-cudart",
            "static",
            "-Xcompiler",
            "-static-libstdc++,-static-libgcc",
            "-o",
            "roofline",
            *objects,
        ]
    )
