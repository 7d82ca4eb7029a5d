"""Many findings of a diagnosis in order: a table of joints by kinds of effects, and their cards by joint."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any, Final

from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Diagnosis, Finding
from robodyn.report.diagnosis_gap import units_at
from robodyn.report.diagnosis_headline import by_kind, kind_of
from robodyn.report.diagnosis_text import (
    chosen,
    claims,
    is_contact,
    is_unseen,
    place_of,
    title_of,
    touched_at,
    value_text,
)
from robodyn.report.figures import formatted

#: So many claims stand one below the other, open; more are folded, by joint, below a table of all findings.
FEW: Final = 3


def table_of_kinds(diagnosis: Diagnosis) -> dict[str, Any] | None:
    """Joints down, kinds of effects and effects across, with the first number of each finding; None of a few
    claims."""
    findings = diagnosis.findings
    if len(claims(diagnosis)) <= FEW:
        return None
    groups = sorted(by_kind(findings), key=lambda some: -len(some))
    effects = [f.effect for some in groups for f in some]
    columns = list(dict.fromkeys(effects))
    kinds = [
        (kind, [effect for effect, _ in pairs])
        for kind, pairs in groupby(
            ((effect, kind_of(effect)) for effect in columns), key=lambda pair: pair[1]
        )
    ]
    return {
        "kinds": [
            {
                "title": kind if len(own) > 1 else title_of(own[0]),
                "effects": [title_of(effect) for effect in own] if len(own) > 1 else [],
            }
            for kind, own in kinds
        ],
        "is_deep": any(len(own) > 1 for _, own in kinds),
        "rows": [
            {
                "place": _place(joint),
                "id": anchor(joint),
                "cells": [
                    {
                        "label": title_of(effect),
                        "entries": [_entry(f) for f in findings if (f.joint, f.effect) == (joint, effect)],
                    }
                    for effect in columns
                ],
            }
            for joint in _joints(findings)
        ],
    }


def by_joint(
    diagnosis: Diagnosis, cards: Sequence[Mapping[str, Any]], *, validated: bool
) -> list[dict[str, Any]]:
    """The ``cards`` of each joint together, from the base to the tip, those of the whole robot last; empty of
    a few claims."""
    if len(claims(diagnosis)) <= FEW:
        return []
    before, after = chosen(diagnosis, validated)
    groups = []
    for joint in _joints(diagnosis.findings):
        own = [card for card in cards if card["joint"] == joint]
        if own:
            remark = f"{len(own)} finding{'s' if len(own) > 1 else ''}"
            if joint is not None:
                unit = units_at(diagnosis, joint - 1)["tau"]
                figures = f"{formatted(before[joint - 1])} → {formatted(after[joint - 1])} {unit}"
                remark = f"{remark}; RMS of the residual {figures}"
            groups.append({"id": anchor(joint), "title": _place(joint), "remark": remark, "cards": own})
    return groups


def anchor(joint: int | None) -> str:
    """Where on the page the findings of a joint are."""
    return "robot" if joint is None else f"joint-{joint}"


def _joints(findings: Sequence[Finding]) -> list[int | None]:
    joints = sorted({f.joint for f in findings if f.joint is not None})
    return [*joints, *([None] if any(f.joint is None for f in findings) else [])]


def _place(joint: int | None) -> str:
    text = place_of(joint)
    return text[:1].upper() + text[1:]


def _entry(finding: Finding) -> dict[str, Any]:
    """A finding in a cell: its first number that was fitted, how sure it is."""
    identified = [
        (name, p) for name, p in finding.parameters.items() if not is_unseen(p, finding.effect, name)
    ]
    fitted = [pair for pair in identified if pair[1].stderr or pair[1].bounds]
    if is_contact(finding.effect):
        text = " ".join(touched_at(finding)).strip()
    else:
        text = next(
            (value_text(p, finding.effect, name) for name, p in fitted or identified), "not identifiable"
        )
    sure = f"{100 * finding.confidence:.0f} %"
    return {"text": text.replace("^2", "²"), "is_claim": finding.confidence >= CLAIM, "sure": sure}
