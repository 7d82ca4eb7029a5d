"""Slips in the thesis's equations and printed data: each as printed and right, against a reference."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from robodyn.thesis.slips.comparison import Comparison
from robodyn.thesis.slips.rows import SLIPS
from robodyn.thesis.slips.slip import Slip
from robodyn.thesis.tables.table import Column, Progress, Row, Table

#: How tables show forms that are tried.
COLUMNS: Final = (
    Column("as printed off by", "ours", "printed_off"),
    Column("right off by", "ours", "right_off"),
    Column("unit", "ours", "unit"),
    Column("printed", "printed", "says", below=True),
    Column("right", "ours", "right", below=True),
)


def table(progress: Progress = lambda _: None, slips: Sequence[Slip] = SLIPS) -> Table:
    """Every slip with what its printed form and the right one give."""
    rows = []
    for slip in slips:
        progress(slip.place)
        rows.append(slip_row(slip))
    return Table(
        "equations",
        "slips in the thesis's equations and printed data",
        COLUMNS,
        tuple(rows),
        (
            "Off by: the largest difference to the reference, over 1,000 random states where torques are "
            "compared (N at the Stanford arm's slide). One step is as printed, the others are right. "
            "reproduced: what is printed is right. Misprinted levels of Tables 4.3, 4.7 and C are in robodyn "
            "tables schedules, the counts of listings in robodyn tables 2.10.",
        ),
    )


def slip_row(slip: Slip) -> Row:
    """A slip as a row: what it says, what is right, and how far both are from the reference."""
    ours = {"right": slip.right}
    if isinstance(slip.check, str):
        return Row(slip.place, {"says": slip.printed}, ours, "differs", f"nothing to compute: {slip.check}")
    return Row(
        slip.place,
        {"says": slip.printed},
        {**ours, **figures(comparison := slip.check())},
        "reproduced" if comparison.printed_agrees else "differs",
        verdict_in_words(comparison),
    )


def figures(comparison: Comparison) -> dict[str, str | float]:
    """A comparison as JSON holds it, differences to three digits."""
    return {
        "printed_off": float(f"{comparison.printed:.3g}"),
        "right_off": float(f"{comparison.right:.0e}"),
        "unit": comparison.unit,
        "against": comparison.against,
    }


def verdict_in_words(comparison: Comparison) -> str:
    """Which of the two forms agrees with the reference."""
    if comparison.printed_agrees:
        return f"as printed it agrees with the reference: {comparison.against}"
    if comparison.right_agrees:
        return f"slip confirmed; reference: {comparison.against}"
    return f"neither form agrees with the reference: {comparison.against}"
