"""The page of a fleet: one HTML file that needs no network. What matters stands on top: how many units differ
and how sure that is, and the units to look at first.

Names of units, types and files may be any text: they are escaped wherever they stand, and the page's own
policy names its one script by its hash.
"""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterator
from typing import Any, Final

import numpy as np

from robodyn.draw.markup import json_text, markup_template, policy, script_template, script_text
from robodyn.draw.scales import day_text, range_text
from robodyn.fleet.result import FleetResult, TypeResult, UnitResult, address, unit_folder
from robodyn.report import fleet_charts as charts
from robodyn.report import fleet_text as words
from robodyn.report.chart_frames import Frame, percent
from robodyn.report.figures import capital, several
from robodyn.version import VERSION

#: Changes and unused logs that are seen at once; the others are folded. Unused logs that are listed.
_CHANGES, _UNUSED, _LISTED = 40, 12, 500
#: Ticks of the time line at most.
_TICKS: Final = 8


def page(result: FleetResult) -> str:
    """The HTML of ``result``, the same bytes at any time and place."""
    script = script_text(script_template("fleet.js").render())
    return markup_template("fleet.html.j2").render(
        name=result.name,
        headline=words.headline(result),
        extent=words.extent_text(result),
        tiles=_tiles(result),
        looks=_looks(result),
        maps=charts.type_maps(result),
        kinds=charts.kinds_of(result),
        types=result.types,
        shades=[f"{bound:g}" for bound in charts.SHADES],
        timeline=_timeline(result),
        not_observed=words.not_observed_lines(result),
        together=words.together_lines(result),
        odd=[(one, day_text(one.date)) for one in result.odd_logs[:_LISTED]],
        unused=result.unused[:_LISTED],
        unused_count=len(result.unused),
        unused_shown=_UNUSED,
        data=json_text(charts.script_data(result)),
        script=script,
        policy=policy([script]),
        version=VERSION,
        words=words,
    )


def _tiles(result: FleetResult) -> list[tuple[str, str, str]]:
    """Question, answer, and a remark on it."""
    claims = [claim for unit in result.units for claim in unit.claims if not words.is_event(claim)]
    different = len(words.differing(result))
    what = words.counted([words.effects_text(claim.effects) for claim in claims]) or "no unit stands out"
    changes = [claim.since for claim in claims if claim.since is not None]
    always = len(claims) - len(changes)
    parts = [f"the last one on {day_text(max(changes))}"] if changes else []
    parts += [f"{always:,} {'differs' if always == 1 else 'differ'} in all logs"] if always else []
    when = f"{len(changes):,} changed" if claims else "nothing"
    tiles = [
        ("Units that differ", f"{different:,} of {len(result.units):,}", what),
        ("How sure", f"{100 * result.false_names:g} % false names", words.false_text(result)),
        ("Since when", when, "; ".join(parts) if claims else "has changed"),
    ]
    unseen = {(one.type, one.unit) for one in result.not_observed}
    if unseen:
        joints = sum(one.joint is not None for one in result.not_observed)
        remark = f"{several(joints, 'joint')} of them" if joints else "too few logs"
        tiles.append(("Not observed", several(len(unseen), "unit"), remark))
    for look in result.first_to_look_at[:1]:
        units = [unit for unit in result.units if (unit.type, unit.unit) == (look.type, look.unit)]
        first = next((claim for unit in units for claim in unit.claims), None)
        tiles.append(("Look first at", look.unit, capital(words.brief(first)) if first else look.why))
    return tiles


def _looks(result: FleetResult) -> list[dict[str, Any]]:
    """What to look at, with a chart of what is claimed first, or is most unusual."""
    units = {(unit.type, unit.unit): unit for unit in result.units}
    kinds = {kind.name: kind for kind in result.types}
    looks = []
    for look in result.first_to_look_at:
        unit, kind = units.get((look.type, look.unit)), kinds.get(look.type)
        if unit is None or kind is None:
            continue
        features = {feature.name: feature for feature in kind.features}
        claim = next((claim for claim in unit.claims if claim.feature in features), None)
        unusual = [
            (abs(x), name) for name, x in unit.unusual.items() if words.is_known(x) and name in features
        ]
        strangest = max(unusual, default=(0.0, None))[1]
        name = claim.feature if claim else strangest
        looks.append(
            {
                "unit": unit.unit, "type": unit.type, "page": words.page_of(unit),
                "diagnosis": address(unit.diagnosis) if unit.diagnosis else None,
                "why": capital(look.why), "record": capital(look.record), "action": capital(look.action),
                "logs": several(unit.logs, "log"),
                "chart": charts.readings_chart(unit, features[name], claim) if name else None,
                "claims": unit.claims,
            }
        )  # fmt: skip
    return looks


