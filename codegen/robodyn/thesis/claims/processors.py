"""Sampling rates, how long the thesis's processor takes (sections 1.1 and 4.1), and schedules of chapter 4:
speed-up, efficiency and time on p processors."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from math import pi
from typing import Any, Final

from robodyn.schedule import (
    FLOPS_PER_TASK,
    TaskGraph,
    critical_path_order,
    general_graph,
    list_schedule,
    lower_bound,
)
from robodyn.schedule.branch_and_bound import one_processor_a_joint
from robodyn.targets import target_named
from robodyn.thesis.claims import FLOP_US, LINKS, PUMA, Arms, Outcome
from robodyn.thesis.claims.tasks import MOST, SIZES
from robodyn.thesis.judge import UNIT_MS, rival_graph
from robodyn.thesis.polynomial import value
from robodyn.thesis.printed import (
    LEVELS_SIX_LINK,
    LEVELS_STANFORD,
    TABLE_1_1,
    TASK_MS,
    TIMES_OTHERS,
    TIMES_STANFORD,
    bundled,
    table_2_10,
)
from robodyn.thesis.tables.customised import plain

#: Samples a period of the natural frequency that section 1.1 asks for, the frequencies of industrial arms
#: [Hz], and the factor by which those of smaller arms may be higher.
SAMPLES: Final = 20
RESONANCES: Final = (5, 10)
SMALL_ARMS: Final = 2
#: What controllers are wanted to reach by section 4.1 [Hz], and what section 1.1 makes of SAMPLES [Hz].
WANTED_HZ: Final = 1000
BANDWIDTH_HZ: Final = (1000, 2000)
#: Time of the inverse dynamics by section 1.1 [ms], how near a time must come to it, and clocks of the 8086
#: [MHz].
ON_AN_8086_MS: Final = 800
_SAME: Final = 0.01
CLOCKS_MHZ: Final = (5, 8, 10)


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


# --- sampling rates ---------------------------------------------------------------------------------------


def high_sampling_rates(arms: Arms) -> Outcome:
    """Rates of the longest chains, of any six joints and of the Stanford arm."""
    operations, levels = FLOPS_PER_TASK * arms.six.critical_path, arms.stanford_by_rule.critical_path
    ms, best_ms = operations * FLOP_US / 1e3, levels * TASK_MS
    figures = {"operations": operations, "ms": round(ms, 3), "hz": round(1e3 / ms), "stanford_levels": levels}
    figures |= {"stanford_ms": round(best_ms, 3), "stanford_hz": round(1e3 / best_ms)}
    return figures, ms <= 1e3 / WANTED_HZ


def joints_within_a_millisecond(_: Arms) -> Outcome:
    """The operations that fit between two samples at 1 kHz, and the joints whose 12 n + 9 they are."""
    operations = int(1e6 / WANTED_HZ / FLOP_US)
    two = general_graph(2).critical_path * TASK_MS
    figures = {"operations": operations, "joints": (operations - 9) // 12, "two_joints_ms": round(two, 3)}
    return figures, two <= 1e3 / WANTED_HZ


def bandwidth(_: Arms) -> Outcome:
    """Twenty times the natural frequencies, in hertz and, as a slip might have it, in radians a second."""
    rates = [SAMPLES * frequency for frequency in RESONANCES]
    small = SMALL_ARMS * rates[1]
    without_2_pi = [round(2 * pi * rate) for rate in (*rates, small)]
    times_less = [BANDWIDTH_HZ[1] // rate for rate in (small, rates[1])]
    figures = {"hz": rates, "small_arms_hz": small, "without_2_pi": without_2_pi, "times_less": times_less}
    return figures, tuple(rates) == BANDWIDTH_HZ


def on_an_8086(_: Arms) -> Outcome:
    """Times of Table 1.1's counts at the thesis's own rate, and an operation's if 800 ms is right."""
    ms = {name: round(cost.total_6 * FLOP_US / 1e3, 1) for name, cost in TABLE_1_1.items()}
    operations = TABLE_1_1["uicker_kahn"].total_6
    us = 1e3 * ON_AN_8086_MS / operations
    figures = {
        "operations": operations,
        "seconds": round(ms["uicker_kahn"] / 1e3, 2),
        "times_longer": round(ms["uicker_kahn"] / ON_AN_8086_MS, 1),
        "us_an_operation": round(us, 2),
        "cycles": [round(us * mhz) for mhz in CLOCKS_MHZ],
        "ms": ms,
    }
    return figures, any(abs(time / ON_AN_8086_MS - 1) < _SAME for time in ms.values())


def operations_of_the_puma(_: Arms) -> Outcome:
    """The printed polynomial at six joints, and the Lagrangian of the PUMA itself."""
    printed = TABLE_1_1["uicker_kahn"]
    polynomial, puma = value(printed.mul, LINKS), plain(bundled(PUMA), "lagrange").total
    same = polynomial == printed.mul_6 and puma == printed.total_6
    return {"polynomial": int(polynomial), "puma": puma}, same


def rate_of_the_vax(_: Arms) -> Outcome:
    """35 ms as a rate, beside what section 1.1 itself asks for."""
    return {"hz": round(1e3 / 35, 1), "wanted_hz": SAMPLES * RESONANCES[0]}, None


def equal_times(_: Arms) -> Outcome:
    """What an addition costs in multiplications on processors of today, with and without a unit."""
    costs = (target_named(name).single for name in ("cortex-m4f", "rv32imafc", "cortex-m3"))
    *with_unit, in_software = (round(cost.add / cost.mul, 2) for cost in costs)
    return {"in_software": in_software}, set(with_unit) == {1.0}


def on_the_8086_of_table_4_8(_: Arms) -> Outcome:
    """Cycles an operation by Table 4.8 if the clock were 5 MHz."""
    return {"us": round(FLOP_US, 1), "cycles": round(FLOP_US * CLOCKS_MHZ[0])}, None
