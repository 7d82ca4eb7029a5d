"""The residual of a diagnosis: where it is (at which joint, over which quantity), what motion a log went
through, and charts: torques over time; what a model leaves over time, and over what may cause it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.diagnose.limits import ABOVE_NOISE
from robodyn.diagnose.result import Diagnosis, Series, Window
from robodyn.report.chart_frames import Chart, Frame, Mark, Shade, percent, runs, span
from robodyn.report.figures import formatted
from robodyn.robot.model import Robot

#: What a residual may follow, the simplest first.
QUANTITIES: Final = (
    "constant", "direction", "velocity", "position", "acceleration", "load", "load, each way", "a short time",
)  # fmt: skip
#: A quantity that is not as simple must show so much more; below the last figure none shows it.
_MORE, _SHOWS = 0.04, 0.3
#: Bins of a curve.
_BINS: Final = 16
#: Of the fastest motion: below it a joint counts as standing; it turns where it passes it both ways.
_STILL: Final = 0.02
#: A short time, as a share of the log.
_MOMENT: Final = 1 / 8


@dataclass(frozen=True, slots=True, eq=False)
class Localised:
    """A joint (from 1): its ``share`` of what exceeds the noise, over all joints; ``shown``: how much of its
    own excess a curve over each quantity explains, empty where there is no excess; ``best``: the quantity
    that shows it best, None where none does; ``left``: what is left beside what would matter."""

    joint: int
    share: float
    shown: tuple[float, ...]
    best: str | None
    left: float


def localised(diagnosis: Diagnosis) -> list[Localised]:
    """Every joint, from the first log that was fitted."""
    before, floor = diagnosis.gap.train_before, diagnosis.gap.noise_floor
    with np.errstate(all="ignore"):
        excess = np.nan_to_num(np.maximum((before / floor) ** 2 - 1, 0.0), nan=0.0, posinf=0.0)
    total = float(excess.sum()) or 1.0
    is_long = bool(diagnosis.series) and len(diagnosis.series[0].times) > 4 * _BINS
    rows = []
    for j in range(diagnosis.robot.n):
        shown: tuple[float, ...] = ()
        if is_long and excess[j] > ABOVE_NOISE**2 - 1:
            most = float(excess[j] / (excess[j] + 1))
            shown = tuple(min(x / most, 1.0) for x in shown_over(diagnosis.series[0], j))
        left = float(diagnosis.left[j]) if j < len(diagnosis.left) else np.nan
        rows.append(Localised(j + 1, float(excess[j]) / total, shown, best_of(shown), left))
    return rows


def shown_over(series: Series, j: int) -> tuple[float, ...]:
    """Share of the mean square at joint ``j`` (from 0) that a curve over each quantity explains, what is
    constant apart; and that is of a short time."""
    parts = (series.before, series.qd, series.q, series.qdd, series.load)
    columns = np.array([series.times, *(part[:, j] for part in parts)])
    y, qd, q, qdd, load = columns[1:, np.isfinite(columns).all(axis=0)]
    energy = float(np.mean(y**2)) if len(y) > 4 * _BINS else 0.0
    if not energy > 0:
        return (0.0,) * len(QUANTITIES)
    way = (qd > 0).astype(np.intp)
    places = [way, *map(_place, (qd, q, qdd, load)), 2 * _place(load) + way]
    steady = float(np.mean(y)) ** 2 / energy
    # The share of the loudest short time, beyond what any has.
    total, wide = np.concatenate([[0.0], np.cumsum(y**2)]), max(1, round(_MOMENT * len(y)))
    loudest = float((total[wide:] - total[:-wide]).max() / total[-1])
    burst = max(0.0, (loudest - _MOMENT) / (1 - _MOMENT))
    return (steady, *(_explained(place, y) / energy for place in places), burst)


def _place(x: Floats) -> NDArray[np.intp]:
    """Bins of about as many samples each."""
    edges = np.unique(np.quantile(x, np.linspace(0, 1, _BINS + 1)[1:-1]))
    return np.asarray(np.searchsorted(edges, x, "right"), dtype=np.intp)


def _explained(place: NDArray[np.intp], y: Floats) -> float:
    """Variance of ``y`` that the means of bins explain, less what chance would."""
    count = np.bincount(place)
    mean = np.bincount(place, y) / np.maximum(count, 1)
    used, total = int((count > 0).sum()), float(np.var(y))
    within = float(np.mean((y - mean[place]) ** 2)) * (len(y) - 1) / max(len(y) - used, 1)
    return max(total - within, 0.0)


def best_of(shown: Sequence[float]) -> str | None:
    """The simplest quantity that shows a residual about as well as any."""
    if not shown or max(shown) < _SHOWS:
        return None
    limit = max(shown) - _MORE
    return next(name for name, value in zip(QUANTITIES, shown, strict=True) if value >= limit)


@dataclass(frozen=True, slots=True)
class Travel:
    """What a joint (from 1) went through in a log: lowest and highest position, its ``limits`` if they are
    known, highest speed, reversals, lowest and highest load; ``wants``: what the log lacks at this joint, in
    words, empty where it lacks nothing."""

    joint: int
    low: float
    high: float
    limits: tuple[float, float] | None
    speed: float
    top: float | None
    reversals: int
    load: tuple[float, float]
    wants: str


def travelled(robot: Robot, series: Series) -> list[Travel]:
    """Every joint's travel."""
    rows = []
    for j, link in enumerate(robot.links):
        q, qd, load = (x[:, j][np.isfinite(x[:, j])] for x in (series.q, series.qd, series.load))
        if not (len(q) and len(qd) and len(load)):
            continue
        limits, speed = link.joint.limits, float(np.abs(qd).max())
        reversals = int(np.count_nonzero(np.diff(np.sign(qd[np.abs(qd) > _STILL * speed]))))
        low, high = float(load.min()), float(load.max())
        wants = "the load keeps its sign" if low * high > 0 else ""
        wants = "does not move" if not speed > 0 else "hardly reverses" if reversals < 4 else wants
        position = None if limits.position is None else (float(limits.position[0]), float(limits.position[1]))
        top = None if limits.velocity is None else float(limits.velocity)
        extent = float(q.min()), float(q.max())
        rows.append(Travel(j + 1, *extent, position, speed, top, reversals, (low, high), wants))
    return rows


