"""Table 3.3: what friction costs a joint."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from robodyn.counts import Count
from robodyn.counts.general import Tally
from robodyn.effects import thesis_friction as friction
from robodyn.thesis.printed_counts import TABLE_3_3, Pair
from robodyn.thesis.tables import table_2_9
from robodyn.thesis.tables.table import Column, Row, Table, apart, counted, judged, pair, summed

#: Why a printed figure is not ours, by row and what ours has more: read only where it is so.
WHY: Final[dict[tuple[str, int, int], str]] = {
    ("frictionless, revolute", 0, 6): "row n of Table 2.9, whose R n goes without its additions",
    ("joint, revolute", 0, 2): (
        "Eq 3.3 has four terms 0.5 d f +- n (4 additions), two sums of squares (2) and the sum of the roots "
        "(1): 7, corrected and as printed; its 15 multiplications follow with 0.5 d f formed in every term"
    ),
    ("total_cubic, revolute", 0, 8): "6 of row n of Table 2.9 and 2 of Eq 3.3; the printed column adds up",
    ("total_linear, revolute", 0, 8): "6 of row n of Table 2.9 and 2 of Eq 3.3; the printed column adds up",
}

AGREE: Final = {
    "frictionless, prismatic": "as Table 2.9, whose rows treat R differently",
    "joint, prismatic": "Eq 3.4 with 0.5 d f formed in every term, mu/d first, and the sign multiplied",
    "transmission, linear": "the straight piece e_0 + e_1 load, then torque/efficiency + breakaway sgn(qd)",
    "transmission, cubic_spline": (
        "the cubic as e_0 + e_1 load + load^2 (e_2 + e_3 load), then torque/efficiency + breakaway sgn(qd); "
        "how the thesis evaluates it is not said, and by Horner's rule it is a multiplication less"
    ),
}


def tallied(run: Callable[[Callable[[], Any]], object]) -> Count:
    """The operations of ``run``, which is given a maker of numbers."""
    ledger: dict[str, int] = {}
    run(lambda: Tally(ledger))
    return Count(**ledger)


def journal(*, as_printed: bool = False) -> Count:
    """Operations of Eq 3.3."""

    def run(x: Callable[[], Any]) -> object:
        f, n = (x(), x(), x()), (x(), x(), x())
        return friction.journal_bearing(x(), x(), x(), f, n, x(), as_printed=as_printed)

    return tallied(run)


def linear() -> Count:
    """Operations of Eq 3.4."""
    return tallied(
        lambda x: friction.linear_bearing(x(), x(), (x(), x(), x()), (x(), x(), x()), x()),
    )


def transmission(efficiency: Callable[[Any, Any], Any]) -> Count:
    """Operations of Table 3.2's first case with the efficiency by ``efficiency(load, coefficients)``."""

    def run(x: Callable[[], Any]) -> object:
        torque = x()
        load = friction.load_fraction(torque, x())
        return friction.driving(torque, efficiency(load, [x() for _ in range(4)]), x(), x())

    return tallied(run)


def ours() -> dict[str, Count]:
    """All rows of the table, ours."""
    cubic = transmission(friction.cubic_efficiency_in_pairs)
    straight = transmission(friction.linear_efficiency)
    counts = {}
    for kind, joint in (("revolute", journal()), ("prismatic", linear())):
        rigid = summed(*table_2_9.counts("I", kind == "revolute").values())
        counts[f"frictionless, {kind}"] = rigid
        counts[f"joint, {kind}"] = joint
        counts[f"total_cubic, {kind}"] = summed(rigid, joint, cubic)
        counts[f"total_linear, {kind}"] = summed(rigid, joint, straight)
    return {**counts, "transmission, cubic_spline": cubic, "transmission, linear": straight}


def table() -> Table:
    """Printed and recomputed operations of friction in joints and transmissions."""
    counts = ours()
    rows = tuple(
        _row(f"{name}, {kind}", printed, counts[f"{name}, {kind}"])
        for name, figures in TABLE_3_3.items()
        for kind, printed in figures.items()
    )
    return Table(
        "3.3",
        "operations a joint of the inverse dynamics with friction, method I",
        (Column("printed", "printed", "operations"), Column("ours", "ours", "operations")),
        rows,
        (
            "Multiplications/additions = total. Ours: Eqs 3.3 and 3.4 and Table 3.2 (effects/"
            "thesis_friction.py) carried out on numbers that only count; no constant is formed beforehand. "
            "The thesis counts divisions and square roots for nothing, and so does the verdict: ours has "
            "them written out. Absolute values and changes of sign are free.",
        ),
    )


def _row(name: str, printed: Pair, count: Count) -> Row:
    operations = (count.mul, count.add)
    same = operations == printed
    more = (operations[0] - printed[0], operations[1] - printed[1])
    reason = AGREE.get(name, "the sum of the rows above")
    if not same:
        reason = f"{apart(printed, operations)}: {WHY.get((name, *more), 'not explained')}"
    return Row(
        name, {"operations": pair(*printed)}, {"operations": counted(count)}, judged(same), reason,
        _beside(name),
    )  # fmt: skip


def _beside(name: str) -> tuple[dict[str, Any], ...]:
    if name == "joint, revolute":
        return ({"what": "Eq 3.3 as printed, a wrong sign in it", **counted(journal(as_printed=True))},)
    if name == "transmission, cubic_spline":
        horner = transmission(friction.cubic_efficiency)
        return ({"what": "by Horner's rule", **counted(horner)},)
    return ()
