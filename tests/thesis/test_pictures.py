"""Pictures of tables and Figure 3.5: well-formed, the same bytes every time, to scale, from the counts."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from robodyn.thesis import steps
from robodyn.thesis.case_pictures import transmission
from robodyn.thesis.printed import METHODS, TABLE_2_9, table_2_10
from robodyn.thesis.tables.pictures import figure_2_9_svg, operations_svg
from thesis.recomputed import SVG, Patch, check_frames, table


def bars(text: str) -> dict[str, float]:
    """Heights of the bars by their titles, which end in what they show: to one linear scale, from 0."""
    found = {}
    for rect in ET.fromstring(text).iter(f"{SVG}rect"):
        title = rect.find(f"{SVG}title")
        if title is not None and title.text:
            found[title.text] = float(rect.attrib["height"])
    scale = [height / float(name.rpartition(" ")[2]) for name, height in found.items()]
    assert max(scale) - min(scale) < 2e-3
    return found


def test_the_bars_are_the_totals_and_follow_them(monkeypatch: Patch) -> None:
    text = operations_svg()
    check_frames(text)
    assert text.count("<polyline") == 4 + 8
    printed = {name: sum(column["total"]) for name, column in TABLE_2_9.items()}
    assert printed == {"revolute_I": 168, "revolute_II": 258, "prismatic_I": 113, "prismatic_II": 200}
    assert set(bars(text)) == {
        "revolute, method I, printed: 168", "revolute, method I, ours: 174",
        "revolute, method II, printed: 258", "revolute, method II, ours: 245",
        "prismatic, method I, printed: 113", "prismatic, method I, ours: 113",
        "prismatic, method II, printed: 200", "prismatic, method II, ours: 199",
    }  # fmt: skip
    assert operations_svg() == text
    monkeypatch.setattr(steps, "omega", lambda R, w, qd: w)
    assert "revolute, method I, ours: 158" in bars(operations_svg())


@pytest.mark.thorough
def test_figure_2_9_has_the_published_methods_ours_beside() -> None:
    text = figure_2_9_svg(table("2.10"))
    totals = {method: sum(pair) for method, pair in table_2_10()["puma_6"].items()}
    printed = {f"{m}, {METHODS[m]}, printed in Table 2.10: {total}" for m, total in totals.items()}
    assert len(bars(text)) == 2 * len(METHODS)
    assert printed <= set(bars(text))
    assert text == figure_2_9_svg(table("2.10"))


def test_figure_3_5_has_both_directions_and_all_quadrants() -> None:
    text = transmission()
    assert all(text.count(word) >= 3 for word in ("moving forward", "moving backward", "without loss"))
    lines = [line.attrib["points"] for line in ET.fromstring(text).iter(f"{SVG}polyline")]
    assert len(lines) == 9  # forward, backward and without loss, of three joints
    for three in zip(lines[::3], lines[1::3], lines[2::3], strict=True):
        heights = [[float(point.split(",")[1]) for point in line.split()] for line in three]
        assert {len(line) for line in heights} == {201}
        for forward, backward, ideal in zip(*heights, strict=True):
            assert forward <= ideal + 0.11 <= backward + 0.22  # up is less; friction is against motion
        assert heights[0][0] != heights[1][0]
