"""The page of a fleet: one HTML file that needs no network. What matters stands on top: how many units differ
and how sure that is, and the units to look at first.

Names of units, types and files may be any text: they are escaped wherever they stand, and the page's own
policy names its one script by its hash.
"""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final

import numpy as np

from robodyn.draw.markup import json_text, markup_template, policy, script_template, script_text
from robodyn.draw.scales import day_text, range_text
from robodyn.fleet.result import (
    Claim,
    Feature,
    FleetResult,
    Look,
    TypeResult,
    UnitResult,
    address,
    unit_folder,
)
from robodyn.report import fleet_text
from robodyn.report.chart_frames import Frame, percent
from robodyn.report.figures import capital
from robodyn.report.fleet_charts import (
    SHADES,
    days_span,
    kinds_of,
    page_of,
    readings_chart,
    script_data,
    shade_of,
    sparkline,
    type_maps,
)
from robodyn.report.fleet_text import (
    brief,
    counted,
    days_of,
    effects_text,
    extent_text,
    false_text,
    has_unit,
    headline,
    interval_text,
    is_known,
    place_text,
    plain,
    several,
    since_text,
    size_text,
    unusual_text,
    what_text,
    with_error,
)

#: Changes and unused logs that are seen at once; the others are folded. Unused logs that are listed.
_CHANGES, _UNUSED, _LISTED = 40, 12, 500
#: Ticks of the time line at most.
_TICKS: Final = 8


def page(result: FleetResult) -> str:
    """The HTML of ``result``, the same bytes at any time and place."""
    from importlib.metadata import version

    script = script_text(script_template("fleet.js").render())
    return markup_template("fleet.html.j2").render(
        name=result.name,
        headline=headline(result),
        extent=extent_text(result),
        tiles=_tiles(result),
        looks=_looks(result),
        maps=type_maps(result),
        kinds=kinds_of(result),
        types=[kind.name for kind in result.types],
        units=len(result.units),
        shades=[f"{bound:g}" for bound in SHADES],
        timeline=_timeline(result),
        populations=[
            (kind, sorted({name for feature in kind.features for name in feature.slopes}))
            for kind in result.types
        ],
        unused=result.unused[:_LISTED],
        unused_count=len(result.unused),
        unused_shown=_UNUSED,
        data=json_text(script_data(result)),
        script=script,
        policy=policy([script]),
        version=version("robodyn"),
        words=fleet_text,
    )


# --- the head ---------------------------------------------------------------------------------------------


def _tiles(result: FleetResult) -> list[tuple[str, str, str]]:
    """Question, answer, and a remark on it."""
    claims = [claim for unit in result.units for claim in unit.claims]
    different = sum(bool(unit.claims) for unit in result.units)
    what = counted([effects_text(claim.effects) for claim in claims]) if claims else "no unit stands out"
    changed = [claim for claim in claims if claim.since is not None]
    when = f"{len(changed):,} changed"
    always = len(claims) - len(changed)
    tiles = [
        ("Units that differ", f"{different:,} of {len(result.units):,}", what),
        ("How sure", f"{100 * result.false_names:g} % false names", false_text(result)),
        ("Since when", when if claims else "nothing", _latest(changed, always) if claims else "has changed"),
    ]
    if result.first_to_look_at:
        first = result.first_to_look_at[0]
        tiles.append(("Look first at", first.unit, _why(result, first)))
    return tiles


def _why(result: FleetResult, look: Look) -> str:
    """Why to look at a unit, in a few words."""
    claims = (
        claim
        for one in result.units
        if (one.type, one.unit) == (look.type, look.unit)
        for claim in one.claims
    )
    first = next(claims, None)
    return look.why if first is None else capital(brief(first))


