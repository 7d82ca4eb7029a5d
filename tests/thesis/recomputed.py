"""Tables that are recomputed, and arms to recompute them for."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from robodyn.draw.panels import HEIGHT, WIDTH
from robodyn.robot import Robot
from robodyn.thesis.printed import bundled
from robodyn.thesis.tables import TABLE_IDS, Table, make

IDS = tuple(name for name in TABLE_IDS if name != "robots")
Patch = pytest.MonkeyPatch
SVG = "{http://www.w3.org/2000/svg}"


@cache
def table(name: str) -> Table:
    """A table, made once: to be asked for before anything is patched."""
    return make(name)


def named(found: Table, verdict: str | None = "differs") -> set[str]:
    """The rows of a verdict."""
    return {row.name for row in found.rows if row.verdict == verdict}


def changed(name: str, link: int, **numbers: Any) -> Callable[[str], Robot]:
    """Loads bundled robots, ``name`` with other numbers at a link (from 1)."""

    def load_changed(wanted: str) -> Robot:
        robot = bundled(wanted)
        if wanted != name:
            return robot
        links = list(robot.links)
        links[link - 1] = replace(links[link - 1], **numbers)
        return replace(robot, links=tuple(links))

    return load_changed


def check_frames(text: str) -> None:
    """That a picture has lines, in their frames, which are in it with all words."""
    assert text.isascii()
    root = ET.fromstring(text)
    assert list(root.iter(f"{SVG}polyline"))
    width, height = (float(root.attrib[side]) for side in ("width", "height"))
    for panel in root.iter(f"{SVG}g"):
        x, y = map(float, panel.attrib["transform"].removeprefix("translate(").rstrip(")").split())
        assert x + WIDTH < width
        assert y + max(float(words.attrib["y"]) for words in panel.iter(f"{SVG}text")) < height
        assert all(float(rect.attrib["y"]) >= 0 for rect in panel.iter(f"{SVG}rect"))
        for line in panel.iter(f"{SVG}polyline"):
            points = [tuple(map(float, pair.split(","))) for pair in line.attrib["points"].split()]
            assert all(-0.1 <= x <= WIDTH + 0.1 and -0.1 <= y <= HEIGHT + 0.1 for x, y in points)
