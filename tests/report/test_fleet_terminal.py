"""A fleet on a terminal: a few lines that fit, and whatever is named in them cannot move the cursor."""

from __future__ import annotations

from dataclasses import replace

from report.made_up_fleet import fleet, of_one
from robodyn.fleet.result import Look, Unused
from robodyn.report.fleet_terminal import summary


def test_what_to_look_at_first() -> None:
    lines = summary(fleet(30, 9), "out/index.html")
    assert " ".join(line.strip() for line in lines[:2]).startswith(
        "plant: 9 of 30 units differ from their siblings"
    )
    assert "look at first:" in lines
    first = " ".join(line.strip() for line in lines[4:6])
    assert first.startswith("1. arm<6>/AR-0000: Coulomb and viscous friction, joint 1: +1.10 ")
    assert first.endswith("(+25 %), drifted until 27 Jun 2025 from 28 Apr 2025 (16 Apr to 7 May 2025)")
    assert "and 4 more on the page" in lines
    assert "record next of AR-0000: Record the same motion again." in lines
    assert "- 1: times go backward (logs/a.csv)" in lines
    assert lines[-1] == "page: out/index.html"
    assert max(map(len, lines)) <= 100
    assert len(lines) <= 20


def test_where_nothing_is_named() -> None:
    assert summary(of_one(), "index.html") == [
        "plant: The only unit is what it was",
        "1 unit of 1 type, 1 log of 1 day",
        "page: index.html",
    ]


def test_reasons_are_counted() -> None:
    result = of_one()
    unused = [Unused(f"{k}.csv", "a", "b", f"reason {min(k, 5) % 5}") for k in range(10)]
    lines = summary(replace(result, unused=tuple(unused)), "p")
    assert "10 logs not used:" in lines
    assert "- 6: reason 0 (such as 0.csv)" in lines
    assert "- 2 for other reasons" in lines


def test_control_characters_do_not_reach_the_terminal() -> None:
    result = fleet(3, 1)
    look = result.first_to_look_at[0]
    hostile = replace(result, name="\x1b[2J", first_to_look_at=(Look(look.type, look.unit, "", "a\x1bb\nc"),))
    assert all(line.isprintable() for line in summary(hostile, "p"))
