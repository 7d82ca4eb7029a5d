"""The page of a diagnosis: whole, offline, escaped, small, drawn from the figures."""

from __future__ import annotations

import itertools
import re
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest
from numpy.typing import NDArray

from report.made_up import HOSTILE, hostile, made, series
from robodyn.diagnose.result import Gap
from robodyn.report.diagnosis import MOST_JOINTS, page
from robodyn.report.diagnosis_summary import summary
from robodyn.robot import Robot, load, read_text

Floats = NDArray[np.float64]

VOID = {"meta", "link", "br", "input", "col", "img"}
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

    @property
    def tags(self) -> list[str]:
        """The names of the elements."""
        return [tag for tag, _ in self.elements]

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
        assert re.fullmatch(r"data:,|#[a-z]+(-\d+)?", attributes.get("href", "data:,"))
    assert not re.search(r"https?:|url\(|@import", text)
    (policy,) = seen.all("meta", **{"http-equiv": "Content-Security-Policy"})
    assert policy["content"].startswith("default-src 'none'")
    assert len(text.encode()) < 600_000


def test_everything_found_stands_in_it(text: str) -> None:
    seen = Page(text)
    words = " ".join(seen.text.split())
    for part in (
        "puma560_3dof: Coulomb friction at joint 3 is missing ", "12 % of the torque stays unexplained.",
        "off by", "of the torque before,",
        "2.901 N m", "97 % sure",
        "stribeck_friction", "A step where the velocity reverses", "Slow reversals of joint 3",
        "tau2: 3 rows cut off", "a remark", "80 operations before and 83 after (+3, +4 %)", "one.csv",
        "ab" * 32, "2.797 to 3.005",
        "± 3.6 %", "not ruled out", "806 (99 %)", "203 (25 %)",
        "15 → 3.75 N m", "85 % of the gap closed",
    ):  # fmt: skip
        assert part in words, part
    rows = [[" ".join(cell.split()) for cell in row] for row in seen.cells]
    assert ["3", "12", "3.3", "3", "−72 %"] in rows
    assert ["3", "15", "3.75", "3", "−75 %"] in rows
    assert ["one.csv", "fitted", "ab" * 32] in rows
    assert ["two.csv", "validation", "cd" * 32] in rows
    kinds = [
        a["class"] for t, a in seen.elements if t == "span" and a.get("class") in ("added", "gone", "hunk")
    ]
    assert kinds == ["hunk", "hunk", "hunk", "gone", "added"]


def test_who_does_not_see_it_is_told(text: str) -> None:
    seen = Page(text)
    assert seen.all("html", lang="en")
    told = [a for a in seen.all("svg") if not a.keys() & {"aria-hidden", "viewbox"} and a]
    assert all(a["role"] == "img" and a["aria-label"] for a in told)
    assert all(a.get("scope") in ("row", "col") for a in seen.all("th"))
    assert any(
        a["aria-label"] == "Joint 3: 15 before, 3.75 after, noise floor 3 N m; now 1.25 times the noise"
        for a in told
    )
    levels = [int(tag[1]) for tag, _ in seen.elements if re.fullmatch("h[1-6]", tag)]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(b <= a + 1 for a, b in itertools.pairwise(levels))
    places = {a["href"][1:] for a in seen.all("a")}
    assert places == {"torque", "gap", "findings", "next", "where", "residual", "model", "motion", "data"}
    assert all(len(seen.all("h2", id=place)) == 1 for place in places)


def share(place: dict[str, str], key: str) -> float:
    return float(place[key].removesuffix("%"))


