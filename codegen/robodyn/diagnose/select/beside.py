"""Candidates beside what is known already, many at once.

Each is fitted together with all that is known, to all parts of the log but one, and judged on that one. The
known columns are the same for all candidates: they are eliminated once a step (Schur complement of a bordered
Gram matrix), and a candidate costs a few products of small matrices, whatever the length of the log.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.fit import Fit, Problem, counts, excluded, precisions
from robodyn.diagnose.select.library import Candidate, Context, candidates, without_regressor
from robodyn.diagnose.select.library.matched import along, light
from robodyn.diagnose.select.library.prepared import prepared
from robodyn.diagnose.select.limits import BLOCKS, FREE_PRECISION, SPANNED, TRIED_AT_ONCE
from robodyn.diagnose.select.scope import Scope

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Rows = tuple[int, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Library:
    """Candidates [M], without columns of their own, and the columns, filtered and thinned [N, rows, all], of
    those at the same joints; ``places`` [M]: where those of each stand among them. Columns are kept in single
    precision, which halves what takes most of the memory; sums of their products are in double precision."""

    candidates: tuple[Candidate, ...]
    columns: dict[Rows, Singles]
    places: tuple[slice, ...]

    @classmethod
    def of(cls, pairs: Iterable[tuple[Candidate, Singles]]) -> Library:
        """Of candidates with their columns [N, rows, c]."""
        several, places = list[Candidate](), list[slice]()
        parts: dict[Rows, list[Singles]] = {}
        widths: dict[Rows, int] = {}
        for candidate, columns in pairs:
            rows = candidate.rows
            begin = widths.get(rows, 0)
            widths[rows] = begin + columns.shape[2]
            places.append(slice(begin, widths[rows]))
            parts.setdefault(rows, []).append(columns)
            several.append(light(candidate))
        return cls(tuple(several), {rows: _joined(parts.pop(rows)) for rows in widths}, tuple(places))

    @classmethod
    def along(cls, contexts: Sequence[Context], scope: Scope) -> Library:
        """Of all candidates along several logs, one after the other: of the first, and as they are along the
        others. Those that a log lacks are left out."""
        first, *others = contexts
        library = cls.of(prepared(first, candidates(first, scope)))
        without_regressor(first)
        if not others:
            return library
        ends = np.cumsum([len(c.slow.thinned(c.slow.q)) for c in contexts]).tolist()
        columns = {}
        for rows in list(library.columns):  # one after the other, so that little is in memory twice
            part = library.columns.pop(rows)
            columns[rows] = np.zeros((ends[-1], *part.shape[1:]), dtype=np.float32)
            columns[rows][: ends[0]] = part
        lacking = set[int]()
        for c, begin, end in zip(others, ends, ends[1:], strict=False):
            for k, each in enumerate(along(c, library.candidates, scope)):
                if each is None:
                    lacking.add(k)
                else:
                    columns[library.candidates[k].rows][begin:end, :, library.places[k]] = each
            without_regressor(c)
        kept = [k for k in range(len(library)) if k not in lacking]
        return cls(
            tuple(library.candidates[k] for k in kept), columns, tuple(library.places[k] for k in kept)
        )

    def __len__(self) -> int:
        return len(self.candidates)

    def of_candidate(self, k: int) -> Singles:
        """The columns [N, rows, c] of candidate ``k``; a view."""
        return self.columns[self.candidates[k].rows][:, :, self.places[k]]

    def groups(self, which: Sequence[int]) -> list[list[int]]:
        """Of the candidates ``which`` those at the same joints with as many columns, some at a time."""
        groups: dict[tuple[Rows, int, bool], list[int]] = {}
        for k in which:
            one, place = self.candidates[k], self.places[k]
            groups.setdefault((one.rows, place.stop - place.start, one.fixed), []).append(k)
        return [
            group[k : k + TRIED_AT_ONCE]
            for group in groups.values()
            for k in range(0, len(group), TRIED_AT_ONCE)
        ]


def _joined(parts: list[Singles]) -> Singles:
    """Columns [N, rows, c] side by side; the list is used up, so that they are in memory once."""
    joined = np.empty((*parts[0].shape[:2], sum(part.shape[2] for part in parts)), dtype=np.float32)
    end = joined.shape[2]
    while parts:
        part = parts.pop()
        joined[:, :, end - part.shape[2] : end] = part
        end -= part.shape[2]
    return joined


@dataclass(frozen=True, slots=True, eq=False)
class Fits:
    """The fits of candidates ``which`` [M], with ``explained`` [M, rows], the RMS of what each explains in
    units of the noise."""

    which: list[int]
    fits: list[Fit]
    explained: list[Floats]


def fits(p: Problem, current: Fit, library: Library, which: Sequence[int]) -> Fits:
    """The problem with each of the candidates ``which`` of the library, one by one; ``current`` is its fit
    without.

    A column of a candidate that what is known explains already gets no coefficient."""
    outcome = Fits([], [], [])
    for group in library.groups(which):
        rows = library.candidates[group[0]].rows
        places = [np.arange(library.places[k].start, library.places[k].stop) for k in group]
        columns = library.columns[rows][:, :, np.concatenate(places)]
        cross, right = _products(p, rows, columns)
        wide: NDArray[np.intp] = np.arange(columns.shape[2]).reshape(len(group), -1)
        own = _own(p, rows, columns, wide)
        signs = np.array([library.candidates[k].signs for k in group])
        fixed = library.candidates[group[0]].fixed
        scales = [library.candidates[k].scale for k in group]
        prior = np.stack([precisions(wide.shape[1], scale, p.thin) for scale in scales])
        sums = (cross[:, :, wide], right[:, :, wide], own)
        tried = _group(p, current, rows, sums, signs > 0, prior, fixed=fixed)
        outcome.which.extend(group)
        outcome.fits.extend(tried[0])
        outcome.explained.extend(tried[1])
    return outcome


def _products(p: Problem, rows: Rows, columns: Singles) -> tuple[Floats, Floats]:
    """Products of the columns [N, rows, all] with what is known, by part and row: [BLOCKS, rows, all, p], and
    with the rest: [BLOCKS, rows, all]."""
    sums = np.empty((BLOCKS, len(rows), columns.shape[2], p.A.shape[2] + 1))
    for i, j in enumerate(rows):
        with_rest = np.concatenate([p.A[:, j], p.rest[:, j, None]], axis=1) * (
            p.weight[:, j, None] / p.sigma[j]
        )
        for k, part in enumerate(p.parts):
            sums[k, i] = columns[part, i].T @ with_rest[part]
    return sums[..., :-1], sums[..., -1]


def _own(p: Problem, rows: Rows, columns: Singles, wide: NDArray[np.intp]) -> Floats:
    """Products of the columns of each candidate [M, c] with each other, by part and row:
    [BLOCKS, rows, M, c, c]."""
    c = wide.shape[1]
    sums = np.empty((BLOCKS, len(rows), len(wide), c, c))
    for i, j in enumerate(rows):
        squared = p.weight[:, j, None] ** 2
        is_plain = bool(np.all(squared == 1))
        several = [columns[:, i, wide[:, a]].astype(np.float64) for a in range(c)]
        for a in range(c):
            for b in range(a + 1):
                product = several[a] * several[b]
                if not is_plain:
                    product = product * squared
                by_part = np.add.reduceat(product, [part.start for part in p.parts], axis=0)
                sums[:, i, :, a, b] = sums[:, i, :, b, a] = by_part / p.sigma[j] ** 2
    return sums


def _group(
    p: Problem, current: Fit, rows: Rows, products: tuple[Floats, Floats, Floats],
    positive: NDArray[np.bool_], prior: Floats, *, fixed: bool,
) -> tuple[list[Fit], list[Floats]]:  # fmt: skip
    """The fits of candidates [M] at the same joints, of ``prior`` precisions [M, c], and what each
    explains."""
    folds = current.folds
    assert folds is not None
    cross, right, own = products  # [B, rows, M, c, p], [B, rows, M, c], [B, rows, M, c, c]
    M, c = right.shape[2:]
    samples = float(counts(p).sum())
    size = np.sqrt(np.einsum("kimaa->ma", own) / samples / len(rows))
    size = np.where(size > 0, size, 1.0)
    if fixed:
        size = np.ones_like(size)
    cross, right = cross / size[:, :, None], right / size
    own = own / size[:, :, None] / size[:, None, :]
    turned = excluded(cross.sum(axis=1)).reshape(BLOCKS + 1, M * c, -1) @ folds.root
    turned = turned.reshape(BLOCKS + 1, M, c, -1)  # in coordinates of which the system is 1
    goal = (np.swapaxes(folds.root, 1, 2) @ excluded(p.rights)[:, :, None])[:, :, 0]
    if fixed:
        y, spread = np.ones((BLOCKS + 1, M, c)), np.zeros((M, c, c))
    else:
        whole = excluded(own.sum(axis=1)) + (prior / size**2)[:, :, None] * np.eye(c)
        system = whole - turned @ np.swapaxes(turned, 2, 3)
        target = excluded(right.sum(axis=1)) - np.einsum("kmap,kp->kma", turned, goal)
        free = np.full(y_shape := (BLOCKS + 1, M, c), fill_value=True)
        y, inverse = _solved(system, whole, target, free)
        for _ in range(c):
            wrong = np.where(positive & (y < 0), y, 0.0)
            worst = wrong.argmin(axis=2)
            hit = np.take_along_axis(wrong, worst[..., None], axis=2)[..., 0] < 0
            if not hit.any():
                break
            free[(*np.nonzero(hit), worst[hit])] = False
            y[hit] = _solved(system[hit], whole[hit], target[hit], free[hit])[0]
        assert y.shape == y_shape
        spread = p.thin * inverse[-1]
    change = np.einsum("kma,kmap->kmp", y, turned) @ np.swapaxes(folds.root, 1, 2)
    held_out = _held_out(p, current, rows, (cross, right, own), y[:-1], change[:-1]) / counts(p)[:, None]
    known = folds.known[-1] - change[-1]
    nuisance = slice(0, p.nuisance)
    penalty = np.sum(p.prior[nuisance] * known[:, nuisance] ** 2, axis=1) / p.thin / 2
    explained = np.sqrt(np.einsum("ma,kimab,mb->mi", y[-1], own, y[-1]) / samples)
    spread = spread * np.maximum(held_out.mean(axis=(1, 2)), 1e-300)[:, None, None]
    x, spread = y[-1] / size, spread / size[:, :, None] / size[:, None, :]
    done = [Fit(x[m], spread[m], known[m], held_out[m], float(penalty[m])) for m in range(M)]
    return done, list(explained)


def _solved(system: Floats, whole: Floats, target: Floats, free: NDArray[np.bool_]) -> tuple[Floats, Floats]:
    """Coefficients [..., c] of the columns that are ``free``, and the inverses [..., c, c]; ``whole`` is the
    system before anything was eliminated from it."""
    scale = np.sqrt(np.maximum(np.diagonal(whole, axis1=-2, axis2=-1), FREE_PRECISION))
    scaled = system / scale[..., :, None] / scale[..., None, :]
    scaled = np.where(free[..., :, None] & free[..., None, :], scaled, 0.0)
    sizes, directions = np.linalg.eigh(scaled)
    seen = sizes > SPANNED
    weight = np.where(seen, 1 / np.where(seen, sizes, 1.0), 0.0)
    inverse = (directions * weight[..., None, :]) @ np.swapaxes(directions, -1, -2)
    inverse = inverse / scale[..., :, None] / scale[..., None, :]
    return (inverse @ target[..., None])[..., 0], inverse


def _held_out(
    p: Problem, current: Fit, rows: Rows, products: tuple[Floats, Floats, Floats], y: Floats, change: Floats
) -> Floats:
    """Sums of squares [M, BLOCKS, n] in the parts that were held out, with coefficients ``y``
    [BLOCKS, M, c] by which those of what is known ``change`` [BLOCKS, M, p]."""
    folds = current.folds
    assert folds is not None
    cross, right, own = products
    squares = np.empty((y.shape[1], BLOCKS, p.n))
    before = current.held_out * counts(p)[:, None]
    for j in range(p.n):
        through = change @ p.gram[:, j]
        grown = np.sum(change * (through - 2 * folds.slope[:, None, j]), axis=2)
        squares[:, :, j] = (before[:, None, j] + grown).T
    for i, j in enumerate(rows):
        left = right[:, i] - np.einsum("kmap,kp->kma", cross[:, i], folds.known[:-1])
        mixed = np.einsum("kmap,kmp->kma", cross[:, i], change)
        through = np.einsum("kmab,kmb->kma", own[:, i], y)
        squares[:, :, j] += np.sum(y * (through - 2 * left - 2 * mixed), axis=2).T
    return np.maximum(squares, 0.0)
