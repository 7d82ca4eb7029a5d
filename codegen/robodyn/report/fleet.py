"""The page of a fleet: one HTML file that needs no network. What matters stands on top: how many units differ
and how sure that is, and the units to look at first.

Names of units, types and files may be any text: they are escaped wherever they stand, and the page's own
policy names its one script by its hash.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np

from robodyn.draw.dates import day_text
from robodyn.draw.markup import markup_template
from robodyn.emit.render import environment
from robodyn.fleet.places import address
from robodyn.fleet.result import Claim, Feature, FleetResult, Look, TypeResult, UnitResult, Unused
from robodyn.report.chart_frames import Frame, percent
from robodyn.report.fleet_charts import days_span, readings_chart
from robodyn.report.fleet_map import SHADES, kinds_of, page_of, script_data, type_maps
from robodyn.report.fleet_text import (
    brief,
    capital,
    counted,
    days_of,
    effects_text,
    extent_text,
    false_text,
    headline,
    interval_text,
    is_known,
    place_text,
    plain,
    several,
    since_text,
    size_text,
    what_text,
    with_unit,
)
from robodyn.report.scripts import json_text, policy, script_text

#: Changes and unused logs that are seen at once; the others are folded. Unused logs that are listed.
_CHANGES, _UNUSED, _LISTED = 40, 12, 500
#: Ticks of the time line at most.
_TICKS: Final = 8


def page(result: FleetResult) -> str:
    """The HTML of ``result``, the same bytes at any time and place."""
    from importlib.metadata import version

    script = script_text(environment().get_template("report/fleet.js").render())
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
        populations=[_population(kind) for kind in result.types],
        unused=[_unused(log) for log in result.unused[:_LISTED]],
        unused_count=len(result.unused),
        unused_shown=_UNUSED,
        data=json_text(script_data(result)),
        script=script,
        policy=policy([script]),
        version=version("robodyn"),
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


# --- populations and logs ---------------------------------------------------------------------------------


def _population(kind: TypeResult) -> dict[str, Any]:
    conditions = sorted({name for feature in kind.features for name in feature.slopes})
    return {
        "name": kind.name,
        "extent": f"{several(kind.units, 'unit')}, {several(kind.logs, 'log')}, "
        f"{several(kind.joints, 'joint')}",
        "conditions": conditions,
        "has_rest": any(not feature.effects for feature in kind.features),
        "rows": [
            {
                "what": capital(effects_text(feature.effects)),
                "place": place_text(feature.joint),
                "name": feature.name,
                "mean": with_unit(feature.mean, feature.unit),
                "units": with_unit(feature.between_units, feature.unit),
                "logs": with_unit(feature.between_logs, feature.unit),
                "slopes": [
                    plain(feature.slopes[name], signed=True) if name in feature.slopes else ""
                    for name in conditions
                ],
                "count": f"{feature.logs:,}",
            }
            for feature in kind.features
        ],
    }


def _unused(log: Unused) -> dict[str, str]:
    return {"source": log.source, "type": log.type, "unit": log.unit, "why": log.why}
