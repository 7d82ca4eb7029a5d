"""Schedules of chapter 4: speed-up, efficiency and time on p processors."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from typing import Any, Final

from robodyn.schedule import TaskGraph, critical_path_order, general_graph, list_schedule, lower_bound
from robodyn.schedule.branch_and_bound import one_processor_a_joint
from robodyn.thesis.claims.arms import FLOP_US, LINKS, TASK_MS, Arms
from robodyn.thesis.claims.claim import Outcome
from robodyn.thesis.claims.tasks import MOST, SIZES
from robodyn.thesis.printed_counts import table_2_10
from robodyn.thesis.printed_tasks import LEVELS_SIX_LINK, LEVELS_STANFORD, TIMES_OTHERS, TIMES_STANFORD
from robodyn.thesis.rival_tasks import UNIT_MS, rival_graph

#: Steps of the branch and bound for one processor a joint: as many on every machine.
_STEPS: Final = 200
#: The efficiency that section 4.5 speaks of [%].
HIGH: Final = 98
KASAHARA: Final = "Kasahara and Narita 1985"


def _best(graph: TaskGraph, p: int) -> int:
    """Levels critical path first."""
    return list_schedule(graph, p, critical_path_order(graph)).levels


def _share(graph: TaskGraph, levels: int, p: int) -> float:
    return round(100 * len(graph) / levels / p, 2)


def _most_above(graph: TaskGraph) -> int:
    """The most processors up to which all have an efficiency above 98 %, critical path first."""
    above = itertools.takewhile(lambda p: _share(graph, _best(graph, p), p) > HIGH, itertools.count(1))
    return max(above)


def luh_and_lin(arms: Arms) -> Outcome:
    """The speed-up of Luh and Lin by Table 4.8, and that of our tasks with one processor a joint."""
    steps = itertools.count()
    graph = arms.stanford_by_rule
    best = one_processor_a_joint(graph, seconds=_STEPS, clock=lambda: float(next(steps)))
    times = TIMES_OTHERS["Luh and Lin 1982"]
    figures = {
        "by_table_4_8": round(times[1] / times[LINKS], 2),
        "speedup": round(len(graph) / best.schedule.levels, 2),
        "tasks": len(graph),
        "levels": best.schedule.levels,
        "bound_levels": best.lower_bound,
    }
    return figures, abs(figures["by_table_4_8"] - 2.64) < 0.01


def critical_path_bound(_: Arms) -> Outcome:
    """The longest chain of Kasahara's tasks beside the least printed time [ms]."""
    graph = rival_graph()
    chain = lower_bound(graph, len(graph)) * UNIT_MS
    least = min(TIMES_OTHERS[KASAHARA].values())
    fewest = next(p for p in itertools.count(1) if lower_bound(graph, p) * UNIT_MS <= chain)
    return {"chain_ms": round(chain, 2), "least_ms": least, "not_fewer_than": fewest}, chain > 0


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
    graph = arms.six
    fewest = next((p for p in range(1, MOST) if _best(graph, p) == graph.critical_path), MOST)
    share = _share(graph, graph.critical_path, fewest)
    return {"processors": fewest, "efficiency_pct": share, "levels": graph.critical_path}, fewest == MOST


def strategy(arms: Arms) -> Outcome:
    """Processors for which the list of section 4.3.3 has other levels than the printed schedule."""
    apart: dict[str, Any] = {}
    for name, graph, printed in (
        ("six_link", arms.six, LEVELS_SIX_LINK),
        ("stanford", arms.stanford_printed, LEVELS_STANFORD),
    ):
        ours = {
            p: list_schedule(graph, p).levels
            for p in printed
            if 1 < p < MOST - 4 or (p == 9 and name == "six_link")
        }
        apart[name] = {str(p): [levels, printed[p]] for p, levels in ours.items() if levels != printed[p]}
    return apart, not any(apart.values())


def _efficiencies(graph: TaskGraph, printed: Mapping[int, int], most: int) -> dict[str, Any]:
    ours = {str(p): _share(graph, list_schedule(graph, p).levels, p) for p in range(1, most + 1)}
    speedups = [round(len(graph) / printed[p], 2) for p in range(2, most + 1)]
    return {"by_processors": ours, "least_pct": min(ours.values()), "speedups": speedups}


def six_link_efficiency(arms: Arms) -> Outcome:
    """Efficiencies of our schedules on one to six processors."""
    figures = _efficiencies(arms.six, LEVELS_SIX_LINK, 6)
    return figures, figures["least_pct"] > HIGH


def stanford_efficiency(arms: Arms) -> Outcome:
    """The same of the Stanford arm's tasks by rule on one to four."""
    figures = _efficiencies(arms.stanford_by_rule, LEVELS_STANFORD, 4)
    figures["shares"] = list(figures["by_processors"].values())
    figures["levels"] = [list_schedule(arms.stanford_by_rule, p).levels for p in (2, 3, 4)]
    return figures, figures["least_pct"] > HIGH


def _beyond(graph: TaskGraph, printed: Mapping[int, int], processors: range) -> dict[str, Any]:
    """Gains in speed-up by another processor and efficiencies [%], by printed levels and at best."""
    return {
        "gain_pct": [round(100 * (printed[p - 1] / printed[p] - 1), 1) for p in processors],
        "efficiency_pct": [_share(graph, printed[p], p) for p in processors],
        "best_pct": [_share(graph, _best(graph, p), p) for p in processors],
    }


