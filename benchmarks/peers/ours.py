"""Our kernels as runners: one state a call, and batches."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.peers.building import NATIVE, STRICT, Source, library
from benchmarks.peers.candidates import Candidate
from benchmarks.peers.race import Floats, States

from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program
from robodyn.kernels.generate import Options, generate, program
from robodyn.passes.trig_given import given_layout
from robodyn.robot import Robot
from robodyn.toolchain.compiler import C_FLAGS

_TRIG = {
    "builtin": "built-in sine and cosine",
    "libm": "libm's sine and cosine",
    "given": "sines and cosines given",
}
#: How our kernels are compiled for the clock: as all that is timed, with gcc's scheduler before the registers
#: are given out, as what instructions are counted in, and as robodyn compiles by itself.
BUILDS: dict[str, tuple[str, ...]] = {
    "native": NATIVE,
    "scheduled": (*NATIVE, "-fschedule-insns"),
    "v3": STRICT,
    "default": C_FLAGS,
}
#: Names of the widths of vectors, by their bytes.
VECTORS = {32: "AVX2", 64: "AVX-512"}
#: As all that is timed, and for any processor, which is asked at run time what it has: the same bits on all.
_BATCHES = {"native": NATIVE, "portable": ("-std=c99", "-O2", "-fno-math-errno")}


def kernels(
    robot: Robot, folder: Path, states: States, builds: Sequence[str], optimize: str = "record"
) -> list[Candidate]:
    """The inverse dynamics of ``robot``, one state a call, with every kind of sine and cosine."""
    candidates = []
    for trig, title in _TRIG.items():
        options = Options(("inverse_dynamics",), trig=trig, optimize=optimize)  # type: ignore[arg-type]
        place = folder / trig
        files = written(place, generate(robot, options).files(("c",)))
        defines = _defines(robot, f"{robot.name}.h", "")
        if trig == "given":
            width = write_given(robot, states, folder / "given.bin", optimize)
            defines = (*defines, ("GIVEN", str(width)))
        source = Source(("robodyn.c", *files), (f"-I{place}",), defines=defines)
        counted = library(folder / f"robodyn-{trig}-counted.so", source, STRICT)
        for build in builds:
            timed = library(folder / f"robodyn-{trig}-{build}.so", source, BUILDS[build])
            key = f"robodyn-{trig}" + ("" if build == "native" else f"-{build}")
            flags = " ".join(BUILDS[build])
            candidates.append(Candidate(key, f"robodyn, {title}", flags, timed, counted, ours=True))
    return candidates


def batches(robot: Robot, folder: Path) -> list[Candidate]:
    """Batches in double and float, with vectors of either width; ``given.bin`` is there."""
    candidates = []
    for scalar in ("double", "float"):
        for trig in ("builtin", "given"):
            options = Options(("inverse_dynamics",), trig=trig, scalar=scalar)
            generated = generate(robot, options)
            place = folder / f"batch-{trig}-{scalar}"
            files = written(place, generated.files(("c",), batch=True))
            defines = _defines(robot, f"{robot.name}_batch.h", "_batch")
            if trig == "given":
                defines = (*defines, ("GIVEN", str(dict(generated.signatures[0].inputs)["sc"])))
            kernels = [file for file in files if file.name.endswith("_batch.c")]
            sources: tuple[str | Path, ...] = ("robodyn.c", *kernels)
            for width, vectors in VECTORS.items():
                upper = robot.name.upper()
                own_defines = (
                    *defines,
                    (f"{upper}_BATCH_BYTES", str(width)),
                    ("BATCH", f"{upper}_BATCH_BLOCK"),
                )
                source = Source(sources, (f"-I{place}",), defines=own_defines)
                key = f"batch-{trig}-{scalar}-{width}"
                title = f"robodyn, batch, {scalar}, {_TRIG[trig]}, {vectors}"
                counted = library(folder / f"{key}-counted.so", source, STRICT) if width == 32 else None
                for build, flags in _BATCHES.items():
                    if trig == "given" and build != "native":
                        continue
                    built = library(folder / f"{key}-{build}.so", source, flags)
                    own = key if build == "native" else f"{key}-{build}"
                    settings, single = " ".join(flags), scalar == "float"
                    candidates.append(
                        Candidate(own, title, settings, built, counted, ours=True, single=single)
                    )
    return candidates


def write_given(robot: Robot, states: States, path: Path, optimize: str = "record") -> int:
    """Sines and cosines of ``states`` as the kernel with ``--trig given`` takes them; how many a state."""
    options = Options(("inverse_dynamics",), optimize=optimize)  # type: ignore[arg-type]
    layout = given_layout([program(robot, "inverse_dynamics", options)])
    columns = []
    functions: dict[str, Callable[[Any], Any]] = {"sin": np.sin, "cos": np.cos, "q": lambda x: x}
    for kind, terms, constant in layout:
        angle = float(constant) + sum(float(m) * states.q[:, x.index] for x, m in terms)
        columns.append(functions[kind](angle))
    path.write_bytes(np.ascontiguousarray(np.array(columns).T).tobytes())
    return len(layout)


def values_of(own: Program, states: Floats) -> Floats:
    """What a program of ours gives [N, m] at ``states`` [3, N, n]: positions, velocities, and accelerations
    or torques."""
    place = {"q": 0, "qd": 1, "qdd": 2, "tau": 2}
    inputs = {Input(name, i): states[k, :, i] for name, k in place.items() for i in range(states.shape[2])}
    functions = {"sin": np.sin, "cos": np.cos, "sqrt": np.sqrt}
    columns = [x for values in evaluate(own, inputs, functions=functions).values() for x in values]
    return np.stack([np.broadcast_to(x, states.shape[1]) for x in columns], axis=1)


def reference(robot: Robot, states: States) -> Floats:
    """Torques [N, n] of the plain textbook in double precision, which shares nothing with the kernels."""
    from robodyn.verify.reference import Reference

    return Reference(robot).inverse_dynamics(states.q, states.qd, states.qdd)


def _defines(robot: Robot, header: str, ending: str) -> tuple[tuple[str, str], ...]:
    name = robot.name
    kernel = f"{name}_inverse_dynamics{ending}"
    return ("HEADER", f'"{header}"'), ("REAL", f"{name}_real"), ("KERNEL", kernel)


def written(folder: Path, files: dict[str, str]) -> list[Path]:
    """Write the files; those in C that are compiled by themselves."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    return [folder / name for name in sorted(files) if name.endswith(".c")]
