"""Whether, when and how a unit has changed: a scan over days and courses, by generalised least squares.

A unit's numbers y at its logs are its own mean and, perhaps, a change of a known course g(t) times amplitudes
in some direction. Mean and amplitudes are profiled out, so that each course and direction has a
log-likelihood ratio. That of the best of many courses is judged by how many independent ones they are worth
(Li and Ji 2005).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from robodyn.draw.scales import DAY
from robodyn.fleet.limits import (
    FINE_RAMPS,
    FINE_STEP,
    HALF,
    LEAST_AFTER,
    LEAST_BEFORE,
    NOT_YET,
    ONSET_STEP,
    OWN_SCATTER,
    RAMPS,
)
from robodyn.fleet.pool.features import solved

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Courses:
    """Courses of a change at the logs of a unit: ``shares`` [M, L] from 0 to 1, of changes that begin at
    ``onsets`` [M] (s since 1970) and take ``lengths`` [M] (s); ``worth``: as many independent ones."""

    shares: Floats
    onsets: Floats
    lengths: Floats

    @property
    def worth(self) -> float:
        """How many tests they are worth."""
        centred = self.shares - self.shares.mean(axis=1, keepdims=True)
        size = np.sqrt((centred**2).sum(axis=1))
        centred = centred[size > 0] / size[size > 0, None]
        if len(centred) < 2:
            return float(max(len(centred), 1))
        values = np.abs(np.linalg.eigvalsh(centred @ centred.T))
        return float(max(1.0, ((values >= 1) + values - np.floor(values)).sum()))


def courses(dates: Floats, *, steps_only: bool = False, fine: bool = False) -> Courses:
    """The courses that logs on ``dates`` [L] (s since 1970) can tell: all that are different, or (``fine``)
    all."""
    step = FINE_STEP if fine else ONSET_STEP
    ramps: tuple[float, ...] = FINE_RAMPS if fine else RAMPS
    ramps = (0.0,) if steps_only else ramps
    span = dates[-1] - dates[0]
    onsets = dates[0] + np.arange(0.0, span, step * DAY)
    shares, begins, lengths = list[Floats](), list[float](), list[float]()
    different = set[bytes]()
    for length in (x * DAY for x in ramps):
        for onset in onsets.tolist():
            rise = np.clip((dates - onset) / length, 0, 1) if length else (dates > onset) * 1.0
            rise = rise / rise[-1] if rise[-1] > 0 else rise  # what it has come to is its amplitude
            if (rise >= HALF).sum() < LEAST_AFTER or (rise <= NOT_YET).sum() < LEAST_BEFORE:
                continue
            key = np.round(rise, 9).tobytes()
            if not fine and key in different:
                continue
            different.add(key)
            shares.append(rise)
            begins.append(onset)
            lengths.append(length)
    return Courses(np.array(shares).reshape(len(shares), len(dates)), np.array(begins), np.array(lengths))


@dataclass(frozen=True, eq=False)
class History:
    """Of the logs of a unit, in order of their ``dates`` [L]: ``information`` [L, s + r, s + r] of numbers y
    of logs, log-to-log scatter included, and of numbers d of the unit, and its products with them
    (``weighted`` [L, s + r]); precision and its product with the mean (``prior``) of the unit's own mean;
    ``size``: s."""

    dates: Floats
    information: Floats
    weighted: Floats
    prior: tuple[Floats, Floats]
    size: int

    @cached_property
    def mean_information(self) -> Floats:
        """Of the unit's means and d [s + r, s + r]."""
        return np.asarray(self.information.sum(axis=0) + self.prior[0])

    @cached_property
    def mean(self) -> Floats:
        """The unit's means and d [s + r], its siblings' taken into account."""
        return solved(self.mean_information, self._right)

    def scores(self, shares: Floats) -> tuple[Floats, Floats]:
        """Of courses [M, L] the information of amplitudes [M, s, s] of the numbers y, means and d being free,
        and its product with them [M, s]."""
        s, count = self.size, len(shares)
        S1 = np.tensordot(shares, self.information[:, :, :s], axes=1)  # [M, s + r, s]
        S2 = np.tensordot(shares**2, self.information[:, :s, :s], axes=1)
        flat = S1.transpose(1, 0, 2).reshape(len(self._right), count * s)
        across = solved(self.mean_information, flat).reshape(len(self._right), count, s)
        A = S2 - np.einsum("mks,kmt->mst", S1, across, optimize=True)
        return A, shares @ self.weighted[:, :s] - np.einsum("mks,k->ms", S1, self.mean)

    @cached_property
    def _right(self) -> Floats:
        return np.asarray(self.weighted.sum(axis=0) + self.prior[1])

    def says(self, direction: Floats) -> Floats:
        """How much each log says [L] of a change in a ``direction`` [s, k]."""
        own = self.information[:, : self.size, : self.size]
        return np.asarray(np.einsum("sk,lst,tk->l", direction, own, direction, optimize=True))

    def excess(self, share: Floats, direction: Floats) -> float:
        """By how much more than logs of the type those of this unit scatter about a change of that course in
        a ``direction`` [s, k] (a variance ratio, at least 1)."""
        along = direction.sum(axis=1)
        weight = self.says(along[:, None])
        score = (self.weighted - self.information @ self.mean)[:, : self.size]
        left = (score @ along) / np.maximum(weight, 1e-300)  # of each log, what it says beyond the mean
        A = np.stack([np.ones_like(share), share]) * np.sqrt(weight)
        b = left * np.sqrt(weight)
        rest = b - A.T @ np.linalg.lstsq(A.T, b, rcond=None)[0]
        freedom = max(len(share) - 2, 0)
        return max(1.0, (OWN_SCATTER + float(rest @ rest)) / (OWN_SCATTER + freedom))

    def without(self, share: Floats, amplitudes: Floats) -> History:
        """The same less a change by ``amplitudes`` [s] of the course ``share`` [L]."""
        removed = share[:, None] * (self.information[:, :, : self.size] @ amplitudes)
        return History(self.dates, self.information, self.weighted - removed, self.prior, self.size)

    def leaving_out(self, log: int) -> History:
        """The same without one of the logs."""
        keep = np.arange(len(self.dates)) != log
        return History(self.dates[keep], self.information[keep], self.weighted[keep], self.prior, self.size)


