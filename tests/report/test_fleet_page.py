"""The page of a fleet and those of its units: what they say, whatever the fleet's names are."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from report.made_up import START, fleet, of_one
from report.test_diagnosis_report import Page
from robodyn.draw.scales import DAY
from robodyn.fleet.result import FleetResult, Look, UnitResult
from robodyn.report.fleet import page, unit_pages
from robodyn.report.fleet_charts import SHADES, SHOWN, ordered, script_data, shade_css, type_maps
from robodyn.report.fleet_text import most_unusual, summary, unusual_text
from robodyn_testing import representative

HOSTILE = "</script><script>alert(1)</script>\"><img src=x onerror='alert(2)'>"


@pytest.fixture(scope="module")
def small() -> FleetResult:
    return fleet(30, 6)


def renamed(result: FleetResult, name: str) -> FleetResult:
    """The fleet with ``name`` in the place of its own, of its first type and a unit of that, and of texts."""
    kind = result.types[0].name
    types = (replace(result.types[0], name=name), *result.types[1:])
    units = [replace(unit, type=name) if unit.type == kind else unit for unit in result.units]
    looks = [replace(look, type=name) if look.type == kind else look for look in result.first_to_look_at]
    units[0] = replace(units[0], unit=name, diagnosis=name)
    looks[0] = Look(name, name, name, name, name)
    features = tuple(
        replace(feature, effects=(name,), unit=name, slopes={name: 1.0}) for feature in types[0].features
    )
    types = (replace(types[0], features=features), *types[1:])
    unseen = tuple(replace(one, type=name, unit=name, reason=name) for one in result.not_observed)
    odd = tuple(replace(one, type=name, unit=name, source=name) for one in result.odd_logs)
    unused = tuple(replace(log, source=name, type=name, unit=name, why=name) for log in result.unused)
    return replace(
        result, name=name, types=types, units=tuple(units), first_to_look_at=tuple(looks), unused=unused,
        not_observed=unseen, odd_logs=odd,
    )  # fmt: skip


def test_the_map_has_all_units_once_the_named_first() -> None:
    result = fleet(90, 9)
    maps = type_maps(result)
    assert [len(m["shown"]) for m in maps] == [SHOWN] * 3
    rows = [row for m in maps for row in (*m["shown"], *m["folded"])]
    assert sorted(row["unit"] for row in rows) == sorted(unit.unit for unit in result.units)
    order = ordered(result)
    assert all(order[row["index"]].unit == row["unit"] for row in rows)
    assert [bool(unit.claims) for unit in order] == [True] * 9 + [False] * 81
    sizes = [most_unusual(unit) for unit in order[9:]]
    assert sizes == sorted(sizes, reverse=True)
    assert [(m["places"][-1], len(m["places"])) for m in maps] == [("arm", 7), ("arm", 5), ("arm", 8)]
    named = {cell["css"] for row in maps[0]["shown"] for cell in row["cells"] if "named" in cell["css"]}
    assert named == {"p4 named"}
    assert {row["cells"][0]["css"] for row in maps[0]["shown"] if "J1" in row["named"]} == named


def test_shades_begin_where_the_legend_says() -> None:
    assert shade_css(None) == shade_css(float("inf")) == shade_css(1.9) == ""
    for k, bound in enumerate(SHADES, 1):
        assert (shade_css(bound), shade_css(-bound)) == (f"p{k}", f"m{k}")
        assert shade_css(bound - 0.1) == (f"p{k - 1}" if k > 1 else "")


def test_the_script_gets_what_the_cells_show(small: FleetResult) -> None:
    data = script_data(small)
    for m in type_maps(small):
        kind = data["types"][m["index"]]
        for row in (*m["shown"], *m["folded"]):
            _, unit, unusual, now, named = data["units"][row["index"]]
            assert unit == row["unit"]
            assert len(unusual) == len(now) == len(kind["features"])
            for place, cell in zip(kind["places"], row["cells"], strict=True):
                at = [unusual[k] for k, feature in enumerate(kind["features"]) if feature[1] == place]
                assert cell["text"] == unusual_text(max(at, key=abs) / 10)
                assert ("named" in cell["css"]) == any(kind["features"][k][1] == place for k in named)


@pytest.mark.parametrize(
    "name",
    representative((HOSTILE, "..", "", "a\nb\0", "-->", "{{ 7*7 }}", "'\"", "\u202e"), HOSTILE, "a\nb\0"),
)
def test_a_name_is_only_text(small: FleetResult, name: str) -> None:
    result = renamed(small, name)
    plain = Page(page(small)).tags
    pages = [page(result), *(text for _, text in unit_pages(result))]
    for text in pages:
        tags = Page(text).tags
        assert "img" not in tags
        assert tags.count("script") == (2 if text is pages[0] else 0)
    assert Page(pages[0]).tags.count("tr") == plain.count("tr")
    (data,) = re.findall(r'<script type="application/json" id="fleet">(.*?)</script>', pages[0], re.DOTALL)
    assert json.loads(data)["types"][0]["name"] == name


def test_figures_that_are_none_leave_no_trace(small: FleetResult) -> None:
    bad = float("nan")
    units = tuple(
        replace(
            unit, unusual=dict.fromkeys(unit.unusual, bad), now=dict.fromkeys(unit.now, (bad, bad)),
            readings={k: tuple(replace(r, value=bad) for r in own) for k, own in unit.readings.items()},
        )
        for unit in small.units
    )  # fmt: skip
    result = replace(small, units=units)
    for text in (page(result), *(text for _, text in unit_pages(result))):
        assert not re.search(r"\bnan\b|\binf\b|NaN|Infinity", text.partition("<script>")[0])


@pytest.mark.parametrize("result", [of_one(), fleet(9, 0), replace(fleet(3, 0), units=(), types=())])
def test_little_makes_a_page_as_well(result: FleetResult) -> None:
    """One log; nothing to name; no log that could be used."""
    text = page(result)
    Page(text)
    assert "What to do first" not in text
    assert "What changed and when" not in text
    assert len(list(unit_pages(result))) == len(result.units)


def test_changes_stand_in_the_order_of_their_days(small: FleetResult) -> None:
    text = page(small).partition('id="changes"')[2].partition("</section>")[0]
    days = [(u.claims[0].since, u.unit) for u in small.units if u.claims]
    changed = [unit for since, unit in sorted((s, u) for s, u in days if s is not None)]
    always = [unit for since, unit in days if since is None]
    assert re.findall(r'class="who"><a [^>]*>([^<]*)<', text) == [*changed, *always]
    assert text.count('class="ever"') == len(always) == 2
    assert text.count('class="reach"') == len(changed) == 4


def test_a_units_page_has_all_its_readings(small: FleetResult) -> None:
    pages = dict(unit_pages(small))
    unit = small.units[0]
    assert unit.type == "arm<6>"
    text = pages[f"units/arm%3C6%3E/{unit.unit}/index.html"]
    table = text.partition('<table class="readings">')[2].partition("</table>")[0]
    assert table.count("<tr>") == 1 + unit.logs
    assert table.count("<td") == unit.logs * len(unit.readings)
    assert text.count('<svg class="spark"') == len(unit.readings)
    assert 'href="../../../index.html"' in text


def test_the_diagnosis_is_linked(small: FleetResult) -> None:
    unit = next(unit for unit in small.units if unit.claims)
    moved = replace(unit, diagnosis="units/arm%3C6%3E/a b/report.html")
    result = replace(small, units=tuple(moved if one is unit else one for one in small.units))
    assert 'href="units/arm%253C6%253E/a%20b/report.html"' in page(result)
    (text,) = [text for path, text in unit_pages(result) if unit.unit in path]
    assert 'href="../a%20b/report.html"' in text


def test_two_logs_of_one_moment_are_two_rows(small: FleetResult) -> None:
    unit = small.units[0]
    twice: UnitResult = replace(
        unit, readings={name: (several[0], *several) for name, several in unit.readings.items()}
    )
    ((_, text),) = unit_pages(replace(small, units=(twice,)))
    assert text.partition('<table class="readings">')[2].count("<tr>") == 2 + unit.logs


def test_the_days_of_a_change_are_drawn_where_they_are() -> None:
    """A year of logs: the interval is as long and where it should be, in percent of the axis."""
    result = fleet(3, 1)
    (unit,) = [unit for unit in result.units if unit.claims]
    interval = (START + 40 * DAY, START + 60 * DAY)
    unit = replace(
        unit, first=START, last=START + 100 * DAY,
        claims=(replace(unit.claims[0], since=START + 50 * DAY, since_interval=interval),),
    )  # fmt: skip
    text = page(replace(result, units=(unit,), types=result.types))
    low, width = re.findall(r'class="reach" x="([\d.]+)%" width="([\d.]+)%"', text)[0]
    (at,) = re.findall(r'class="point" cx="([\d.]+)%"', text)
    np.testing.assert_allclose([float(low), float(width), float(at)], [2 + 40, 20, 50], atol=2.0)


def test_control_characters_do_not_reach_the_terminal() -> None:
    result = fleet(3, 1)
    look = result.first_to_look_at[0]
    hostile = replace(
        result, name="\x1b[2J", first_to_look_at=(Look(look.type, look.unit, "", "a\x1bb\nc", ""),)
    )
    assert all(line.isprintable() for line in summary(hostile, "p"))
