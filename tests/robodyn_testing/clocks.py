"""Time in tests, of which nothing may depend on how fast the machine is or how busy.

What keeps to a budget of seconds is tested with a clock that goes on by itself (:func:`ticking`); what must
not take for ever is tested by the calls that it makes (:func:`calls_of`); and what another process or thread
does sooner or later is waited for (:mod:`robodyn_testing.waiting`).
"""

from __future__ import annotations

import itertools
import sys
from collections.abc import Callable
from types import FrameType, ModuleType
from typing import Any, TypeVar

import pytest

__all__ = ["Ticking", "calls_of", "ticking"]

T = TypeVar("T")


class Ticking:
    """A clock in place of the module ``time``: a reading is `tick` seconds later than the one before."""

    def __init__(self, tick: float) -> None:
        self.tick = tick
        self._readings = itertools.count(1)

    def monotonic(self) -> float:
        """The time [s]."""
        return self.tick * next(self._readings)


def ticking(patch: pytest.MonkeyPatch, ticks: dict[ModuleType, float]) -> None:
    """Give modules that say ``time.monotonic()`` a clock each, whose every reading is so much later [s]."""
    for module, tick in ticks.items():
        patch.setattr(module, "time", Ticking(tick))


def calls_of(work: Callable[[], T], *, most: int) -> T:
    """Do `work`, and fail when it makes more than `most` calls, of functions in Python and in C.

    The same on every machine, where a limit in seconds is not. What is slow within one call is not seen.
    """
    calls = 0

    def count(frame: FrameType, event: str, argument: Any) -> None:
        nonlocal calls
        if event.endswith("call"):
            calls += 1
            if calls > most:
                sys.setprofile(before)
                raise AssertionError(f"more than {most} calls, the last of {frame.f_code.co_qualname}")

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        return work()
    finally:
        sys.setprofile(before)