def beyond_six(arms: Arms) -> Outcome:
    """Seven to nine processors."""
    figures = _beyond(arms.six, LEVELS_SIX_LINK, range(7, 10))
    return figures, None


def beyond_four(arms: Arms) -> Outcome:
    """Five to eight processors for the Stanford arm."""
    figures = _beyond(arms.stanford_printed, LEVELS_STANFORD, range(5, 9))
    return figures, None


def six_ideal(arms: Arms) -> Outcome:
    """The most processors with an efficiency above 98 % for six joints."""
    return {"processors": _most_above(arms.six)}, _most_above(arms.six) == 6


def six_ideal_in_general(_: Arms) -> Outcome:
    """The same for two to nine joints."""
    most = [_most_above(general_graph(n)) for n in SIZES]
    return {"processors": most}, set(most) == {6}


def four_ideal(arms: Arms) -> Outcome:
    """The most processors with an efficiency above 98 % by the Stanford arm's printed levels."""
    graph = arms.stanford_printed
    shares = {p: _share(graph, levels, p) for p, levels in LEVELS_STANFORD.items()}
    most = max(itertools.takewhile(lambda p: shares[p] > HIGH, sorted(shares)))
    return {"processors": most, "efficiency_pct": {str(p): share for p, share in shares.items()}}, most == 4


def _less(ours: float, theirs: float) -> float:
    return round(100 * (1 - ours / theirs), 1)


def one_processor(_: Arms) -> Outcome:
    """468 operations at the rate of Table 4.8, and the operations of the thesis's own listing."""
    ms, theirs = LEVELS_STANFORD[1] * TASK_MS, TIMES_OTHERS[KASAHARA][1]
    least = min(LEVELS_STANFORD.values()) * TASK_MS
    listing = sum(table_2_10()["stanford_6"]["I"])
    figures = {
        "ms": round(ms, 2),
        "less_pct": _less(ms, theirs),
        "listing": listing,
        "listing_ms": round(listing * FLOP_US / 1e3, 1),
        "listing_speedup": round(listing * FLOP_US / 1e3 / least, 2),
        "speedup": round(ms / least, 2),
    }
    return figures, figures["ms"] == TIMES_STANFORD[1] and ms < theirs


def four_processors(_: Arms) -> Outcome:
    """39 levels beside the others' time."""
    ms, theirs = LEVELS_STANFORD[4] * TASK_MS, TIMES_OTHERS[KASAHARA][4]
    return {"ms": round(ms, 3), "less_pct": _less(ms, theirs)}, abs(ms - TIMES_STANFORD[4]) < 0.01


def least_time_as_printed(_: Arms) -> Outcome:
    """The least of Table 4.8 by printed levels, and the fewest processors that have it."""
    fewest = min(LEVELS_STANFORD, key=lambda p: (LEVELS_STANFORD[p], p))
    ms = LEVELS_STANFORD[fewest] * TASK_MS
    theirs = min(TIMES_OTHERS[KASAHARA].values())
    figures = {"ms": round(ms, 3), "processors": fewest, "others_ms": theirs}
    return figures, fewest == 7 and abs(ms - 3.65) < 0.01


def least_time(arms: Arms) -> Outcome:
    """The least time of the Stanford arm's tasks, and the fewest processors that reach it."""
    graph = arms.stanford_printed
    levels = graph.critical_path
    fewest = next(p for p in itertools.count(1) if _best(graph, p) == levels)
    figures = {"ms": round(levels * TASK_MS, 3), "levels": levels, "processors": fewest}
    return figures, levels == min(LEVELS_STANFORD.values())


def reasons_of_the_gain(_: Arms) -> Outcome:
    """3.65/5.60 as a product: less work, and more work done at once."""
    ours, theirs = min(TIMES_STANFORD.values()), min(TIMES_OTHERS[KASAHARA].values())
    work = TIMES_STANFORD[1] / TIMES_OTHERS[KASAHARA][1]
    speedups = TIMES_STANFORD[1] / ours, TIMES_OTHERS[KASAHARA][1] / theirs
    figures: dict[str, Any] = {
        "work": round(work, 2),
        "speedups": [round(x, 2) for x in speedups],
        "concurrency": round(speedups[1] / speedups[0], 2),
        "time": round(ours / theirs, 2),
    }
    return figures, figures["concurrency"] < 1 and work < 1


def less_than_all(_: Arms) -> Outcome:
    """The least times of the columns of Table 4.8."""
    others = sorted(min(times.values()) for times in TIMES_OTHERS.values())
    least = min(TIMES_STANFORD.values())
    return {"ms": least, "others_ms": others}, least < others[0]


def customising(_: Arms) -> Outcome:
    """Levels of any six joints and of the Stanford arm at two to eight processors, as printed."""
    pairs = {str(p): [LEVELS_SIX_LINK[p], LEVELS_STANFORD[p]] for p in range(2, 9)}
    return {"levels": pairs}, all(stanford < any_arm for any_arm, stanford in pairs.values())


def least_after_customising(arms: Arms) -> Outcome:
    """The least levels that are printed of both, and the longest chains."""
    least = [min(LEVELS_SIX_LINK.values()), min(LEVELS_STANFORD.values())]
    chains = [arms.six.critical_path, arms.stanford_printed.critical_path]
    return {"least": least, "chains": chains}, least[1] < least[0]
