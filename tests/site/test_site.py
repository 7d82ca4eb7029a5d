"""The site as it is built: without a warning, read as files without a network, searched, and accessible."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from robodyn_testing import require_module
from robodyn_testing.browser import PHONE, Browser
from robodyn_testing.wanted import ROOT

pytestmark = pytest.mark.thorough

#: Pages of every kind: prose, tables wider than a phone, code, equations, curves, pictures, options.
PAGES = tuple(
    f"{page}.html"
    for page in (
        "index", "diagnose", "functions", "operation-counts", "glossary", "description", "contributing",
        "commands/index", "commands/gen", "effects/load_dependent_friction", "functions/inverse_dynamics",
        "targets/cortex-m4f", "languages/rust", "python/kernels", "benchmarks/peers", "decisions/index",
    )
)  # fmt: skip
#: On a desk by day and on a phone by night, in turn.
VIEWS = [(page, *((1280, "light"), (PHONE, "dark"))[k % 2]) for k, page in enumerate(PAGES)]


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site, built strictly: a link to nowhere, or a page that cannot be reached, ends the build."""
    require_module("mkdocs")
    require_module("material")
    folder = tmp_path_factory.mktemp("site")
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(folder)],
        cwd=ROOT,
        env={**os.environ, "NO_MKDOCS_2_WARNING": "1"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert "WARNING" not in done.stderr
    return folder


@pytest.mark.parametrize(("page", "width", "scheme"), VIEWS)
def test_a_page_needs_no_network_and_is_accessible(
    browser: Browser, site: Path, page: str, width: int, scheme: str
) -> None:
    assert (site / page).is_file()
    visit = browser.open(site / page, width=width, scheme=scheme)
    assert visit.complaints == ()
    assert [url for url in visit.requests if not url.startswith("file:")] == []
    assert browser.violations() == []
    assert browser.run("return document.documentElement.scrollWidth") <= width


@pytest.mark.slow
def test_every_page_is_accessible(browser: Browser, site: Path) -> None:
    pages = {path.relative_to(site) for path in site.rglob("*.html")} - {Path("404.html")}  # of servers alone
    assert len(pages) > 150
    violations = {}
    for page in sorted(pages):
        for width in (1280, PHONE):
            browser.open(site / page, width=width)
            violations[f"{page} at {width} px"] = browser.violations()
    assert {place: lines for place, lines in violations.items() if lines} == {}


def test_the_search_answers_without_a_server(browser: Browser, site: Path) -> None:
    wait = require_module("selenium.webdriver.support.wait").WebDriverWait(browser.driver, 30)
    browser.open(site / "index.html")
    field = browser.one(".md-search__input")
    field.click()
    field.send_keys("stribeck")
    links = wait.until(lambda _: browser.all(".md-search-result__item a.md-search-result__link"))
    address = links[0].get_attribute("href").partition("?")[0]
    assert address == (site / "effects/stribeck_friction.html").as_uri()


def test_equations_are_typeset(site: Path) -> None:
    for page in (site / "effects").glob("*.html"):
        text = page.read_text(encoding="utf-8")
        assert '<math display="block">' in text
        assert "arithmatex" not in text
