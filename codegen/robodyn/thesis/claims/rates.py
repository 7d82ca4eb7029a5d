"""Sampling rates, and how long the thesis's processor takes (sections 1.1 and 4.1)."""

from __future__ import annotations

from math import pi
from typing import Final

from robodyn.schedule import FLOPS_PER_TASK, general_graph
from robodyn.targets import target_named
from robodyn.thesis.claims.arms import FLOP_US, LINKS, PUMA, Arms, Outcome
from robodyn.thesis.polynomial import value
from robodyn.thesis.printed import TABLE_1_1, TASK_MS, bundled
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
