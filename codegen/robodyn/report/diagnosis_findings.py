"""Findings of a diagnosis as cards: the values and their intervals, a picture, the evidence for the name."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np

from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Rival, Series, Window
from robodyn.report import diagnosis_text as words
from robodyn.report.chart_frames import Chart, percent
from robodyn.report.diagnosis_residual import Across, Localised, over, over_time
from robodyn.report.figures import capital, formatted

#: An interval is drawn from nothing to this many times the value.
REACH: Final = 2.0
#: Cards with pictures, and with values, at most.
_PICTURES, MOST_CARDS = 20, 40
#: What is drawn over time.
_IN_TIME: Final = ("a short time", "constant")


def cards(
    diagnosis: Diagnosis, places: Sequence[Localised], windows: Sequence[Window]
) -> list[dict[str, Any]]:
    """A card for each finding, those that are claims first."""
    ordered = sorted(diagnosis.findings, key=lambda f: f.confidence < CLAIM)
    return [
        {
            "effect": f.effect,
            "joint": f.joint,
            "title": words.title_of(f.effect),
            "place": words.place_of(f.joint),
            "confidence": f"{100 * f.confidence:.0f} %",
            "sure": part(f.confidence),
            "is_claim": f.confidence >= CLAIM,
            "rivals": f.confounded_with,
            "where": capital(f.where.removeprefix(f"{words.place_of(f.joint)}: ")),
            "parameters": [_parameter(f.effect, name, p) for name, p in words.identified(f).items()],
            "unseen": [name for name in f.parameters if name not in words.identified(f)],
            "evidence": _evidence(f),
            "parts": _parts(f),
            "picture": _picture(diagnosis, f, places, windows) if k < _PICTURES else None,
        }
        for k, f in enumerate(ordered[:MOST_CARDS])
    ]


def _parameter(effect: str, name: str, estimate: Estimate) -> dict[str, Any]:
    """A parameter with its interval, which is drawn beside what would be nothing: as shares of the value."""
    value, interval = estimate.value, estimate.interval
    nothing = words.traits_of(effect).nothing.get(name, 0.0)
    drawn, text, relative = None, "", ""
    if not isinstance(value, str) and math.isfinite(value) and interval is not None:
        text = words.interval_text(value, interval)
        away = value - nothing
        if away:
            shares = [
                sign * math.inf if side is None else (side - nothing) / away
                for sign, side in zip(
                    (-math.copysign(1, away), math.copysign(1, away)), interval, strict=True
                )
            ]
            half = abs(shares[1] - shares[0]) / 2
            relative = f"± {100 * half:.2g} %" if not nothing and half < 1 else ""
            scale = 100 / (2 * REACH)
            way = math.copysign(scale, away)
            ends = sorted(min(max(scale * REACH + way * share, 0.0), 100.0) for share in shares)
            drawn = {
                "low": percent(ends[0]),
                "width": percent(max(ends[1] - ends[0], 0.6)),
                "value": percent(scale * REACH + way),
                "reaches": min(shares) <= 0,
            }
    return {
        "name": name,
        "text": words.value_text(estimate, effect, name).replace("^2", "²"),
        "words": text,
        "relative": relative,
        "nothing": f"{nothing:g}",
        "drawn": drawn,
        "is_fitted": words.is_contact(effect)
        or isinstance(value, str)
        or bool(estimate.stderr or estimate.bounds),
    }


def part(share: float) -> str:
    """A share as the width of a bar, 0 to 100."""
    return f"{100 * min(max(share, 0.0), 1.0):.1f}" if math.isfinite(share) else "0"


def _evidence(finding: Finding) -> list[dict[str, Any]]:
    itself = Rival(finding.effect, finding.joint, finding.gain, finding.parts)
    rows = [itself, *finding.rivals]
    top = max((row.gain for row in rows if math.isfinite(row.gain)), default=0.0)
    return [
        {
            "title": words.title_of(row.effect),
            "place": "" if row.joint == finding.joint else words.place_of(row.joint),
            "gain": formatted(row.gain),
            "width": part(row.gain / top if top > 0 else 0.0),
            "share": f"{100 * row.gain / top:.0f} %" if top > 0 and math.isfinite(row.gain) else "n/a",
            "is_named": k == 0,
            "is_open": k > 0 and row.effect in finding.confounded_with,
            "why": "; ".join(text for text in (_lead_text(itself, row) if k else "", row.why) if text),
        }
        for k, row in enumerate(rows)
    ]


def _lead_text(itself: Rival, other: Rival) -> str:
    """In how many parts of the log an effect explains more than a rival."""
    if not other.parts or len(itself.parts) != len(other.parts):
        return ""
    ahead = sum(a > b for a, b in zip(itself.parts, other.parts, strict=True))
    return f"behind in {ahead} of {len(other.parts)} parts"


def _parts(finding: Finding) -> dict[str, Any] | None:
    """Gains in the parts of the log: how many there are, and in how many the effect helped."""
    gains = [x for x in finding.parts if math.isfinite(x)]
    if not gains:
        return None
    top = max(map(abs, gains)) or 1.0
    return {
        "good": sum(x > 0 for x in gains),
        "all": len(gains),
        "bars": [{"height": part(abs(x) / top), "is_good": x > 0} for x in gains],
    }


# --- pictures ---------------------------------------------------------------------------------------------


def across(series: Series, j: int, name: str, units: Mapping[str, str]) -> Across:
    """What the residual of joint ``j`` (from 0) is drawn over, by its name in ``QUANTITIES``."""
    if name in ("velocity", "direction", "constant"):
        return Across("velocity", units["velocity"], series.qd[:, j])
    if name.startswith("load"):
        return Across("load", units["torque"], series.load[:, j], each_way=True)
    if name == "acceleration":
        return Across(name, units["acceleration"], series.qdd[:, j], each_way=True)
    return Across("position", units["position"], series.q[:, j], each_way=True)


def _picture(
    diagnosis: Diagnosis, finding: Finding, places: Sequence[Localised], windows: Sequence[Window]
) -> Chart | None:
    """The residual at the joint that shows a finding best, over what it depends on."""
    place = places[finding.joint - 1] if finding.joint else max(places, key=lambda place: place.share)
    name = words.traits_of(finding.effect).over or place.best or "position"
    charts = _charts(diagnosis, place.joint - 1, name, windows, _dependence(diagnosis, finding))
    return charts[-1] if charts else None


def looks(diagnosis: Diagnosis, place: Localised, windows: Sequence[Window]) -> list[Chart]:
    """What is left at a joint over time, and over what shows it best."""
    return _charts(diagnosis, place.joint - 1, place.best or "constant", windows)


def _charts(
    diagnosis: Diagnosis, j: int, name: str, windows: Sequence[Window], abscissa: Across | None = None
) -> list[Chart]:
    """What is left at joint ``j`` (from 0) over time and, where time does not show it best, over the quantity
    ``name`` or the ``abscissa``; none without samples."""
    if not diagnosis.series or len(diagnosis.series[0].times) < 2:
        return []
    series, units = diagnosis.series[0], words.units_at(diagnosis, j)
    floor = float(diagnosis.gap.noise_floor[j])
    charts = [over_time(series, j, units["torque"], floor, windows)]
    if abscissa is not None or name not in _IN_TIME:
        abscissa = abscissa or across(series, j, name, units)
        charts.append(over(series, j, abscissa, units["torque"], floor))
    return charts


def _dependence(diagnosis: Diagnosis, finding: Finding) -> Across | None:
    """What one effect alone depends on: the angle within a ripple, the speed of another joint."""
    if finding.joint is None or not diagnosis.series:
        return None
    series, j = diagnosis.series[0], finding.joint - 1
    numbers = {
        name: float(p.value)
        for name, p in finding.parameters.items()
        if not isinstance(p.value, str) and math.isfinite(p.value)
    }
    cycles, other = numbers.get(words.traits_of(finding.effect).cycles, 0.0), numbers.get("with", 0.0)
    if cycles > 0 and words.units_at(diagnosis, j)["position"] == "rad":
        turns = np.mod(series.q[:, j] * cycles / (2 * math.pi), 1.0)
        return Across(f"place in a cycle of 1/{cycles:.4g} turn", "", turns, each_way=True)
    if 1 <= other <= diagnosis.robot.n and other == int(other):
        k = int(other) - 1
        return Across(f"velocity of joint {k + 1}", words.units_at(diagnosis, k)["velocity"], series.qd[:, k])
    return None


def next_of(diagnosis: Diagnosis) -> list[dict[str, str]]:
    """What to record next: what it settles, and how; each thing once."""
    steps: dict[str, dict[str, str]] = {}
    for f in diagnosis.findings:
        if f.experiment:
            rivals = f" or {', '.join(map(words.named, f.confounded_with))}" if f.confounded_with else ""
            title = f"{words.title_of(f.effect)} ({words.place_of(f.joint)}){rivals}"
            steps.setdefault(f.experiment, {"title": title, "text": capital(f.experiment)})
    return list(steps.values())