def _latest(changed: Sequence[Claim], always: int) -> str:
    """When the last change was, and how many differ in all their logs."""
    parts = []
    if changed:
        last = max(changed, key=lambda claim: claim.since or 0.0)
        parts.append(f"the last one on {day_text(last.since or 0.0)}")
    if always:
        parts.append(f"{always:,} {'differs' if always == 1 else 'differ'} in all logs")
    return "; ".join(parts)


# --- what to look at --------------------------------------------------------------------------------------


def _looks(result: FleetResult) -> list[dict[str, Any]]:
    units = {(unit.type, unit.unit): unit for unit in result.units}
    kinds = {kind.name: kind for kind in result.types}
    return [
        _look(look, units[look.type, look.unit], kinds[look.type])
        for look in result.first_to_look_at
        if (look.type, look.unit) in units and look.type in kinds
    ]


def _look(look: Look, unit: UnitResult, kind: TypeResult) -> dict[str, Any]:
    features = {feature.name: feature for feature in kind.features}
    claim = next((claim for claim in unit.claims if claim.feature in features), None)
    chart = readings_chart(unit, features[claim.feature], claim) if claim else _strangest(unit, features)
    return {
        "unit": unit.unit, "type": unit.type, "page": page_of(unit),
        "diagnosis": address(unit.diagnosis) if unit.diagnosis else None,
        "why": capital(look.why), "record": capital(look.record),
        "logs": several(unit.logs, "log"), "chart": chart,
        "claims": [claim_words(one) for one in unit.claims],
    }  # fmt: skip


def _strangest(unit: UnitResult, features: Mapping[str, Feature]) -> Any:
    """The chart of the most unusual feature of a unit of which nothing is claimed; None without any."""
    known = [name for name, value in unit.unusual.items() if is_known(value) and name in features]
    name = max(known, key=lambda name: abs(unit.unusual[name]), default=None)
    return readings_chart(unit, features[name]) if name else None


def claim_words(claim: Claim) -> dict[str, str]:
    """What is peculiar, in parts."""
    return {
        "what": capital(what_text(claim)), "size": size_text(claim), "since": since_text(claim),
        "interval": interval_text(claim),
        "p": f"{claim.p:.1g}", "q": f"{claim.q:.1g}",
    }  # fmt: skip


# --- what changed and when --------------------------------------------------------------------------------


def _timeline(result: FleetResult) -> dict[str, Any]:
    """A row for each claim: those with a day in their order, then those that were always so."""
    rows = [(unit, claim) for unit in result.units for claim in unit.claims]
    rows.sort(key=lambda row: (row[1].since is None, row[1].since or 0.0, row[0].type, row[0].unit))
    span = days_of(result)
    if span is None:
        return {"rows": [], "more": [], "ticks": []}
    frame = Frame(*days_span(np.array(span)), 0.0, 1.0)
    drawn = [_change(unit, claim, frame) for unit, claim in rows]
    axis = frame.chart("", "", ("", ""), (), most=(_TICKS, 2), days=True)
    return {"rows": drawn[:_CHANGES], "more": drawn[_CHANGES:], "ticks": axis.x_ticks}


def _change(unit: UnitResult, claim: Claim, frame: Frame) -> dict[str, Any]:
    def at(moment: float) -> float:
        return min(max(frame.across(moment), 0.0), 100.0)

    low, high = claim.since_interval or (unit.first, unit.last)
    return {
        **claim_words(claim),
        "unit": unit.unit,
        "type": unit.type,
        "page": page_of(unit),
        "first": percent(at(unit.first)),
        "days": percent(at(unit.last) - at(unit.first)),
        "low": percent(at(low)),
        "width": percent(max(at(high) - at(low), 0.3)),
        "at": None if claim.since is None else percent(at(claim.since)),
        "is_less": claim.size < 0,
    }


#: Features that are drawn: those of claims, then the most unusual ones up to so many.
_DRAWN: Final = 4


