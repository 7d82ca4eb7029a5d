"""Where in time what is left of a log stands out of what is left before and after it.

A scan by likelihood ratios (Willsky and Jones 1976). A window's contrast is its mean less the level beside
it; its noise is that of the contrasts of all other windows as long, so that noise may be correlated as it
likes. At rest stiction holds a constant torque: there, too, the change at both ends is what tells.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from robodyn.identify.contact.limits import LENGTHS, LEVEL_TIME, PRACTICAL, QUIET_WAY
from robodyn.identify.contact.loose import Loose
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
Rows = NDArray[np.intp]


@dataclass(frozen=True, slots=True, eq=False)
class Window:
    """A stretch of ``rows`` that stands out by ``nats``: its residual ``torque`` [K, n] beside the level
    before and after it, between which that moves by ``shift`` [n]; ``spread`` [n]: standard deviation of the
    mean."""

    rows: Rows
    nats: float
    torque: Floats
    shift: Floats
    spread: Floats


def quiet(robot: Robot, one: Loose) -> Mask:
    """Where [N] the arm stands, whatever hands move it by."""
    from scipy.ndimage import maximum_filter1d, minimum_filter1d

    far = np.array([QUIET_WAY if k.joint.kind == "revolute" else QUIET_WAY / 3 for k in robot.links])
    wide = max(1, round(2 * LEVEL_TIME / one.step))
    result = np.zeros(len(one.t), dtype=bool)
    for k in np.unique(one.part):
        q = one.q[one.part == k]
        for origin in (-wide, 0, wide - 1):  # after, about, before
            top, low = (f(q, 2 * wide, axis=0, origin=origin) for f in (maximum_filter1d, minimum_filter1d))
            result[one.part == k] |= (top - low < far).all(axis=1)
    return result


class Scan:
    """The windows of ``left`` [N, n], each in one stretch in which the arm stands (``rests`` [N]) or moves.
    Rows of ``out`` [N] say nothing of noise; ``friction`` [n]: the level within which stiction wanders."""

    def __init__(self, one: Loose, left: Floats, rests: Mask, friction: Floats, out: Mask) -> None:
        self.one, self.rests = one, rests
        change = np.flatnonzero((np.diff(rests) != 0) | (np.diff(one.part) != 0)) + 1
        bounds = np.r_[0, change, len(left)]
        self._low, self._high = (np.repeat(x, np.diff(bounds)) for x in (bounds[:-1], bounds[1:]))
        self._x = left.copy()
        for a, b in pairwise(bounds):
            if rests[a]:
                own = left[a:b][~out[a:b]]
                self._x[a:b] -= _mode(own if len(own) > 4 else left[a:b])
        count = round(np.log(LENGTHS[1] / LENGTHS[0]) / np.log(1.4))
        lengths = np.unique(np.round(np.geomspace(*LENGTHS, count) / one.step).astype(int))
        self.lengths: Rows = lengths[lengths >= 2]
        begin, k, *means = self._windows(out)
        size = np.abs(_contrast(*means))
        self._spread = np.empty((2, len(self.lengths), left.shape[1]))
        for kind in (0, 1):
            least = np.maximum(np.maximum(one.floor, 1e-3 * one.size), kind * PRACTICAL * friction)
            last = 3 * least
            for i in range(len(self.lengths)):
                own = size[(k == i) & (rests[begin] == kind)]
                if len(own) > 9:  # a quartile: contacts may be half of the log
                    now = np.maximum(np.quantile(own, 0.25, axis=0) / 0.3186, least)
                    last = np.minimum(now, last) if kind and i else now
                self._spread[kind, i] = last

    def best(self, taken: Mask) -> Window | None:
        """The window that stands out most, of those without rows ``taken`` [N]."""
        begin, k, inside, before, after = self._windows(taken)
        if not len(begin):
            return None
        m, spread = self.lengths[k], self._spread[self.rests[begin].astype(int), k]
        size, level = _contrast(inside, before, after), 0.5 * (before + after)
        # No more than at either end alone, for a load that stays, and than it is farther from rest than what
        # is beside it, for what lies between two contacts.
        within, *beside = (_squares(x / spread) for x in (inside, before, after))
        ends = [_squares(x / spread) for x in (size, inside - before, inside - after)]
        nats = 0.5 * np.minimum.reduce([*ends, *(within - x for x in beside)])
        at = int(nats.argmax())
        if nats[at] <= 0:
            return None
        # Of those that overlap it, the one that explains most, and nearly all of its own.
        own = spread[at]
        both = np.minimum(begin + m, begin[at] + m[at]) - np.maximum(begin, begin[at])
        near = np.flatnonzero((both > 0.5 * np.minimum(m, m[at])) & (nats > 0.1 * nats[at]))
        squares = np.r_[0.0, np.cumsum(_squares(self._x / own))]
        whole = squares[(begin + m)[near]] - squares[begin[near]]
        whole += m[near] * _squares(level[near] / own) - 2 * m[near] * (inside * level / own**2)[near].sum(
            axis=1
        )
        power = m[near] * _squares(size[near] / own)
        i = int(near[(power * (power / np.maximum(whole, 1e-300)) ** 2).argmax()])
        first, last = self._widened(int(begin[i]), int(begin[i] + m[i]), before[i], after[i], own, taken)
        rows, share = np.arange(first, last), np.linspace(0, 1, last - first)[:, None]
        torque = self._x[rows] - (1 - share) * before[i] - share * after[i]
        return Window(rows, float(nats[at]), torque, after[i] - before[i], own)

    def _widened(
        self, first: int, last: int, before: Floats, after: Floats, spread: Floats, taken: Mask
    ) -> tuple[int, int]:
        """The rows from where a window rises to where it has faded to a fifth."""
        inside = _squares((self._x[first:last] - 0.5 * (before + after)) / spread)
        m, least = last - first, 0.04 * float(np.median(inside))
        most = m // 2 if self.rests[first] else m  # at rest friction lets go more slowly than a hand
        low, high = max(self._low[first], first - most), min(self._high[first], last + most)
        rises = (_squares((self._x[low:first] - before) / spread) > least) & ~taken[low:first]
        fades = (_squares((self._x[last:high] - after) / spread) > least) & ~taken[last:high]
        return first - int(np.cumprod(rises[::-1]).sum()), last + int(np.cumprod(fades).sum())

    def _windows(self, taken: Mask) -> tuple[Rows, Rows, Floats, Floats, Floats]:
        """Of all W windows the first row, which of the lengths it has, and the means [W, n] inside, before,
        and after."""
        gap, wide = (max(1, round(time / self.one.step)) for time in (0.2 * LEVEL_TIME, LEVEL_TIME))
        total = np.vstack([0 * self._x[:1], np.cumsum(self._x * ~taken[:, None], axis=0)])
        count = np.r_[0, np.cumsum(~taken)]

        def mean(a: Rows, b: Rows) -> tuple[Floats, Mask]:
            size = count[b] - count[a]
            return (total[b] - total[a]) / np.maximum(size, 1)[:, None], size >= max(2, wide // 3)

        result = []
        for k, m in enumerate(self.lengths):
            a = np.arange(0, max(len(self._x) - m + 1, 0))
            a = a[(count[a + m] - count[a] == m) & (self._high[a] >= a + m)]
            b, low, high = a + m, self._low[a], self._high[a]
            before, some = mean(np.maximum(a - gap - wide, low), np.maximum(a - gap, low))
            after, more = mean(np.minimum(b + gap, high), np.minimum(b + gap + wide, high))
            each = a, np.full(len(a), k), (total[b] - total[a]) / m, before, after
            result.append([x[some & more] for x in each])
        begin, which, inside, before, after = (np.concatenate(x) for x in zip(*result, strict=True))
        return begin, which, inside, before, after


def _contrast(inside: Floats, before: Floats, after: Floats) -> Floats:
    return inside - 0.5 * (before + after)


def _squares(x: Floats) -> Floats:
    return np.asarray((x**2).sum(axis=1))


def _mode(x: Floats) -> Floats:
    """The level [n] of ``x`` [K, n] without contacts: the middle of the shortest interval that holds two
    fifths of its samples."""
    ordered = np.sort(x, axis=0)
    count = max(1, int(0.4 * len(x)))
    widths = ordered[count - 1 :] - ordered[: len(x) - count + 1]
    return np.array([ordered[a : a + count, j].mean() for j, a in enumerate(widths.argmin(axis=0))])
