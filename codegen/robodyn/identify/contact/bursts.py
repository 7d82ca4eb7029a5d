"""Where in time a residual bursts: what stands out of the level and the spread of the samples around it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats, Mask
from robodyn.identify.contact.limits import (
    BURST_ENERGY,
    BURST_HIGH,
    END_STEP,
    FADED,
    FALLEN,
    LEAST_SPREAD,
    LEVEL_TIME,
    LONGEST,
    LONGEST_RISE,
    MEDIAN_TIME,
    QUIET_ANGLE,
    QUIET_NEAR,
    QUIET_PIECE,
    QUIET_REACH,
    QUIET_SHARE,
    QUIET_WAY,
    RINGING_SHARE,
    RINGING_TIME,
    RISE_SHARE,
    SHORTEST,
    SLOW_SHARE,
    STEP_HIGH,
    STEP_TIME,
    STICTION,
    SUSTAINED,
    SUSTAINED_SHARE,
    WANDER,
)
from robodyn.identify.contact.rough import Rough
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """A residual [N, n] in units of the spread around it, ``z``, and the ``spread`` [N, n]; ``quiet``
    [N]: the arm stands, but for what a hand moves it; ``hot`` [N]: the residual stands out."""

    z: Floats
    spread: Floats
    quiet: Mask
    hot: Mask


def seen(robot: Robot, rough: Rough, left: Floats, sigma: Floats, stiction: Floats) -> Seen:
    """What the residual ``left`` [N, n] shows, with its robust deviations ``sigma`` [n] in motion."""
    quiet = _quiet(robot, rough)
    spread = np.tile(sigma, (len(left), 1))
    rest = left.copy()
    # A joint that nearly stands in motion has any torque within its friction.
    slow = np.abs(rough.qd) < SLOW_SHARE * np.sqrt(np.mean(rough.qd**2, axis=0))
    slow |= rough.resting
    within = np.where(slow, STICTION * stiction, 0.0)
    rest = np.sign(rest) * np.maximum(np.abs(rest) - within, 0.0)
    least = np.maximum(rough.floor, LEAST_SPREAD * rough.size)
    for rows in _runs(quiet, rough.part):
        pieces = max(1, round(len(rows) * rough.step / QUIET_PIECE))
        for piece in np.array_split(rows, pieces):
            for j in range(left.shape[1]):
                x = left[piece, j]
                rest[piece, j] = x - _level(x)
                lowest = max(float(least[j]), WANDER * float(stiction[j]))
                spread[piece, j] = max(_noise(x, rough.step), lowest)
    z = rest / spread
    wide = max(1, round(0.1 / rough.step))
    smooth = np.stack([np.convolve(x, np.ones(wide) / wide, mode="same") for x in (z**2).T], axis=1)
    hot = (smooth.max(axis=1) > BURST_HIGH**2) | (smooth.mean(axis=1) > BURST_ENERGY)
    return Seen(z, spread, quiet, hot)


def _quiet(robot: Robot, rough: Rough) -> Mask:
    """Where [N] the arm stands."""
    from scipy.ndimage import maximum_filter1d, minimum_filter1d

    far = np.array([QUIET_ANGLE if k.joint.kind == "revolute" else QUIET_WAY for k in robot.links])
    wide, narrow = (max(1, round(time / rough.step)) for time in (QUIET_REACH, QUIET_NEAR))
    result = np.zeros(len(rough.t), dtype=bool)
    for k in np.unique(rough.part):
        rows = rough.part == k
        q = rough.q[rows]

        def still(before: int, after: int, share: float, q: Floats = q) -> Mask:
            size, origin = before + after + 1, (before - after) // 2
            top, low = (f(q, size, axis=0, origin=origin) for f in (maximum_filter1d, minimum_filter1d))
            return np.asarray((top - low < share * far).all(axis=1))

        # Beside a motion: near it nothing moves, and on one side not for longer.
        beside = still(narrow, narrow, QUIET_NEAR / QUIET_REACH)
        beside &= still(2 * wide, 0, 1.0) | still(0, 2 * wide, 1.0)
        result[rows] = still(wide, wide, 1.0) | beside
    return result


def _runs(mask: Mask, part: NDArray[np.intp]) -> list[NDArray[np.intp]]:
    """Runs of ``mask`` [N] within a part."""
    rows = np.flatnonzero(mask)
    if not len(rows):
        return []
    cuts = np.flatnonzero((np.diff(rows) > 1) | (np.diff(part[rows]) != 0)) + 1
    return np.split(rows, cuts)


def _level(x: Floats) -> float:
    """Middle of the shortest interval that holds :data:`QUIET_SHARE` of ``x``."""
    ordered = np.sort(x)
    count = min(max(2, int(QUIET_SHARE * len(x))), len(x))  # a stretch at rest may be a single row
    widths = ordered[count - 1 :] - ordered[: len(x) - count + 1]
    k = int(widths.argmin())
    return float(ordered[k : k + count].mean())


def _noise(x: Floats, step: float) -> float:
    """Standard deviation of ``x`` about its running median: neither pushes nor the levels between them are in
    it."""
    from scipy.ndimage import median_filter

    wide = 2 * max(2, round(0.5 * MEDIAN_TIME / step)) + 1
    return 1.4826 * float(np.median(np.abs(x - median_filter(x, min(wide, len(x)), mode="nearest"))))


@dataclass(frozen=True, slots=True, eq=False)
class Burst:
    """A stretch in which the residual stands out: its ``rows``, and in them the residual ``z`` [K, n]
    beside the level before and after it; ``shift`` [n]: by how much that after it is another; ``ended``: it
    falls before its last row."""

    rows: NDArray[np.intp]
    z: Floats
    shift: Floats
    ended: bool = False


def bursts(rough: Rough, s: Seen) -> list[list[Burst]]:
    """Stretches from one sudden step of the residual to another between which it stands out: for each step,
    the largest first, those that begin or end with it.

    After a burst the level may be another one than before: stiction holds what the push has moved.
    """
    edges: list[tuple[float, int]] = []
    for k in np.unique(rough.part):
        inside = np.flatnonzero(rough.part == k)
        steps = _steps(s.z[inside], rough.step)
        size = np.sqrt((steps**2).sum(axis=1))
        own = _peaks(size, max(1, round(STEP_TIME / rough.step)))
        # The filter rings beside a large step.
        far = RINGING_TIME / rough.step
        edges += [
            (float(size[m]), int(inside[m])) for m in own
            if not any(abs(m - o) < far and size[m] < RINGING_SHARE * size[o] for o in own)
        ]  # fmt: skip
    edges = sorted(edges, reverse=True)[:24]  # which bounds the pairs of them
    sizes = {place: size for size, place in edges}
    result = []
    for _, one in edges:
        ends = [(min(one, other), max(one, other)) for _, other in edges if other != one]
        whole = [_burst(rough, s, a, b) for a, b in ends if rough.part[a] == rough.part[b]]
        result.append([replace(burst, ended=_ended(burst, sizes)) for burst in whole if burst is not None])
    return result


def _ended(burst: Burst, sizes: dict[int, float]) -> bool:
    """Whether a ``burst`` ends before its last row: at a step, of those with ``sizes``, by which it falls.
    What lasts longer is what stiction holds after it, or there are two."""
    first, last = int(burst.rows[0]), int(burst.rows[-1])
    inside = sorted(place for place in sizes if first < place < last)
    size = np.sqrt((burst.z**2).sum(axis=1))
    least = END_STEP * min(sizes[first], sizes[last])
    bounds = [first, *inside, last]
    for before, at, after in zip(bounds, bounds[1:], bounds[2:], strict=False):
        high, low = (float(np.median(size[a - first : b - first])) for a, b in ((before, at), (at, after)))
        if sizes[at] > least and low < FALLEN * high:
            return True
    return False


def widened(rough: Rough, s: Seen, burst: Burst) -> Burst:
    """The ``burst`` from where it rises to where it has faded."""
    inside = np.flatnonzero(rough.part == rough.part[burst.rows[0]])
    z = s.z[inside]
    a, b = (int(burst.rows[k]) - int(inside[0]) for k in (0, -1))
    most = max(1, min(round(LONGEST_RISE / rough.step), round(RISE_SHARE * (b - a))))
    low, high = max(a - most, 0), min(b + most, len(z) - 1)
    first, last, slower = a, b, round(STEP_TIME / rough.step)
    rests = bool(s.quiet[burst.rows].all())

    def size(z: Floats) -> Floats:
        return np.asarray(np.sqrt((z**2).sum(axis=1)))

    for _ in range(4):
        levels = _levels(z, a, b, rough.step)
        before, after = size(z[low:a] - levels[0]), size(z[b + 1 : high + 1] - levels[-1])
        least = FADED * float(np.median(size(z[a : b + 1] - levels)))
        start, end = a - _run(before[::-1] > least), b + _run(after > least)
        if rests:  # what friction held of it fades more slowly than a hand lets go
            end = min(end, last + first - start + slower)
        if (start, end) == (a, b):
            break
        a, b = start, end
    levels = _levels(z, a, b, rough.step)
    return Burst(np.arange(a, b + 1) + int(inside[0]), z[a : b + 1] - levels, levels[-1] - levels[0])


def _run(mask: Mask) -> int:
    """How many are true before the first that is not."""
    return int(len(mask) if mask.all() else mask.argmin())


def _burst(rough: Rough, s: Seen, first: int, last: int) -> Burst | None:
    """The residual from ``first`` to ``last``, if it stands out there, and all the while."""
    if not SHORTEST <= (last - first) * rough.step <= LONGEST:
        return None
    inside = np.flatnonzero(rough.part == rough.part[first])
    z = s.z[inside]
    a, b = first - int(inside[0]), last - int(inside[0])
    levels = _levels(z, a, b, rough.step)
    own = z[a : b + 1] - levels
    size = np.sqrt((own**2).sum(axis=1))
    if np.sqrt((own**2).mean(axis=0)).max() < STEP_HIGH:
        return None
    core = size[len(size) // 10 : max(len(size) - len(size) // 10, 1)]
    if (core > SUSTAINED * float(np.quantile(size, 0.75))).mean() < SUSTAINED_SHARE:
        return None
    # What lies between two pushes is none, though it stands out of both.
    whole = float(np.sqrt((z[a : b + 1].mean(axis=0) ** 2).sum()))
    if whole < max(float(np.sqrt((levels[k] ** 2).sum())) for k in (0, -1)):
        return None
    return Burst(np.arange(first, last + 1), own, levels[-1] - levels[0])


def _steps(z: Floats, step: float) -> Floats:
    """At each sample [N, n] the mean over a short time after it less that before it."""
    wide = max(1, round(STEP_TIME / step))
    gap = wide // 3
    total = np.vstack([np.zeros((1, z.shape[1])), np.cumsum(z, axis=0)])
    places = np.arange(len(z))

    def mean(low: NDArray[np.intp], high: NDArray[np.intp]) -> Floats:
        low, high = np.clip(low, 0, len(z)), np.clip(high, 0, len(z))
        return np.asarray((total[high] - total[low]) / np.maximum(high - low, 1)[:, None])

    after = mean(places + gap, places + gap + wide)
    before = mean(places - gap - wide + 1, places - gap + 1)
    # Beyond an end nothing is known: no step.
    whole = (places - gap - wide + 1 >= 0) & (places + gap + wide <= len(z))
    return np.asarray((after - before) * whole[:, None])


def _peaks(size: Floats, apart: int) -> list[int]:
    """Places of steps of a ``size`` [N] that stands out, the largest around."""
    from scipy.signal import find_peaks

    if len(size) < 3:
        return []
    places, _ = find_peaks(np.r_[0.0, size, 0.0], height=STEP_HIGH, distance=apart)
    return [int(x) - 1 for x in places]


def _levels(z: Floats, first: int, last: int, step: float) -> Floats:
    """The level [K, n] of ``z`` [N, n] beside the rows ``first`` to ``last``: between that before and
    after."""
    near, far = max(1, round(0.08 / step)), max(3, round(LEVEL_TIME / step))
    before = z[max(first - far, 0) : max(first - near, 0)]
    after = z[last + near + 1 : last + far + 1]
    ends = [np.median(x, axis=0) if len(x) else None for x in (before, after)]
    low, high = (x if x is not None else np.zeros(z.shape[1]) for x in ends)
    share = np.linspace(0, 1, last - first + 1)[:, None]
    return np.asarray((1 - share) * low + share * high)
