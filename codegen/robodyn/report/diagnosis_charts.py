"""Charts of a diagnosis, joint by joint: torques over time; what a model leaves over time, and over what may
cause it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.result import Series, Window
from robodyn.report.chart_frames import Chart, Frame, Mark, Shade, percent, runs, span
from robodyn.report.figures import formatted

Floats = NDArray[np.float64]

#: Dots of a panel, columns of a curve over time, and bins of a mean, at most.
DOTS, COLUMNS, BINS = 150, 320, 20
#: A bin of fewer samples has no mean; so many of a panel's samples are outside its frame at most, in percent.
_FEWEST, _OUTSIDE = 5, 0.5
#: Half of a band that holds 95 of 100 samples of noise, in standard deviations.
WITHIN: Final = 2.0
#: Share of a log at either end that no figure counts.
END: Final = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class Across:
    """What a residual is drawn over: values ``x`` [K], their ``name`` and ``unit``; ``each_way``: forward and
    backward motion apart."""

    name: str
    unit: str
    x: Floats
    each_way: bool = False

    @property
    def label(self) -> str:
        """For the axis."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name


def torques(
    series: Series, j: int, unit: str, windows: Sequence[Window] = (), *, columns: int = COLUMNS
) -> Chart:
    """Torques at joint ``j`` (from 0) over time: as logged, from the lowest to the highest of each column of
    the picture, and the mean of what the model says, before and after."""
    known = np.isfinite(series.times)
    t, logged = series.times[known], series.tau[known, j]
    models = [(css, logged - y[known]) for css, y in _curves(series, j)]
    frame = Frame(*span(t, room=0.0), *span(logged, *(y for _, y in models)))
    outlines = [frame.outline(a, low, high) for a, low, high in _columns(t, logged, columns)]
    marks = [Mark("curve logged", "".join(outlines), "logged")]
    for css, y in models:
        inside = np.isfinite(y)
        lines = _means(t[inside], y[inside], frame, bins=columns, fewest=1)
        marks.append(Mark(f"line {css}", "".join(frame.line(a, mean) for a, mean, _ in lines), css))
    title = f"Torque at joint {j + 1} over time"
    shades = _shades(frame, windows)
    return frame.chart(title, _off(series, j), ("t [s]", f"[{unit}]"), marks, most=(7, 4), shades=shades)


def _off(series: Series, j: int) -> str:
    """How far the model is off at joint ``j`` (from 0), in words."""
    logged = _rms(series, series.tau[:, j])
    shares = [f"{100 * rms / logged:.3g} %" if logged > 0 else "n/a" for _, rms in _sizes(series, j)]
    if len(shares) == 1:
        return f"off by {shares[0]} of the torque, unchanged"
    return f"off by {shares[0]} of the torque before, {shares[1]} after"


def over_time(
    series: Series, j: int, unit: str, floor: float, windows: Sequence[Window] = (), *, columns: int = COLUMNS
) -> Chart:
    """What is left at joint ``j`` (from 0) over time: lowest to highest of each column of the picture."""
    known = np.isfinite(series.times)
    t = series.times[known]
    curves = [(css, y[known]) for css, y in _curves(series, j)]
    noise = _noise(floor)
    frame = Frame(*span(t, room=0.0), *span(*(y for _, y in curves), noise))
    marks = [Mark("noise", frame.level(*noise), "noise")]
    for css, y in curves:
        outlines = [frame.outline(a, low, high) for a, low, high in _columns(t, y, columns)]
        marks.append(Mark(f"curve {css}", "".join(outlines), css))
    shades = _shades(frame, windows)
    caption = f"{range_text(series, j, unit)}{''.join(f'; {s.what} shaded' for s in shades)}"
    title = f"Joint {j + 1} over time"
    return frame.chart(title, caption, ("t [s]", f"[{unit}]"), marks, most=(9, 3), shades=shades)


def _shades(frame: Frame, windows: Sequence[Window]) -> list[Shade]:
    return [
        Shade(percent(start), percent(max(end - start, 0.2)), window.what)
        for window in windows
        for start, end in ([min(max(frame.across(x), 0.0), 100.0) for x in (window.start, window.end)],)
        if end > 0 and start < 100
    ]


