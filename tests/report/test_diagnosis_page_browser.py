"""The page of a diagnosis in a real browser: offline, quiet, whole, readable at any width, usable by keys."""

from __future__ import annotations

import itertools
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report.made_up import hostile, made, many, series
from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Rival, Tried, Window
from robodyn.report.diagnosis import page
from robodyn.robot import Robot, load
from robodyn_testing import require_module
from robodyn_testing.browser import PHONE, SCHEMES, Browser
from robodyn_testing.cases import representative

pytestmark = pytest.mark.thorough

NAMES = ("missing_effect", "consistent", "unexplained", "hostile", "many")

#: Boxes of what was drawn: text of charts, by chart, and whether each is seen.
LABELS = """
const drawn = [...document.querySelectorAll("svg.chart, svg.interval, .scale svg")];
return drawn.filter(c => c.checkVisibility()).map(c => ({
  name: (c.getAttribute("aria-label") || "scale").split(".")[0],
  boxes: [...c.querySelectorAll("text")].filter(t => t.getBoundingClientRect().width > 0).map(t => {
    const b = t.getBoundingClientRect();
    return [t.textContent, b.left, b.top, b.right, b.bottom];
  }),
}));
"""


def robot() -> Robot:
    return load("puma560", warn=lambda _: None)


def findings() -> tuple[Finding, ...]:
    """Claims with and without rivals, a contact, and a suspicion."""
    value = Estimate(2.9012, 0.0531, "N m")
    rivals = (Rival("stribeck_friction", 3, 806.25), Rival("viscous_friction", 3, 203.125))
    return (
        Finding(
            "coulomb_friction", 3, {"level": value}, 0.97, ("stribeck_friction",), "joint 3: a step",
            "slow reversals of joint 3", 812.5, 40.0, rivals, (90.0, 80.0, -3.0, 70.0),
        ),
        Finding(
            "transmission_loss", 2,
            {"efficiency": Estimate(0.95, 0.001, "1"), "breakaway": Estimate(0.1, 0.09, "N m")},
            0.9, (), "joint 2: two branches", None, 700.0, 30.0,
        ),
        Finding(
            "external_contact", None,
            {"start": Estimate(4.0, 0.0, "s"), "end": Estimate(4.5, 0.0, "s"), "link": Estimate(4, 0.0, "1")},
            0.9, (), "the whole robot: a burst", None, 300.0, 9.0,
        ),
        Finding("spring", 1, {"stiffness": value}, 0.3, (), "joint 1: position", None, 20.0, 3.0),
    )  # fmt: skip


def whole() -> Diagnosis:
    """A diagnosis with everything that a page may show."""
    arm = robot()
    return made(
        arm, findings=findings(), flags=("tau2: 3 rows cut off", "q1: a gap, rows 10 to 20"),
        windows=(Window("train", 4.0, 4.5, "contact"), Window("validate", 8.0, 8.2, "gap")),
        tried=(Tried("backlash", 2, 12.0, 2.1, "t below 3"),),
        detectable=np.linspace(0.1, 0.5, arm.n),
        counts=({"mul": 50, "add": 30}, {"mul": 51, "add": 32}),
    )  # fmt: skip


def pages() -> dict[str, str]:
    arm = robot()
    unchanged = [replace(one, after=one.before) for one in (series("train", 6), series("validate", 6))]
    same: dict[str, Any] = {"series": tuple(unchanged), "diff": "", "operations": (80, 80)}
    return {
        "missing_effect": page(whole(), validated=True),
        "consistent": page(made(arm, verdict="consistent", findings=(), **same), validated=True),
        "unexplained": page(
            made(arm, verdict="unexplained", findings=findings()[3:], left=np.arange(6.0), **same),
            validated=False,
        ),
        "hostile": page(hostile(robot()), validated=True),
        "many": page(made(arm, findings=many(6), extra={"one_body": "a remark"}), validated=True),
    }


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("pages")
    for name, text in pages().items():
        (folder / f"{name}.html").write_text(text, encoding="utf-8")
    return {name: folder / f"{name}.html" for name in NAMES}


