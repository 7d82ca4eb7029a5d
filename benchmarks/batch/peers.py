"""Batches and workspaces beside Pinocchio's ``rnea`` called in a loop from Python, and instructions a state.

    python -m benchmarks.batch.peers [ROBOT] [-n STATES] [-r ROUNDS] [--check]

All are called in turn, ROUNDS times, in one process; a ratio is the median of the ratios of each round. It
needs Pinocchio (PyPI: pin). Instructions are those of the AVX2 code in the C functions, counted by valgrind
where there is one; what was not counted misses its limit. With ``--check`` the exit code is 1 where a limit
is missed: a call through a workspace at most 0.2 of ``rnea``'s time, a batch of 10,000 at least 50 times as
fast a state, at most 150 instructions a state in double and 70 in float (blocks, puma560).
"""

from __future__ import annotations

import argparse
import math
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import robodyn
from robodyn.kernels.generate import Options, generate
from robodyn.robot import Robot
from robodyn.toolchain.compiler import C_FLAGS, find_c

WORKSPACE_LIMIT, BATCH_LIMIT = 0.2, 50.0
INSTRUCTIONS_LIMIT = {"double": 150.0, "float": 70.0}

#: Calls of a single state in a round. A choice: milliseconds, a thousand times what the clock resolves.
SINGLE = 2000

_MAIN = """#include "{name}_batch.h"
#include <stdlib.h>
enum {{ STATES = 1024, CALLS = 4 }};
int main(int count, char **arguments)
{{
    {name}_real *q = aligned_alloc(64, (size_t)STATES * {length} * sizeof *q);
    const size_t block = count > 1 ? (size_t)atoi(arguments[1]) : {upper}_BATCH_BLOCK;
    int k;
    for (k = 0; k < STATES * {inputs}; ++k) {{
        q[k] = ({name}_real)((k * 7919) % 601) / 100 - 3;
    }}
    for (k = 0; k < CALLS; ++k) {{
        {name}_inverse_dynamics_batch(STATES, block, {places});
    }}
    free(q);
    return 0;
}}
"""


def pinocchio_call(robot: Robot) -> Callable[[np.ndarray, np.ndarray, np.ndarray], Any]:
    """``rnea`` of Pinocchio on one state."""
    sys.path.insert(0, str(Path(__file__).parents[2] / "tests"))
    import pinocchio

    from peers.pinocchio_peer import pinocchio_model

    model = pinocchio_model(robot)
    data = model.createData()
    return lambda q, qd, qdd: pinocchio.rnea(model, data, q, qd, qdd)


def timed(call: Callable[[], object]) -> float:
    """Seconds of one call."""
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def measured(robot: Robot, states: int, rounds: int) -> dict[str, list[float]]:
    """Seconds a state of each way to call, one number a round."""
    rnea = pinocchio_call(robot)
    double = robodyn.compile(robot, trig="builtin", functions=("inverse_dynamics",))
    single = robodyn.compile(robot, trig="builtin", functions=("inverse_dynamics",), scalar="float")
    libm = robodyn.compile(robot, functions=("inverse_dynamics",))
    arrays = np.random.default_rng(0).uniform(-3, 3, (3, states, robot.n))
    rows = [np.ascontiguousarray(a) for a in arrays]
    columns = [np.asfortranarray(a) for a in arrays]
    floats = [np.asfortranarray(a, dtype=np.float32) for a in arrays]
    out, turned = np.empty((states, robot.n)), np.empty((robot.n, states)).T
    turned_floats = np.empty((robot.n, states), np.float32).T
    workspaces = {"": double.workspace(), ", libm": libm.workspace()}
    for ws in workspaces.values():
        ws.q, ws.qd, ws.qdd = (a[0] for a in arrays)  # at rest at zero libm's sines are cheaper

    def loop(call: Callable[..., object], *arguments: object) -> Callable[[], None]:
        def run() -> None:
            for _ in range(SINGLE):
                call(*arguments)

        return run

    ways: dict[str, tuple[Callable[[], object], int]] = {
        "pinocchio.rnea": (loop(rnea, *(a[0] for a in arrays)), SINGLE)
    }
    ways |= {f"Workspace{kind}": (loop(ws), SINGLE) for kind, ws in workspaces.items()}
    for threads in (1, 2):
        also = "" if threads == 1 else f", {threads} threads"
        ways[f"batch, rows{also}"] = (partial(double.batch, *rows, out=out, threads=threads), states)
        ways[f"batch, columns{also}"] = (
            partial(double.batch, *columns, out=turned, threads=threads),
            states,
        )
    ways["batch, columns, float"] = (lambda: single.batch(*floats, out=turned_floats), states)
    for call, _ in ways.values():
        call()
    wanted = np.array([rnea(*state) for state in zip(*(a[:100] for a in arrays), strict=True)])
    assert np.allclose(out[:100], wanted, rtol=1e-9, atol=1e-9)
    assert np.array_equal(out, turned)
    times: dict[str, list[float]] = {way: [] for way in ways}
    for _ in range(rounds):
        for way, (call, count) in ways.items():
            times[way].append(timed(call) / count)
    return times


