"""Efficiency curves: how much of the torque a gear passes on, by load.

A curve through knots ``(load fraction, efficiency)``: straight lines, or a monotone cubic (Fritsch and
Carlson 1980), which never leaves the range of its knots as a natural spline may. Left of the first knot and
right of the last it stays level. Written with ``|x|`` alone, so that it is a straight line of C.

Source: Dhanaraj 1990, section 3.4 (an interpolated curve of measured points).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from robodyn.effects.scalars import clamped

Knots = Sequence[tuple[Any, Any]]


def efficiency_at(load: Any, knots: Knots, interpolation: str) -> Any:
    """Efficiency at the load fraction ``load`` >= 0, over any scalar; the knots are numbers, loads rising."""
    first, last = knots[0], knots[-1]
    if len(knots) == 1:
        return first[1]
    x = clamped(load, first[0], last[0])
    if interpolation == "linear" or len(knots) == 2:
        return _linear(x, knots)
    return _cubic(x, knots)


def _linear(x: Any, knots: Knots) -> Any:
    """A sum over the pieces: what the piece adds from its start up to ``x`` or its end. (A sum of changes of
    slope takes fewer operations, and loses the digits that steep pieces cancel.)"""
    total = knots[0][1]
    for (start, _), (end, _), slope in zip(knots, knots[1:], _slopes(knots), strict=False):
        total = total + slope * (clamped(x, start, end) - start)
    return total


def _cubic(x: Any, knots: Knots) -> Any:
    """The same with a cubic on each piece."""
    tangents = monotone_tangents(knots)
    total = knots[0][1]
    for (x0, y0), (x1, y1), m0, m1 in zip(knots, knots[1:], tangents, tangents[1:], strict=False):
        width = x1 - x0
        slope = (y1 - y0) / width
        t = clamped(x, x0, x1) - x0
        second = (3 * slope - 2 * m0 - m1) / width
        third = (m0 + m1 - 2 * slope) / (width * width)
        total = total + t * (m0 + t * (second + t * third))
    return total


def _slopes(knots: Knots) -> list[Any]:
    return [(y1 - y0) / (x1 - x0) for (x0, y0), (x1, y1) in pairwise(knots)]


def monotone_tangents(knots: Knots) -> list[Any]:
    """Slopes at the knots that keep the cubic monotone: weighted harmonic means (Fritsch and Butland 1984),
    at the ends the one-sided three-point formula, limited."""
    slopes = _slopes(knots)
    widths = [x1 - x0 for (x0, _), (x1, _) in pairwise(knots)]
    inner = []
    for h0, h1, d0, d1 in zip(widths, widths[1:], slopes, slopes[1:], strict=False):
        if d0 * d1 <= 0:
            inner.append(0 * d0)
        else:
            w0, w1 = 2 * h1 + h0, h1 + 2 * h0
            inner.append((w0 + w1) / (w0 / d0 + w1 / d1))
    return [
        _end(widths[0], widths[1], slopes[0], slopes[1]),
        *inner,
        _end(widths[-1], widths[-2], slopes[-1], slopes[-2]),
    ]


def _end(h0: Any, h1: Any, d0: Any, d1: Any) -> Any:
    tangent = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1)
    if tangent * d0 <= 0:
        return 0 * d0
    if d0 * d1 <= 0 and abs(tangent) > 3 * abs(d0):
        return 3 * d0
    return tangent
