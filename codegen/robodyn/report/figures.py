"""Figures as pages and summaries show them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

#: Units of what a joint has, by its kind.
UNITS: Final[Mapping[str, Mapping[str, str]]] = {
    "revolute": {
        "position": "rad", "velocity": "rad/s", "acceleration": "rad/s²", "torque": "N m", "inertia": "kg m²",
    },
    "prismatic": {
        "position": "m", "velocity": "m/s", "acceleration": "m/s²", "torque": "N", "inertia": "kg",
    },
}  # fmt: skip


def formatted(value: float) -> str:
    """A figure of three digits, if there is one."""
    if not math.isfinite(value):
        return "n/a"
    return f"{value:,.0f}" if 999.5 <= abs(value) < 1e6 else f"{value:.3g}"


def with_error(value: float, error: float, sign: str = "+-") -> str:
    """A number and its standard error, both to the error's first digit (the second, of 10 to 19), with a
    ``sign`` between them."""
    if not error > 0:
        return f"{value:.4g}"
    digits = 1 - math.floor(math.log10(error))
    first = round(error * 10.0**digits)
    places = digits if first < 20 else digits - 1
    if places > 6:
        return f"{value:.3g} {sign} {error:.1g}"
    value, error = round(value, places), round(error, places)
    places = max(places, 0)
    return f"{value + 0.0:.{places}f} {sign} {error:.{places}f}"


def several(count: int, noun: str) -> str:
    """``1 unit``, ``1,000 units``."""
    return f"{count:,} {noun}{'' if count == 1 else 's'}"


def printable(line: str) -> str:
    """What a terminal prints as it stands."""
    return "".join(c if c.isprintable() else " " for c in line)


def capital(text: str) -> str:
    """``text`` at the beginning of a line."""
    return text[:1].upper() + text[1:]