def _timeline(result: FleetResult) -> dict[str, Any]:
    """A row for each claim: those with a day in their order, then those that were always so."""
    span = words.days_of(result)
    if span is None:
        return {"rows": [], "more": [], "ticks": []}
    frame = Frame(*charts.days_span(np.array(span)), 0.0, 1.0)

    def at(moment: float) -> float:
        return min(max(frame.across(moment), 0.0), 100.0)

    rows = [(unit, claim) for unit in result.units for claim in unit.claims]
    rows.sort(key=lambda row: (row[1].since is None, row[1].since or 0.0, row[0].type, row[0].unit))
    drawn = []
    for unit, claim in rows:
        low, high = claim.since_interval or (unit.first, unit.last)
        drawn.append(
            {
                "claim": claim,
                "unit": unit.unit,
                "type": unit.type,
                "page": words.page_of(unit),
                "first": percent(at(unit.first)),
                "days": percent(at(unit.last) - at(unit.first)),
                "low": percent(at(low)),
                "width": percent(max(at(high) - at(low), 0.3)),
                "at": None if claim.since is None else percent(at(claim.since)),
            }
        )
    axis = frame.chart("", "", ("", ""), (), most=(_TICKS, 2), days=True)
    return {"rows": drawn[:_CHANGES], "more": drawn[_CHANGES:], "ticks": axis.x_ticks}


#: Features that are drawn: those of claims, then the most unusual ones up to so many.
_DRAWN: Final = 4


def unit_pages(result: FleetResult) -> Iterator[tuple[str, str]]:
    """The path of each unit's page, relative to the fleet's, and its HTML; the same bytes at any time."""
    kinds = {kind.name: kind for kind in result.types}
    looks = {(look.type, look.unit): capital(look.record) for look in result.first_to_look_at}
    for unit in result.units:
        folder, kind = unit_folder(unit.type, unit.unit), kinds[unit.type]
        text = markup_template("fleet_unit.html.j2").render(
            fleet=result.name,
            back=posixpath.relpath("index.html", folder),
            unit=unit.unit,
            type=unit.type,
            headline=_headline(unit),
            not_observed=[
                one for one in result.not_observed if (one.type, one.unit) == (unit.type, unit.unit)
            ],
            extent=f"{several(unit.logs, 'log')}, {range_text(unit.first, unit.last)}",
            diagnosis=address(posixpath.relpath(unit.diagnosis, folder)) if unit.diagnosis else None,
            claims=unit.claims,
            record=looks.get((unit.type, unit.unit), ""),
            charts=_charts(unit, kind),
            features=kind.features,
            result=unit,
            sparkline=charts.sparkline,
            shade_css=charts.shade_css,
            words=words,
            readings=_readings(unit, kind),
            version=VERSION,
        )
        yield f"{folder}/index.html", text


def _headline(unit: UnitResult) -> str:
    if not unit.claims:
        return f"Of {unit.unit} no change is seen"
    others = f" and {several(len(unit.claims) - 1, 'other thing')}" if len(unit.claims) > 1 else ""
    return f"{unit.unit} differs: {words.what_text(unit.claims[0])}{others}"


def _charts(unit: UnitResult, kind: TypeResult) -> list[dict[str, Any]]:
    """Charts of what is claimed, then of what is most unusual."""
    claims = {claim.feature: claim for claim in reversed(unit.claims)}

    def order(feature: Any) -> tuple[bool, float]:
        value = unit.unusual.get(feature.name)
        return feature.name not in claims, -abs(value) if words.is_known(value) else 0.0

    drawn = [
        (feature, charts.readings_chart(unit, feature, claims.get(feature.name)))
        for feature in sorted(kind.features, key=order)[: max(_DRAWN, len(claims))]
    ]
    return [{"title": capital(words.what_text(f)), "chart": chart} for f, chart in drawn if chart is not None]


def _readings(unit: UnitResult, kind: TypeResult) -> dict[str, Any]:
    """A table of all readings: a row a day, a column a feature."""
    shown = [feature for feature in kind.features if unit.readings.get(feature.name)]
    by_date: dict[tuple[float, int], list[str]] = {}  # two logs may be of one moment
    for column, feature in enumerate(shown):
        counts: Counter[float] = Counter()
        for reading in unit.readings[feature.name]:
            cells = by_date.setdefault((reading.date, counts[reading.date]), [""] * len(shown))
            cells[column] = words.plain(reading.value)
            counts[reading.date] += 1
    units = [f" [{feature.unit}]" if words.has_unit(feature.unit) else "" for feature in shown]
    return {
        "heads": [capital(words.what_text(f)) + unit for f, unit in zip(shown, units, strict=True)],
        "rows": [(day_text(date), cells) for (date, _), cells in sorted(by_date.items())],
    }
