"""Charts of a fleet: what the logs of a unit show of a feature over the time, and when it changed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.draw.dates import DAY
from robodyn.fleet.result import Claim, Feature, Reading, UnitResult
from robodyn.report.chart_frames import Chart, Frame, Mark, Shade, percent, span
from robodyn.report.fleet_text import capital, has_unit, interval_text, since_text, what_text, with_error

Floats = NDArray[np.float64]

#: Half an interval that holds 95 of 100 errors, and the band that holds 95 of 100 siblings, in standard
#: deviations.
WITHIN: Final = 2.0
#: Room before the first and after the last day of a chart, as a share of its days; days of one that has none.
_ROOM, _FEWEST = 0.02, 30.0
#: A reading with an error so many times that of others says nothing.
_VAGUE: Final = 8.0
#: Signs of a unit of measurement at an axis, at most; longer ones stand below the chart only.
_LABEL: Final = 6
#: The narrowest interval of days that is seen, in percent of the width.
_NARROWEST: Final = 0.6


def readings_chart(unit: UnitResult, feature: Feature, claim: Claim | None = None) -> Chart | None:
    """What the logs of a ``unit`` show of a ``feature``, with 95 % intervals, beside what is usual among its
    siblings; of a ``claim`` when it changed and between which levels. None without readings."""
    x, y, error = _columns(unit.readings.get(feature.name, ()))
    if not len(x):
        return None
    low, high = y - WITHIN * error, y + WITHIN * error
    usual, telling = _usual(feature), _telling(error, feature)
    frame = Frame(*days_span(x, unit.first, unit.last), *span(low[telling], high[telling], usual))
    marks = [Mark("noise", frame.level(*usual)), Mark("whisker logged", frame.whiskers(x, low, high))]
    shades: list[Shade] = []
    if claim is not None:
        levels = _course(unit, feature, claim)
        marks.append(Mark("line after", frame.line(*levels)) if levels else Mark("line after", ""))
        shades = _interval(frame, claim)
    inside = frame.inside(x, y)
    marks.append(Mark("dots reading", frame.dots(x[inside], y[inside])))
    title = f"{unit.unit}: {what_text(feature)}"
    is_shown = has_unit(feature.unit) and len(feature.unit) <= _LABEL
    unit_label = f"[{feature.unit}]" if is_shown else ""
    text = _words(unit, feature, claim)
    return frame.chart(title, text, ("", unit_label), marks, most=(6, 4), shades=shades, days=True)


def sparkline(readings: Sequence[Reading], feature: Feature) -> str:
    """The path of a feature's readings, without axes; empty without any."""
    x, y, error = _columns(readings)
    if not len(x):
        return ""
    telling = _telling(error, feature)
    x, y = x[telling], y[telling]
    frame = Frame(*days_span(x), *span(y, _usual(feature)))
    return frame.line(x, y)


def days_span(*moments: Floats | float) -> tuple[float, float]:
    """The first and the last of some points in time, with room about them."""
    every = np.concatenate([np.atleast_1d(np.asarray(part, dtype=np.float64)) for part in moments])
    first, last = float(every.min()), float(every.max())
    half = _FEWEST * DAY / 2 if last - first < DAY else _ROOM * (last - first)
    return first - half, last + half


def _columns(readings: Sequence[Reading]) -> tuple[Floats, Floats, Floats]:
    """Days, values and errors [K] of what is known, by day."""
    rows = np.array([(r.date, r.value, r.stderr) for r in readings], dtype=np.float64).reshape(-1, 3)
    rows = rows[np.isfinite(rows[:, :2]).all(axis=1)]
    rows[:, 2] = np.where(np.isfinite(rows[:, 2]), rows[:, 2], 0.0)
    x, y, error = rows[np.argsort(rows[:, 0], kind="stable")].T
    return x, y, error


def _usual(feature: Feature) -> tuple[float, float]:
    """Between which values 95 of 100 siblings are."""
    half = WITHIN * feature.between_units
    return feature.mean - half, feature.mean + half


def _telling(error: Floats, feature: Feature) -> NDArray[np.bool_]:
    """Which readings [K] say something: a log in which a joint hardly moves has errors beyond all others."""
    return np.asarray(error <= _VAGUE * max(float(np.median(error)), feature.between_units), dtype=bool)


def _course(unit: UnitResult, feature: Feature, claim: Claim) -> tuple[Floats, Floats] | None:
    """Days and values along the course of a claim: at the mean of the readings before the change, and by
    the claim's size away from it afterwards; at the mean of all where there was no change. None where that
    is not known."""
    x, y, error = _columns(unit.readings.get(feature.name, ()))
    weight = 1 / (error**2 + feature.between_logs**2 + np.finfo(float).tiny)
    early = np.full(len(x), True) if claim.since is None else x < claim.since
    if not early.any():
        return None
    before = float(np.average(y[early], weights=weight[early]))
    if claim.since is None:
        return np.array([unit.first, unit.last]), np.array([before, before])
    after = before + claim.size
    if claim.shape == "drift":
        end = unit.last if claim.until is None else claim.until
        days = np.array([unit.first, claim.since, end, max(end, unit.last)])
        return days, np.array([before, before, after, after])
    days = np.array([unit.first, claim.since, claim.since, unit.last])
    return days, np.array([before, before, after, after])


def _interval(frame: Frame, claim: Claim) -> list[Shade]:
    """The days between which the change was."""
    if claim.since_interval is None:
        return []
    start, end = (min(max(frame.across(day), 0.0), 100.0) for day in claim.since_interval)
    return [Shade(percent(start), percent(max(end - start, _NARROWEST)), "")]


def _words(unit: UnitResult, feature: Feature, claim: Claim | None) -> str:
    """The chart for those who do not see it."""
    text = f"usual: {with_error(feature.mean, feature.between_units, feature.unit)}"
    if feature.name in unit.now:
        text = f"now {with_error(*unit.now[feature.name], feature.unit)}; {text}"
    if claim is None:
        return capital(text)
    days = interval_text(claim)
    return f"{capital(since_text(claim))}{f' ({days})' if days else ''}; {text}"
