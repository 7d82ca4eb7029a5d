"""The layered graph (a lane a link, a row a layer, waits, a critical path) and the picture of a motion."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from robodyn.draw import style
from robodyn.logs.log import Log
from robodyn.report import run
from robodyn.report.schedule_pictures import critical_chain, layers_svg
from robodyn.report.schedules import links_source
from robodyn.robot import load
from robodyn_testing import require_module

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def root() -> ET.Element:
    return ET.fromstring(layers_svg(links_source(4)))


def test_every_task_is_in_the_lane_of_its_link_and_the_row_of_its_layer(root: ET.Element) -> None:
    graph = links_source(4).graph
    level = graph.levels()
    at = {
        int(group.findtext(f"{SVG}text") or 0): (float(rect.attrib["x"]), float(rect.attrib["y"]))
        for group in root.iter(f"{SVG}g")
        for rect in group.findall(f"{SVG}rect")
    }
    assert set(at) == set(graph.tasks)
    assert len(set(at.values())) == len(at), "no box on another"
    for other, task in ((a, b) for a in graph.tasks for b in graph.tasks):
        if graph.link(other) < graph.link(task):
            assert at[other][0] < at[task][0]
        if level[other] < level[task]:
            assert at[other][1] < at[task][1]


def test_drawn_are_the_waits_that_make_the_layers(root: ET.Element) -> None:
    graph = links_source(4).graph
    level = graph.levels()
    last = [(a, b) for b, needed in graph.after.items() for a in needed if level[a] == level[b] - 1]
    lines = list(root.iter(f"{SVG}line"))
    assert len(lines) == len(last)
    thick = [line for line in lines if line.attrib["stroke"] == style.VERMILION]
    assert len(thick) == graph.critical_path - 1
    assert lines[-len(thick) :] == thick, "on top of the others"
    ends = {(line.attrib["x2"], line.attrib["y2"]) for line in thick}
    assert len(ends) == len(thick), "one after the other"


def test_the_critical_path_is_a_chain_of_waits() -> None:
    graph = links_source(4).graph
    chain = critical_chain(graph)
    assert len(chain) == graph.critical_path
    assert not graph.after[chain[0]]
    assert all(a in graph.after[b] for a, b in pairwise(chain))


@pytest.mark.parametrize("links", [1, 4])
def test_the_head_fits(links: int) -> None:
    root = ET.fromstring(layers_svg(links_source(links)))
    note = root.findtext(f"{SVG}desc") or ""
    assert float(root.attrib["width"]) >= style.text_width(note) + style.MARGIN


T = np.linspace(0, 1, 50)


def log(n: int) -> Log:
    q = np.outer(np.sin(T), np.arange(1, n + 1))
    return Log(T, q, q, q, 10 * q)


def words(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Every text that matplotlib sets from now on."""
    text, texts = require_module("matplotlib.text").Text, []
    own = text.set_text

    def set_text(self: object, s: object) -> None:
        texts.append(str(s))
        own(self, s)

    monkeypatch.setattr(text, "set_text", set_text)
    return texts


@pytest.mark.parametrize(("name", "units"), [("puma560_3dof", "rad/s"), ("stanford_3dof", "[m, m/s, N]")])
def test_every_joint_has_a_panel_for_each_quantity(
    name: str, units: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot, texts = load(name, warn=lambda _: None), words(monkeypatch)
    picture = run.motion_picture(robot, log(3), "svg").decode()
    assert len(set(re.findall(r'id="axes_\d+"', picture))) == 9
    assert sum(text.startswith("joint ") for text in texts) == 3
    assert any(units in text for text in texts)
    assert ("velocity [rad/s]" in texts) == (name == "puma560_3dof")
    assert not any("reference" in text for text in texts)


def test_what_a_log_lacks_has_no_column() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    bare = replace(log(3), qd=None)
    picture = run.motion_picture(robot, bare, "svg")
    assert len(set(re.findall(rb'id="axes_\d+"', picture))) == 6
    assert run.motion_picture(robot, bare, "svg") == picture
