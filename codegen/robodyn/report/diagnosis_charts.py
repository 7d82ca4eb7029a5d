"""Charts of a diagnosis: what a model leaves over time and over what may cause it, joint by joint.

A chart is a frame with ticks, and marks that are paths of SVG; how they look is the page's affair.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.result import Series
from robodyn.report.curves import share, ticks

Floats = NDArray[np.float64]

#: Dots of a panel, columns of a curve over time, and bins of a mean, at most.
DOTS, COLUMNS, BINS = 260, 300, 20
#: A bin of fewer samples has no mean; so many of a panel's samples are outside its frame at most, in percent.
_FEWEST, _OUTSIDE = 5, 0.5
#: Share of a log at either end that no figure counts.
_END = 0.02
_SMALL, _WIDE = (300.0, 170.0), (680.0, 150.0)
_BAR_WIDTH: Final = 620.0
#: Bars of such unlike heights stand on a logarithmic axis.
_UNLIKE = 50.0


@dataclass(frozen=True, slots=True)
class Mark:
    """A path; ``css`` names its looks, ``title`` what it is."""

    css: str
    path: str
    title: str = ""


@dataclass(frozen=True, slots=True)
class Tick:
    """A place on an axis, in the chart's units from its left or top."""

    at: str
    label: str


@dataclass(frozen=True, slots=True)
class Chart:
    """A frame of ``width`` and ``height`` with its marks; ``text`` is for those who do not see it."""

    title: str
    text: str
    width: float
    height: float
    x_label: str
    y_label: str
    x_ticks: tuple[Tick, ...]
    y_ticks: tuple[Tick, ...]
    marks: tuple[Mark, ...]


@dataclass(frozen=True, slots=True)
class _Frame:
    """A scale of each axis, from values to the chart's units."""

    x: list[float]
    y: list[float]
    width: float
    height: float

    def points(self, x: Floats, y: Floats) -> list[str]:
        across = self.width * (x - self.x[0]) / (self.x[-1] - self.x[0])
        down = self.height * (1 - (y - self.y[0]) / (self.y[-1] - self.y[0]))
        return [f"{_short(a)} {_short(b)}" for a, b in zip(across.tolist(), down.tolist(), strict=True)]

    def chart(self, title: str, text: str, x_label: str, y_label: str, marks: Sequence[Mark]) -> Chart:
        across = tuple(Tick(_short(self.width * share(v, self.x)), f"{v:g}") for v in _fewer(self.x, 6))
        up = tuple(Tick(_short(self.height * (1 - share(v, self.y))), f"{v:g}") for v in _fewer(self.y, 6))
        return Chart(title, text, self.width, self.height, x_label, y_label, across, up, tuple(marks))


