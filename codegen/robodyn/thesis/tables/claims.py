"""What the thesis claims in its running text, each claim recomputed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from robodyn.thesis.claims.arms import Arms
from robodyn.thesis.claims.claim import Claim, read_claims
from robodyn.thesis.tables.table import Column, Progress, Row, Table, judged
from robodyn.thesis.tables.table_2_10 import Load, load_quietly


@dataclass(frozen=True, slots=True)
class ClaimRow(Row):
    """A claim as a row: its ``claim_number``, its ``section``, what follows from printed figures."""

    claim_number: int = 0
    section: str = ""
    derived: Mapping[str, Any] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """As ``tables --json`` prints it."""
        return {
            "number": self.claim_number,
            "section": self.section,
            **Row.to_dict(self),
            "derived_from_printed": dict(self.derived),
        }


def table(progress: Progress = lambda _: None, load_robot: Load = load_quietly) -> Table:
    """Every claim beside what our task graphs, schedules and counts say."""
    arms = Arms(load_robot)
    rows = []
    for claim in read_claims():
        progress(claim.name)
        rows.append(_row(claim, arms))
    return Table(
        "claims",
        "what the thesis claims in its text",
        (
            Column("no.", "row", "claim_number"),
            Column("section", "row", "section"),
            Column("printed", "printed", "claim", below=True),
            Column("ours", "ours", "found", below=True),
        ),
        tuple(rows),
        (
            "Claims are paraphrased, figures as printed; a claim whose parts come out differently has a row "
            "for each. Ours: the graph of the tasks of Table 4.1, corrected, schedules by section "
            "4.3.3 or critical path first, counts of Tables 2.9 and 3.3, the case study. A level is a task "
            "long, three operations; M and A are multiplications and additions.",
        ),
    )


def _row(claim: Claim, arms: Arms) -> ClaimRow:
    figures, holds = claim.recompute(arms)
    verdict = claim.verdict or judged(bool(holds))
    return ClaimRow(
        claim.name,
        {"claim": claim.claim, **claim.printed},
        {"found": claim.ours.format_map(figures), **figures},
        verdict,
        claim.reason.format_map(figures),
        claim_number=claim.claim_number,
        section=claim.section,
        derived=claim.derived,
    )
