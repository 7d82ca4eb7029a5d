"""What it costs to work on many logs: overhead a piece, speed-up of processes, memory.

    python -m benchmarks.fleet.engine [--overhead] [--speed [--logs N] [--pairs K]] [--memory [--many N]]
                                      [--check]

``--overhead``: pieces that do nothing, in two processes of this machine: what each costs.
``--speed``: N logs are digested in this process and in two others, K times in turn: wall-clock times, and the
CPU time of all processes together, which says what the speed-up would be if nothing else ran here.
``--memory``: a fleet of ``--many`` small logs from its files to its result: the largest memory of all
processes together (proportional set sizes, sampled), and how it goes on from the first thousand logs.

All three without any option. With ``--check`` the exit code is 1 where a limit is missed.
"""

from __future__ import annotations

import argparse
import os
import resource
import statistics
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np

from robodyn.cluster import Done, open_cluster
from robodyn.fleet.run import DIGESTING, run_fleet
from robodyn.fleet.sources.fleet import ArmType, Fleet, LogFile
from robodyn.fleet.work import digest_log
from robodyn.formats.loading import load, text_of
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.content import digest
from robodyn.logs.log import Log

#: [s] A piece of work may cost so much beside its own work; [-] two processes are so much faster; [bytes] all
#: processes together need less.
OVERHEAD_LIMIT, SPEED_LIMIT, MEMORY_LIMIT = 0.05, 1.8, 1.5e9
#: The arm of the logs to be digested, how long they are [s], and how many samples a second they have.
ARM, SECONDS, RATE = "ur5", 60.0, 250.0
#: The same of the small logs, of which there are so many a unit.
SMALL_ARM, SMALL_SECONDS, SMALL_RATE, LOGS_A_UNIT = "stanford_3dof", 4.0, 100.0, 10
DAY = 86400.0


def nothing(k: int) -> int:
    """The smallest piece of work."""
    return k


def write_log(path: Path, arm: str, seconds: float, rate: float, seed: int) -> None:
    """A log of an ``arm`` with friction and noise."""
    rng = np.random.default_rng(seed)
    robot = load(arm)
    n, t = robot.n, np.arange(int(seconds * rate)) / rate
    ranges = ((0.0, 6.0), (0.8, 2.5), (0.05, 0.25))
    phase, speed, size = (rng.uniform(low, high, (3, n)) for low, high in ranges)
    angle = speed[:, None] * t[None, :, None] + phase[:, None]
    q = (size[:, None] * np.sin(angle)).sum(axis=0) + 0.8
    qd = ((size * speed)[:, None] * np.cos(angle)).sum(axis=0)
    qdd = -((size * speed**2)[:, None] * np.sin(angle)).sum(axis=0)
    tau = Model(robot).torque(q, qd, qdd) + 5.0 * qd + 3.0 * np.tanh(qd / 0.01)
    path.write_text(Log(t, q, None, None, tau + 0.05 * rng.standard_normal(tau.shape)).csv())


def cpu() -> float:
    """CPU time [s] of this process and of those that it has waited for."""
    return sum(
        usage.ru_utime + usage.ru_stime
        for usage in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    )


def overhead(count: int) -> bool:
    """Pieces that do nothing."""
    with open_cluster("local:2") as cluster:
        list(cluster.each(nothing, ((k, (k,)) for k in range(100))))
        start, own = time.perf_counter(), time.process_time()
        done = sum(1 for _ in cluster.each(nothing, ((k, (k,)) for k in range(count))))
        wall, own = time.perf_counter() - start, time.process_time() - own
    assert done == count
    print(f"overhead: {1e3 * wall / count:.1f} ms a piece, {1e3 * own / count:.1f} ms of it CPU here")
    return wall / count < OVERHEAD_LIMIT


def digested(on: str, arm: ArmType, logs: list[tuple[str, str]]) -> tuple[float, float, list[bytes]]:
    """Wall-clock and CPU time [s] of the digests of ``logs`` (paths and hashes), without the start of
    processes; and the digests."""
    before, tasks = cpu(), [((path,), (content,)) for path, content in logs]
    with open_cluster(on) as cluster:
        warm = [result for _, result in cluster.each(digest_log, ((k, (arm, *tasks[0])) for k in range(6)))]
        assert all(isinstance(result, Done) for result in warm), warm
        start = time.perf_counter()
        results = dict(cluster.each(digest_log, ((k, (arm, *task)) for k, task in enumerate(tasks))))
        wall = time.perf_counter() - start
    return wall, cpu() - before, [results[k].value for k in range(len(logs))]


