"""Schedules of chapter 4: speed-up, efficiency and time on p processors."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from typing import Any, Final

from robodyn.schedule import TaskGraph, critical_path_order, general_graph, list_schedule, lower_bound
from robodyn.schedule.branch_and_bound import one_processor_a_joint
from robodyn.thesis.claims.arms import FLOP_US, LINKS, Arms, Outcome
from robodyn.thesis.claims.tasks import MOST, SIZES
from robodyn.thesis.judge import UNIT_MS, rival_graph
from robodyn.thesis.printed import (
    LEVELS_SIX_LINK,
    LEVELS_STANFORD,
    TASK_MS,
    TIMES_OTHERS,
    TIMES_STANFORD,
    table_2_10,
)

#: Steps of the branch and bound for one processor a joint: as many on every machine.
_STEPS: Final = 200
#: The efficiency that section 4.5 speaks of [%].
HIGH: Final = 98
KASAHARA: Final = TIMES_OTHERS["Kasahara and Narita 1985"]


def best_levels(graph: TaskGraph, p: int) -> int:
    """Levels critical path first."""
    return list_schedule(graph, p, critical_path_order(graph)).levels


def efficiency_share(graph: TaskGraph, levels: int, p: int) -> float:
    """The efficiency [%] of so many levels on ``p`` processors."""
    return round(100 * len(graph) / levels / p, 2)


def _most_above(graph: TaskGraph) -> int:
    """The most processors up to which all have an efficiency above 98 %, critical path first."""
    shares = ((p, efficiency_share(graph, best_levels(graph, p), p)) for p in itertools.count(1))
    return max(p for p, _ in itertools.takewhile(lambda one: one[1] > HIGH, shares))


def _less(ours: float, theirs: float) -> float:
    return round(100 * (1 - ours / theirs), 1)


def luh_and_lin(arms: Arms) -> Outcome:
    """The speed-up of Luh and Lin by Table 4.8, and that of our tasks with one processor a joint."""
    steps = itertools.count()
    graph = arms.stanford_by_rule
    best = one_processor_a_joint(graph, seconds=_STEPS, clock=lambda: float(next(steps)))
    times, levels = TIMES_OTHERS["Luh and Lin 1982"], best.schedule.levels
    by_table = round(times[1] / times[LINKS], 2)
    figures = {"by_table_4_8": by_table, "speedup": round(len(graph) / levels, 2), "tasks": len(graph)}
    return {**figures, "levels": levels, "bound_levels": best.lower_bound}, abs(by_table - 2.64) < 0.01


def critical_path_bound(_: Arms) -> Outcome:
    """The longest chain of Kasahara's tasks beside the least printed time [ms]."""
    graph = rival_graph()
    chain = lower_bound(graph, len(graph)) * UNIT_MS
    return {"chain_ms": round(chain, 2), "least_ms": min(KASAHARA.values())}, chain > 0


def speedup(arms: Arms) -> Outcome:
    """Speed-up, efficiency and idle time with 13 processors."""
    schedule = list_schedule(arms.six, MOST)
    figures = {
        "speedup": round(schedule.speedup, 4),
        "efficiency_pct": round(100 * schedule.efficiency, 2),
        "idle_pct": round(100 * (1 - schedule.efficiency), 2),
        "levels": schedule.levels,
    }
    same = abs(figures["speedup"] - 8.55) < 0.01
    return figures, same and (figures["efficiency_pct"], figures["idle_pct"]) == (65.81, 34.19)


def fewest_processors(arms: Arms) -> Outcome:
    """The fewest processors that reach the longest chain, critical path first."""
    graph, levels = arms.six, arms.six.critical_path
    fewest = next((p for p in range(1, MOST) if best_levels(graph, p) == levels), MOST)
    share = efficiency_share(graph, levels, fewest)
    return {"processors": fewest, "efficiency_pct": share, "levels": levels}, fewest == MOST


def strategy(arms: Arms) -> Outcome:
    """Processors for which the list of section 4.3.3 has other levels than the printed schedule."""
    apart: dict[str, Any] = {}
    for name, graph, printed, most in (
        ("six_link", arms.six, LEVELS_SIX_LINK, 9), ("stanford", arms.stanford_printed, LEVELS_STANFORD, 8)
    ):  # fmt: skip
        ours = {p: list_schedule(graph, p).levels for p in printed if 1 < p <= most}
        apart[name] = {str(p): [levels, printed[p]] for p, levels in ours.items() if levels != printed[p]}
    return apart, not any(apart.values())


def six_link_efficiency(arms: Arms) -> Outcome:
    """Efficiencies of our schedules on one to six processors."""
    graph = arms.six
    least = min(efficiency_share(graph, list_schedule(graph, p).levels, p) for p in range(1, 7))
    speedups = [round(len(graph) / LEVELS_SIX_LINK[p], 2) for p in range(2, 7)]
    return {"least_pct": least, "speedups": speedups}, least > HIGH


def stanford_efficiency(arms: Arms) -> Outcome:
    """The same of the Stanford arm's tasks by rule on one to four."""
    graph = arms.stanford_by_rule
    levels = [list_schedule(graph, p).levels for p in range(1, 5)]
    shares = [efficiency_share(graph, count, p) for p, count in enumerate(levels, 1)]
    return {"shares": shares, "levels": levels[1:]}, min(shares) > HIGH