# --- charts ----------------------------------------------------------------------------------------------

#: Dots of a panel and of a wide one, columns of a curve over time, and bins of a mean, at most.
DOTS, WIDE_DOTS, COLUMNS, BINS = 150, 260, 320, 20
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


def torques(
    series: Series, j: int, unit: str, windows: Sequence[Window] = (), *, columns: int = COLUMNS
) -> Chart:
    """Torques at joint ``j`` (from 0) over time: as logged, from the lowest to the highest of each column of
    the picture, and the mean of what the model says, before and after."""
    finite = np.isfinite(series.times)
    t, logged = series.times[finite], series.tau[finite, j]
    models = {css: logged - y[finite] for css, y in _curves(series, j).items()}
    frame = Frame(*span(t, room=0.0), *span(logged, *models.values()))
    marks = [Mark("curve logged", _envelope(frame, t, logged, columns), "logged")]
    for css, y in models.items():
        inside = np.isfinite(y)
        lines = _means(t[inside], y[inside], frame, bins=columns, fewest=1)
        marks.append(Mark(f"line {css}", "".join(frame.line(a, mean) for a, mean, _ in lines), css))
    rms = _rms(series, series.tau[:, j])
    shares = [f"{100 * size / rms:.3g} %" if rms > 0 else "n/a" for size in _sizes(series, j)]
    text = f"off by {shares[0]} of the torque"
    text += f" before, {shares[1]} after" if len(shares) > 1 else ", unchanged"
    return _chart_over_time(frame, f"Torque at joint {j + 1}", text, unit, marks, windows, (7, 4))


def over_time(
    series: Series, j: int, unit: str, floor: float, windows: Sequence[Window] = (), *, columns: int = COLUMNS
) -> Chart:
    """What is left at joint ``j`` (from 0) over time: lowest to highest of each column of the picture."""
    finite = np.isfinite(series.times)
    t = series.times[finite]
    curves = {css: y[finite] for css, y in _curves(series, j).items()}
    noise = _noise(floor)
    frame = Frame(*span(t, room=0.0), *span(*curves.values(), noise))
    marks = [Mark("noise", frame.level(*noise), "noise")]
    marks += [Mark(f"curve {css}", _envelope(frame, t, y, columns), css) for css, y in curves.items()]
    shades = "".join(f"; {shade.what} shaded" for shade in _shades(frame, windows))
    caption = range_text(series, j, unit) + shades
    return _chart_over_time(frame, f"Joint {j + 1}", caption, unit, marks, windows, (9, 3))


def _chart_over_time(
    frame: Frame, title: str, text: str, unit: str, marks: Sequence[Mark], windows: Sequence[Window],
    most: tuple[int, int],
) -> Chart:  # fmt: skip
    labels, shades = ("t [s]", f"[{unit}]"), _shades(frame, windows)
    return frame.chart(f"{title} over time", text, labels, marks, most=most, shades=shades)


