"""The README is short, and what it shows and names exists."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_it_is_short() -> None:
    assert len(README.split()) <= 900


def test_it_begins_with_the_two_commands() -> None:
    (first, *_) = re.findall(r"```console\n(.*?)```", README, flags=re.DOTALL)
    assert first == "$ make\n$ make test\n"


def test_every_road_ends_in_a_link() -> None:
    for road in ("Generate", "Deploy", "Diagnose", "Compare"):
        section = README.partition(f"## {road}\n")[2].partition("\n## ")[0]
        last = section.strip().rpartition("\n\n")[2]
        assert "$ robodyn" in section, road
        assert "](docs/" in last, road