def _fewer(marks: list[float], most: int) -> list[float]:
    """Every so manieth of ``marks``, zero among them if it was."""
    step = -(-len(marks) // most)
    zero = marks.index(0) % step if 0 in marks else 0
    return marks[zero::step]


def _short(x: float) -> str:
    text = f"{x:.1f}".removesuffix(".0")
    return "0" if text == "-0" else text


# --- what a model leaves ----------------------------------------------------------------------------------


def over_time(series: Series, j: int, unit: str, *, columns: int = COLUMNS) -> Chart:
    """What is left at joint ``j`` (from 0) over time: lowest to highest of each column of the picture."""
    known = np.isfinite(series.times)
    t = series.times[known]
    curves = [(css, rest[known, j]) for css, rest in (("before", series.before), ("after", series.after))]
    frame = _Frame(ticks(_known(t)), ticks(_known(*(y for _, y in curves))), *_WIDE)
    marks = []
    for css, y in curves:
        for a, low, high in _columns(t, y, columns):
            outline = [*frame.points(a, high), *frame.points(a[::-1], low[::-1])]
            marks.append(Mark(f"curve {css}", f"M{'L'.join(outline)}z", css))
    return frame.chart(
        f"Joint {j + 1} over time", _told(series, j, unit), "t [s]", f"residual [{unit}]", marks
    )


def over(series: Series, j: int, name: str, x: Floats, x_unit: str, unit: str, *, dots: int = DOTS) -> Chart:
    """What is left at joint ``j`` (from 0) over ``x`` [K], called ``name``: dots, and the mean of each bin
    with one standard deviation about it."""
    curves = [("before", series.before[:, j]), ("after", series.after[:, j])]
    shown = [
        part for _, y in curves for part in np.percentile(_finite(y), (_OUTSIDE, 100 - _OUTSIDE)).tolist()
    ]
    frame = _Frame(ticks(_known(x)), ticks(shown), *_SMALL)
    faint, bold = [], []
    for css, y in curves:
        inside = np.isfinite(x) & np.isfinite(y) & (y >= frame.y[0]) & (y <= frame.y[-1])
        a, b = x[inside], y[inside]
        places = np.unique(np.linspace(0, len(a) - 1, min(len(a), dots)).astype(int))
        faint.append(Mark(f"dots {css}", "".join(f"M{p}h0" for p in frame.points(a[places], b[places]))))
        for centre, mean, spread in _means(a, b, frame.x):
            low, high = (np.clip(mean + way * spread, frame.y[0], frame.y[-1]) for way in (-1, 1))
            outline = [*frame.points(centre, high), *frame.points(centre[::-1], low[::-1])]
            bold.append(Mark(f"band {css}", f"M{'L'.join(outline)}z"))
            bold.append(Mark(f"mean {css}", f"M{'L'.join(frame.points(centre, mean))}", f"mean {css}"))
    title = f"Joint {j + 1} over {name}"
    return frame.chart(
        title,
        f"{title}: {_told(series, j, unit)}",
        f"{name} [{x_unit}]",
        f"residual [{unit}]",
        [*faint, *bold],
    )


def _told(series: Series, j: int, unit: str) -> str:
    edge = int(_END * len(series.times))
    kept = slice(edge, len(series.times) - edge)
    rms = [float(np.sqrt(np.mean(_finite(x[kept, j]) ** 2))) for x in (series.before, series.after)]
    return f"RMS {rms[0]:.3g} {unit} before, {rms[1]:.3g} {unit} after"


def _finite(x: Floats) -> Floats:
    kept: Floats = x[np.isfinite(x)]
    return kept if len(kept) else np.zeros(1)


def _known(*parts: Floats) -> list[float]:
    both = np.concatenate([_finite(part) for part in parts])
    return [float(both.min()), float(both.max())]


def _columns(t: Floats, y: Floats, columns: int) -> Iterator[tuple[Floats, Floats, Floats]]:
    """Runs of columns that hold samples: their middles, lowest and highest values."""
    kept = np.isfinite(y)
    t, y = t[kept], y[kept]
    if not len(t):
        return
    count = max(1, min(columns, len(t) // 4))
    edges = np.linspace(t.min(), t.max(), count + 1)
    place = np.clip(np.searchsorted(edges, t, "right") - 1, 0, count - 1)
    low, high = np.full(count, np.inf), np.full(count, -np.inf)
    np.minimum.at(low, place, y)
    np.maximum.at(high, place, y)
    middle = (edges[1:] + edges[:-1]) / 2
    for run in _runs(low <= high):
        yield middle[run], low[run], high[run]


def _means(x: Floats, y: Floats, marks: Sequence[float]) -> Iterator[tuple[Floats, Floats, Floats]]:
    """Runs of bins that hold enough samples: mean place, mean, and standard deviation."""
    place = np.clip((BINS * (x - marks[0]) / (marks[-1] - marks[0])).astype(int), 0, BINS - 1)
    count = np.bincount(place, minlength=BINS)
    some = np.maximum(count, 1)
    centre = np.bincount(place, x, BINS) / some
    mean = np.bincount(place, y, BINS) / some
    spread = np.sqrt(np.bincount(place, (y - mean[place]) ** 2, BINS) / some)
    for run in _runs(count >= _FEWEST):
        yield centre[run], mean[run], spread[run]


def _runs(there: NDArray[np.bool_]) -> Iterator[slice]:
    bounds = np.flatnonzero(np.diff(np.concatenate([[False], there, [False]]).astype(int)))
    for start, end in bounds.reshape(-1, 2).tolist():
        yield slice(start, end)


# --- bars -------------------------------------------------------------------------------------------------


def joint_bars(title: str, before: Floats, after: Floats, floor: Floats, unit: str) -> Chart:
    """RMS [n] of each joint before and after, and the noise floor, as bars beside each other."""
    groups = [("before", before), ("after", after), ("floor", floor)]
    words = {"before": "before", "after": "after", "floor": "noise floor"}
    heights = np.concatenate([_finite(values) for _, values in groups])
    some = heights[heights > 0]
    is_log = len(some) > 0 and float(some.max()) > _UNLIKE * float(some.min())
    if is_log:
        first, last = math.floor(math.log10(some.min())), math.ceil(math.log10(some.max()))
        first = max(first - (10.0**first == some.min()), last - 6)
        up = [float(k) for k in range(first, max(last, first + 1) + 1)]
    else:
        up = ticks([0.0, float(heights.max(initial=0)) or 1.0])
    width, height = _BAR_WIDTH, 190.0
    pitch = width / len(before)
    thick = min(0.26 * pitch, 26.0)
    marks = []
    for k, (css, values) in enumerate(groups):
        for j, value in enumerate(values.tolist()):
            if not math.isfinite(value) or value <= 0:
                continue
            high = share(math.log10(value) if is_log else value, up)
            tall = height * min(max(high, 0.005), 1.0)
            left = pitch * (j + 0.5) + thick * (k - 1.5)
            path = f"M{_short(left)} {_short(height)}v{_short(-tall)}h{_short(thick - 1)}v{_short(tall)}z"
            marks.append(Mark(f"bar {css}", path, f"joint {j + 1}, {words[css]}: {value:.3g} {unit}"))
    every = -(-len(before) // 24)
    across = tuple(Tick(_short(pitch * (j + 0.5)), str(j + 1)) for j in range(0, len(before), every))
    labels = tuple(
        Tick(_short(height * (1 - share(v, up))), f"{10.0**v:g}" if is_log else f"{v:g}") for v in up
    )
    text = "; ".join(
        f"joint {j + 1}: {b:.3g} before, {a:.3g} after, floor {f:.3g}"
        for j, (b, a, f) in enumerate(zip(before.tolist(), after.tolist(), floor.tolist(), strict=True))
    )
    scale = ", logarithmic" if is_log else ""
    return Chart(title, text, width, height, "joint", f"RMS [{unit}]{scale}", across, labels, tuple(marks))
