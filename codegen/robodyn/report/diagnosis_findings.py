"""Findings of a diagnosis as cards: the values and their intervals, a picture, the evidence for the name."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np

from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Rival, Series
from robodyn.report.chart_frames import Chart, percent
from robodyn.report.diagnosis_charts import Across, over, over_time
from robodyn.report.diagnosis_joints import units_at
from robodyn.report.diagnosis_text import (
    interval_text,
    is_contact,
    is_unseen,
    named,
    place_of,
    title_of,
    traits_of,
    value_text,
)
from robodyn.report.diagnosis_where import Localised
from robodyn.report.figures import capital, formatted

#: An interval is drawn from nothing to this many times the value.
REACH: Final = 2.0
#: Cards with pictures, and with values, at most.
_PICTURES, MOST_CARDS = 20, 40
#: What is drawn over time.
_IN_TIME: Final = ("a short time", "constant")


def across(series: Series, j: int, name: str, units: Mapping[str, str]) -> Across:
    """What the residual of joint ``j`` (from 0) is drawn over, by its name in ``QUANTITIES``."""
    if name in ("velocity", "direction", "constant"):
        return Across("velocity", units["velocity"], series.qd[:, j])
    if name.startswith("load"):
        return Across("load", units["torque"], series.load[:, j], each_way=True)
    if name == "acceleration":
        return Across(name, units["acceleration"], series.qdd[:, j], each_way=True)
    return Across("position", units["position"], series.q[:, j], each_way=True)


def cards(diagnosis: Diagnosis, places: Sequence[Localised], windows: Any) -> list[dict[str, Any]]:
    """A card for each finding, those that are claims first."""
    ordered = sorted(diagnosis.findings, key=lambda f: f.confidence < CLAIM)
    return [
        {
            "effect": f.effect,
            "joint": f.joint,
            "title": title_of(f.effect),
            "place": place_of(f.joint),
            "confidence": f"{100 * f.confidence:.0f} %",
            "sure": part(f.confidence),
            "is_claim": f.confidence >= CLAIM,
            "rivals": f.confounded_with,
            "where": _where(f),
            "parameters": [
                _parameter(f.effect, name, p)
                for name, p in f.parameters.items()
                if not is_unseen(p, f.effect, name)
            ],
            "unseen": [name for name, p in f.parameters.items() if is_unseen(p, f.effect, name)],
            "evidence": _evidence(f),
            "parts": _parts(f),
            "t": formatted(f.t),
            "picture": _picture(diagnosis, f, places, windows) if k < _PICTURES else None,
        }
        for k, f in enumerate(ordered[:MOST_CARDS])
    ]


def _where(finding: Finding) -> str:
    """Words of where, without the place, which stands above them."""
    text = finding.where.removeprefix(f"{place_of(finding.joint)}: ")
    return capital(text)


# --- values -----------------------------------------------------------------------------------------------


def _parameter(effect: str, name: str, estimate: Estimate) -> dict[str, Any]:
    """A parameter with its interval, which is drawn beside what would be nothing: as shares of the value."""
    value, error, interval = estimate.value, estimate.stderr, estimate.interval
    nothing = traits_of(effect).nothing.get(name, 0.0)
    drawn, words, relative = None, "", ""
    is_known = not isinstance(value, str) and math.isfinite(value) and not is_unseen(estimate, effect, name)
    if is_known and interval is not None and not isinstance(value, str):
        words = interval_text(value, interval)
        away = value - nothing
        if away:
            low, high = ((side - nothing) / away if side is not None else None for side in interval)
            low, high = (low, high) if away > 0 else (high, low)
            half = None if low is None or high is None else (high - low) / 2
            relative = f"± {100 * half:.2g} %" if half is not None and not nothing and half < 1 else ""
            way = math.copysign(1, away)
            scale = 100 / (2 * REACH)
            shares = (-math.inf if low is None else low, math.inf if high is None else high)
            ends = sorted(min(max(scale * (REACH + way * share), 0.0), 100.0) for share in shares)
            drawn = {
                "low": percent(ends[0]),
                "width": percent(max(ends[1] - ends[0], 0.6)),
                "value": percent(scale * (REACH + way)),
                "reaches": shares[0] <= 0,
            }
    return {
        "name": name,
        "text": value_text(estimate, effect, name).replace("^2", "²"),
        "words": words,
        "relative": relative,
        "nothing": f"{nothing:g}",
        "drawn": drawn,
        "is_fitted": is_contact(effect) or isinstance(value, str) or bool(error or estimate.bounds),
    }


def part(share: float) -> str:
    """A share as the width of a bar, 0 to 100."""
    return f"{100 * min(max(share, 0.0), 1.0):.1f}" if math.isfinite(share) else "0"


# --- evidence ---------------------------------------------------------------------------------------------


def _evidence(finding: Finding) -> list[dict[str, Any]]:
    itself = Rival(finding.effect, finding.joint, finding.gain, finding.parts)
    rows = [itself, *finding.rivals]
    top = max((row.gain for row in rows if math.isfinite(row.gain)), default=0.0)
    return [
        {
            "title": title_of(row.effect),
            "place": "" if row.joint == finding.joint else place_of(row.joint),
            "gain": formatted(row.gain),
            "width": part(row.gain / top if top > 0 else 0.0),
            "share": f"{100 * row.gain / top:.0f} %" if top > 0 and math.isfinite(row.gain) else "n/a",
            "is_named": k == 0,
            "is_open": k > 0 and row.effect in finding.confounded_with,
            "why": "; ".join(text for text in (_ahead(itself, row) if k else "", row.why) if text),
        }
        for k, row in enumerate(rows)
    ]


def _ahead(itself: Rival, other: Rival) -> str:
    """In how many parts of the log an effect explains more than a rival."""
    if not other.parts or len(itself.parts) != len(other.parts):
        return ""
    ahead = sum(a > b for a, b in zip(itself.parts, other.parts, strict=True))
    return f"behind in {ahead} of {len(other.parts)} parts"


def _parts(finding: Finding) -> dict[str, Any] | None:
    """Gains in the parts of the log: how many there are, and in how many the effect helped."""
    known = [x for x in finding.parts if math.isfinite(x)]
    if not known:
        return None
    top = max(abs(x) for x in known) or 1.0
    return {
        "good": sum(x > 0 for x in known),
        "all": len(known),
        "bars": [{"height": part(abs(x) / top), "is_good": x > 0} for x in known],
    }


# --- pictures ---------------------------------------------------------------------------------------------


def _picture(
    diagnosis: Diagnosis, finding: Finding, places: Sequence[Localised], windows: Any
) -> Chart | None:
    """The residual at the joint that shows a finding best, over what it depends on."""
    if not diagnosis.series or len(diagnosis.series[0].times) < 2:
        return None
    series = diagnosis.series[0]
    j = (finding.joint or max(places, key=lambda place: place.share).joint) - 1
    units, floor = units_at(diagnosis, j), float(diagnosis.gap.noise_floor[j])
    own = _own(series, finding, diagnosis, units)
    if own is not None:
        return over(series, j, own, units["torque"], floor, dots=260, wide=True)
    name = traits_of(finding.effect).over or places[j].best or "position"
    if name in _IN_TIME:
        return over_time(series, j, units["torque"], floor, windows)
    return over(series, j, across(series, j, name, units), units["torque"], floor, dots=260, wide=True)


def looks(diagnosis: Diagnosis, place: Localised, windows: Any) -> list[Chart]:
    """What is left at a joint over time, and over what shows it best."""
    if not diagnosis.series or len(diagnosis.series[0].times) < 2:
        return []
    series, j = diagnosis.series[0], place.joint - 1
    units, floor = units_at(diagnosis, j), float(diagnosis.gap.noise_floor[j])
    charts = [over_time(series, j, units["torque"], floor, windows)]
    if place.best not in (None, *_IN_TIME):
        what = across(series, j, place.best or "", units)
        charts.append(over(series, j, what, units["torque"], floor, dots=260, wide=True))
    return charts


def _own(series: Series, finding: Finding, diagnosis: Diagnosis, units: Mapping[str, str]) -> Across | None:
    """What one effect alone depends on: the angle within a ripple, the speed of another joint."""
    if finding.joint is None:
        return None
    numbers = {
        name: float(p.value)
        for name, p in finding.parameters.items()
        if not isinstance(p.value, str) and math.isfinite(p.value)
    }
    cycles, other = numbers.get(traits_of(finding.effect).cycles, 0.0), numbers.get("with", 0.0)
    if cycles > 0 and units["position"] == "rad":
        turns = np.mod(series.q[:, finding.joint - 1] * cycles / (2 * math.pi), 1.0)
        return Across(f"place in a cycle of 1/{cycles:.4g} turn", "", turns, each_way=True)
    if 1 <= other <= diagnosis.robot.n and other == int(other):
        k = int(other) - 1
        return Across(f"velocity of joint {k + 1}", units_at(diagnosis, k)["velocity"], series.qd[:, k])
    return None


def next_of(diagnosis: Diagnosis) -> list[dict[str, str]]:
    """What to record next: what it settles, and how; each thing once."""
    seen: dict[str, dict[str, str]] = {}
    for f in diagnosis.findings:
        if f.experiment:
            about = f"{title_of(f.effect)} ({place_of(f.joint)})"
            title = (
                f"{about} or {', '.join(named(r) for r in f.confounded_with)}" if f.confounded_with else about
            )
            seen.setdefault(f.experiment, {"title": title, "text": capital(f.experiment)})
    return list(seen.values())
