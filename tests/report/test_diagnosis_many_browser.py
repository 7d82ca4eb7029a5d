"""The page of a diagnosis with many findings in a real browser: its head, its tables on a phone, on paper."""

from __future__ import annotations

from pathlib import Path

import pytest

from report.made_up import many
from report.test_diagnosis_page_browser import NAMES, pages
from robodyn_testing.browser import PHONE, Browser

pytestmark = pytest.mark.thorough


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("pages")
    written = {name: folder / f"{name}.html" for name in NAMES}
    for name, text in pages().items():
        written[name].write_text(text, encoding="utf-8")
    return written


@pytest.mark.parametrize("name", NAMES)
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
