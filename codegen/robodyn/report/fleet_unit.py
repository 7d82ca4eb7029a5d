"""The page of a unit of a fleet: what is peculiar to it, and all that its logs show, feature by feature."""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any, Final

from robodyn.draw.dates import day_text, range_text
from robodyn.draw.markup import markup_template
from robodyn.fleet.places import address, unit_folder
from robodyn.fleet.result import Feature, FleetResult, TypeResult, UnitResult
from robodyn.report.fleet import claim_words
from robodyn.report.fleet_charts import readings_chart, sparkline
from robodyn.report.fleet_map import shade_of
from robodyn.report.fleet_text import (
    capital,
    effects_text,
    has_unit,
    is_known,
    place_text,
    plain,
    several,
    unusual_text,
    what_text,
    with_error,
)

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