def test_marks_bars_and_intervals_are_to_scale(text: str) -> None:
    seen = Page(text)
    # 5 times the noise before and 1.25 times after, on the validation log: on a logarithmic scale.
    (before, *_), (after, *_) = (
        [share(a, "cx") for a in seen.all("circle", **{"class": css})]
        for css in ("ring before proof", "disc after proof")
    )
    noise = share(next(a for a in seen.all("rect", **{"class": "noise"}) if a["width"] != "14"), "width")
    assert (before - noise) / (after - noise) == pytest.approx(np.log(5) / np.log(1.25), rel=0.02)
    named, first, second = (share(a, "width") for a in evidence(seen))
    assert named == 100
    assert (first / named, second / named) == pytest.approx((806.25 / 812.5, 0.25), abs=1e-3)
    (interval,) = seen.all("rect", **{"class": "reach"})
    # From 0 in the middle to twice the value at the right end.
    assert share(interval, "x") == pytest.approx(50 + 25 * (1 - 1.96 * 0.0531 / 2.9012), abs=0.06)
    assert share(interval, "width") == pytest.approx(50 * 1.96 * 0.0531 / 2.9012, abs=0.06)


def evidence(seen: Page) -> list[dict[str, str]]:
    """Bars of gains."""
    labels = [k for k, (_, a) in enumerate(seen.elements) if a.get("aria-label", "").startswith("gain ")]
    return [seen.elements[k + 2][1] for k in labels]


def points(path: str) -> Floats:
    """The corners of a path, in the box of a chart."""
    start, _, steps = path.removesuffix("z").partition("l")
    numbers = [int(x) for x in re.findall(r"-?\d+", start + " " + steps)]
    return np.cumsum(np.reshape(numbers, (-1, 2)), axis=0)


def test_the_residual_is_drawn_where_it_is(robot: Robot) -> None:
    seen = Page(page(made(robot), validated=True))
    logs = seen.all("details", **{"class": "log"})
    assert [("open" in a) for a in logs] == [True, False]
    charts = [
        a["aria-label"] for a in seen.all("svg", role="img") if a["aria-label"].startswith("Joint 3 over")
    ]
    names = ["time", "velocity", "position", "load", "acceleration"]
    # Once in the card of the finding, and once for either log.
    assert sorted(label.partition(".")[0] for label in charts) == sorted(
        f"Joint 3 over {name}" for name in [*names, *names, "velocity"]
    )
    curves = [k for k, (t, a) in enumerate(seen.elements) if a.get("class") == "mean before fore"]
    # Over the velocity the mean is -1 on the left, and 1 on the right.
    mean = points(seen.elements[curves[0]][1]["d"])
    left, right = mean[mean[:, 0] < 400, 1], mean[mean[:, 0] > 600, 1]
    assert left.min() > right.max() + 50
    assert np.ptp(left) < 20
    for _, a in seen.elements:
        assert not re.search("nan|inf", a.get("d", ""))


def test_hostile_names_are_text(robot: Robot) -> None:
    diagnosis = hostile(robot)
    text = page(diagnosis, validated=False)
    seen = Page(text)
    assert not {tag for tag, _ in seen.elements} & ACTIVE
    assert "<script" not in text
    assert seen.text.count(HOSTILE) >= 12
    assert all(line.isprintable() for line in summary(diagnosis, "report.html", validated=False))


def test_nothing_found_and_nothing_known(robot: Robot) -> None:
    nan = np.full(3, np.nan)
    empty = made(
        robot, verdict="consistent", findings=(), gap=Gap(nan, nan, nan, nan, nan), diff="", flags=(),
        left=nan, words=(), logs=(), series=(), operations=(0, 0),
    )  # fmt: skip
    seen = Page(page(empty, validated=False))
    assert "explains the logs: no effect needs to be added" in seen.text
    assert "The description stays as it is" in seen.text
    assert [a["class"] for a in seen.all("details")] == ["plain"]
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
    assert len(html.encode()) < 1_500_000
    seen = Page(html)
    assert len(seen.all("figure", **{"class": "strip"})) == 2 * (MOST_JOINTS - 1)
    assert f"{n - MOST_JOINTS} more joints" in seen.text
    assert "N m or N" in seen.text


def test_the_same_bytes_again(robot: Robot, text: str) -> None:
    assert page(made(robot), validated=True) == text
