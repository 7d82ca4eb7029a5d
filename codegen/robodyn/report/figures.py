"""Figures as pages and summaries show them."""

from __future__ import annotations

import math


def formatted(value: float) -> str:
    """A figure of three digits, if there is one."""
    if not math.isfinite(value):
        return "n/a"
    return f"{value:,.0f}" if 999.5 <= abs(value) < 1e6 else f"{value:.3g}"
