"""The browser of the tests sees what is wrong with a page: else no page would ever fail."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn_testing.browser import PHONE, Browser

pytestmark = pytest.mark.thorough

BAD = """
<!doctype html><html><head><title>bad</title>
<style>body {{ background: white }} @media (prefers-color-scheme: dark) {{ body {{ background: black }} }}
@media print {{ body {{ background: blue }} }}</style></head>
<body><img src="{picture}"><p style="color: #aaa; background: #fff">pale</p>
<details><input></details><script>console.error("broken")</script></body></html>
"""
GOOD = """
<!doctype html><html lang="en"><head><title>good</title><link rel="icon" href="data:,"></head>
<body><main><h1>Good</h1></main></body></html>
"""


@pytest.fixture
def bad(tmp_path: Path) -> Path:
    (tmp_path / "bad.html").write_text(BAD.format(picture=(tmp_path / "none.png").as_uri()))
    return tmp_path / "bad.html"


def test_complaints_and_requests_are_seen(browser: Browser, bad: Path) -> None:
    visit = browser.open(bad)
    assert any("broken" in complaint for complaint in visit.complaints)
    assert visit.requests == ((bad.parent / "none.png").as_uri(),)
    visit = browser.open(bad)
    assert len(visit.requests) == 1, "of this visit only"


def test_what_is_not_accessible_is_named(browser: Browser, bad: Path) -> None:
    browser.open(bad)
    rules = {line.split(" ")[0] for line in browser.violations()}
    assert {"html-has-lang", "image-alt", "color-contrast"} <= rules
    assert "label" not in rules
    browser.unfold()
    assert any(line.startswith("label (critical): ") and "<input>" in line for line in browser.violations())


def test_nothing_is_held_against_a_good_page(browser: Browser, tmp_path: Path) -> None:
    (tmp_path / "good.html").write_text(GOOD)
    visit = browser.open(tmp_path / "good.html")
    assert (visit.complaints, visit.requests, browser.violations()) == ((), (), [])


def test_width_scheme_and_paper_are_as_asked(browser: Browser, bad: Path) -> None:
    paper = "return getComputedStyle(document.body).backgroundColor"
    browser.open(bad, width=PHONE)
    assert (browser.run("return innerWidth"), browser.run(paper)) == (PHONE, "rgb(255, 255, 255)")
    browser.open(bad, scheme="dark")
    assert (browser.run("return innerWidth"), browser.run(paper)) == (1280, "rgb(0, 0, 0)")
    browser.open(bad, media="print")
    assert browser.run(paper) == "rgb(0, 0, 255)"
