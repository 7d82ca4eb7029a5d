"""Tables that are recomputed, and arms to recompute them for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from robodyn.robot import Robot, load
from robodyn.thesis.tables import (
    TABLE_IDS,
    Table,
)

IDS = tuple(name for name in TABLE_IDS if name != "robots")
Patch = pytest.MonkeyPatch


def verdicts(table: Table) -> dict[str, str | None]:
    return {row.name: row.verdict for row in table.rows}


def bundled(name: str) -> Robot:
    return load(name, warn=lambda _: None)


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
