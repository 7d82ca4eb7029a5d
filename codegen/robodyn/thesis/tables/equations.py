"""Equations as printed and right, against a reference: the steps of the recursion (Table 2.4), friction of
the kinds of joints (Table 3.1), and slips in the thesis's equations and printed data."""

from __future__ import annotations

from collections.abc import Iterator

from robodyn.thesis.slips import Slip, slips, slips_of
from robodyn.thesis.tables.table import Row, verdict_of


def table_2_4() -> Iterator[Row]:
    """The steps in their order, a prismatic joint's after a revolute one's; those with a slip as ``tables
    equations`` has them."""
    rows = [slip_row(step) for step in (*slips("table_2_4"), *slips_of("Table 2.4, "))]
    yield from sorted(rows, key=lambda row: (row.name.partition(",")[0], row.name.endswith("prismatic")))


def table_3_1() -> Iterator[Row]:
    """The kinds of bearings, each tried on random loads."""
    yield from map(slip_row, slips("table_3_1"))


def table_of_equations() -> Iterator[Row]:
    """Every slip with what its printed form and the right one give."""
    yield from map(slip_row, slips())


def slip_row(slip: Slip) -> Row:
    """A slip as a row: what it says, what is right, and how far both are from the reference, to three digits
    and one."""
    printed, right = {"says": slip.printed}, {"right": slip.right}
    if isinstance(slip.check, str):
        return Row(slip.place, printed, right, "differs", f"nothing to compute: {slip.check}")
    found = slip.check()
    same = found.printed <= found.tolerance
    if same:
        verdict = "as printed it agrees with the reference"
    elif found.right <= found.tolerance:
        verdict = "slip confirmed; reference"
    else:
        verdict = "neither form agrees with the reference"
    figures = {
        "printed_off": float(f"{found.printed:.3g}"),
        "right_off": float(f"{found.right:.0e}"),
        "unit": found.unit,
        "against": found.against,
    }
    return Row(slip.place, printed, {**right, **figures}, verdict_of(same), f"{verdict}: {found.against}")
