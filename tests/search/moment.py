"""Searches of a moment, the same on any machine."""

from __future__ import annotations

from typing import Any

import pytest

from robodyn.ir import Program
from robodyn.search import climb as climbing
from robodyn.search import improve as improving
from robodyn.search.climb import climb
from robodyn_testing.clocks import ticking


def search_for_a_moment(patch: pytest.MonkeyPatch) -> None:
    """Let walks be short, and a second of them ten thousand steps.

    A search for any algebra takes a second of it otherwise, however short it is.
    """
    ticking(patch, {climbing: 0.1})

    def climbs(programs: Any, *, seconds: float, **more: Any) -> list[Program]:
        return climb(programs, seconds=min(seconds, 0.25), **more)

    patch.setattr(improving, "climb", climbs)
