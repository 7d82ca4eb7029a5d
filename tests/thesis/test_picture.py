"""Figure 2.9 as a picture: well-formed, the same bytes every time, drawn from the counts."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from robodyn.draw.panels import HEIGHT, WIDTH
from robodyn.thesis import method_steps as steps
from robodyn.thesis.printed_counts import TABLE_2_9
from robodyn.thesis.tables.picture import operations_svg

SVG = "{http://www.w3.org/2000/svg}"


def bars(text: str) -> dict[str, float]:
    """Heights of the bars by their titles."""
    found = {}
    for rect in ET.fromstring(text).iter(f"{SVG}rect"):
        title = rect.find(f"{SVG}title")
        if title is not None and title.text:
            found[title.text] = float(rect.attrib["height"])
    return found


@pytest.fixture(scope="module")
def text() -> str:
    return operations_svg()


def test_the_picture_is_an_svg_whose_bars_are_the_totals(text: str) -> None:
    assert text.isascii()
    root = ET.fromstring(text)
    found = bars(text)
    printed = {name: sum(column["total"]) for name, column in TABLE_2_9.items()}
    assert printed == {"revolute_I": 168, "revolute_II": 258, "prismatic_I": 113, "prismatic_II": 200}
    assert set(found) == {
        "revolute, method I, printed: 168", "revolute, method I, ours: 174",
        "revolute, method II, printed: 258", "revolute, method II, ours: 245",
        "prismatic, method I, printed: 113", "prismatic, method I, ours: 113",
        "prismatic, method II, printed: 200", "prismatic, method II, ours: 199",
    }  # fmt: skip
    heights = {name: height / float(name.rpartition(" ")[2]) for name, height in found.items()}
    assert max(heights.values()) - min(heights.values()) < 1e-3  # to scale
    assert len(list(root.iter(f"{SVG}polyline"))) == 4 + 8


def test_everything_is_inside(text: str) -> None:
    root = ET.fromstring(text)
    wide, high = (float(root.attrib[side]) for side in ("width", "height"))
    for group in root.iter(f"{SVG}g"):
        x, y = map(float, group.attrib["transform"].removeprefix("translate(").rstrip(")").split())
        for line in group.iter(f"{SVG}polyline"):
            for point in line.attrib["points"].split():
                px, py = map(float, point.split(","))
                assert 0 <= px <= WIDTH
                assert 0 <= py <= HEIGHT
                assert x + px <= wide
        for rect in group.iter(f"{SVG}rect"):
            assert float(rect.attrib["y"]) >= 0
        for words in group.iter(f"{SVG}text"):
            assert y + float(words.attrib["y"]) < high


def test_the_picture_follows_the_counts(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert operations_svg() == text
    monkeypatch.setattr(steps, "omega", lambda R, w, qd: w)
    after = operations_svg()
    assert after != text
    assert "revolute, method I, ours: 158" in bars(after)
