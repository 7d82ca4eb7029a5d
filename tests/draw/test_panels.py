"""Panels: curves and bars to scale, names beside what they name and not over each other; round
scales, of days too."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from robodyn.draw import style
from robodyn.draw.markup import markup_template
from robodyn.draw.panels import HEIGHT, WIDTH, Bars, Curve, Panel, figure, spread
from robodyn.draw.scales import DAY, date_ticks, day_text, decades, label, range_text, share, ticks
from robodyn.logs.log import Log
from robodyn.report.run import motion_picture
from robodyn.robot import load
from robodyn_testing import require_module

SVG = "{http://www.w3.org/2000/svg}"


def drawn(*panels: Panel) -> ET.Element:
    return ET.fromstring(figure("t", "n", panels))


def texts(root: ET.Element) -> dict[str, ET.Element]:
    return {element.text or "": element for element in root.iter(f"{SVG}text")}


def test_a_curve_is_drawn_where_its_numbers_are() -> None:
    curve = Curve("c", [0, 1, 2], [-1.0, 0.0, 3.0], dashed=True)
    (line,) = drawn(Panel("p", "x", "y", (curve,))).iter(f"{SVG}polyline")
    assert line.attrib["points"] == f"0.0,{HEIGHT:.1f} {WIDTH / 2:.1f},{HEIGHT * 3 / 4:.1f} {WIDTH:.1f},0.0"
    assert line.attrib["stroke-dasharray"] == style.DASHES


def test_bars_begin_at_zero_and_say_what_they_are() -> None:
    bars = (Bars("ours", [30.0, 60.0]), Bars("theirs", [90.0, 120.0], pale=True))
    root = drawn(Panel("p", "x", "y", bars=bars, categories=("a", "b")))
    heights = {
        rect.findtext(f"{SVG}title"): float(rect.attrib["height"])
        for rect in root.iter(f"{SVG}rect")
        if rect.find(f"{SVG}title") is not None
    }
    assert heights == {
        "a, ours: 30": HEIGHT / 4, "b, ours: 60": HEIGHT / 2, "a, theirs: 90": 3 * HEIGHT / 4,
        "b, theirs: 120": HEIGHT,
    }  # fmt: skip
    assert {"a", "b", "ours", "theirs", "30", "120"} <= set(texts(root))


def test_bars_are_never_on_a_logarithmic_axis() -> None:
    with pytest.raises(ValueError, match="bars begin at 0, which a logarithmic axis does not have"):
        Panel("p", "x", "y", bars=(Bars("b", [1.0]),), categories=("a",), logarithmic=True)
    with pytest.raises(ValueError, match="a bar for each of 2 categories"):
        Panel("p", "x", "y", bars=(Bars("b", [1.0]),), categories=("a", "b"))


def test_a_logarithmic_axis_has_a_step_a_power_of_ten() -> None:
    root = drawn(Panel("p", "x", "y", (Curve("c", [0, 1], [1.0, 1000.0]),), logarithmic=True))
    assert {"1", "10", "100", "1 000"} <= set(texts(root))
    (line,) = root.iter(f"{SVG}polyline")
    assert line.attrib["points"] == f"0.0,{HEIGHT:.1f} {WIDTH:.1f},0.0"


def test_names_stand_at_the_ends_of_curves_in_their_order() -> None:
    curves = tuple(Curve(name, [0, 1], [0, end]) for name, end in (("low", 1), ("high", 3), ("middle", 2.9)))
    root = drawn(Panel("p", "x", "y", curves))
    y = {name: float(texts(root)[name].attrib["y"]) for name in ("low", "high", "middle")}
    assert y["high"] + style.LEADING <= y["middle"] <= y["low"] - style.LEADING
    assert y["low"] == pytest.approx(HEIGHT * 2 / 3, abs=0.1), "where there is room it is level with its end"


def test_ends_that_meet_are_told_apart_before() -> None:
    """As torques of friction that end at 0: the names are in the order in which the curves came there."""
    x = [k / 100 for k in range(101)]
    curves = tuple(Curve(f"c{k}", x, [k * (a < 1) for a in x]) for k in range(3))
    root = drawn(Panel("p", "x", "y", curves))
    y = [float(texts(root)[f"c{k}"].attrib["y"]) for k in range(3)]
    assert y[2] < y[1] < y[0]
    assert y[1] == pytest.approx(HEIGHT / 2, abs=0.1)


def test_things_are_spread_without_touching() -> None:
    assert spread([(50, 10), (20, 10)], 100) == [50, 20]
    assert spread([(50, 10), (52, 10), (99, 10)], 100) == [50, 60, 95]
    crowded = spread([(0, 40), (0, 40), (0, 40)], 100)
    assert [b - a for a, b in pairwise(crowded)] == [40, 40]


def test_scales_are_round_and_readable() -> None:
    assert ticks([-1, 3]) == [-1, 0, 1, 2, 3]
    assert ticks([5.0, 5.0])[0] < 5 < ticks([5.0, 5.0])[-1]
    assert ticks([1, 6], tight=True, whole=True) == [1, 2, 3, 4, 5, 6]
    assert decades([3.0, 40.0]) == [1, 10, 100]
    assert decades([1.0, 1.0]) == [1, 10]
    assert [label(v) for v in (1e6, -2000.0, 0.05, 0.0)] == ["1 000 000", "-2 000", "0.05", "0"]
    assert share(2, [1, 2, 5]) == 0.25


MAY_3 = 1_746_230_400.0  # 2025-05-03T00:00:00Z


def test_days_are_utc() -> None:
    assert day_text(MAY_3) == "3 May 2025"
    assert day_text(MAY_3 - 1) == "2 May 2025"
    assert day_text(0.0) == "1 Jan 1970"


@pytest.mark.parametrize(
    ("days", "text"),
    [(0, "3 May 2025"), (9, "3 to 12 May 2025"), (30, "3 May to 2 Jun 2025"),
     (300, "3 May 2025 to 27 Feb 2026")],
)  # fmt: skip
def test_what_two_days_share_is_said_once(days: int, text: str) -> None:
    assert range_text(MAY_3, MAY_3 + days * DAY) == text


@pytest.mark.parametrize(
    ("days", "labels"),
    [
        (5, ["3 May", "4 May", "5 May", "6 May", "7 May", "8 May"]),
        (20, ["7 May", "12 May", "17 May", "22 May"]),
        (365, ["Jul 2025", "Sep", "Nov", "Jan 2026", "Mar", "May"]),
        (5 * 365, ["Jan 2026", "Jan 2027", "Jan 2028", "Jan 2029", "Jan 2030"]),
    ],
)
def test_ticks_are_firsts_of_months_or_days(days: int, labels: list[str]) -> None:
    assert [label for _, label in date_ticks(MAY_3, MAY_3 + days * DAY, 6)] == labels


@pytest.mark.parametrize("days", [0.001, 3, 90, 3000, pytest.param(2_900_000, marks=pytest.mark.thorough)])
def test_ticks_are_few_and_within(days: float) -> None:
    for most in (2, 4, 8):
        at = [moment for moment, _ in date_ticks(MAY_3, MAY_3 + days * DAY, most)]
        assert len(at) <= most
        assert all(MAY_3 <= moment <= MAY_3 + days * DAY for moment in at)
        assert len(at) >= 2 or days < 10 or most == 2


CODE = Path(__file__).parents[2] / "codegen"
HOSTILE = "</title><script>alert(1)</script> & \" ' \x00\x0b\x1b\x85\u2028\u202e\ud800 {{ 7 * 7 }}"


def test_texts_in_pictures_are_texts() -> None:
    curve = Curve(HOSTILE, [0.0, 1.0], [0.0, 2.0], dashed=True)
    picture = figure(HOSTILE, HOSTILE, [Panel(HOSTILE, HOSTILE, HOSTILE, (curve,))])
    root = ElementTree.fromstring(picture)
    shown = [text for text in root.itertext() if "alert" in text and "{{" in text]
    assert len(shown) == 8, "title and text, note and text, three labels, the curve"
    assert {re.sub("\ufffd+", " ", text) for text in shown} == {
        "</title><script>alert(1)</script> & \" '   {{ 7 * 7 }}"
    }
    assert {element.tag.partition("}")[2] for element in root.iter()} <= {
        "svg", "title", "desc", "rect", "text", "g", "line", "polyline",
    }  # fmt: skip
    assert 'stroke-dasharray="6 4"' in picture


def test_every_page_and_picture_is_of_the_same_environment() -> None:
    """Escaping is switched on in one place; templates of C have the other."""
    code = {path: path.read_text(encoding="utf-8") for path in CODE.rglob("*.py")}
    makers = [path for path, text in code.items() if "jinja2.Environment(" in text]
    assert [path.relative_to(CODE).as_posix() for path in makers] == ["robodyn/emit/render.py"]
    environment = markup_template("gantt.svg.j2").environment
    assert environment.autoescape is True
    said = environment.from_string("<b>{{ x }}</b>").render(x="<i>\u202e\n")
    assert said == "<b>&lt;i&gt;\ufffd\n</b>"


def test_a_title_is_no_formula() -> None:
    require_module("matplotlib")
    robot = replace(load("stanford_3dof"), title="costs $5 and $\\frac{$")
    zeros = np.zeros((3, 3))
    log = Log(np.arange(3.0), zeros, zeros, zeros, zeros)
    assert motion_picture(robot, log, "svg").startswith(b"<?xml")