def speed(count: int, pairs: int) -> bool:
    """One process beside two."""
    with tempfile.TemporaryDirectory() as name:
        arm, logs = ArmType(ARM, ARM, text_of(ARM)), []
        for k in range(count):
            path = Path(name) / f"{k}.csv"
            write_log(path, ARM, SECONDS, RATE, k)
            logs.append((str(path), digest(str(path))))
        ratios = []
        for _ in range(pairs):
            wall_1, cpu_1, digests_1 = digested("here", arm, logs)
            wall_2, cpu_2, digests_2 = digested("local:2", arm, logs)
            assert digests_1 == digests_2, "the digests differ"
            ratios.append(wall_1 / wall_2)
            print(
                f"speed: {count} logs of {SECONDS:g} s: {wall_1:.1f} s in one process, "
                f"{wall_2:.1f} s in two: {ratios[-1]:.2f} times as fast; CPU {1e3 * cpu_1 / count:.0f} and "
                f"{1e3 * cpu_2 / count:.0f} ms a log, with the start of processes"
            )
    print(f"speed: median {statistics.median(ratios):.2f}")
    return statistics.median(ratios) >= SPEED_LIMIT


def tree_memory(root: int) -> int:
    """Proportional set size [bytes] of a process and all below it."""
    parents: dict[int, list[int]] = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
            except OSError:
                continue
            parents.setdefault(parent, []).append(int(entry.name))
    total, waiting = 0, [root]
    while waiting:
        process = waiting.pop()
        waiting += parents.get(process, [])
        try:
            lines = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
        except OSError:
            continue
        total += sum(1024 * int(line.split()[1]) for line in lines if line.startswith("Pss:"))
    return total


@contextmanager
def sampled() -> Iterator[list[tuple[float, int]]]:
    """Times and memory of this process and those below it, while the context lasts."""
    samples: list[tuple[float, int]] = []
    ended = threading.Event()

    def sample() -> None:
        while not ended.wait(0.5):
            samples.append((time.perf_counter(), tree_memory(os.getpid())))

    thread = threading.Thread(target=sample)
    thread.start()
    try:
        yield samples
    finally:
        ended.set()
        thread.join()


def small_logs(folder: Path, count: int) -> Fleet:
    """A fleet of ``count`` logs: hundred are computed, the others differ from them in a digit of a time."""
    arm = ArmType(SMALL_ARM, SMALL_ARM, text_of(SMALL_ARM))
    texts = []
    for k in range(min(count, 100)):
        write_log(folder / "log.csv", SMALL_ARM, SMALL_SECONDS, SMALL_RATE, k)
        texts.append((folder / "log.csv").read_text())
    logs = []
    for k in range(count):
        path = folder / f"{k}.csv"
        head, _, rest = texts[k % 100].partition("\n")
        first, comma, others = rest.partition(",")
        path.write_text(f"{head}\n{float(first) + 1e-9 * (k // 100)!r}{comma}{others}")
        unit, date = divmod(k, LOGS_A_UNIT)
        logs.append(LogFile(str(path), SMALL_ARM, f"unit {unit:05d}", 30 * DAY * date, {}))
    return Fleet("many", {SMALL_ARM: arm}, tuple(logs))


def memory(count: int) -> bool:
    """A fleet of many small logs."""
    with tempfile.TemporaryDirectory() as name:
        fleet = small_logs(Path(name), count)
        digesting: list[tuple[float, int]] = []

        def progress(stage: str, done: int, _: int) -> None:
            if stage == DIGESTING:
                digesting.append((time.perf_counter(), done))

        start, before = time.perf_counter(), cpu()
        with sampled() as samples:
            result = run_fleet(fleet, Path(name) / "out", "local:2", progress=progress)
        wall = time.perf_counter() - start
        print(
            f"memory: {count} logs of {SMALL_SECONDS:g} s, {len(result.units)} units, {len(result.unused)} "
            f"logs not used: {wall:.0f} s, {1e3 * (cpu() - before) / count:.0f} ms of CPU a log"
        )
        for share in (0.1, 0.5, 1.0):
            until = next(at for at, done in digesting if done >= share * count)
            largest = max(size for at, size in samples if at <= until)
            print(f"memory: {largest / 1e6:.0f} MB until {share * count:.0f} logs are digested")
        largest = max(size for _, size in samples)
        print(f"memory: {largest / 1e6:.0f} MB at most")
        again, before = time.perf_counter(), cpu()
        run_fleet(replace(fleet), Path(name) / "out", "local:2")
        print(f"memory: a second run: {time.perf_counter() - again:.1f} s, {cpu() - before:.1f} s of CPU")
    return largest < MEMORY_LIMIT


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    for name in ("overhead", "speed", "memory", "check"):
        parser.add_argument(f"--{name}", action="store_true")
    parser.add_argument("--logs", type=int, default=100)
    parser.add_argument("--many", type=int, default=10_000)
    parser.add_argument("--pairs", type=int, default=3)
    options = parser.parse_args()
    everything = not (options.overhead or options.speed or options.memory)
    results = []
    if options.overhead or everything:
        results.append(overhead(2000))
    if options.speed or everything:
        results.append(speed(options.logs, options.pairs))
    if options.memory or everything:
        results.append(memory(options.many))
    return int(options.check and not all(results))


if __name__ == "__main__":
    sys.exit(main())
