"""The page of a fleet in a real browser: offline, quiet, readable at any width, used by keys."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest

from report.made_up import fleet, of_one
from report.test_fleet_page import HOSTILE, renamed
from robodyn.fleet.result import FleetResult
from robodyn.report.fleet import page, unit_pages
from robodyn.report.fleet_charts import SHOWN, ordered
from robodyn_testing import require_module
from robodyn_testing.browser import Browser

pytestmark = pytest.mark.thorough

BIG, FEWER, HOSTILE_NAMES, ONE, QUIET, UNIT = NAMES = ("big", "fewer", "hostile", "one", "quiet", "unit")

#: The units of the rows that are seen, table by table.
ROWS: Final = """
return [...document.querySelectorAll("table.map")].filter(t => t.checkVisibility()).map(t =>
  [...t.querySelectorAll("tbody tr:not([hidden]) th")].map(e => e.textContent));
"""
CELL: Final = """
const e = document.activeElement, row = e.parentElement;
return [row.querySelector("th").textContent, [...row.querySelectorAll("td.v")].indexOf(e)];
"""


def pages() -> dict[str, str]:
    """The page of ninety units is made as that of a thousand is, which takes axe-core a minute to look at."""
    return {
        FEWER: page(fleet(90, 9)),
        HOSTILE_NAMES: page(renamed(fleet(30, 6), HOSTILE)),
        ONE: page(of_one()),
        QUIET: page(fleet(9, 0)),
        UNIT: next(text for _, text in unit_pages(fleet(9, 3))),
    }


@pytest.fixture(scope="module")
def big() -> FleetResult:
    return fleet()


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory, big: FleetResult) -> dict[str, Path]:
    file = tmp_path_factory.mktemp("fleet") / "big.html"
    file.write_text(page(big), encoding="utf-8")
    return {BIG: file}


def test_sections_are_linked_and_folded(browser: Browser, files: dict[str, Path], big: FleetResult) -> None:
    visit = browser.open(files[BIG])
    assert (visit.complaints, visit.requests) == ((), ())
    assert files[BIG].stat().st_size < 3 * 2**20
    assert len(browser.all("nav a")) == 6
    for link in browser.all("nav a"):
        assert browser.one(link.get_attribute("hash")).is_displayed()
    assert len(browser.all("ol.looks > li")) == len(big.first_to_look_at)
    assert len(browser.all("ol.looks svg.chart")) == len(big.first_to_look_at)
    rows = browser.run(ROWS)
    assert [len(several) for several in rows] == [SHOWN] * 3
    browser.unfold()
    assert sum(map(len, browser.run(ROWS))) == len(big.units)


def type_into(browser: Browser, text: str) -> None:
    field = browser.one("#search")
    field.clear()
    field.send_keys(text)


def test_it_is_searched(browser: Browser, files: dict[str, Path], big: FleetResult) -> None:
    """What fits is seen though it was folded; without a search all is as before."""
    browser.open(files[BIG])
    wanted = ordered(big)[-1].unit
    type_into(browser, wanted.lower())
    assert [name for names in browser.run(ROWS) for name in names] == [wanted]
    assert browser.one("#count").text == "1 of 1,000 units"
    type_into(browser, "no such unit")
    assert browser.run(ROWS) == []
    type_into(browser, "")
    browser.run("fleetMap.fields.search.dispatchEvent(new Event('input'))")
    assert [len(several) for several in browser.run(ROWS)] == [SHOWN] * 3
    assert browser.one("#count").text == "1,000 units"


def test_it_is_narrowed_to_types_effects_and_what_is_named(
    browser: Browser, files: dict[str, Path], big: FleetResult
) -> None:
    browser.open(files[BIG])
    select = require_module("selenium.webdriver.support.select").Select
    select(browser.one("#type")).select_by_visible_text("scara")
    assert len(browser.run(ROWS)) == 1
    browser.one("#only").click()
    scara = [u.unit for u in big.units if u.type == "scara" and u.claims]
    assert sorted(name for names in browser.run(ROWS) for name in names) == scara
    select(browser.one("#kind")).select_by_visible_text("Backlash")
    slack = [
        u.unit for u in big.units if u.type == "scara" and any("backlash" in c.effects for c in u.claims)
    ]
    assert sorted(name for names in browser.run(ROWS) for name in names) == slack
    marked = browser.run(
        "return [...document.querySelectorAll('td.named')].filter(e => e.checkVisibility()).length"
    )
    assert marked == len(slack)


def test_one_kind_of_effects_orders_the_rows_anew(
    browser: Browser, files: dict[str, Path], big: FleetResult
) -> None:
    """Those of which it is named first, then by how unusual it is; all effects bring the old order back."""
    browser.open(files[BIG])
    before = browser.run(ROWS)
    select = require_module("selenium.webdriver.support.select").Select
    select(browser.one("#kind")).select_by_visible_text("Payload")
    units = [unit for unit in big.units if unit.type == "seven"]

    def rank(unit_name: str) -> tuple[bool, float]:
        unit = next(unit for unit in units if unit.unit == unit_name)
        named = any(claim.feature == "payload.mass" for claim in unit.claims)
        return not named, -abs(round(unit.unusual["payload.mass"], 1))

    seen = browser.run(ROWS)[2]
    assert len(seen) == SHOWN
    assert [rank(name) for name in seen] == sorted(rank(unit.unit) for unit in units)[:SHOWN]
    cells = "[...document.querySelectorAll('table.map')].at(-2).querySelectorAll('td.v:not(:nth-child(9))')"
    filled = browser.run(f"return [...{cells}].map(e => e.textContent)")
    assert set(filled) == {"\u2013"}
    select(browser.one("#kind")).select_by_visible_text("all effects")
    assert browser.run(ROWS) == before


def test_cells_are_walked_by_keys_and_say_what_they_show(
    browser: Browser, files: dict[str, Path], big: FleetResult
) -> None:
    keys = require_module("selenium.webdriver.common.keys").Keys
    browser.open(files[BIG])
    rows = browser.run(ROWS)[0]
    browser.run("document.querySelector('table.map td.v').focus()")

    def press(*several: str) -> list[object]:
        for key in several:
            browser.driver.switch_to.active_element.send_keys(key)
        cell: list[object] = browser.run(CELL)
        return cell

    assert press(keys.ARROW_RIGHT, keys.ARROW_RIGHT) == [rows[0], 2]
    assert press(keys.ARROW_DOWN, keys.ARROW_DOWN, keys.ARROW_DOWN) == [rows[3], 2]
    assert press(keys.END) == [rows[3], 6]
    assert press(keys.ARROW_RIGHT) == [rows[3], 6]
    assert press(keys.HOME, keys.PAGE_DOWN) == [rows[13], 0]
    assert press(keys.PAGE_DOWN) == [rows[-1], 0]
    assert press(keys.ARROW_UP) == [rows[-2], 0]
    lines = browser.one("#detail").text.splitlines()
    assert lines[0] == f"{rows[-2]}, arm<6>, joint 1"
    assert len(lines) == 4
    assert browser.run("return document.querySelectorAll('table.map td.v[tabindex=\"0\"]').length") == len(
        browser.all("table.map")
    )
    address = browser.run("return document.activeElement.parentElement.querySelector('a').href")
    browser.driver.switch_to.active_element.send_keys(keys.ENTER)
    assert browser.driver.current_url == address


def test_without_scripts_everything_is_there(
    browser: Browser, files: dict[str, Path], big: FleetResult
) -> None:
    """But the search: rows beyond the first are folded by the browser itself."""
    browser.command("Emulation.setScriptExecutionDisabled", value=True)
    try:
        browser.open(files[BIG])
        assert not browser.one("#tools").is_displayed()
        assert len(browser.all("table.map tbody tr")) == len(big.units)
        assert browser.one("details.more-rows summary").is_displayed()
    finally:
        browser.command("Emulation.setScriptExecutionDisabled", value=False)
