"""How long it takes from a robot description to its kernels, in seconds and milliseconds of CPU.

    python benchmarks/generation.py [ROBOT] [-n RUNS] [--check]
    python benchmarks/generation.py --long [-n RUNS] [--check]

Measured is the CPU time, of user and system, of ``robodyn gen ROBOT`` as a whole process (start of Python
and writing of the files included), and within a process that of the model and the passes alone. The median of
RUNS is what counts; the smallest stands beside it. With ``--check`` the exit code is 1 where a limit is
exceeded: half a second for the process, 50 ms for the model and the passes of the inverse dynamics.

``--long`` measures whole processes with ``--optimize fast``: every function of an arm of 7 joints, every
function that is no derivative of one of 30, the inverse dynamics of one of 100; and how large the C of both
derivatives of the arm of 7 joints is. The long arms are made by rule: axes parallel or perpendicular as arms
have them, full inertias.
"""

from __future__ import annotations

import argparse
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

PROCESS_LIMIT = 0.5
MODEL_LIMIT = 0.05
#: Arms of --long, which of their functions, and the limit [s].
SEVEN = "panda"
LONG = ((SEVEN, "all", 2.0), (30, "all but derivatives", 5.0), (100, "inverse_dynamics", 10.0))
DERIVATIVES = ("inverse_dynamics_derivatives", "forward_dynamics_derivatives")
#: Functions that arms so long do not have: 27,000 symbols, and currents of motors that are not described.
NOT_OF_LONG = ("christoffel_symbols", "motor_torque", "motor_current")
TEXT_LIMIT = 250_000


@dataclass(frozen=True)
class Timing:
    """CPU times [s] of one thing that was measured, and the limit that the median is held to."""

    what: str
    times: tuple[float, ...]
    limit: float | None = None

    @property
    def median(self) -> float:
        """The median [s]."""
        return statistics.median(self.times)

    @property
    def exceeded(self) -> bool:
        """Whether the median is over the limit."""
        return self.limit is not None and self.median > self.limit

    def row(self) -> tuple[str, str, str, str, str]:
        """As text: what, median, smallest and limit [ms], verdict."""
        limit = "-" if self.limit is None else f"{1000 * self.limit:.0f}"
        verdict = "-" if self.limit is None else "too slow" if self.exceeded else "ok"
        return self.what, f"{1000 * self.median:.1f}", f"{1000 * min(self.times):.1f}", limit, verdict


def of_process(command: Sequence[str], runs: int) -> tuple[float, ...]:
    """CPU times [s] of ``command``, run in a temporary folder; once before to warm the disk's cache."""
    times = []
    for k in range(runs + 1):
        with tempfile.TemporaryDirectory() as folder:
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode:
            sys.exit(f"{' '.join(command)} failed:\n{done.stderr}")
        if k:
            times.append(after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)
    return tuple(times)


def of_call(call: Callable[[], object], runs: int) -> tuple[float, ...]:
    """CPU times [s] of ``call`` in this process; once before, so that imports are not measured."""
    times = []
    for k in range(runs + 1):
        start = time.process_time()
        call()
        if k:
            times.append(time.process_time() - start)
    return tuple(times)


def measured(robot: str, runs: int) -> list[Timing]:
    """All that is measured, for ``robot``."""
    from robodyn.kernels.generate import generate, program
    from robodyn.robot import load

    arm = load(robot, warn=lambda _: None)
    every = generate(arm)
    names = tuple(every.counts)
    command = [sys.executable, "-m", "robodyn", "gen", robot, "-o", "out"]
    return [
        Timing(f"robodyn gen {robot}, the whole process", of_process(command, runs), PROCESS_LIMIT),
        Timing(
            "model and passes, inverse_dynamics",
            of_call(lambda: program(arm, "inverse_dynamics"), runs),
            MODEL_LIMIT,
        ),
        Timing(f"model and passes, all {len(names)} functions", of_call(lambda: generate(arm), runs)),
        Timing("text of all files", of_call(every.files, runs)),
        Timing("reading the description", of_call(lambda: load(robot, warn=lambda _: None), runs)),
    ]


