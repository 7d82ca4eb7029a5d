"""Folders of units: whatever their names are, each has its own, within the folder of the results."""

from __future__ import annotations

from pathlib import Path
from urllib.parse import unquote

import pytest

from robodyn.fleet.places import address, unit_folder

NAMES = (
    "A-12", "cell 7", "..", ".", "", "/etc/passwd", "a/b", "a\\b", "%2E", "<b>", "x\ny", "\0", "x" * 300,
    "x" * 301, "é" * 200, "\udcff", ".hidden", "C:",
)  # fmt: skip


def test_plain_names_stay_as_they_are() -> None:
    assert unit_folder("ur5", "A-12 (left)") == "units/ur5/A-12 (left)"


@pytest.mark.parametrize("name", NAMES)
def test_a_folder_can_be_made_and_is_two_levels_down(name: str, tmp_path: Path) -> None:
    folder = unit_folder(name, name)
    assert folder.count("/") == 2
    (tmp_path / folder).mkdir(parents=True)
    assert (tmp_path / folder).resolve().parents[2] == tmp_path.resolve()


def test_no_two_units_share_a_folder() -> None:
    assert len({unit_folder(a, b) for a in NAMES for b in NAMES}) == len(NAMES) ** 2


def test_addresses_lead_to_folders() -> None:
    assert address("units/a b/%2E") == "units/a%20b/%252E"
    assert unquote(address(unit_folder("a?b", "#c"))) == unit_folder("a?b", "#c")
