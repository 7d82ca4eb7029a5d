"""Tables 2.4, 2.6, 3.1 and 3.4 beside a transcription of the thesis, and that they follow their data."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest

from robodyn.effects import thesis_friction
from robodyn.thesis import method_steps as steps
from robodyn.thesis import printed_counts, printed_parameters
from robodyn.thesis.tables import Table, make, table_2_4, table_2_6, table_3_1, table_3_4
from thesis.recomputed import Patch, bundled, verdicts

# Tables 2.5, 2.6 and program D.2, once more, link by link: mass x y z | Ixx Iyy Izz motor | D.2.
PUMA = (
    ("0 0 0 0", "- - 0.35 1.14", "- - 1.490"),
    ("17.40 0.0680 0.0060 -0.0160", "0.130 0.524 0.539 4.71", "0.1351 0.6089 5.3301"),
    ("4.80 0 -0.0700 0.0140", "0.066 0.0125 0.086 0.83", "0.066 0.0134 0.9395"),
    ("0.82 0 0 -0.0190", "0.0018 0.0018 0.0013 0.20", "0.0021 0.0021 0.2013"),
    ("0.34 0 0 0", "0.0030 0.0030 0.0040 0.179", "0.0003 0.0003 0.1794"),
    ("0.09 0 0 0.032", "0.0015 0.0015 0.0004 0.193", "0.0002422 0.0002422 0.1930"),
)
# Table 3.4: mu, radius, breakaway, largest.
FRICTION = ("0.1 0.10 6.3 97.6", "0.1 0.08 5.5 186.4", "0.1 0.07 2.6 89.4")


@pytest.fixture(scope="module")
def four() -> dict[str, Table]:
    return {name: make(name) for name in ("2.4", "2.6", "3.1", "3.4")}


def numbers(text: str) -> list[float]:
    return [float(x) for x in text.split() if x != "-"]


# --- 2.4 ----------------------------------------------------------------------------------------------------


def test_table_2_4(four: dict[str, Table]) -> None:
    wrong = [name for name, verdict in verdicts(four["2.4"]).items() if verdict == "differs"]
    assert wrong == [
        "step 2A, revolute", "step 2A, prismatic", "step 6", "step 8; Eq 4.15", "step 9, prismatic",
    ]  # fmt: skip
    assert {name.partition(",")[0].partition(";")[0] for name in verdicts(four["2.4"])} == {
        "step 1", "step 2", "step 2A", "step 3", "step 4", "step 5", "step 6", "step 7", "step 8", "step 9",
    }  # fmt: skip
    assert all(row.ours["right_off"] < 1e-12 for row in four["2.4"].rows)


def test_table_2_4_follows_the_steps(monkeypatch: Patch) -> None:
    monkeypatch.setattr(steps, "slide_I", lambda w, qd, qdd: (qd * w[1], -(qd * w[0]), qdd))  # not twice
    table = table_2_4.table()
    assert table.row("step 3, prismatic").verdict == "differs"
    assert table.row("step 3, revolute").verdict == "reproduced"


# --- 2.6 ----------------------------------------------------------------------------------------------------


def test_table_2_6_has_every_printed_figure(four: dict[str, Table]) -> None:
    rows = {row.name: row.printed["value"] for row in four["2.6"].rows if "triangle" not in row.name}
    transcribed: dict[str, float] = {}
    for link, (_, moments, _) in enumerate(PUMA, 1):
        for name, text in zip(("Ixx", "Iyy", "Izz", "rotor"), moments.split(), strict=True):
            if text != "-":
                transcribed[f"link {link}, {name}"] = float(text)
    assert rows == transcribed


def test_table_2_6_by_hand(four: dict[str, Table]) -> None:
    for link, (body, moments, tensor) in enumerate(PUMA, 1):
        if "-" in moments:
            continue
        m, x, y, z = numbers(body)
        about_origin = numbers(tensor)
        squares = (y * y + z * z, x * x + z * z, x * x + y * y)
        rotors = (0.0, 0.0, numbers(moments)[3])
        for axis, name in enumerate(("Ixx", "Iyy", "Izz")):
            ours = about_origin[axis] - m * squares[axis] - rotors[axis]
            row = four["2.6"].row(f"link {link}, {name}")
            assert row.ours["value"] == pytest.approx(ours, abs=1e-6)
            assert (row.verdict == "reproduced") == (abs(ours - row.printed["value"]) < 0.51e-4)
    wrong = {name for name, verdict in verdicts(four["2.6"]).items() if verdict == "differs"}
    assert wrong == {
        "link 3, Ixx", "link 5, Ixx", "link 5, Iyy", "link 5, Izz", "link 6, Ixx", "link 6, Iyy",
        "link 6, Izz", "link 3, triangle",
    }  # fmt: skip
    assert four["2.6"].row("link 6, Iyy").reason == "ten times what program D.2 has"
    assert "was not moved" in four["2.6"].row("link 3, Ixx").reason
    assert four["2.6"].row("link 3, triangle").ours["value"] == pytest.approx(0.066 + 0.0125 - 0.086)


def test_the_printed_parameters_are_those_of_the_bundled_robots() -> None:
    for k, (link, bundle) in enumerate(zip(printed_parameters.PUMA, bundled("puma560").links, strict=True)):
        assert (link.mass, link.com) == (bundle.mass, bundle.com)
        assert link.motor == bundle.joint.motor_inertia
        share = 10 if k >= 4 else 1
        tensor = (bundle.inertia.xx, bundle.inertia.yy, bundle.inertia.zz)
        for moment, entry in zip(link.moments, tensor, strict=True):
            assert moment is None or moment == share * entry
    for tensor_d2, bundle in zip(printed_parameters.D_2, bundled("puma560_d2").links, strict=True):
        entries = (bundle.inertia.xx, bundle.inertia.yy, bundle.inertia.zz)
        assert all(x is None or x == y for x, y in zip(tensor_d2, entries, strict=True))


def test_table_2_6_follows_the_printed_figures(monkeypatch: Patch) -> None:
    links = list(printed_parameters.PUMA)
    links[1] = replace(links[1], moments=(Fraction("0.2"), Fraction("0.3"), Fraction("0.539")))
    links[4] = replace(links[4], moments=(Fraction("3e-4"), Fraction("3e-4"), Fraction("4e-4")))
    monkeypatch.setattr(table_2_6, "PUMA", tuple(links))
    table = table_2_6.table()
    assert table.row("link 2, Ixx").verdict == "differs"
    assert table.row("link 2, triangle").verdict == "differs"
    assert table.row("link 5, Izz").verdict == table.row("link 5, rotor").verdict == "reproduced"


# --- 3.1 ----------------------------------------------------------------------------------------------------


def test_table_3_1(four: dict[str, Table]) -> None:
    assert list(verdicts(four["3.1"]).values()) == ["reproduced", "differs", "reproduced", "reproduced"]
    assert four["3.1"].row("revolute, two journals (Eq 3.3)").ours["printed_off"] > 1


@pytest.mark.parametrize(
    ("name", "row"),
    [
        ("linear_bearing", "prismatic, two sliding bearings (Eq 3.4)"),
        ("thrust_bearing", "revolute, thrust bearing"),
    ],
)
def test_table_3_1_follows_the_bearings(name: str, row: str, monkeypatch: Patch) -> None:
    bearing = getattr(thesis_friction, name)

    def weaker(*arguments: Any) -> Any:
        return bearing(*arguments) / 2

    monkeypatch.setattr(thesis_friction, name, weaker)
    table = table_3_1.table()
    assert table.row(row).verdict == "differs"
    assert table.row(row).reason.startswith("neither form")


# --- 3.4 ----------------------------------------------------------------------------------------------------


def test_table_3_4_has_every_printed_figure(four: dict[str, Table]) -> None:
    names = ("mu", "radius [m]", "breakaway [N m]", "largest torque [N m]")
    transcribed = {
        f"link {link}, {name}": value
        for link, text in enumerate(FRICTION, 1)
        for name, value in zip(names, numbers(text), strict=True)
    }
    assert {row.name: row.printed["value"] for row in four["3.4"].rows} == transcribed


def test_table_3_4(four: dict[str, Table]) -> None:
    different = {name for name, verdict in verdicts(four["3.4"]).items() if verdict == "differs"}
    assert different == {"link 2, mu", "link 2, radius [m]", "link 3, mu", "link 3, radius [m]"}
    lost = {name for name, verdict in verdicts(four["3.4"]).items() if verdict == "not recoverable"}
    assert lost == {"link 1, mu", "link 1, radius [m]"}
    # by hand, from Table 3.5: link 3 brakes with 2.3648 N m in and -0.6801 N m out
    third = four["3.4"].row("link 3, breakaway [N m]").ours
    assert third["least"] == pytest.approx(2.3648, abs=0.01)
    assert third["most"] == pytest.approx(2.3648 + 0.6801, abs=0.01)
    first = four["3.4"].row("link 1, largest torque [N m]").ours
    assert first["least"] == pytest.approx(2.9943 / (15.9646 / 186.4), abs=0.1)
    assert first["most"] == pytest.approx(2.9943 / (0.6801 / 89.4), abs=1)
    # the least friction of link 2 is in Table 3.5's own row
    bound = make("3.5").row("link 2, joint friction").ours["bound"]
    second = four["3.4"].row("link 2, mu").ours["most"]
    assert second == pytest.approx(0.1 * 0.3281 / bound, rel=0.01)


def test_table_3_4_would_refuse_other_figures(monkeypatch: Patch) -> None:
    first, second, third = printed_counts.TABLE_3_4
    changed = (
        replace(first, breakaway=Fraction(12)), replace(second, largest=Fraction(1000)),
        replace(third, breakaway=Fraction(4)),
    )  # fmt: skip
    monkeypatch.setattr(table_3_4, "TABLE_3_4", changed)
    table = table_3_4.table()
    assert table.row("link 1, breakaway [N m]").verdict == "differs"
    assert table.row("link 3, breakaway [N m]").verdict == "differs"
    assert table.row("link 2, largest torque [N m]").verdict == "differs"
    assert table.row("link 2, breakaway [N m]").verdict == "reproduced"
