"""Frames of the charts on pages: scales, ticks, and paths of SVG in few bytes.

A path is drawn in a box of :data:`WIDE` by :data:`HIGH` that is stretched to the place it gets; ticks are in
percent of that place, so that text keeps its size on a screen of any width.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.draw.scales import date_ticks, ticks

WIDE: Final = 1000
HIGH: Final = 400
#: Room about the values, as a share of their range.
_ROOM: Final = 0.04
#: Signs of a tick's label; longer ones get a common power of ten.
_LABEL: Final = 6


class Mark(NamedTuple):
    """A path; ``css`` names its looks, ``title`` what it is."""

    css: str
    path: str
    title: str = ""


class Tick(NamedTuple):
    """A place on an axis, in percent from the left or the top."""

    at: str
    label: str


class Shade(NamedTuple):
    """A stretch of the horizontal axis, in percent."""

    at: str
    width: str
    what: str


class Chart(NamedTuple):
    """A frame with its marks; ``text`` is for those who do not see it; ``zero`` is where the horizontal line
    of zero is, None outside the frame."""

    title: str
    text: str
    x_label: str
    y_label: str
    x_ticks: tuple[Tick, ...]
    y_ticks: tuple[Tick, ...]
    zero: str | None
    marks: tuple[Mark, ...]
    shades: tuple[Shade, ...] = ()


class Frame(NamedTuple):
    """The lowest and highest value of each axis."""

    left: float
    right: float
    bottom: float
    top: float

    def inside(self, x: Floats, y: Floats) -> NDArray[np.bool_]:
        """Which points are known and within the frame."""
        with np.errstate(invalid="ignore"):
            return np.asarray(
                (x >= self.left) & (x <= self.right) & (y >= self.bottom) & (y <= self.top), dtype=bool
            )

    def line(self, x: Floats, y: Floats) -> str:
        """A path through points, those outside moved to the edge."""
        a, b = self._places(x, y)
        if not len(a):
            return ""
        steps = _pairs(np.diff(a), np.diff(b))
        return f"M{a[0]} {b[0]}" + (f"l{steps}" if steps else "h0")

    def outline(self, x: Floats, low: Floats, high: Floats) -> str:
        """A closed path between two lines over the same ``x``."""
        there, back = np.concatenate([x, x[::-1]]), np.concatenate([high, low[::-1]])
        path = self.line(there, back)
        return f"{path}z" if path else ""

    def dots(self, x: Floats, y: Floats) -> str:
        """A path of length zero at each point, to be drawn with round ends."""
        a, b = self._places(x, y)
        if not len(a):
            return ""
        steps = zip(np.diff(a).tolist(), np.diff(b).tolist(), strict=True)
        return f"M{a[0]} {b[0]}h0" + "".join(f"m{p}{_signed(q)}h0" for p, q in steps)

    def whiskers(self, x: Floats, low: Floats, high: Floats) -> str:
        """A path of upright strokes."""
        a, b = self._places(x, high)
        _, c = self._places(x, low)
        rows = zip(a.tolist(), b.tolist(), c.tolist(), strict=True)
        return "".join(f"M{at} {top}V{bottom}" for at, top, bottom in rows)

    def level(self, low: float, high: float) -> str:
        """A band across the frame; empty where it would be outside."""
        edges = np.array([low, high])
        if not np.isfinite(edges).all() or high < self.bottom or low > self.top:
            return ""
        return self.outline(np.array([self.left, self.right]), np.full(2, low), np.full(2, high))

    def across(self, value: float) -> float:
        """Percent from the left."""
        return 100 * (value - self.left) / (self.right - self.left)

    def down(self, value: float) -> float:
        """Percent from the top."""
        return 100 * (self.top - value) / (self.top - self.bottom)

    def chart(
        self, title: str, text: str, labels: tuple[str, str], marks: Sequence[Mark], *,
        most: tuple[int, int] = (5, 5), shades: Sequence[Shade] = (), days: bool = False,
    ) -> Chart:  # fmt: skip
        """The whole, with ``most`` ticks on either axis and ``labels`` of the axes; ``days``: the horizontal
        axis is time [s since 1970]."""
        rows = tuple(
            Tick(percent(self.down(v)), label) for v, label in _labelled(self.bottom, self.top, most[1])
        )
        places = (date_ticks if days else _labelled)(self.left, self.right, most[0])
        columns = tuple(Tick(percent(self.across(v)), label) for v, label in places)
        zero = percent(self.down(0.0)) if self.bottom <= 0 <= self.top else None
        kept = tuple(mark for mark in marks if mark.path)
        return Chart(title, text, *labels, columns, rows, zero, kept, tuple(shades))

    def _places(self, x: Floats, y: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        known = np.isfinite(x) & np.isfinite(y)
        a = WIDE * (x[known] - self.left) / (self.right - self.left)
        b = HIGH * (self.top - y[known]) / (self.top - self.bottom)
        return np.rint(np.clip(a, 0, WIDE)).astype(np.intp), np.rint(np.clip(b, 0, HIGH)).astype(np.intp)


def span(*parts: Floats | Sequence[float], room: float = _ROOM) -> tuple[float, float]:
    """The lowest and the highest of known values with some room about them; never of no width."""
    values = np.concatenate([np.asarray(part, dtype=np.float64).ravel() for part in parts] or [np.zeros(1)])
    values = values[np.isfinite(values)]
    low, high = (float(values.min()), float(values.max())) if len(values) else (0.0, 0.0)
    if high - low <= 1e-9 * max(abs(low), abs(high)):
        half = 0.5 * abs(high) or 0.5
        return low - half, high + half
    return low - room * (high - low), high + room * (high - low)


def percent(value: float) -> str:
    """A place in percent with one digit."""
    text = f"{value:.1f}".removesuffix(".0")
    return "0" if text == "-0" else text


def runs(there: NDArray[np.bool_]) -> Iterator[slice]:
    """Stretches of what is there."""
    bounds = np.flatnonzero(np.diff(np.concatenate([[False], there, [False]]).astype(int)))
    for start, end in bounds.reshape(-1, 2).tolist():
        yield slice(start, end)


def _labelled(low: float, high: float, most: int) -> list[tuple[float, str]]:
    """Round numbers within a range, ``most`` at most, zero among them if it was."""
    slack = 1e-9 * (high - low)
    inside = [v for v in ticks([low, high]) if low - slack <= v <= high + slack]
    step = -(-len(inside) // most)
    shown = inside[(inside.index(0) % step if 0 in inside else 0) :: step]
    plain = [f"{v:g}" for v in shown]
    if all(len(text.lstrip("-")) <= _LABEL for text in plain):
        return list(zip(shown, plain, strict=True))
    tens = math.floor(math.log10(max(abs(v) for v in shown)))
    return [(v, "0" if v == 0 else f"{v / 10.0**tens:.3g}e{tens}") for v in shown]


def _pairs(a: NDArray[np.intp], b: NDArray[np.intp]) -> str:
    text = "".join(f"{_signed(p)}{_signed(q)}" for p, q in zip(a.tolist(), b.tolist(), strict=True))
    return text.lstrip(" ")


def _signed(step: int) -> str:
    """A step after another number: a minus sign parts them as well as a space does."""
    return f"{step}" if step < 0 else f" {step}"