def long_arm(joints: int) -> str:
    """The description of an arm of so many joints; every fifth axis is parallel to the one before it."""
    lines = [f"name: arm{joints}", "links:"]
    for i in range(joints):
        alpha, a, d = ("pi/2", "0", "-pi/2", "pi/2", "-pi/2")[i % 5], i % 3 / 10, i % 2 / 10
        com = [(1 + i % 7) / 100, (2 - i % 5) / 100, (3 - i % 4) / 100]
        moments = f"xx: {(40 + i % 9) / 100}, yy: {(45 + i % 7) / 100}, zz: {(50 - i % 5) / 100}"
        lines += [
            "  - joint: revolute",
            f"    alpha: {alpha}\n    a: {a}\n    d: {d}",
            f"    mass: {1 + i % 5}\n    com: {com}",
            f"    inertia: {{{moments}, xy: 0.01, xz: -0.02, yz: 0.005}}",
        ]
    return "\n".join(lines) + "\n"


def measured_long(runs: int) -> tuple[list[Timing], int]:
    """The times, and the size of the C of both derivatives of the arm of 7 joints [bytes]."""
    from robodyn.dynamics.functions import FUNCTIONS
    from robodyn.kernels.generate import Options, generate
    from robodyn.robot import load

    timings = []
    with tempfile.TemporaryDirectory() as folder:
        for arm, which, limit in LONG:
            path, functions = arm, which
            if isinstance(arm, int):
                path = str(Path(folder) / f"arm{arm}.yaml")
                Path(path).write_text(long_arm(arm), encoding="utf-8")
            if which == "all but derivatives":
                functions = ",".join(name for name in FUNCTIONS if name not in (*DERIVATIVES, *NOT_OF_LONG))
            command = [sys.executable, "-m", "robodyn", "gen", str(path), "-o", "out"]
            command += ["--functions", functions, "--optimize", "fast"]
            joints = arm if isinstance(arm, int) else load(arm, warn=lambda _: None).n
            timings.append(Timing(f"{joints} joints, {which}", of_process(command, runs), limit))
    kernels = generate(load(SEVEN, warn=lambda _: None), Options(DERIVATIVES, optimize="fast"))
    return timings, len(kernels.files(("c",))[f"{SEVEN}.c"].encode())


def table(timings: Sequence[Timing]) -> str:
    """A table for people."""
    rows = [("CPU time [ms]", "median", "least", "limit", ""), *(timing.row() for timing in timings)]
    widths = [max(len(row[k]) for row in rows) for k in range(5)]
    return "\n".join(
        "  ".join(
            [row[0].ljust(widths[0]), *(cell.rjust(w) for cell, w in zip(row[1:], widths[1:], strict=True))]
        ).rstrip()
        for row in rows
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, print the table, and return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("robot", nargs="?", default="puma560", help="a bundled robot or a file")
    parser.add_argument("-n", "--runs", type=int, default=7, help="how often each is measured (default: 7)")
    parser.add_argument("--long", action="store_true", help="arms of 7, 30 and 100 joints")
    parser.add_argument("--check", action="store_true", help="exit 1 where a limit is exceeded")
    options = parser.parse_args(arguments)
    if options.runs < 1:
        parser.error("RUNS must be at least 1")
    size = 0
    if options.long:
        timings, size = measured_long(options.runs)
        print(table(timings))
        print(f"C of both derivatives of {SEVEN}: {size / 1000:.0f} kB, limit {TEXT_LIMIT / 1000:.0f} kB")
    else:
        timings = measured(options.robot, options.runs)
        print(table(timings))
    exceeded = size > TEXT_LIMIT or any(timing.exceeded for timing in timings)
    return 1 if options.check and exceeded else 0


if __name__ == "__main__":
    sys.exit(main())
