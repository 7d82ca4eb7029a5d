"""The page of a diagnosis: whole, offline, escaped, small, drawn from the figures."""

from __future__ import annotations

import itertools
import re
import subprocess
from dataclasses import replace
from html import escape
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

from report.made_up import made, series
from robodyn.diagnose.result import Estimate, Finding, Gap, Rival
from robodyn.report.diagnosis import MOST_JOINTS, page
from robodyn.report.diagnosis_text import summary
from robodyn.robot import Robot, load, read_text
from robodyn_testing import require_tool

HOSTILE = '<script>alert("1")</script>&amp;\'</title></svg></style>{{ 7 * 7 }}'
VOID = {"meta", "link", "br"}
#: Places of a document that something could be fetched or run from.
ACTIVE = {"script", "iframe", "img", "object", "embed", "form", "base", "audio", "video", "use", "image"}


class Page(HTMLParser):
    """Elements in order with their attributes, text by the element that it is in; nesting is checked."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.open: list[str] = []
        self.elements: list[tuple[str, dict[str, str]]] = []
        self.text = ""
        self.cells: list[list[str]] = []
        self.feed(text)
        self.close()
        assert not self.open

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, {key: value or "" for key, value in attrs}))
        if tag not in VOID:
            self.open.append(tag)
        if tag == "tr":
            self.cells.append([])
        if tag in ("td", "th"):
            self.cells[-1].append("")

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, {key: value or "" for key, value in attrs}))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if "style" not in self.open:
            self.text += data
        if "td" in self.open or "th" in self.open:
            self.cells[-1][-1] += data

    def all(self, tag: str, **attributes: str) -> list[dict[str, str]]:
        return [a for t, a in self.elements if t == tag and attributes.items() <= a.items()]


@pytest.fixture(scope="module")
def robot() -> Robot:
    return load("puma560_3dof", warn=lambda _: None)


@pytest.fixture(scope="module")
def text(robot: Robot) -> str:
    return page(made(robot), validated=True)


def test_one_file_that_needs_nothing_else(text: str) -> None:
    seen = Page(text)
    assert text.startswith("<!doctype html>\n")
    assert not {tag for tag, _ in seen.elements} & ACTIVE
    for _, attributes in seen.elements:
        assert not any(name.startswith("on") or name == "src" for name in attributes)
        assert attributes.get("href", "data:,") == "data:,"
    assert not re.search(r"https?:|url\(|@import", text)
    (policy,) = seen.all("meta", **{"http-equiv": "Content-Security-Policy"})
    assert policy["content"].startswith("default-src 'none'")
    assert len(text.encode()) < 600_000


def test_everything_found_stands_in_it(text: str) -> None:
    seen = Page(text)
    words = " ".join(seen.text.split())
    for part in (
        "puma560_3dof lacks Coulomb friction (joint 3).", "2.901 ± 0.053 N m", "97 %", "stribeck_friction",
        "joint 3: a step where the velocity reverses", "slow reversals of joint 3", "tau2: 3 rows cut off",
        "a remark", "80 operations before and 83 after (+3)", "one.csv", "ab" * 32, "2.797 to 3.005",
    ):  # fmt: skip
        assert part in words, part
    rows = [[" ".join(cell.split()) for cell in row] for row in seen.cells]
    assert ["3", "12", "3.3", "3", "-72 %"] in rows
    assert ["3", "15", "3.75", "3", "-75 %"] in rows
    assert ["one.csv", "fitted", "ab" * 32] in rows
    assert ["two.csv", "validation", "cd" * 32] in rows
    assert ["Stribeck friction (not ruled out)", "joint 3", "806", ""] in rows
    kinds = [
        a["class"] for t, a in seen.elements if t == "span" and a.get("class") in ("added", "gone", "hunk")
    ]
    assert kinds == ["hunk", "hunk", "hunk", "gone", "added"]


def test_who_does_not_see_it_is_told(text: str) -> None:
    seen = Page(text)
    assert seen.all("html", lang="en")
    assert all(a["aria-label"] for a in seen.all("svg", role="img"))
    assert len(seen.all("svg")) == len(seen.all("svg", role="img"))
    assert all(a.get("scope") in ("row", "col") for a in seen.all("th"))
    (bars,) = (a for a in seen.all("svg") if a["aria-label"].startswith("Validation log, not fitted."))
    assert "joint 3: 15 before, 3.75 after, floor 3" in bars["aria-label"]
    levels = [int(tag[1]) for tag, _ in seen.elements if re.fullmatch("h[1-6]", tag)]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(b <= a + 1 for a, b in itertools.pairwise(levels))


def test_bars_and_intervals_are_to_scale(text: str) -> None:
    seen = Page(text)
    paths = [a["d"] for t, a in seen.elements if t == "path" and a["class"] == "bar before"]
    heights = [float(re.findall(r"v-([\d.]+)", d)[0]) for d in paths]
    assert np.allclose(np.array(heights[:3]) / heights[0], [1, 2, 3], atol=0.02)
    named, first, second = (float(a["width"]) for a in evidence(seen))
    assert named == 100
    assert (first / named, second / named) == pytest.approx((806.25 / 812.5, 0.25), abs=1e-3)
    (interval,) = (a for t, a in seen.elements if t == "rect" and a.get("height") == "4")
    # From 0 in the middle to twice the value at the right end.
    assert float(interval["x"]) == pytest.approx(50 + 25 * (1 - 1.96 * 0.0531 / 2.9012), abs=0.06)
    assert float(interval["width"]) == pytest.approx(50 * 1.96 * 0.0531 / 2.9012, abs=0.06)


def evidence(seen: Page) -> list[dict[str, str]]:
    """Bars of gains."""
    labels = [k for k, (_, a) in enumerate(seen.elements) if a.get("aria-label", "").startswith("gain ")]
    return [seen.elements[k + 2][1] for k in labels]


def test_the_residual_is_drawn_where_it_is(robot: Robot) -> None:
    seen = Page(page(made(robot), validated=True))
    assert len(seen.all("details")) == 6
    assert len([a for a in seen.all("details") if "open" in a]) == 1
    charts = [
        a["aria-label"] for a in seen.all("svg", role="img") if a["aria-label"].startswith("Joint 3 over")
    ]
    names = ["time", "velocity", "position", "load", "acceleration"]
    assert [label.partition(".")[0] for label in charts] == [f"Joint 3 over {name}" for name in names] * 2
    curves = [k for k, (t, a) in enumerate(seen.elements) if a.get("class") == "mean before"]
    # Over the velocity of joint 1 the mean is -1 on the left, and 1 on the right.
    points = np.array(re.findall(r"[ML](\S+) ([^\sLM]+)", seen.elements[curves[0]][1]["d"]), dtype=float)
    left, right = points[points[:, 0] < 140, 1], points[points[:, 0] > 160, 1]
    assert left.min() > right.max() + 50
    assert np.ptp(left) < 8
    for _, a in seen.elements:
        assert not re.search("nan|inf", a.get("d", ""))


def test_hostile_names_are_text(robot: Robot) -> None:
    finding = Finding(
        HOSTILE, None, {HOSTILE: Estimate(HOSTILE, None, HOSTILE)}, 0.9, (HOSTILE,), HOSTILE, HOSTILE,
        1.0, 1.0, (Rival(HOSTILE, 1, 0.5),),
    )  # fmt: skip
    found = made(
        replace(robot, title=HOSTILE),
        findings=(finding,), diff=f"+{HOSTILE}\n", flags=(HOSTILE,), words=(HOSTILE,),
        logs=({"name": HOSTILE, "sha256": HOSTILE},),
    )  # fmt: skip
    text = page(found, validated=False)
    seen = Page(text)
    assert not {tag for tag, _ in seen.elements} & ACTIVE
    assert "<script" not in text
    assert seen.text.count(HOSTILE) >= 12
    assert all(line.isprintable() for line in summary(found, "report.html", validated=False))


def test_nothing_found_and_nothing_known(robot: Robot) -> None:
    nan = np.full(3, np.nan)
    empty = made(
        robot, verdict="consistent", findings=(), gap=Gap(nan, nan, nan, nan, nan), diff="", flags=(),
        left=nan, words=(), logs=(), series=(), operations=(0, 0),
    )  # fmt: skip
    seen = Page(page(empty, validated=False))
    assert "explains the logs: nothing is worth adding" in seen.text
    assert "The description stays as it is" in seen.text
    assert not seen.all("details")
    wide = (1500, 3)
    gone = replace(
        series("train", 3), before=np.full(wide, np.nan), after=np.zeros(wide), qd=np.full(wide, np.inf)
    )
    text = page(made(robot, series=(gone,), gap=empty.gap), validated=False)
    assert not any(re.search("nan|inf", a.get("d", "")) for _, a in Page(text).elements)
    short = series("train", 3, samples=2)
    Page(page(made(robot, series=(short,)), validated=False))


def test_long_arms_and_logs_stay_small() -> None:
    n = 24
    text = (
        "name: snake\nlinks:\n"
        + "  - {joint: revolute, a: 1, mass: 1}\n" * (n - 1)
        + ("  - {joint: prismatic, mass: 1}\n")
    )
    snake = read_text(text)
    found = made(snake, series=(series("train", n, 8000), series("validate", n, 8000)), diff="+x\n" * 100_000)
    html = page(found, validated=True)
    assert len(html.encode()) < 3_000_000
    seen = Page(html)
    assert len(seen.all("details")) == 2 * MOST_JOINTS
    assert f"{n - MOST_JOINTS} more joints" in seen.text
    assert "N or N m" in seen.text


def test_the_same_bytes_again(robot: Robot, text: str) -> None:
    assert page(made(robot), validated=True) == text


#: A frame as wide as a phone; the title tells how wide the page in it would be, and whether it is drawn.
FRAME = """\
<!doctype html><title>not yet</title><iframe width="360" height="700" srcdoc="{}"></iframe>
<script>onload = () => {{
  const page = frames[0].document, box = page.querySelector("path.bar.before").getBoundingClientRect();
  document.title = [page.documentElement.scrollWidth, page.fonts.status, box.height > 20].join(" ");
}}</script>
"""


@pytest.mark.slow
def test_a_browser_shows_it_and_complains_of_nothing(robot: Robot, tmp_path: Path) -> None:
    text = page(made(robot), validated=True)
    file, frame = tmp_path / "report.html", tmp_path / "frame.html"
    file.write_text(text, encoding="utf-8")
    frame.write_text(FRAME.format(escape(text)), encoding="utf-8")
    shown, complaints = browsed(file)
    assert "CONSOLE" not in complaints
    assert [tag for tag, _ in Page(shown).elements] == [tag for tag, _ in Page(text).elements]
    shown, complaints = browsed(frame)
    assert "CONSOLE" not in complaints
    assert "<title>360 loaded true</title>" in shown


def browsed(file: Path) -> tuple[str, str]:
    """The document as a browser holds it, and what that browser says."""
    flags = """
        headless no-sandbox disable-gpu disable-quic no-first-run disable-background-networking
        disable-component-update disable-sync hide-scrollbars enable-logging=stderr dump-dom
    """
    options = [f"--{flag}" for flag in (*flags.split(), f"user-data-dir={file.with_suffix('')}")]
    run = subprocess.run(
        [require_tool("chromium"), *options, file.as_uri()],
        capture_output=True, text=True, timeout=60, check=True,
    )  # fmt: skip
    return run.stdout, run.stderr
