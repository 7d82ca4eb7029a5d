"""Check, time and count runners: the harness in ``native/harness.c``, and what is read off it."""

from __future__ import annotations

import math
import shutil
import struct
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.peers.building import Lacking, Source, program
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class States:
    """The states of a race, each array [N, n]."""

    q: Floats
    qd: Floats
    qdd: Floats

    def write(self, path: Path) -> None:
        """As the harness reads them."""
        head = struct.pack("=qq", *self.q.shape)
        path.write_bytes(
            head + b"".join(np.ascontiguousarray(x).tobytes() for x in (self.q, self.qd, self.qdd))
        )


def random_states(n: int, count: int = 256, seed: int = 7) -> States:
    """Joint angles within half a turn to each side, velocities to 3, accelerations to 10 (SI)."""
    random = np.random.default_rng(seed)
    q, qd, qdd = (random.uniform(-limit, limit, (count, n)) for limit in (math.pi, 3.0, 10.0))
    return States(q, qd, qdd)


class Race:
    """Runners on the states of a folder, which has ``states.bin`` and ``arm.txt``."""

    def __init__(self, folder: Path, harness: Path) -> None:
        self.folder, self.harness = folder, harness

    def results(self, library: Path, shape: tuple[int, int]) -> Floats:
        """What a runner computes [N, n].

        Raises
        ------
        Lacking: it cannot be set up.
        """
        out = self.folder / "results.bin"
        self._run(["check", *self._where, str(out), str(library)])
        return np.frombuffer(out.read_bytes()).reshape(shape)

    def times(self, libraries: Sequence[Path], rounds: int, block_ns: float = 2e5) -> Floats:
        """Nanoseconds a state [rounds, runners], interleaved in one process."""
        output = self._run(["time", *self._where, str(rounds), str(block_ns), *map(str, libraries)])
        return np.array([[float(x) for x in line.split()] for line in output.splitlines()])

    def instructions(self, library: Path, states: int) -> float | None:
        """Instructions a state, the loop around it included; None where there is no valgrind."""
        valgrind = shutil.which("valgrind")
        if valgrind is None:
            return None
        counts = [self._counted(valgrind, library, passes) for passes in (2, 6)]
        return (counts[1] - counts[0]) / (4 * states)

    def _counted(self, valgrind: str, library: Path, passes: int) -> int:
        out = self.folder / "callgrind.out"
        command = [valgrind, "--tool=callgrind", f"--callgrind-out-file={out}", str(self.harness)]
        command += ["count", *self._where, str(passes), str(library)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        totals = [line for line in out.read_text().splitlines() if line.startswith(("totals:", "summary:"))]
        if done.returncode or not totals:
            raise Lacking(f"valgrind: {done.stderr.strip().splitlines()[-1]}")
        return int(totals[0].split()[1])

    @property
    def _where(self) -> tuple[str, str]:
        return str(self.folder / "states.bin"), str(self.folder)

    def _run(self, arguments: Sequence[str]) -> str:
        done = subprocess.run([str(self.harness), *arguments], capture_output=True, text=True, check=False)
        if done.returncode:
            raise Lacking(f"does not run: {done.stderr.strip()[-300:] or f'exit code {done.returncode}'}")
        return done.stdout


def harness(folder: Path) -> Path:
    """The harness, compiled."""
    return program(folder / "harness", Source(("harness.c",), libraries=("-ldl",)))


@dataclass(frozen=True, slots=True)
class Ratio:
    """The median of ratios taken round by round, and an interval that has it with 95 %."""

    median: float
    low: float
    high: float

    def to_list(self) -> list[float]:
        """For JSON."""
        return [self.median, self.low, self.high]


def paired(times: Any, reference: Any) -> Ratio:
    """Ratio of ``times`` to ``reference`` [rounds], both of the same rounds.

    The interval is that of the median of any distribution, by order statistics.
    """
    ratios = np.sort(np.asarray(times, float) / np.asarray(reference, float))
    count = len(ratios)
    reach = 0.98 * math.sqrt(count)
    low = max(0, math.floor(count / 2 - reach))
    high = min(count - 1, math.ceil(count / 2 + reach))
    return Ratio(float(np.median(ratios)), float(ratios[low]), float(ratios[high]))
