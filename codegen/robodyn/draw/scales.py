"""Axes: round numbers, where a value is between them, and how they read."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

_TICKS: Final = 6


def share(value: float, marks: Sequence[float]) -> float:
    """Where ``value`` is between the first and the last of ``marks``, as a share of the way."""
    return (value - marks[0]) / (marks[-1] - marks[0])


def ticks(values: Sequence[float], *, tight: bool = False, whole: bool = False) -> list[float]:
    """Round numbers, evenly spaced, around all of ``values``; with ``tight`` more of them, with ``whole`` no
    parts of one."""
    low, high = min(values), max(values)
    if high - low <= 1e-9 * max(abs(low), abs(high)):
        low, high = low - 0.5, high + 0.5
    rough = (high - low) / (_TICKS + 4 * tight)
    size = 10.0 ** math.floor(math.log10(rough))
    step = size * next((m for m in (1, 2, 5) if m * size >= rough), 10)
    step = max(step, 1) if whole else step
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return [round(k * step, 12) for k in range(first, last + 1)]


def decades(values: Sequence[float]) -> list[float]:
    """Powers of ten around all of ``values``, which are positive."""
    first, last = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    return [10.0**k for k in range(first, max(last, first + 1) + 1)]


def label(value: float) -> str:
    """A number at an axis: thousands apart, no power of ten where it can be read without."""
    if value == int(value) and abs(value) < 1e9:
        return f"{int(value):,}".replace(",", " ")
    return f"{value:g}"