@dataclass(frozen=True, slots=True, eq=False)
class Change:
    """A change: log-likelihood ratio ``worth``, ``amplitudes`` [k] in its direction with their ``covariance``
    [k, k]."""

    worth: float
    amplitudes: Floats
    covariance: Floats


def changes(A: Floats, b: Floats, direction: Floats) -> tuple[Floats, Floats]:
    """Of courses with information ``A`` [M, s, s] and ``b`` [M, s] the log-likelihood ratios [M] of changes
    in a ``direction`` [s, k], and their amplitudes [M, k]."""
    information = direction.T @ A @ direction
    score = b @ direction
    size = np.sqrt(np.maximum(np.einsum("mkk->mk", information), 1e-300))
    scaled = information / (size[:, :, None] * size[:, None, :]) + 1e-9 * np.eye(direction.shape[1])
    amplitudes = np.linalg.solve(scaled, (score / size)[:, :, None])[:, :, 0] / size
    return np.einsum("mk,mk->m", score, amplitudes) / 2, amplitudes


def change_at(A: Floats, b: Floats, direction: Floats) -> Change:
    """That of one course, of information [s, s] and score [s]."""
    worth, amplitudes = changes(A[None], b[None], direction)
    covariance = np.asarray(np.linalg.pinv(direction.T @ A @ direction, rcond=1e-12), np.float64)
    return Change(float(worth[0]), amplitudes[0], covariance)


@dataclass(frozen=True, slots=True)
class Dated:
    """When a change began (``since`` [s since 1970]), the ``interval`` that holds the day in 95 of 100 cases,
    and when it ended (``until``; at once: the day on which it began)."""

    since: float
    interval: tuple[float, float]
    until: float

    @property
    def is_step(self) -> bool:
        """Whether it came at once."""
        return self.until == self.since


def dated(several: Courses, worth: Floats) -> Dated:
    """The days of a change, of log-likelihoods ``worth`` [M] of fine courses, all lengths of which are as
    likely before."""
    weight: Floats = np.exp(worth - worth.max())
    for length in set(several.lengths.tolist()):  # so are all lengths
        same = several.lengths == length
        weight[same] /= same.sum()
    weight /= weight.sum()
    order = np.argsort(several.onsets, kind="stable")
    days, total = several.onsets[order], np.cumsum(weight[order])
    at = np.minimum(np.searchsorted(total, (0.025, 0.5, 0.975)), len(days) - 1)
    low, middle, high = days[at].tolist()
    half = FINE_STEP * DAY / 2
    since, interval = middle + half, (low, high + 2 * half)
    takes_time = several.lengths > 0
    if weight[takes_time].sum() < HALF:
        return Dated(since, interval, since)
    ends, weight = (several.onsets + several.lengths)[takes_time], weight[takes_time]
    order = np.argsort(ends, kind="stable")
    total = np.cumsum(weight[order])
    end = float(ends[order][np.searchsorted(total, total[-1] / 2)]) + half
    return Dated(since, interval, max(end, interval[1]))


def directions_of(places: Sequence[int], size: int, values: Floats | None = None) -> Floats:
    """The direction [s, k] of numbers at ``places``: each on its own, or all in the proportion of
    ``values``."""
    if values is None:
        direction = np.zeros((size, len(places)))
        direction[list(places), np.arange(len(places))] = 1.0
        return direction
    direction = np.zeros((size, 1))
    direction[list(places), 0] = values
    return direction
