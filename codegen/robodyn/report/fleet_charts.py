"""Charts of a fleet: what the logs of a unit show of a feature over the time, and when it changed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.draw.scales import DAY
from robodyn.fleet.result import (
    Claim,
    Feature,
    FleetResult,
    Reading,
    TypeResult,
    UnitResult,
    address,
    unit_folder,
)
from robodyn.report.chart_frames import Chart, Frame, Mark, Shade, percent, span
from robodyn.report.figures import capital
from robodyn.report.fleet_text import (
    brief,
    effects_text,
    has_unit,
    interval_text,
    is_known,
    most_unusual,
    since_text,
    unusual_text,
    what_text,
    with_error,
    with_unit,
)

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


#: Rows of a type that are seen at once; the others are folded.
SHOWN: Final = 20
#: From how far beyond what is usual on, in standard deviations, a cell has its first, second, ... shade.
SHADES: Final = (2.0, 3.0, 4.5, 7.0, 10.0)


@dataclass(frozen=True, slots=True)
class Cell:
    """A joint of a unit: the feature that is furthest from usual there, and how far; ``shade``: 0 for what
    is usual, negative for less; ``is_named``: something there is a claim."""

    text: str
    shade: int
    is_named: bool

    @property
    def css(self) -> str:
        """The names of its looks."""
        shade = f"p{self.shade}" if self.shade > 0 else f"m{-self.shade}" if self.shade < 0 else ""
        return " ".join(part for part in (shade, "named" if self.is_named else "") if part)


@dataclass(frozen=True, slots=True)
class Row:
    """A unit: where its page is, its place in the data of the script, its cells, what is named of it."""

    unit: str
    page: str
    index: int
    cells: tuple[Cell, ...]
    named: str


@dataclass(frozen=True, slots=True)
class TypeMap:
    """The rows of a type, the most unusual first; ``places`` are the columns: joints, and the whole arm."""

    name: str
    index: int
    places: tuple[str, ...]
    titles: tuple[str, ...]
    shown: tuple[Row, ...]
    folded: tuple[Row, ...]


def ordered(result: FleetResult) -> list[UnitResult]:
    """The units, those with claims first, then the most unusual."""
    return sorted(result.units, key=lambda unit: (not unit.claims, -most_unusual(unit), unit.type, unit.unit))


def type_maps(result: FleetResult) -> list[TypeMap]:
    """A map of each type that has units."""
    by_type: dict[str, list[tuple[int, UnitResult]]] = {}
    for index, unit in enumerate(ordered(result)):
        by_type.setdefault(unit.type, []).append((index, unit))
    maps = []
    for k, kind in enumerate(result.types):
        places = _places(kind)
        rows = tuple(_row(unit, index, kind, places) for index, unit in by_type.get(kind.name, []))
        if rows:
            texts = tuple("arm" if place is None else f"J{place}" for place in places)
            titles = tuple("the whole arm" if place is None else f"joint {place}" for place in places)
            maps.append(TypeMap(kind.name, k, texts, titles, rows[:SHOWN], rows[SHOWN:]))
    return maps


def script_data(result: FleetResult) -> dict[str, Any]:
    """What the script is told, so that a cell can say what it shows and the map be made of one kind of
    effects: kinds; of each type the features; of each unit, in the order of the rows, how unusual and how
    much each feature is."""
    kinds = kinds_of(result)
    indices = {kind.name: k for k, kind in enumerate(result.types)}
    return {
        "shades": SHADES,
        "kinds": kinds,
        "types": [
            {
                "name": kind.name,
                "places": [place or 0 for place in _places(kind)],
                "features": [_feature(feature, kinds) for feature in kind.features],
            }
            for kind in result.types
        ],
        "units": [
            _unit(unit, indices[unit.type], result.types[indices[unit.type]].features)
            for unit in ordered(result)
        ],
    }


def kinds_of(result: FleetResult) -> list[str]:
    """The kinds of features that there are, in words, in the order in which the types have them."""
    every = [capital(effects_text(feature.effects)) for kind in result.types for feature in kind.features]
    return list(dict.fromkeys(every))


def furthest(values: Mapping[str, float], features: Sequence[Feature]) -> float | None:
    """The value of the feature that is furthest from usual, to a tenth; None where none is known."""
    known = [round(value, 1) for feature in features if is_known(value := values.get(feature.name))]
    return max(known, key=abs, default=None)


def shade_of(value: float | None) -> int:
    """The shade of a cell, with the sign of ``value``."""
    if not is_known(value):
        return 0
    steps = sum(abs(value) >= bound for bound in SHADES)
    return steps if value > 0 else -steps


def page_of(unit: UnitResult) -> str:
    """The address of the page of a unit."""
    return address(f"{unit_folder(unit.type, unit.unit)}/index.html")


def _places(kind: TypeResult) -> tuple[int | None, ...]:
    """The columns of a type: all its joints, and the whole arm (None) if there are features of it."""
    whole = any(feature.joint is None for feature in kind.features)
    return (*range(1, kind.joints + 1), *([None] if whole else []))


def _row(unit: UnitResult, index: int, kind: TypeResult, places: Sequence[int | None]) -> Row:
    named = {claim.joint for claim in unit.claims}
    by_place = {
        place: list(group)
        for place, group in groupby(
            sorted(kind.features, key=lambda feature: feature.joint or 0), key=lambda feature: feature.joint
        )
    }
    cells = []
    for place in places:
        value = furthest(unit.unusual, by_place.get(place, []))
        cells.append(Cell(unusual_text(value), shade_of(value), place in named))
    words = "; ".join(brief(claim) for claim in unit.claims)
    return Row(unit.unit, page_of(unit), index, tuple(cells), capital(words))


def _feature(feature: Feature, kinds: Sequence[str]) -> list[Any]:
    """Title, joint (0: the whole arm), kind, and what is usual."""
    title = capital(effects_text(feature.effects))
    usual = with_error(feature.mean, feature.between_units, feature.unit)
    return [title, feature.joint or 0, kinds.index(title), usual]


def _unit(unit: UnitResult, type: int, features: Sequence[Feature]) -> list[Any]:
    """Type, name, how unusual each feature is (tenths), how much it is, and which features are named."""
    unusual = [_tenths(unit.unusual.get(feature.name)) for feature in features]
    now = [_amount(unit.now.get(feature.name), feature.unit) for feature in features]
    named = [k for k, f in enumerate(features) if any(claim.feature == f.name for claim in unit.claims)]
    return [type, unit.unit, unusual, now, named]


def _tenths(value: float | None) -> int | None:
    return round(10 * value) if is_known(value) else None


def _amount(now: tuple[float, float] | None, unit: str) -> str:
    return with_unit(now[0], unit) if now is not None and is_known(now[0]) else ""
