"""The search over variants: gauges, forms, frames, origins, chains.

Rounds of annealing walks from the best variants so far (and now and then from the plain one), each followed
by a descent over all neighbours. A walk is so many steps, not so many seconds: with the same seed, number of
rounds and of processes (a round has a walk for each) the same is found on any machine.
"""

from __future__ import annotations

import math
import random
import time
from collections.abc import Callable
from dataclasses import dataclass

from robodyn.counts.objective import Objective, operations_of
from robodyn.ir.program import Program
from robodyn.optimize.fast import suited_variant
from robodyn.optimize.programs import Choice, build
from robodyn.optimize.variant import Variant
from robodyn.passes import FRESH, run
from robodyn.robot.model import Robot
from robodyn.search.space import Candidates, Sketch, Space
from robodyn.toolchain.workers import Workers

#: How many results a search hands back, and how many of each other's values they have at most.
KEPT = 10
ALIKE = 0.95

#: Steps of a walk: with a millisecond or two a step, a few seconds.
STEPS = 1500

Result = tuple[float, Choice, Program]
#: Variants with their costs and sketches.
Known = dict[Variant, tuple[float, Sketch]]


@dataclass(frozen=True, slots=True)
class Progress:
    """What a search tells: seconds gone, rounds done, variants tried, the best cost."""

    seconds: float
    round: int
    tried: int
    best: float


def search(
    robot: Robot,
    *,
    seconds: float = 60.0,
    seed: int = 0,
    objective: Objective | None = None,
    progress: Callable[[Progress], None] | None = None,
    processes: int = 2,
    rounds: int | None = None,
    steps: int = STEPS,
) -> list[Result]:
    """The best formulation variants the inverse dynamics of ``robot`` that are found in ``seconds`` (or in so
    many ``rounds``), best first and different from one another: cost, choice, program after all passes.

    The programs are those of the passes; that they equal the plain recursion is for the caller to prove
    (:func:`~robodyn.dynamics.equality.equals_recursion`).
    """
    objective = objective or Objective()
    began = time.monotonic()
    deadline = began + seconds if rounds is None else math.inf
    space, candidates = Space(robot), Candidates(robot, objective)
    plain = space.fitted(suited_variant(space.arm))
    judged = candidates.judged(plain)
    assert judged is not None, "the plain variant suits every arm"
    known: Known = {plain: judged}
    tried, done = 1, 0
    with Workers(processes) as workers:
        while (rounds is None or done < rounds) and (time.monotonic() < deadline or not done):
            pool = diverse(known, KEPT)
            tasks = []
            for k in range(processes):
                rng = random.Random(f"{seed} {done} {k}")
                origin = plain if done < 2 or rng.random() < 0.2 else _drawn(pool, rng)
                heat = rng.choice((1.0, 2.0, 3.0)) if origin is not plain else 3.0
                left = deadline - time.monotonic()
                tasks.append((robot, objective, origin, f"{seed} {done} {k}", heat, steps, left))
            for discovered, count in workers.run(walk, tasks):
                known.update(discovered)
                tried += count
            known = dict(sorted(known.items(), key=_by_cost)[:2000])
            done += 1
            if progress is not None:
                progress(Progress(time.monotonic() - began, done, tried, min(known.values())[0]))
    return _results(robot, objective, known)


def _drawn(pool: list[tuple[float, Variant]], rng: random.Random) -> Variant:
    """One of the best, the better the likelier."""
    return pool[min(int(rng.expovariate(0.5)), len(pool) - 1)][1]


_CANDIDATES: dict[tuple[str, Objective], tuple[Robot, Candidates, Space]] = {}


def walk(
    robot: Robot, objective: Objective, origin: Variant, seed: str, heat: float, length: int, seconds: float
) -> tuple[Known, int]:
    """One walk from ``origin`` of so many steps, and the descent from the best it saw; the best variants, and
    how many were tried."""
    key = (robot.name, objective)
    if key not in _CANDIDATES or _CANDIDATES[key][0] != robot:
        _CANDIDATES.clear()
        _CANDIDATES[key] = (robot, Candidates(robot, objective), Space(robot))
    _, candidates, space = _CANDIDATES[key]
    deadline = time.monotonic() + seconds
    rng = random.Random(seed)
    cost = candidates.cost(origin)
    assert cost is not None
    here, at = origin, cost
    best, best_cost = origin, cost
    seen = {origin: cost}
    steps = tries = 0
    while steps < length and tries < 20 * length and time.monotonic() < deadline:
        tries += 1
        other = space.random_neighbour(here, rng)
        if other == here:
            continue
        there = candidates.cost(other)
        if there is None:
            continue
        steps += 1
        temperature = heat * (0.1 ** (steps / length))
        if there <= at or rng.random() < math.exp((at - there) / temperature):
            here, at = other, there
            seen[here] = at
            if at < best_cost:
                best, best_cost = here, at
    moved = True
    while moved and time.monotonic() < deadline:
        moved = False
        for other in space.neighbours(best):
            there = candidates.cost(other)
            steps += 1
            if there is not None and there <= best_cost and other not in seen:
                seen[other] = there
                if there < best_cost:
                    moved = True
                    best, best_cost = other, there
                    break
            if steps % 64 == 0 and time.monotonic() > deadline:
                break
    top = sorted(seen, key=seen.__getitem__)[:100]
    judged = {variant: candidates.judged(variant) for variant in top}
    return {variant: known for variant, known in judged.items() if known is not None}, steps


def _by_cost(item: tuple[Variant, tuple[float, Sketch]]) -> float:
    return item[1][0]


def diverse(known: Known, count: int) -> list[tuple[float, Variant]]:
    """The best ``count`` of ``known`` that differ from one another."""
    chosen: list[tuple[float, Variant]] = []
    sketches: list[frozenset[int]] = []
    for variant, (cost, sketch) in sorted(known.items(), key=_by_cost):
        values = frozenset(sketch)
        if all(_alike(values, other) < ALIKE for other in sketches):
            chosen.append((cost, variant))
            sketches.append(values)
            if len(chosen) == count:
                break
    return chosen


def _alike(one: frozenset[int], other: frozenset[int]) -> float:
    """The share of values that two sketches have in common, of those that both could have."""
    reach = min(max(one, default=0), max(other, default=0))
    values = {value for value in one | other if value <= reach}
    return len(one & other) / len(values) if values else 1.0


def _results(robot: Robot, objective: Objective, known: Known) -> list[Result]:
    """Programs of the best, by their cost after the passes."""
    results: dict[object, Result] = {}
    for _, variant in diverse(known, 4 * KEPT):
        choice = Choice(variant=variant)
        program = run(build(robot, "inverse_dynamics", choice), FRESH)
        cost = objective.cost(operations_of(program))
        results.setdefault(program.operations, (cost, choice, program))
    return sorted(results.values(), key=lambda result: result[0])[:KEPT]