@pytest.mark.parametrize("name", ["missing_effect", "consistent", "unexplained"])
def test_every_section_is_there_and_seen(browser: Browser, files: dict[str, Path], name: str) -> None:
    browser.open(files[name])
    sections = {"torque", "gap", "findings", "next", "where", "residual", "model", "motion", "data"}
    asked = {"missing_effect": set(), "consistent": {"next"}, "unexplained": set()}[name]
    for link in browser.all("nav a"):
        target = browser.one(link.get_attribute("hash"))
        assert target.is_displayed()
        assert target.size["height"] > 10
        sections.discard(target.get_attribute("id"))
    assert sections <= asked
    tiles = [tile.text.split("\n")[0] for tile in browser.all(".tiles > div")]
    assert tiles[:3] == ["What is missing", "At which joint", "How sure"]
    assert tiles[-1] == "What to record next"
    tall = browser.run("return document.querySelector('.tiles').getBoundingClientRect().bottom + scrollY")
    assert tall < 500, "the answers are not seen at once"
    for curve in browser.all("details[open] .strip path.curve"):
        assert curve.size["width"] > 900
        assert curve.size["height"] > 1


@pytest.mark.parametrize(
    ("name", "width"),
    representative(
        itertools.product(("missing_effect", "unexplained"), (1280, 700, PHONE, 320)),
        ("missing_effect", 320), ("unexplained", 1280), rest="slow",
    ),
)  # fmt: skip
def test_labels_of_charts_do_not_overlap(
    browser: Browser, files: dict[str, Path], name: str, width: int
) -> None:
    browser.open(files[name], width=width)
    browser.unfold()
    charts = browser.run(LABELS)
    assert len(charts) > 30
    for chart in charts:
        assert chart["boxes"], chart["name"]
        for one, other in itertools.combinations(chart["boxes"], 2):
            across = min(one[3], other[3]) - max(one[1], other[1])
            down = min(one[4], other[4]) - max(one[2], other[2])
            assert across <= 0.5 or down <= 2, (chart["name"], one, other)


def luminance(colour: list[float]) -> float:
    linear = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in (x / 255 for x in colour)]
    return float(np.dot(linear, (0.2126, 0.7152, 0.0722)))


#: The colour of every text, and of what is behind it.
COLOURS = """
const rgb = text => text.match(/[\\\\d.]+/g).map(Number);
const behind = e => {
  for (; e; e = e.parentElement) {
    const c = rgb(getComputedStyle(e).backgroundColor);
    if (c.length === 3 || c[3] > 0) return c.slice(0, 3);
  }
};
return [...document.querySelectorAll("body *")].filter(e => e.checkVisibility()
  && [...e.childNodes].some(n => n.nodeType === 3 && n.data.trim())).map(e => {
  const style = getComputedStyle(e);
  const ink = e instanceof SVGElement ? style.fill : style.color;
  return [e.textContent.trim().slice(0, 40), rgb(ink).slice(0, 3), behind(e)];
});
"""


@pytest.mark.parametrize("scheme", SCHEMES)
def test_text_stands_out_by_day_and_by_night(browser: Browser, files: dict[str, Path], scheme: str) -> None:
    browser.open(files["missing_effect"], scheme=scheme)
    seen = browser.run(COLOURS.replace("\\\\", "\\"))
    assert len(seen) > 100
    papers = {round(luminance(paper), 1) for _, _, paper in seen}
    assert max(papers) <= 0.2 if scheme == "dark" else min(papers) >= 0.7
    for text, ink, paper in seen:
        low, high = sorted((luminance(ink), luminance(paper)))
        assert (high + 0.05) / (low + 0.05) >= 4.5, (text, ink, paper)