def unit_pages(result: FleetResult) -> Iterator[tuple[str, str]]:
    """The path of each unit's page, relative to the fleet's, and its HTML; the same bytes at any time."""
    from importlib.metadata import version

    kinds, own = {kind.name: kind for kind in result.types}, version("robodyn")
    looks = {(look.type, look.unit): capital(look.record) for look in result.first_to_look_at}
    for unit in result.units:
        path = f"{unit_folder(unit.type, unit.unit)}/index.html"
        record = looks.get((unit.type, unit.unit), "")
        yield path, _page(result.name, unit, kinds[unit.type], record, own)


def _page(fleet: str, unit: UnitResult, kind: TypeResult, record: str, version: str) -> str:
    folder = unit_folder(unit.type, unit.unit)
    return markup_template("fleet_unit.html.j2").render(
        fleet=fleet,
        back=posixpath.relpath("index.html", folder),
        unit=unit.unit,
        type=unit.type,
        headline=_headline(unit),
        extent=f"{several(unit.logs, 'log')}, {range_text(unit.first, unit.last)}",
        diagnosis=address(posixpath.relpath(unit.diagnosis, folder)) if unit.diagnosis else None,
        claims=[claim_words(claim) for claim in unit.claims],
        record=record,
        charts=_charts(unit, kind),
        rows=[_row(unit, feature) for feature in kind.features],
        readings=_readings(unit, kind.features),
        version=version,
    )


def _headline(unit: UnitResult) -> str:
    if not unit.claims:
        return f"{unit.unit} is like its siblings"
    several_of = "" if len(unit.claims) == 1 else f" and {several(len(unit.claims) - 1, 'other thing')}"
    return f"{unit.unit} differs: {what_text(unit.claims[0])}{several_of}"


def _charts(unit: UnitResult, kind: TypeResult) -> list[dict[str, Any]]:
    """Charts of what is claimed, then of what is most unusual."""
    claims = {claim.feature: claim for claim in reversed(unit.claims)}
    order = sorted(
        kind.features,
        key=lambda f: (f.name not in claims, -abs(_known(unit.unusual.get(f.name)))),
    )
    charts = []
    for feature in order[: max(_DRAWN, len(claims))]:
        chart = readings_chart(unit, feature, claims.get(feature.name))
        if chart is not None:
            charts.append({"title": capital(what_text(feature)), "chart": chart})
    return charts


def _known(value: float | None) -> float:
    return value if is_known(value) else 0.0


def _row(unit: UnitResult, feature: Feature) -> dict[str, Any]:
    value, error = unit.now.get(feature.name, (float("nan"), float("nan")))
    unusual = unit.unusual.get(feature.name)
    shade = shade_of(None if not is_known(unusual) else round(unusual, 1))
    return {
        "what": capital(effects_text(feature.effects)),
        "place": place_text(feature.joint),
        "name": feature.name,
        "now": with_error(value, error, feature.unit) if is_known(value) else "\u2013",
        "usual": with_error(feature.mean, feature.between_units, feature.unit),
        "unusual": unusual_text(unusual),
        "css": f"p{shade}" if shade > 0 else f"m{-shade}" if shade < 0 else "",
        "path": sparkline(unit.readings.get(feature.name, ()), feature),
    }


def _readings(unit: UnitResult, features: Sequence[Feature]) -> dict[str, Any]:
    """A table of all readings: a row a day, a column a feature."""
    shown = [feature for feature in features if unit.readings.get(feature.name)]
    by_date: dict[tuple[float, int], list[str]] = {}  # two logs may be of one moment
    for column, feature in enumerate(shown):
        counts: Counter[float] = Counter()
        for reading in unit.readings[feature.name]:
            cells = by_date.setdefault((reading.date, counts[reading.date]), [""] * len(shown))
            cells[column] = plain(reading.value)
            counts[reading.date] += 1
    return {
        "heads": [capital(what_text(f)) + (f" [{f.unit}]" if has_unit(f.unit) else "") for f in shown],
        "rows": [(day_text(date), cells) for (date, _), cells in sorted(by_date.items())],
    }
