"""Pages in a real browser: what it complains of, what it asks the network for, what is not accessible.

``browser`` is one headless Chromium for all tests of a run (``tests/conftest.py`` hands it to them)::

    def test_my_page(browser: Browser, tmp_path: Path) -> None:
        visit = browser.open(page, width=375, scheme="dark")
        assert visit.complaints == ()
        assert visit.requests == ()
        assert browser.violations() == []
        browser.screenshot("mine-375-dark")
"""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import pytest

from robodyn_testing.wanted import ROOT, require_module, require_npm_package, require_tool

__all__ = ["PHONE", "SCHEMES", "SCREENSHOTS", "Browser", "Visit", "browser"]

SCREENSHOTS: Final = ROOT / "build" / "screenshots"
"""Where pictures of pages are left, to be looked at."""

PHONE: Final = 375
"""Width of a phone's window, px: the smallest that a page is made for."""

SCHEMES: Final = ("light", "dark")

_FLAGS: Final = (
    "headless", "no-sandbox", "disable-gpu", "disable-quic", "no-first-run", "disable-background-networking",
    "disable-component-update", "disable-sync", "hide-scrollbars", "window-size=1280,900",
)  # fmt: skip

#: Runs axe over the page, and hands back what it holds against it: rule, impact, help, the elements.
_AXE: Final = """
const done = arguments[arguments.length - 1];
axe.run(document, {resultTypes: ["violations"]}).then(
  result => done(result.violations.map(v => {
    const elements = v.nodes.map(n => `${n.target} ${n.html.slice(0, 160)}`);
    return `${v.id} (${v.impact}): ${v.help}: ${elements.join(" | ")}`;
  })),
  error => done([`axe-core failed: ${error}`]));
"""


@dataclass(frozen=True, slots=True)
class Visit:
    """What came of opening a page: ``complaints`` of the console, ``requests`` beyond the page itself."""

    complaints: tuple[str, ...]
    requests: tuple[str, ...]


class Browser:
    """A selenium ``driver`` of Chromium, and what the tests of pages ask of it."""

    def __init__(self, driver: Any) -> None:
        self.driver = driver

    def open(
        self,
        file: Path,
        *,
        width: int = 1280,
        height: int = 900,
        scheme: str = "light",
        media: str = "",
    ) -> Visit:
        """Show ``file`` in a window of ``width`` by ``height`` px to one who prefers ``scheme`` (light or
        dark); ``media``: "print" as on paper, "" as on a screen."""
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        self.command("Emulation.setEmulatedMedia", media=media, features=features)
        self.command(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )
        self._messages()  # those of the page before
        self.driver.get(file.as_uri())
        complaints, addresses = self._messages()
        return Visit(complaints, tuple(url for url in addresses if url.partition("#")[0] != file.as_uri()))

    def _messages(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Console messages and addresses asked for, since the last time."""
        complaints = tuple(entry["message"] for entry in self.driver.get_log("browser"))
        events = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        sent = [event["params"] for event in events if event["method"] == "Network.requestWillBeSent"]
        # The browser's own first page may still be asking for its parts.
        urls = [m["request"]["url"] for m in sent if not m["documentURL"].startswith("chrome://")]
        return complaints, tuple(url for url in urls if not url.startswith("data:"))

    def command(self, name: str, **arguments: Any) -> Any:
        """A command of Chrome's DevTools protocol."""
        return self.driver.execute_cdp_cmd(name, arguments)

    def run(self, script: str, *arguments: Any) -> Any:
        """What ``script`` returns in the page."""
        return self.driver.execute_script(script, *arguments)

    def all(self, selector: str) -> list[Any]:
        """The elements that a CSS ``selector`` selects."""
        elements: list[Any] = self.driver.find_elements("css selector", selector)
        return elements

    def one(self, selector: str) -> Any:
        """The first element that a CSS ``selector`` selects."""
        return self.driver.find_element("css selector", selector)

    def unfold(self) -> None:
        """Open whatever is folded."""
        self.run("document.querySelectorAll('details').forEach(d => d.open = true)")

    def violations(self) -> list[str]:
        """What axe-core, with all its rules, holds against the page as it is now: a line for each rule.

        Without axe-core the test is skipped (fails in CI): ``make axe`` installs it.
        """
        axe = require_npm_package("axe-core") / "axe.min.js"
        self.run(axe.read_text(encoding="utf-8"))
        lines: list[str] = self.driver.execute_async_script(_AXE)
        return lines

    def screenshot(self, name: str) -> Path:
        """A picture of the whole page, in :data:`SCREENSHOTS` as ``name``.png."""
        picture = self.command("Page.captureScreenshot", format="png", captureBeyondViewport=True)
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        file = SCREENSHOTS / f"{name}.png"
        file.write_bytes(base64.b64decode(picture["data"]))
        return file


@pytest.fixture(scope="session")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    """Chromium, headless, with a profile of its own."""
    webdriver = require_module("selenium.webdriver")
    options, service = webdriver.ChromeOptions(), require_module("selenium.webdriver.chrome.service")
    options.binary_location = require_tool("chromium")
    for flag in (*_FLAGS, f"user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(f"--{flag}")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=service.Service(require_tool("chromedriver")))
    yield Browser(driver)
    driver.quit()
