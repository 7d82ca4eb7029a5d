"""A diagnosis joint by joint: the gap before and after in units of each joint's noise, and many findings in
order, as a table of joints by kinds of effects and as cards."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Diagnosis, Finding
from robodyn.report import diagnosis_text as words
from robodyn.report.chart_frames import percent
from robodyn.report.figures import capital, formatted, several

Floats = NDArray[np.float64]

#: The scale reaches from below the noise to at least so many times it.
_LOW, _REACH = 0.7, 3.0
#: Effects that a row of a joint names at most.
_NAMED: Final = 3


def ladder(diagnosis: Diagnosis, validated: bool) -> dict[str, Any]:
    """Rows of joints: how many times the noise floor the gap was and is, on a logarithmic scale."""
    floor, (before, after) = diagnosis.gap.noise_floor, words.chosen(diagnosis, validated)
    logs = {"proof": (before, after)} | ({"fitted": words.chosen(diagnosis, False)} if validated else {})
    with np.errstate(all="ignore"):
        times = {kind: tuple(values / floor for values in pair) for kind, pair in logs.items()}
    every = np.concatenate([values for pair in times.values() for values in pair])
    top = max(_REACH, 1.15 * float(every[np.isfinite(every)].max(initial=0.0)))

    def at(value: float) -> float:
        return 100 * math.log(min(max(value, _LOW), top) / _LOW) / math.log(top / _LOW)

    rows = []
    for j in range(diagnosis.robot.n):
        drawn = []
        for kind, (a, b) in times.items():
            if math.isfinite(a[j]) and math.isfinite(b[j]):
                old, new = at(float(a[j])), at(float(b[j]))
                drawn.append(
                    {
                        "kind": kind, "is_same": bool(a[j] == b[j]), "before": percent(old),
                        "after": percent(new), "low": percent(min(old, new)), "high": percent(max(old, new)),
                    }
                )  # fmt: skip
        names = [words.named(f.effect) for f in words.claims(diagnosis) if f.joint == j + 1]
        more = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
        figures = {"before": before[j], "after": after[j], "floor": floor[j]}
        effects, unit = ", ".join(names[:_NAMED]) + more, words.units_at(diagnosis, j)["torque"]
        rows.append({"effects": effects, "drawn": drawn, "unit": unit, **figures})
    wide = math.log10(top / _LOW)
    steps = (1, 2, 3, 4, 6) if wide < 1 else (1, 2, 5) if wide < 1.7 else (1,)
    marks = [m * 10.0**k for k in range(math.ceil(math.log10(top)) + 1) for m in steps]
    ticks = [{"at": percent(at(v)), "label": f"{v:g}×"} for v in marks if v <= top]
    return {"rows": rows, "ticks": ticks[:: -(-len(ticks) // 6) or 1], "noise": percent(at(1.0))}


def change(before: float, after: float) -> str:
    """A change in percent."""
    if not before > 0 or not math.isfinite(after / before):
        return "n/a"
    rounded = round(100 * (after / before - 1))
    return f"{rounded:+d} %".replace("-", "−") if rounded else "0 %"


#: So many claims stand one below the other, open; more are folded, by joint, below a table of all findings.
FEW: Final = 3


def table_of_kinds(diagnosis: Diagnosis) -> dict[str, Any] | None:
    """Joints down, kinds of effects and effects across, with the first number of each finding; None of a few
    claims."""
    findings = diagnosis.findings
    if len(words.claims(diagnosis)) <= FEW:
        return None
    kinds = [
        list(dict.fromkeys(f.effect for f in some))
        for some in sorted(words.by_kind(findings), key=lambda some: -len(some))
    ]
    return {
        "kinds": [
            {"title": words.kind_of(ids[0]), "effects": list(map(words.title_of, ids))}
            if len(ids) > 1
            else {"title": words.title_of(ids[0]), "effects": []}
            for ids in kinds
        ],
        "is_deep": any(len(ids) > 1 for ids in kinds),
        "rows": [
            {
                "place": capital(words.place_of(joint)),
                "id": _anchor(joint),
                "cells": [
                    {
                        "label": words.title_of(effect),
                        "entries": [_entry(f) for f in findings if (f.joint, f.effect) == (joint, effect)],
                    }
                    for ids in kinds
                    for effect in ids
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
    if len(words.claims(diagnosis)) <= FEW:
        return []
    before, after = words.chosen(diagnosis, validated)
    groups = []
    for joint in _joints(diagnosis.findings):
        group = [card for card in cards if card["joint"] == joint]
        if group:
            remark = several(len(group), "finding")
            if joint is not None:
                unit = words.units_at(diagnosis, joint - 1)["torque"]
                figures = f"{formatted(before[joint - 1])} → {formatted(after[joint - 1])} {unit}"
                remark = f"{remark}; RMS of the residual {figures}"
            title = capital(words.place_of(joint))
            groups.append({"id": _anchor(joint), "title": title, "remark": remark, "cards": group})
    return groups


def _anchor(joint: int | None) -> str:
    """Where on the page the findings of a joint are."""
    return "robot" if joint is None else f"joint-{joint}"


def _joints(findings: Sequence[Finding]) -> list[int | None]:
    return sorted({f.joint for f in findings}, key=lambda joint: math.inf if joint is None else joint)


def _entry(finding: Finding) -> dict[str, Any]:
    """A finding in a cell: its first number that was fitted, how sure it is."""
    seen = words.identified(finding)
    fitted = {name: p for name, p in seen.items() if p.stderr or p.bounds} or seen
    texts = [words.value_text(p, finding.effect, name) for name, p in fitted.items()]
    text = (
        " ".join(words.touched_at(finding)).strip()
        if words.is_contact(finding.effect)
        else [*texts, "not identifiable"][0]
    )
    sure = f"{100 * finding.confidence:.0f} %"
    return {"text": text.replace("^2", "²"), "is_claim": finding.confidence >= CLAIM, "sure": sure}
