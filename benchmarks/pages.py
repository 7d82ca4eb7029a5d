"""Pages of all bundled robots in headless Chromium: ``python benchmarks/pages.py [ROBOT ...]``.

Bytes of a page, CPU time to make it, time until something of it is seen (first contentful paint), and while
its drawing is turned the work of a frame and the time between two. Needs chromium, chromedriver, selenium.
"""

from __future__ import annotations

import shutil
import statistics
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from robodyn.report.arm_data import arm_of
from robodyn.report.arm_page import page
from robodyn.robot import bundled_names, load

_FLAGS = ("headless", "no-sandbox", "disable-gpu", "no-first-run", "window-size=1280,900")
#: Drags over the drawing for 120 frames; ms between frames, and of the page's own work for each.
_DRAG = """
const done = arguments[arguments.length - 1], canvas = document.querySelector("canvas");
const box = canvas.getBoundingClientRect(), { shares } = robodyn, times = [];
canvas.setPointerCapture = () => {};
const point = (type, x) => canvas.dispatchEvent(new PointerEvent(type, {
    pointerType: "mouse", clientX: box.left + x, clientY: box.top + 100 + x / 4, bubbles: true }));
Object.keys(robodyn.scene.shows).forEach((what) => (robodyn.scene.shows[what] = true));
point("pointerdown", 60);
const [busy, frames] = [shares.busy, shares.frames];
const step = (now) => {
    times.push(now);
    point("pointermove", 60 + 2 * times.length);
    if (times.length < 120) return requestAnimationFrame(step);
    point("pointerup", 300);
    done({ between: times.slice(1).map((t, k) => t - times[k]),
           work: (shares.busy - busy) / (shares.frames - frames) });
};
requestAnimationFrame(step);
"""
_PAINT = "return performance.getEntriesByName('first-contentful-paint')[0].startTime"


def main(names: list[str]) -> int:
    """Measure, print a table, and return the exit code."""
    print(
        f"{'robot':<22}{'KiB':>7}{'made, s':>9}{'paint, ms':>11}{'work, ms':>10}{'frame, ms':>11}{'worst':>7}"
    )
    with tempfile.TemporaryDirectory() as folder:
        driver = _driver(folder)
        try:
            for name in names or bundled_names():
                print(_measured(driver, name, Path(folder) / f"{name}.html"), flush=True)
        finally:
            driver.quit()
    return 0


def _measured(driver: Any, name: str, file: Path) -> str:
    begin = time.process_time()
    file.write_text(page([arm_of(load(name, warn=lambda _: None))]), encoding="utf-8")
    built = time.process_time() - begin
    driver.get(file.as_uri())
    drag = driver.execute_async_script(_DRAG)
    paint = driver.execute_script(_PAINT)
    between = drag["between"]
    return (
        f"{name:<22}{file.stat().st_size / 1024:>7.0f}{built:>9.1f}{paint:>11.0f}{drag['work']:>10.2f}"
        f"{statistics.median(between):>11.1f}{max(between):>7.0f}"
    )


def _driver(folder: str) -> Any:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = _program("chromium")
    for flag in (*_FLAGS, f"user-data-dir={folder}/profile"):
        options.add_argument(f"--{flag}")
    return webdriver.Chrome(options=options, service=Service(_program("chromedriver")))


def _program(name: str) -> str:
    place = shutil.which(name)
    if place is None:
        raise SystemExit(f"{name} is missing (Debian: apt install chromium chromium-driver)")
    return place


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