def _beyond(graph: TaskGraph, printed: Mapping[int, int], processors: range) -> dict[str, Any]:
    """Gains in speed-up by another processor and efficiencies [%], by printed levels and at best."""
    return {
        "gain_pct": [round(100 * (printed[p - 1] / printed[p] - 1), 1) for p in processors],
        "efficiency_pct": [efficiency_share(graph, printed[p], p) for p in processors],
        "best_pct": [efficiency_share(graph, best_levels(graph, p), p) for p in processors],
    }


def beyond_six(arms: Arms) -> Outcome:
    """Seven to nine processors."""
    return _beyond(arms.six, LEVELS_SIX_LINK, range(7, 10)), None


def beyond_four(arms: Arms) -> Outcome:
    """Five to eight processors for the Stanford arm."""
    return _beyond(arms.stanford_printed, LEVELS_STANFORD, range(5, 9)), None


def six_ideal(arms: Arms) -> Outcome:
    """The most processors with an efficiency above 98 % for six joints."""
    most = _most_above(arms.six)
    return {"processors": most}, most == 6


def six_ideal_in_general(_: Arms) -> Outcome:
    """The same for two to nine joints."""
    most = [_most_above(general_graph(n)) for n in SIZES]
    return {"processors": most}, set(most) == {6}


def four_ideal(arms: Arms) -> Outcome:
    """The most processors with an efficiency above 98 % by the Stanford arm's printed levels."""
    shares = ((p, efficiency_share(arms.stanford_printed, n, p)) for p, n in LEVELS_STANFORD.items())
    most = max(p for p, _ in itertools.takewhile(lambda one: one[1] > HIGH, shares))
    return {"processors": most}, most == 4


def one_processor(_: Arms) -> Outcome:
    """468 operations at the rate of Table 4.8, and the operations of the thesis's own listing."""
    ms, least = LEVELS_STANFORD[1] * TASK_MS, min(LEVELS_STANFORD.values()) * TASK_MS
    listing = sum(table_2_10()["stanford_6"]["I"])
    listing_ms = listing * FLOP_US / 1e3
    figures = {"ms": round(ms, 2), "less_pct": _less(ms, KASAHARA[1]), "speedup": round(ms / least, 2)}
    figures |= {"listing": listing, "listing_ms": round(listing_ms, 1)}
    holds = figures["ms"] == TIMES_STANFORD[1] and ms < KASAHARA[1]
    return {**figures, "listing_speedup": round(listing_ms / least, 2)}, holds


def four_processors(_: Arms) -> Outcome:
    """39 levels beside the others' time."""
    ms = LEVELS_STANFORD[4] * TASK_MS
    figures = {"ms": round(ms, 3), "less_pct": _less(ms, KASAHARA[4])}
    return figures, abs(ms - TIMES_STANFORD[4]) < 0.01


def least_time_as_printed(_: Arms) -> Outcome:
    """The least of Table 4.8 by printed levels, and the fewest processors that have it."""
    fewest = min(LEVELS_STANFORD, key=lambda p: (LEVELS_STANFORD[p], p))
    ms = LEVELS_STANFORD[fewest] * TASK_MS
    figures = {"ms": round(ms, 3), "processors": fewest, "others_ms": min(KASAHARA.values())}
    return figures, fewest == 7 and abs(ms - 3.65) < 0.01


def least_time(arms: Arms) -> Outcome:
    """The least time of the Stanford arm's tasks, and the fewest processors that reach it."""
    levels = arms.stanford_printed.critical_path
    fewest = next(p for p in itertools.count(1) if best_levels(arms.stanford_printed, p) == levels)
    figures = {"ms": round(levels * TASK_MS, 3), "levels": levels, "processors": fewest}
    return figures, levels == min(LEVELS_STANFORD.values())


def reasons_of_the_gain(_: Arms) -> Outcome:
    """3.65/5.60 as a product: less work, and more work done at once."""
    ours, theirs = min(TIMES_STANFORD.values()), min(KASAHARA.values())
    work = TIMES_STANFORD[1] / KASAHARA[1]
    speedups = TIMES_STANFORD[1] / ours, KASAHARA[1] / theirs
    concurrency = round(speedups[1] / speedups[0], 2)
    figures: dict[str, Any] = {"work": round(work, 2), "speedups": [round(x, 2) for x in speedups]}
    figures |= {"concurrency": concurrency, "time": round(ours / theirs, 2)}
    return figures, concurrency < 1 and work < 1


def less_than_all(_: Arms) -> Outcome:
    """The least times of the columns of Table 4.8."""
    others = sorted(min(times.values()) for times in TIMES_OTHERS.values())
    return {"others_ms": others}, min(TIMES_STANFORD.values()) < others[0]


def customising(_: Arms) -> Outcome:
    """Levels of any six joints and of the Stanford arm at two to eight processors, as printed."""
    pairs = {str(p): [LEVELS_SIX_LINK[p], LEVELS_STANFORD[p]] for p in range(2, 9)}
    return {"levels": pairs}, all(stanford < any_arm for any_arm, stanford in pairs.values())


def least_after_customising(arms: Arms) -> Outcome:
    """The least levels that are printed of both, and the longest chains."""
    least = [min(LEVELS_SIX_LINK.values()), min(LEVELS_STANFORD.values())]
    chains = [arms.six.critical_path, arms.stanford_printed.critical_path]
    return {"least": least, "chains": chains}, least[1] < least[0]
