"""Charts of a fleet: what the logs of a unit show of a feature over the time, and when it changed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.draw.scales import DAY
from robodyn.fleet.result import Claim, Feature, FleetResult, Reading, TypeResult, UnitResult
from robodyn.report import fleet_text as words
from robodyn.report.chart_frames import Chart, Frame, Mark, Shade, percent, span
from robodyn.report.figures import capital

#: Half an interval that holds 95 of 100 errors, and the band that holds 95 of 100 siblings, in standard
#: deviations.
WITHIN: Final = 2.0
#: Room before the first and after the last day of a chart, as a share of its days; days of one that has none.
_ROOM, _FEWEST = 0.02, 30.0
#: A reading with an error so many times that of others says nothing.
_VAGUE: Final = 8.0
#: Signs of a unit of measurement at an axis, at most; longer ones stand below the chart only.
_LABEL: Final = 6
#: Colours of programs of motion.
_COLOURS: Final = 4
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
    text = f"usual: {words.with_error(feature.mean, feature.between_units, feature.unit)}"
    if feature.name in unit.now:
        text = f"now {words.with_error(*unit.now[feature.name], feature.unit)}; {text}"
    shades: list[Shade] = []
    if claim is not None:
        weight = 1 / (error**2 + feature.between_logs**2 + np.finfo(float).tiny)
        marks.append(Mark("line after", _course(frame, unit, claim, x, y, weight)))
        days = words.interval_text(claim)
        text = f"{words.since_text(claim)}{f' ({days})' if days else ''}; {text}"
    if claim is not None and claim.since_interval is not None:
        start, end = (min(max(frame.across(day), 0.0), 100.0) for day in claim.since_interval)
        shades = [Shade(percent(start), percent(max(end - start, _NARROWEST)), "")]
    inside = frame.inside(x, y)
    programs = np.array([one.program for one in _in_order(unit.readings[feature.name])])
    for k, program in enumerate(dict.fromkeys(programs.tolist())):
        own = inside & (programs == program)
        marks.append(Mark(f"dots reading g{k % _COLOURS}", frame.dots(x[own], y[own])))
    title = f"{unit.unit}: {words.what_text(feature)}"
    is_shown = words.has_unit(feature.unit) and len(feature.unit) <= _LABEL
    labels = ("", f"[{feature.unit}]" if is_shown else "")
    return frame.chart(title, capital(text), labels, marks, most=(6, 4), shades=shades, days=True)


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


def _in_order(readings: Sequence[Reading]) -> list[Reading]:
    """What is known, by day."""
    known = [one for one in readings if words.is_known(one.date) and words.is_known(one.value)]
    return sorted(known, key=lambda one: one.date)


def _columns(readings: Sequence[Reading]) -> tuple[Floats, Floats, Floats]:
    """Days, values and errors [K] of what is known, by day."""
    rows = np.array([(r.date, r.value, r.stderr) for r in _in_order(readings)], dtype=np.float64)
    x, y, error = rows.reshape(-1, 3).T
    return x, y, np.where(np.isfinite(error), error, 0.0)


def _usual(feature: Feature) -> tuple[float, float]:
    """Between which values 95 of 100 siblings are."""
    half = WITHIN * feature.between_units
    return feature.mean - half, feature.mean + half


def _telling(error: Floats, feature: Feature) -> NDArray[np.bool_]:
    """Which readings [K] say something: a log in which a joint hardly moves has errors beyond all others."""
    return np.asarray(error <= _VAGUE * max(float(np.median(error)), feature.between_units), dtype=bool)


def _course(frame: Frame, unit: UnitResult, claim: Claim, x: Floats, y: Floats, weight: Floats) -> str:
    """The path of a claim: at the mean of the readings before the change, and by the claim's size away from
    it afterwards; at the mean of all where there was no change. Empty where that is not known."""
    since = claim.since
    early = np.full(len(x), True) if since is None else x < since
    if not early.any():
        return ""
    before = float(np.average(y[early], weights=weight[early]))
    if since is None:
        return frame.line(np.array([unit.first, unit.last]), np.array([before, before]))
    end = since
    if claim.shape == "drift":
        end = unit.last if claim.until is None else claim.until
    days = np.array([unit.first, since, end, max(end, unit.last)])
    return frame.line(days, before + np.array([0, 0, claim.size, claim.size]))


#: Rows of a type that are seen at once; the others are folded.
SHOWN: Final = 20
#: From how far beyond what is usual on, in standard deviations, a cell has its first, second, ... shade.
SHADES: Final = (2.0, 3.0, 4.5, 7.0, 10.0)


def ordered(result: FleetResult) -> list[UnitResult]:
    """The units, those with claims first, then the most unusual."""
    return sorted(
        result.units, key=lambda unit: (not unit.claims, -words.most_unusual(unit), unit.type, unit.unit)
    )


def type_maps(result: FleetResult) -> list[dict[str, Any]]:
    """A map of each type that has units: its columns, and its rows, the most unusual first."""
    units = list(enumerate(ordered(result)))
    maps = []
    for k, kind in enumerate(result.types):
        places = _places(kind)
        rows = [_row(unit, index, kind, places) for index, unit in units if unit.type == kind.name]
        if rows:
            maps.append(
                {
                    "name": kind.name,
                    "index": k,
                    "places": ["arm" if place is None else f"J{place}" for place in places],
                    "titles": [words.place_text(place) for place in places],
                    "shown": rows[:SHOWN],
                    "folded": rows[SHOWN:],
                }
            )
    return maps


def _row(unit: UnitResult, index: int, kind: TypeResult, places: Sequence[int | None]) -> dict[str, Any]:
    """A unit: where its page is, its place in the data of the script, what is named of it, and of each joint
    how far what is furthest from usual is."""
    named = {claim.joint for claim in unit.claims}
    cells = []
    for place in places:
        values = [unit.unusual.get(f.name) for f in kind.features if f.joint == place]
        value = max((round(x, 1) for x in values if words.is_known(x)), key=abs, default=None)
        css = " ".join([*shade_css(value).split(), *(["named"] if place in named else [])])
        cells.append({"text": words.unusual_text(value), "css": css})
    text = capital("; ".join(words.brief(claim) for claim in unit.claims))
    return {"unit": unit.unit, "page": words.page_of(unit), "index": index, "cells": cells, "named": text}


def script_data(result: FleetResult) -> dict[str, Any]:
    """What the script is told, so that a cell can say what it shows and the map be made of one kind of
    effects: kinds; of each type the features (title, joint or 0, kind, what is usual); of each unit, in the
    order of the rows, how unusual each feature is (tenths), how much it is, and which are named."""
    kinds = kinds_of(result)
    types = []
    for kind in result.types:
        features = []
        for f in kind.features:
            title = capital(words.effects_text(f.effects))
            usual = words.with_error(f.mean, f.between_units, f.unit)
            features.append([title, f.joint or 0, kinds.index(title), usual])
        places = [place or 0 for place in _places(kind)]
        types.append({"name": kind.name, "places": places, "features": features})
    indices = {kind.name: (k, kind.features) for k, kind in enumerate(result.types)}
    units = [_unit(unit, *indices[unit.type]) for unit in ordered(result)]
    return {"shades": SHADES, "kinds": kinds, "types": types, "units": units}


def _unit(unit: UnitResult, type: int, features: Sequence[Feature]) -> list[Any]:
    unusual = [unit.unusual.get(f.name) for f in features]
    now = [(unit.now.get(f.name, (None,))[0], f.unit) for f in features]
    named = [k for k, f in enumerate(features) if any(claim.feature == f.name for claim in unit.claims)]
    return [
        type,
        unit.unit,
        [round(10 * value) if words.is_known(value) else None for value in unusual],
        [words.with_unit(value, unit) if words.is_known(value) else "" for value, unit in now],
        named,
    ]


def kinds_of(result: FleetResult) -> list[str]:
    """The kinds of features that there are, in words, in the order in which the types have them."""
    every = [capital(words.effects_text(f.effects)) for kind in result.types for f in kind.features]
    return list(dict.fromkeys(every))


def shade_css(value: float | None) -> str:
    """The name of the looks of a cell; empty for what is usual."""
    steps = sum(abs(round(value, 1)) >= bound for bound in SHADES) if words.is_known(value) else 0
    return f"{'p' if value and value > 0 else 'm'}{steps}" if steps else ""


def _places(kind: TypeResult) -> tuple[int | None, ...]:
    """The columns of a type: all its joints, and the whole arm (None) if there are features of it."""
    whole = any(feature.joint is None for feature in kind.features)
    return (*range(1, kind.joints + 1), *([None] if whole else []))
