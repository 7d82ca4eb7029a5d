"""The claims as ``claims.yaml`` holds them."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, cast

from robodyn.thesis.claims.arms import Arms
from robodyn.thesis.tables.table import Verdict

#: Figures by name, and whether the claim holds by them: None where figures do not decide.
Outcome = tuple[dict[str, Any], bool | None]


@dataclass(frozen=True, slots=True)
class Claim:
    """A claim of the text: its ``claim_number`` in the list, which both halves of a claim that is split
    share, a ``name`` of its own, and the ``section`` where it stands.

    ``printed`` are figures as printed, ``derived`` what follows from printed figures by arithmetic alone.
    ``by`` is the function that recomputes it, ``module.function`` of this package. ``ours`` and ``reason``
    are texts with the names of its figures in braces. ``verdict`` stands in the file only where no figure
    decides: where the source lacks what is needed, or a reading is all there is, as of words without a bound
    (much, marginally, drastically).
    """

    claim_number: int
    name: str
    section: str
    claim: str
    ours: str
    reason: str
    printed: Mapping[str, Any]
    derived: Mapping[str, Any]
    by: str | None
    verdict: Verdict | None

    def recompute(self, arms: Arms) -> Outcome:
        """Its figures, and whether it holds by them."""
        if self.by is None:
            return {}, None
        module, _, function = self.by.partition(".")
        figures = getattr(importlib.import_module(f"{__package__}.{module}"), function)
        return cast("Callable[[Arms], Outcome]", figures)(arms)


@cache
def read_claims() -> tuple[Claim, ...]:
    """All of them, in the order of the text."""
    import yaml

    text = Path(__file__).with_name("claims.yaml").read_text(encoding="utf-8")
    optional: dict[str, Any] = {"printed": {}, "derived": {}, "by": None, "verdict": None}
    return tuple(Claim(**{**optional, **entry}) for entry in yaml.load(text, yaml.CSafeLoader))
