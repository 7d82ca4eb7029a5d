"""A search with many seeds, each an independent piece of work: the best of them all is proven and kept."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from robodyn.cluster import Done, open_cluster
from robodyn.counts.objective import Objective
from robodyn.errors import ToolError
from robodyn.kernels.generate import Options
from robodyn.kernels.generate import program as generated
from robodyn.optimize.records import Record, parse_record
from robodyn.robot.model import Robot
from robodyn.search.improve import BUDGET, Stage, check_search, cost, improved, keep, known_records, proved

_log = logging.getLogger("robodyn.search")


def best_of_seeds(
    robot: Robot,
    on: str,
    seeds: Iterable[int],
    *,
    level: Stage = "full",
    function: str = "inverse_dynamics",
    seconds: float | None = None,
    objective: Objective | None = None,
    folders: Sequence[Path] = (),
    progress: Callable[[int, float], object] = lambda done, best: None,
) -> Record:
    """The best record of ``function`` that searches with these ``seeds`` find, each in ``seconds`` of its
    own, ``on`` what :func:`~robodyn.cluster.open_cluster` takes. ``progress`` is told how many are done, and
    the least cost so far.

    All start from the records that are known here, and what they find is compared by cost and, where that is
    equal, by its text: which of them came first, and where, does not matter. The best is proven here, whoever
    worked, and goes into the cache.

    Raises
    ------
    InputError: an unknown function or level, a budget that is none, or ``on`` is no place.
    ToolError: there is nothing to work with, or what came back is not what the recursion is.
    """
    check_search(level, function, seconds)
    objective = objective or Objective()
    recursion = generated(robot, function, Options((function,), optimize="fast"))
    known = known_records(robot, function, objective, folders, recursion)
    budget = BUDGET[level] if seconds is None else seconds
    starts = tuple(record.text() for record in known)
    records: list[Record] = [*known]
    error: Exception | None = None
    with open_cluster(on) as cluster:
        tasks = ((seed, (robot, level, function, budget, seed, objective, starts)) for seed in seeds)
        for k, (seed, outcome) in enumerate(cluster.each(searched, tasks)):
            if isinstance(outcome, Done):
                records.append(parse_record(outcome.value, f"seed {seed}"))
            else:
                error = outcome.error
                _log.warning("seed %d: %s", seed, error)
            progress(k + 1, min((cost(each.program, objective) for each in records), default=float("inf")))
    for record in sorted(records, key=lambda each: (cost(each.program, objective), each.text())):
        proven = proved(robot, function, record.program, recursion, objective, record.origin)
        if proven is not None:
            keep(proven)
            return proven
    raise error or ToolError("no search has come to a program that is what the recursion is")


def searched(
    robot: Robot,
    level: Stage,
    function: str,
    seconds: float,
    seed: int,
    objective: Objective,
    starts: Sequence[str],
) -> str:
    """The text of the record that one seed finds, in one process, from the records ``starts``.

    Raises
    ------
    ToolError: there is no C compiler.
    """
    record = improved(
        robot,
        level=level,
        function=function,
        seconds=seconds,
        seed=seed,
        objective=objective,
        processes=1,
        resume=False,
        known=[parse_record(text, "a start") for text in starts],
    )
    return record.text()
