"""HTML and SVG: texts are escaped, by one environment that all templates share."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from robodyn.draw.markup import markup_template
from robodyn.draw.panels import Curve, Panel, figure
from robodyn.logs.log import Log
from robodyn.report.motion import motion_picture
from robodyn.robot import load
from robodyn_testing import representative, require_module

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


@pytest.mark.parametrize(
    "title", representative(["costs $5", "$\\frac{$", "$x$ and $", "\\$", "$"], "$\\frac{$")
)
def test_a_title_is_no_formula(title: str) -> None:
    require_module("matplotlib")
    robot = replace(load("stanford_3dof"), title=title)
    zeros = np.zeros((3, 3))
    log = Log(np.arange(3.0), zeros, zeros, zeros, zeros)
    assert motion_picture(robot, log, "svg").startswith(b"<?xml")
