"""Walks from several programs at once, in threads, the best ones going on."""

from __future__ import annotations

import random
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from robodyn.counts.objective import Objective, operations_of
from robodyn.ir.program import Program
from robodyn.passes import units
from robodyn.search.network import NoWalk
from robodyn.search.walk import CHAIN, FUSED, SUM, Walk, library

#: Steps of one call into C: a tenth of a second or two, for interrupts and deadlines to be seen.
_CHUNK = 1000
#: How long is waited for a thread that is to stop [s].
_LAST = 2.0
#: Programs that stay in the race.
_POOL = 12
#: Temperatures of walks. Below 0.2 a walk soon stands; above 0.35 it drifts away.
_TEMPERATURES = (0.2, 0.25, 0.25, 0.3, 0.35)


@dataclass(frozen=True, slots=True)
class Climbed:
    """What a climb tells: seconds gone, steps taken so far in all walks, the least cost and its program."""

    seconds: float
    steps: int
    best: float
    program: Program


def climb(
    programs: Sequence[Program],
    *,
    seconds: float,
    seed: int = 0,
    objective: Objective | None = None,
    threads: int = 2,
    progress: Callable[[Climbed], None] | None = None,
) -> list[Program]:
    """Programs that compute what ``programs`` do with less, best first; among them the best given.

    First each of ``programs`` is walked from for a while, then the best and now and then one of the others.

    Raises
    ------
    ToolError: there is no C compiler.
    """
    library()  # compiled here, where Ctrl-C is heard
    threads = max(1, threads)
    race = _Race(programs, seconds, seed, objective or Objective(), threads, progress)
    workers = [threading.Thread(target=race.run, args=(k,), daemon=True) for k in range(threads)]
    for worker in workers:
        worker.start()
    try:
        for worker in workers:
            while worker.is_alive():
                worker.join(0.2)
                race.tell()
    except BaseException:
        race.stopped = True
        for worker in workers:  # they see it after their chunk of steps
            worker.join(_LAST)
        raise
    if race.error is not None:
        raise race.error
    return [program for _, _, program in race.pool]


class _Race:
    """The programs in the race, and when it ends; shared among threads."""

    def __init__(
        self,
        programs: Sequence[Program],
        seconds: float,
        seed: int,
        objective: Objective,
        threads: int,
        progress: Callable[[Climbed], None] | None,
    ) -> None:
        self.objective, self.progress = objective, progress
        self.began = time.monotonic()
        self.end = self.began + seconds
        self.chance = random.Random(f"climb {seed}")
        self.lock = threading.Lock()
        self.stopped, self.steps, self.walks = False, 0, 0
        self.fixed: list[Program] = []  # those that no walk can begin from
        self.error: BaseException | None = None
        self.pool: list[tuple[float, int, Program]] = []
        for program in programs:
            self.add(program)
        self.waiting = [program for _, _, program in self.pool]
        # Half of the time goes to trying each start, and a walk is never so short that it shows nothing.
        self.first = max(2.0, 0.5 * seconds * threads / max(1, len(self.waiting)))
        self.later = max(5.0, seconds / 12)

    def cost(self, program: Program) -> float:
        return self.objective.cost(operations_of(program))

    def add(self, program: Program) -> None:
        """Put ``program`` into the race; the worst falls out where there are too many."""
        self.pool.append((self.cost(program), len(self.pool) + self.walks, program))
        self.pool.sort(key=lambda entry: entry[:2])
        del self.pool[_POOL:]

    def tell(self) -> None:
        if self.progress is not None:
            with self.lock:  # a list that is being sorted looks empty
                best, _, program = self.pool[0]
            self.progress(Climbed(time.monotonic() - self.began, self.steps, best, program))

    def run(self, worker: int) -> None:
        """One thread: walk after walk until the end."""
        try:
            while not self.stopped and time.monotonic() < self.end:
                self._walk(*self._next())
        except BaseException as error:
            self.error = error
            self.stopped = True

    def _next(self) -> tuple[Program, float, int, float]:
        with self.lock:
            self.walks += 1
            seed = self.chance.randrange(1, 1 << 31)
            temperature = self.chance.choice(_TEMPERATURES)
            if self.waiting:
                return self.waiting.pop(0), self.first, seed, 0.25
            pool = [program for _, _, program in self.pool if all(program is not x for x in self.fixed)]
            if not pool:
                self.stopped = True
                return self.pool[0][2], 0.0, seed, temperature
            place = 0 if self.chance.random() < 0.6 else self.chance.randrange(min(5, len(pool)))
            return pool[place], self.later, seed, temperature

    def _walk(self, program: Program, seconds: float, seed: int, temperature: float) -> None:
        kind, weights, scale = _inner(self.objective)
        try:
            walk = Walk([program], seed=seed, objective=kind, weights=weights)
        except NoWalk:
            with self.lock:
                self.fixed.append(program)
            return
        end = min(self.end, time.monotonic() + seconds)
        while not self.stopped and time.monotonic() < end:
            walk.run(_CHUNK, temperature * scale)
            self.steps += _CHUNK
        try:
            best = walk.best()
        except NoWalk:  # a constant grew beyond all bounds: that walk is lost
            return
        # A walk changes one value at a time; units change a whole chain of them.
        best = min(best, units(best), key=self.cost)
        with self.lock:
            if self.cost(best) < self.cost(program):
                self.add(best)


def _inner(objective: Objective) -> tuple[int, tuple[int, int], float]:
    """An objective as a walk has it: its kind, what an addition and a multiplication cost, and the cost that
    counts as one step of temperature."""
    if objective.name == "weighted":
        costs = objective.costs
        cheaper = min(costs.add, costs.mul)
        weights = (round(4 * costs.add / cheaper), round(4 * costs.mul / cheaper))
        return (SUM if costs.fma is None else FUSED), weights, 4.0
    kind = {"fma": FUSED, "depth": CHAIN}.get(objective.name, SUM)
    return kind, ((1, 3) if objective.name == "mul" else (1, 1)), 1.0
