"""Tables that are recomputed, and arms to recompute them for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from robodyn.robot import Robot
from robodyn.thesis.printed import bundled
from robodyn.thesis.tables import TABLE_IDS, Table, make

IDS = tuple(name for name in TABLE_IDS if name != "robots")
Patch = pytest.MonkeyPatch


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
