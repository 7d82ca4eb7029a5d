"""A diagnosis joint by joint: the gap before and after in units of each joint's noise, and many findings in
order, as a table of joints by kinds of effects and as cards."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Diagnosis, Finding
from robodyn.report.chart_frames import percent
from robodyn.report.diagnosis_headline import by_kind, kind_of
from robodyn.report.diagnosis_text import (
    chosen,
    claims,
    is_contact,
    is_unseen,
    named,
    place_of,
    title_of,
    touched_at,
    value_text,
)
from robodyn.report.figures import UNITS, capital, formatted

Floats = NDArray[np.float64]

#: The scale reaches from below the noise to at least so many times it.
_LOW, _REACH = 0.7, 3.0
#: Effects that a row of a joint names at most.
_NAMED: Final = 3


def units_at(diagnosis: Diagnosis, j: int) -> Mapping[str, str]:
    """Units at joint ``j`` (from 0)."""
    return UNITS[diagnosis.robot.links[j].joint.kind]


def ladder(diagnosis: Diagnosis, validated: bool) -> dict[str, Any]:
    """Rows of joints: how many times the noise floor the gap was and is, on a logarithmic scale."""
    gap = diagnosis.gap
    pairs = [chosen(diagnosis, validated)]
    if validated:
        pairs.append((gap.train_before, gap.train_after))
    with np.errstate(all="ignore"):
        times = [tuple(values / gap.noise_floor for values in pair) for pair in pairs]
    known = np.concatenate([values for pair in times for values in pair] or [np.ones(1)])
    known = known[np.isfinite(known)]
    top = max(_REACH, 1.15 * float(known.max(initial=0.0)))

    def at(value: float) -> float:
        return 100 * math.log(min(max(value, _LOW), top) / _LOW) / math.log(top / _LOW)

    before, after = pairs[0]
    rows = []
    for j in range(diagnosis.robot.n):
        drawn = []
        for kind, (a, b) in zip(("proof", "fitted"), times, strict=False):
            if math.isfinite(a[j]) and math.isfinite(b[j]):
                ends = sorted((at(float(a[j])), at(float(b[j]))))
                drawn.append(
                    {
                        "kind": kind,
                        "is_same": bool(a[j] == b[j]),
                        "before": percent(at(float(a[j]))),
                        "after": percent(at(float(b[j]))),
                        "low": percent(ends[0]),
                        "high": percent(ends[1]),
                    }
                )
        rows.append(
            {
                "joint": j + 1,
                "effects": _effects(diagnosis, j + 1),
                "drawn": drawn,
                "before": formatted(before[j]),
                "after": formatted(after[j]),
                "floor": formatted(gap.noise_floor[j]),
                "times": formatted(after[j] / floor) if (floor := gap.noise_floor[j]) > 0 else "n/a",
                "unit": units_at(diagnosis, j)["torque"],
                "change": change(before[j], after[j]),
                "is_same": bool(before[j] == after[j]),
            }
        )
    wide = math.log10(top / _LOW)
    steps = (1, 2, 3, 4, 6) if wide < 1 else (1, 2, 5) if wide < 1.7 else (1,)
    marks = [m * 10.0**k for k in range(math.ceil(math.log10(top)) + 1) for m in steps]
    ticks = [{"at": percent(at(v)), "label": f"{v:g}×"} for v in marks if v <= top]
    return {"rows": rows, "ticks": ticks[:: -(-len(ticks) // 6) or 1], "noise": percent(at(1.0))}


def _effects(diagnosis: Diagnosis, joint: int) -> str:
    """Claims that a row of a joint names."""
    names = [named(f.effect) for f in claims(diagnosis) if f.joint == joint]
    more = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
    return ", ".join(names[:_NAMED]) + more


def change(before: float, after: float) -> str:
    """A change in percent."""
    if not before > 0 or not math.isfinite(after / before):
        return "n/a"
    rounded = round(100 * (after / before - 1))
    return f"{rounded:+d} %".replace("-", "−") if rounded else "0 %"


def tables(diagnosis: Diagnosis, validated: bool) -> list[tuple[str, Floats, Floats]]:
    """The RMS [n] before and after of each kind of log, with a title."""
    gap = diagnosis.gap
    validation = ("Validation log, not fitted", gap.validate_before, gap.validate_after)
    fitted = ("Logs that were fitted", gap.train_before, gap.train_after)
    return [validation, fitted] if validated else [fitted]


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
                "place": capital(place_of(joint)),
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
                unit = units_at(diagnosis, joint - 1)["torque"]
                figures = f"{formatted(before[joint - 1])} → {formatted(after[joint - 1])} {unit}"
                remark = f"{remark}; RMS of the residual {figures}"
            groups.append(
                {"id": anchor(joint), "title": capital(place_of(joint)), "remark": remark, "cards": own}
            )
    return groups


def anchor(joint: int | None) -> str:
    """Where on the page the findings of a joint are."""
    return "robot" if joint is None else f"joint-{joint}"


def _joints(findings: Sequence[Finding]) -> list[int | None]:
    joints = sorted({f.joint for f in findings if f.joint is not None})
    return [*joints, *([None] if any(f.joint is None for f in findings) else [])]


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
