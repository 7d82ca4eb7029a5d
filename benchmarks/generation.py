"""How long it takes from a robot description to its kernels, in seconds and milliseconds of CPU.

    python benchmarks/generation.py [ROBOT] [-n RUNS] [--check]

Measured is the CPU time, of user and system, of ``robodyn gen ROBOT`` as a whole process (start of Python
and writing of the files included), and within a process that of the model and the passes alone. The median of
RUNS is what counts; the smallest stands beside it. With ``--check`` the exit code is 1 where a limit is
exceeded: half a second for the process, 50 ms for the model and the passes of the inverse dynamics.
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

PROCESS_LIMIT = 0.5
MODEL_LIMIT = 0.05


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
    parser.add_argument("--check", action="store_true", help="exit 1 where a limit is exceeded")
    options = parser.parse_args(arguments)
    if options.runs < 1:
        parser.error("RUNS must be at least 1")
    timings = measured(options.robot, options.runs)
    print(table(timings))
    return 1 if options.check and any(timing.exceeded for timing in timings) else 0


if __name__ == "__main__":
    sys.exit(main())
