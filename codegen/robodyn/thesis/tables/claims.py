"""What the thesis claims in its running text, each claim recomputed."""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from robodyn.thesis import claims
from robodyn.thesis.claims import Arms, Outcome
from robodyn.thesis.printed import data
from robodyn.thesis.tables.table import Row, Verdict, verdict_of


@dataclass(frozen=True, slots=True)
class Claim:
    """A claim of the text: its ``claim_number`` in the list, which both halves of a claim that is split
    share, a ``name`` of its own, and the ``section`` where it stands.

    ``printed`` are figures as printed, ``derived`` what follows from printed figures by arithmetic alone.
    ``by`` is the function that recomputes it, ``module.function`` of :mod:`robodyn.thesis.claims`. ``ours``
    and ``reason`` are texts with the names of its figures in braces. ``verdict`` stands in the file only
    where no figure decides: where the source lacks what is needed, or a reading is all there is, as of words
    without a bound (much, marginally, drastically).
    """

    claim_number: int
    name: str
    section: str
    claim: str
    ours: str
    reason: str
    printed: Mapping[str, Any] = field(default_factory=dict)
    derived: Mapping[str, Any] = field(default_factory=dict)
    by: str | None = None
    verdict: Verdict | None = None

    def recompute(self, arms: Arms) -> Outcome:
        """Its figures, and whether it holds by them."""
        if self.by is None:
            return {}, None
        module, _, function = self.by.partition(".")
        outcome: Outcome = getattr(importlib.import_module(f"{claims.__name__}.{module}"), function)(arms)
        return outcome


def read_claims() -> tuple[Claim, ...]:
    """All of them, in the order of the text."""
    return tuple(Claim(**entry) for entry in data("claims"))


@dataclass(frozen=True, slots=True)
class ClaimRow(Row):
    """A claim as a row: its ``claim_number``, its ``section``, what follows from printed figures."""

    claim_number: int = 0
    section: str = ""
    derived: Mapping[str, Any] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """As ``tables --json`` prints it."""
        place = {"number": self.claim_number, "section": self.section}
        return {**place, **Row.to_dict(self), "derived_from_printed": dict(self.derived)}


def table_of_claims() -> Iterator[Row]:
    """Every claim beside what our task graphs, schedules and counts say."""
    arms = Arms()
    for claim in read_claims():
        figures, holds = claim.recompute(arms)
        yield ClaimRow(
            claim.name,
            {"claim": claim.claim, **claim.printed},
            {"found": claim.ours.format_map(figures), **figures},
            claim.verdict or verdict_of(bool(holds)),
            claim.reason.format_map(figures),
            claim_number=claim.claim_number,
            section=claim.section,
            derived=claim.derived,
        )