def over(
    series: Series, j: int, across: Across, unit: str, floor: float, *, dots: int = DOTS, wide: bool = False
) -> Chart:
    """What is left at joint ``j`` (from 0) over something: dots, and the mean of each bin with twice the
    standard deviation about it; ``wide``: there is room for more ticks."""
    x = across.x
    curves = _curves(series, j)
    shown = [np.percentile(_finite(y), (_OUTSIDE, 100 - _OUTSIDE)) for _, y in curves]
    noise = _noise(floor)
    frame = Frame(*span(x), *span(*shown, noise))
    marks, bands, means = [Mark("noise", frame.level(*noise), "noise")], [], []
    speed = series.qd[:, j]
    ways = (
        (("fore", speed > 0), ("back", speed < 0)) if across.each_way else (("fore", np.full(len(x), True)),)
    )
    for css, y in curves:
        inside = frame.inside(x, y)
        rows = np.flatnonzero(inside)
        places = rows[np.unique(np.linspace(0, len(rows) - 1, min(len(rows), dots)).astype(int))]
        marks.append(Mark(f"dots {css}", frame.dots(x[places], y[places])))
        for way, moving in ways:
            a, b = x[inside & moving], y[inside & moving]
            for centre, mean, spread in _means(a, b, frame):
                low, high = mean - WITHIN * spread, mean + WITHIN * spread
                bands.append(Mark(f"band {css}", frame.outline(centre, low, high)))
                means.append(Mark(f"mean {css} {way}", frame.line(centre, mean), f"mean {css}"))
    title = f"Joint {j + 1} over {across.name}"
    return frame.chart(
        title, range_text(series, j, unit), (across.label, f"[{unit}]"), [*marks, *bands, *means],
        most=(7, 5) if wide else (4, 3),
    )  # fmt: skip


def range_text(series: Series, j: int, unit: str) -> str:
    """The residual of joint ``j`` (from 0) in words."""
    rms = [size for _, size in _sizes(series, j)]
    if len(rms) == 1:
        return f"RMS {formatted(rms[0])} {unit}, unchanged"
    return f"RMS {formatted(rms[0])} {unit} before, {formatted(rms[1])} {unit} after"


def _sizes(series: Series, j: int) -> list[tuple[str, float]]:
    """RMS of the residual of joint ``j`` (from 0) before and after; one where nothing changed."""
    return [(css, _rms(series, y)) for css, y in _curves(series, j)]


def _rms(series: Series, values: Floats) -> float:
    edge = int(END * len(series.times))
    return float(np.sqrt(np.mean(_finite(values[edge : len(series.times) - edge]) ** 2)))


def _curves(series: Series, j: int) -> list[tuple[str, Floats]]:
    """The residual of joint ``j`` (from 0) before and after; one where nothing changed."""
    before, after = series.before[:, j], series.after[:, j]
    if np.array_equal(before, after, equal_nan=True):
        return [("same", before)]
    return [("before", before), ("after", after)]


def _noise(floor: float) -> tuple[float, float]:
    return (-WITHIN * floor, WITHIN * floor) if np.isfinite(floor) and floor > 0 else (np.nan, np.nan)


def _finite(x: Floats) -> Floats:
    kept: Floats = x[np.isfinite(x)]
    return kept if len(kept) else np.zeros(1)


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
    for run in runs(low <= high):
        yield middle[run], low[run], high[run]


def _means(
    x: Floats, y: Floats, frame: Frame, *, bins: int = BINS, fewest: int = _FEWEST
) -> Iterator[tuple[Floats, Floats, Floats]]:
    """Runs of ``bins`` that hold ``fewest`` samples or more: mean place, mean, and standard deviation."""
    place = np.clip((bins * (x - frame.left) / (frame.right - frame.left)).astype(int), 0, bins - 1)
    count = np.bincount(place, minlength=bins)
    some = np.maximum(count, 1)
    centre = np.bincount(place, x, bins) / some
    mean = np.bincount(place, y, bins) / some
    spread = np.sqrt(np.bincount(place, (y - mean[place]) ** 2, bins) / some)
    for run in runs(count >= fewest):
        yield centre[run], mean[run], spread[run]