def _envelope(frame: Frame, t: Floats, y: Floats, columns: int) -> str:
    """The path about the lowest and highest values of each of ``columns`` that hold samples."""
    finite = np.isfinite(y)
    t, y = t[finite], y[finite]
    if not len(t):
        return ""
    count = max(1, min(columns, len(t) // 4))
    edges = np.linspace(t.min(), t.max(), count + 1)
    place = np.clip(np.searchsorted(edges, t, "right") - 1, 0, count - 1)
    low, high = np.full(count, np.inf), np.full(count, -np.inf)
    np.minimum.at(low, place, y)
    np.maximum.at(high, place, y)
    middle = (edges[1:] + edges[:-1]) / 2
    return "".join(frame.outline(middle[run], low[run], high[run]) for run in runs(low <= high))


def _shades(frame: Frame, windows: Sequence[Window]) -> list[Shade]:
    shades = []
    for window in windows:
        start, end = (min(max(frame.across(x), 0.0), 100.0) for x in (window.start, window.end))
        if end > 0 and start < 100:
            shades.append(Shade(percent(start), percent(max(end - start, 0.2)), window.what))
    return shades


def over(series: Series, j: int, across: Across, unit: str, floor: float, *, dots: int = WIDE_DOTS) -> Chart:
    """What is left at joint ``j`` (from 0) over something: dots, and the mean of each bin with twice the
    standard deviation about it; more ticks where there is room for :data:`WIDE_DOTS`."""
    x, speed, curves, noise = across.x, series.qd[:, j], _curves(series, j), _noise(floor)
    shown = [np.percentile(_finite(y), (_OUTSIDE, 100 - _OUTSIDE)) for y in curves.values()]
    frame = Frame(*span(x), *span(*shown, noise))
    marks, bands, means = [Mark("noise", frame.level(*noise), "noise")], [], []
    ways = {"fore": speed > 0, "back": speed < 0} if across.each_way else {"fore": np.full(len(x), True)}
    for css, y in curves.items():
        inside = frame.inside(x, y)
        rows = np.flatnonzero(inside)
        places = rows[np.unique(np.linspace(0, len(rows) - 1, min(len(rows), dots)).astype(int))]
        marks.append(Mark(f"dots {css}", frame.dots(x[places], y[places])))
        for way, moving in ways.items():
            for centre, mean, spread in _means(x[inside & moving], y[inside & moving], frame):
                low, high = mean - WITHIN * spread, mean + WITHIN * spread
                bands.append(Mark(f"band {css}", frame.outline(centre, low, high)))
                means.append(Mark(f"mean {css} {way}", frame.line(centre, mean), f"mean {css}"))
    labels = (f"{across.name} [{across.unit}]" if across.unit else across.name, f"[{unit}]")
    title, most = f"Joint {j + 1} over {across.name}", (7, 5) if dots == WIDE_DOTS else (4, 3)
    return frame.chart(title, range_text(series, j, unit), labels, [*marks, *bands, *means], most=most)


def range_text(series: Series, j: int, unit: str) -> str:
    """The residual of joint ``j`` (from 0) in words."""
    before, *after = (f"{formatted(size)} {unit}" for size in _sizes(series, j))
    return f"RMS {before} before, {after[0]} after" if after else f"RMS {before}, unchanged"


def _sizes(series: Series, j: int) -> list[float]:
    """RMS of the residual of joint ``j`` (from 0) before and after; one where nothing changed."""
    return [_rms(series, y) for y in _curves(series, j).values()]


def _rms(series: Series, values: Floats) -> float:
    edge = int(END * len(series.times))
    return float(np.sqrt(np.mean(_finite(values[edge : len(series.times) - edge]) ** 2)))


def _curves(series: Series, j: int) -> dict[str, Floats]:
    """The residual of joint ``j`` (from 0) before and after; one where nothing changed."""
    before, after = series.before[:, j], series.after[:, j]
    if np.array_equal(before, after, equal_nan=True):
        return {"same": before}
    return {"before": before, "after": after}


def _noise(floor: float) -> tuple[float, float]:
    return (-WITHIN * floor, WITHIN * floor) if np.isfinite(floor) and floor > 0 else (np.nan, np.nan)


def _finite(x: Floats) -> Floats:
    finite: Floats = x[np.isfinite(x)]
    return finite if len(finite) else np.zeros(1)


def _means(
    x: Floats, y: Floats, frame: Frame, *, bins: int = BINS, fewest: int = _FEWEST
) -> Iterator[tuple[Floats, Floats, Floats]]:
    """Runs of ``bins`` that hold ``fewest`` samples or more: mean place, mean, and standard deviation."""
    place = np.clip((bins * (x - frame.left) / (frame.right - frame.left)).astype(int), 0, bins - 1)
    count = np.bincount(place, minlength=bins)
    some = np.maximum(count, 1)
    centre, mean = (np.bincount(place, values, bins) / some for values in (x, y))
    spread = np.sqrt(np.bincount(place, (y - mean[place]) ** 2, bins) / some)
    for run in runs(count >= fewest):
        yield centre[run], mean[run], spread[run]
