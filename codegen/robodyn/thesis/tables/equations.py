"""Slips in the thesis's equations and printed data: each as printed and right, against a reference."""

from __future__ import annotations

from collections.abc import Iterator

from robodyn.thesis.slips import Slip, slips
from robodyn.thesis.tables.table import Row, judged


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
    return Row(slip.place, printed, {**right, **figures}, judged(same), f"{verdict}: {found.against}")