def test_what_is_drawn_is_chosen_by_click_and_by_key(browser: Browser, files: dict[str, Path]) -> None:
    keys = require_module("selenium.webdriver.common.keys").Keys
    browser.open(files["missing_effect"])

    def shown(selector: str, where: str = ".residual") -> bool:
        script = "return [...document.querySelectorAll(arguments[0])].some(e => e.checkVisibility())"
        return bool(browser.run(script, f"{where} .ink {selector}"))

    for box, selector in (("torque-before", "path.line.before"), ("torque-after", "path.line.after")):
        assert shown(selector, ".torque")
        browser.one(f"label:has(#{box})").click()
        assert not shown(selector, ".torque")
        assert shown("path.logged", ".torque")
        browser.one(f"label:has(#{box})").click()

    for box, selectors in (
        ("show-before", ["path.curve.before", "path.mean.before"]), ("show-after", ["path.curve.after"]),
        ("show-dots", ["path.dots", "path.band"]), ("show-noise", ["path.noise"]),
    ):  # fmt: skip
        assert all(shown(selector) for selector in selectors)
        browser.one(f"label:has(#{box})").click()
        assert not any(shown(selector) for selector in selectors)
        browser.one(f"#{box}").send_keys(keys.SPACE)
        assert all(shown(selector) for selector in selectors)
    assert browser.one(".card .ink path.mean.before").is_displayed()


def test_keys_reach_everything_in_order(browser: Browser, files: dict[str, Path]) -> None:
    keys = require_module("selenium.webdriver.common.keys").Keys
    browser.open(files["missing_effect"])
    reached = []
    for _ in range(80):
        browser.driver.switch_to.active_element.send_keys(keys.TAB)
        focused = browser.driver.switch_to.active_element
        if focused.tag_name == "body":
            break
        outline = focused.value_of_css_property("outline-style")
        reached.append((focused.tag_name, focused.get_attribute("id") or focused.text[:20]))
        assert outline != "none", reached[-1]
    assert [name for tag, name in reached if tag == "input"] == [
        "torque-before", "torque-after", "show-before", "show-after", "show-dots", "show-noise",
    ]  # fmt: skip
    assert sum(tag == "a" for tag, _ in reached) == 9
    assert sum(tag == "summary" for tag, _ in reached) == 4
    assert sum(tag == "pre" for tag, _ in reached) == 1


@pytest.mark.parametrize("name", ["missing_effect", "many"])
def test_the_headline_is_one_line_on_a_desktop(browser: Browser, files: dict[str, Path], name: str) -> None:
    browser.open(files[name])
    head = browser.one("h1")
    size = float(head.value_of_css_property("font-size").removesuffix("px"))
    assert 20 <= size <= head.size["height"] < 2 * size


def test_tables_are_cards_on_a_phone(browser: Browser, files: dict[str, Path]) -> None:
    """Every figure says what it is, beside it; nothing scrolls sideways but the text of a file."""
    browser.open(files["many"], width=PHONE)
    browser.unfold()
    cells = browser.run(
        "return [...document.querySelectorAll('table.stack td:not(.none)')].map("
        "c => [getComputedStyle(c).display, getComputedStyle(c, '::before').content])"
    )
    assert len(cells) > 100
    assert {display for display, _ in cells} == {"flex"}
    assert all(len(content.strip('"')) >= 1 and content != "none" for _, content in cells)
    wide = browser.run(
        "return [...document.querySelectorAll('.scroll')].filter(e => e.scrollWidth > e.clientWidth)"
        ".map(e => e.outerHTML.slice(0, 200))"
    )
    assert wide == []


def test_what_is_folded_is_printed_with_its_numbers(browser: Browser, files: dict[str, Path]) -> None:
    browser.open(files["many"], media="print")
    lines = browser.all("details.card > summary")
    assert len(lines) == len(many(6))
    assert all(line.is_displayed() for line in lines)
    assert sum("4 N m" in line.text for line in lines) >= 1