def instructions(robot: Robot, scalar: str) -> dict[str, float]:
    """Instructions a state of the AVX2 code, by layout; nothing where there is no valgrind."""
    valgrind = shutil.which("valgrind")
    if valgrind is None:
        print("valgrind is missing (apt install valgrind): no instruction counts", file=sys.stderr)
        return {}
    options = Options(scalar=scalar, trig="builtin", functions=("inverse_dynamics",))  # type: ignore[arg-type]
    name, n = robot.name, robot.n
    places = ", ".join(f"q + {k * n} * STATES" for k in range(4))
    text = _MAIN.format(
        name=name,
        upper=name.upper(),
        length=4 * n,
        inputs=3 * n,
        places=places,
    )
    with tempfile.TemporaryDirectory() as folder:
        for path, content in {
            **generate(robot, options).files(("c",), batch=True),
            "main.c": text,
        }.items():
            (Path(folder) / path).write_text(content)
        find_c().run(
            [*C_FLAGS, f"-D{name.upper()}_BATCH_BYTES=32", f"{name}_batch.c", "main.c", "-lm", "-o", "main"],
            folder=Path(folder),
            doing="the counted program",
        )
        instructions = {}
        for layout, arguments in (("blocks", []), ("columns", ["1024"]), ("rows", ["1"])):
            done = subprocess.run(
                [
                    valgrind,
                    "--tool=callgrind",
                    "--callgrind-out-file=/dev/null",
                    f"--toggle-collect={name}_inverse_dynamics_batch",
                    "./main",
                    *arguments,
                ],
                cwd=folder,
                capture_output=True,
                text=True,
                check=True,
            )
            counted = re.search(r"Collected : (\d+)", done.stderr)
            assert counted is not None, done.stderr
            instructions[f"{scalar}, {layout}"] = int(counted[1]) / (1024 * 4)
        return instructions


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, print the tables, and return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("robot", nargs="?", default="puma560", help="a bundled robot or a file")
    parser.add_argument("-n", "--states", type=int, default=10_000, help="states of a batch (default: 10000)")
    parser.add_argument(
        "-r", "--rounds", type=int, default=60, help="how often each is measured (default: 60)"
    )
    parser.add_argument("--check", action="store_true", help="exit 1 where a limit is missed")
    options = parser.parse_args(arguments)
    robot = robodyn.load(options.robot, warn=lambda _: None)
    times = measured(robot, options.states, options.rounds)
    peer = times.pop("pinocchio.rnea")
    print(f"{robot.name}, batches of {options.states}; pinocchio.rnea is 1, called in a loop")
    ratios = {}
    for way, own in times.items():
        ratios[way] = statistics.median(a / b for a, b in zip(own, peer, strict=True))
        print(f"{way:28} {ratios[way]:8.4f} of its time, {1 / ratios[way]:7.1f} times as fast")
    print("instructions a state, AVX2 (at most)")
    counts: dict[str, float] = {}
    for scalar in ("double", "float"):
        counts |= instructions(robot, scalar)
    for what, count in counts.items():
        print(f"{what:28} {count:8.1f}")
    missed = [
        what
        for what, met in {
            "a call through a workspace": ratios["Workspace"] <= WORKSPACE_LIMIT,
            "a batch": 1 / ratios["batch, rows"] >= BATCH_LIMIT,
            **{
                f"instructions, {scalar}": counts.get(f"{scalar}, blocks", math.inf) <= limit
                for scalar, limit in INSTRUCTIONS_LIMIT.items()
            },
        }.items()
        if not met
    ]
    for what in missed:
        print(f"{what}: the limit is missed", file=sys.stderr)
    return 1 if options.check and missed else 0


if __name__ == "__main__":
    sys.exit(main())
