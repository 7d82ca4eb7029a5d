"""Friction: of the kinds of joints, beside the statics of two bearings (Table 3.1), and what it costs a joint
(Table 3.3)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from robodyn.counts import Count
from robodyn.counts.general import Tally
from robodyn.dynamics.vectors import Vector
from robodyn.effects import thesis_friction as friction
from robodyn.thesis.printed import TABLE_3_3
from robodyn.thesis.slips import slips
from robodyn.thesis.tables.equations import slip_row
from robodyn.thesis.tables.recursion import joint_count
from robodyn.thesis.tables.table import Row, compared_count, counted, summed, words_of


def table_3_1() -> Iterator[Row]:
    """The kinds of bearings, each tried on random loads."""
    yield from map(slip_row, slips("table_3_1"))


def _tallied(run: Callable[[Callable[[], Any], Callable[[], Vector]], object]) -> Count:
    """The operations of ``run``, which is given makers of numbers and of vectors."""
    ledger: dict[str, int] = {}

    def number() -> Any:
        return Tally(ledger)

    run(number, lambda: (number(), number(), number()))
    return Count(**ledger)


def journal(*, as_printed: bool = False) -> Count:
    """Operations of Eq 3.3."""
    return _tallied(
        lambda x, v: friction.journal_bearing(x(), x(), x(), v(), v(), x(), as_printed=as_printed)
    )


def transmission(efficiency: Callable[[Any, Any], Any]) -> Count:
    """Operations of Table 3.2's first case with the efficiency by ``efficiency(load, coefficients)``."""

    def run(x: Callable[[], Any], _: object) -> object:
        torque = x()
        load = friction.load_fraction(torque, x())
        return friction.driving(torque, efficiency(load, [x() for _ in range(4)]), x(), x())

    return _tallied(run)


def friction_counts() -> dict[str, Count]:
    """All rows of Table 3.3, ours."""
    cubic = transmission(friction.cubic_efficiency_in_pairs)
    straight = transmission(friction.linear_efficiency)
    linear = _tallied(lambda x, v: friction.linear_bearing(x(), x(), v(), v(), x()))
    counts = {"transmission, cubic_spline": cubic, "transmission, linear": straight}
    for kind, joint in (("revolute", journal()), ("prismatic", linear)):
        rigid = joint_count("I", kind == "revolute")
        counts[f"frictionless, {kind}"] = rigid
        counts[f"joint, {kind}"] = joint
        counts[f"total_cubic, {kind}"] = summed((rigid, joint, cubic))
        counts[f"total_linear, {kind}"] = summed((rigid, joint, straight))
    return counts


def table_3_3() -> Iterator[Row]:
    """Printed and recomputed operations of friction in joints and transmissions."""
    counts, reasons = friction_counts(), words_of("3.3")["reasons"]
    beside: dict[str, Mapping[str, Any]] = {
        "joint, revolute": {
            "what": "Eq 3.3 as printed, a wrong sign in it", **counted(journal(as_printed=True)),
        },
        "transmission, cubic_spline": {
            "what": "by Horner's rule", **counted(transmission(friction.cubic_efficiency)),
        },
    }  # fmt: skip
    for name, figures in TABLE_3_3.items():
        for kind, printed in figures.items():
            row = f"{name}, {kind}"
            others = (beside[row],) if row in beside else ()
            yield compared_count(row, printed, counts[row], reasons, "the sum of the rows above", others)
