"""Every page in a real browser: it asks for nothing, fits into the window, is accessible by day and night."""

from __future__ import annotations

import itertools
from typing import Final

import pytest

from report import test_arm_page_browser as arms
from report import test_diagnosis_page_browser as diagnoses
from report import test_fleet_page_browser as fleets
from robodyn_testing import require_module
from robodyn_testing.browser import PHONE, SCHEMES, Browser
from robodyn_testing.cases import representative

pytestmark = pytest.mark.thorough

PAGES: Final = (
    *(f"diagnosis {name}" for name in diagnoses.NAMES),
    *(f"fleet {name}" for name in fleets.NAMES if name != fleets.BIG),
    "panda", "stanford", arms.RUBBING_ARM, "two",
)  # fmt: skip
#: What scrolls within a box of its own, by kind of page.
APART: Final = {
    "diagnosis": ".scroll, pre.diff, .ink",
    "fleet": ".scroll, .ink, caption",
    "arm": ".scroll, .law, .steps-of, label, pre, .ink",
}
#: Elements that reach beyond the window, those within such a box apart.
OUTSIDE: Final = """
const wide = document.documentElement.clientWidth;
return [...document.querySelectorAll("body *")].filter(e => {
  const b = e.getBoundingClientRect();
  return b.width > 0 && (b.right > wide + 0.5 || b.left < -0.5) && !e.closest(arguments[0]);
}).map(e => e.outerHTML.slice(0, 120));
"""


def kind_of(name: str) -> str:
    return name.partition(" ")[0] if " " in name else "arm"


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> arms.Pages:
    """Those of arms are made when they are asked for."""
    written = arms.Pages(tmp_path_factory.mktemp("pages"))
    for kind, texts in (("diagnosis", diagnoses.pages()), ("fleet", fleets.pages())):
        for name, text in texts.items():
            written[f"{kind} {name}"] = written.folder / f"{kind}-{name}.html"
            written[f"{kind} {name}"].write_text(text, encoding="utf-8")
    return written


@pytest.mark.parametrize("name", representative(dict.fromkeys((*PAGES, *arms.NAMES)), *PAGES, rest="slow"))
def test_it_asks_for_nothing_and_nothing_goes_wrong(browser: Browser, files: arms.Pages, name: str) -> None:
    """Nor is it large."""
    visit = browser.open(files[name])
    assert visit.complaints == ()
    assert visit.requests == ()
    assert browser.run("return document.images.length") == 0
    assert files[name].stat().st_size < 2 * 2**20
    with pytest.raises(require_module("selenium.common.exceptions").NoAlertPresentException):
        browser.driver.switch_to.alert.dismiss()


@pytest.mark.parametrize(
    ("name", "width"),
    representative(
        itertools.product(PAGES, (1280, 700, PHONE, 320)),
        *((name, width) for name, width in zip(PAGES, itertools.cycle((PHONE, 320, 700)), strict=False)),
        rest="slow",
    ),
)
def test_nothing_is_wider_than_the_window(browser: Browser, files: arms.Pages, name: str, width: int) -> None:
    browser.open(files[name], width=width)
    if kind_of(name) != "fleet":
        browser.unfold()
    assert browser.run("return document.documentElement.scrollWidth") <= width
    assert browser.run(OUTSIDE, APART[kind_of(name)]) == []


@pytest.mark.parametrize(
    ("name", "width", "scheme"),
    representative(
        itertools.product(PAGES, (1280, PHONE), SCHEMES),
        *((name, PHONE if k % 2 else 1280, SCHEMES[k // 2 % 2]) for k, name in enumerate(PAGES)),
        rest="slow",
    ),
)
def test_it_is_accessible(browser: Browser, files: arms.Pages, name: str, width: int, scheme: str) -> None:
    browser.open(files[name], width=width, scheme=scheme)
    browser.screenshot(f"{files[name].stem}-{width}-{scheme}")
    assert browser.violations() == []
    if kind_of(name) != "fleet":
        browser.unfold()
        assert browser.violations() == []


@pytest.mark.parametrize("name", ["diagnosis missing_effect", "fleet fewer", "panda"])
def test_on_paper_it_is_light_and_no_wider_than_the_sheet(
    browser: Browser, files: arms.Pages, name: str
) -> None:
    browser.open(files[name], width=760, media="print", scheme="dark")
    assert browser.run("return document.documentElement.scrollWidth") <= 760
    assert browser.run("return getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    for controls in browser.all("nav, #tools, [data-play]"):
        assert not controls.is_displayed()
