"""One candidate beside what is known already: its fit, and what it explains more, by parts of the log."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.beside import Library, fits
from robodyn.diagnose.select.fit import Columns, Fit, Problem
from robodyn.diagnose.select.library import Candidate
from robodyn.diagnose.select.limits import BLOCKS, BODY_NUMBERS, LEAST_T, RELIEF

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Trial:
    """A candidate beside what was chosen before: its columns [N, rows, c], the fit, the ``gain`` in units of
    log-likelihood, its ``t`` over the parts, the RMS that it explains at its best joint, as a share of what
    would matter; ``share``: of the mean square that is left at its best joint, in parts that were not fitted,
    what it takes away; ``beside``: gives the problem in which it was tried, with its fit (they are as large
    as the log, and made again where they are needed); ``replaced``: the places in the list of what was chosen
    before of those that it stands for, which have so many free parameters, ``numbers_replaced``."""

    candidate: Candidate
    columns: Columns
    fit: Fit
    gain: float
    t: float
    matters: float
    per_part: Floats
    share: float = 1.0
    beside: Callable[[], tuple[Problem, Fit]] | None = None
    replaced: tuple[int, ...] = ()
    numbers_replaced: int = 0

    @property
    def is_as_simple(self) -> bool:
        """Whether it has no more free parameters than what it stands for."""
        return self.candidate.in_place and numbers_of(self) <= self.numbers_replaced


def without_columns(one: Trial) -> Trial:
    """The trial without its columns [0, rows, c] and the problem it was tried in, which take memory."""
    return replace(one, columns=one.columns[:0].copy(), beside=None)


def trials(
    now: Problem,
    current: Fit,
    library: Library,
    least: Floats,
    which: Sequence[int] | None = None,
    *,
    against: Fit | None = None,
    replaced: tuple[int, ...] = (),
    numbers_replaced: int = 0,
    again: Callable[[], tuple[Problem, Fit]] | None = None,
) -> list[Trial]:
    """Each candidate of the library (or those ``which``) beside what is known in ``now``, with its fit
    ``current``, best first; ``against``: the fit that it is compared with, if that has more in it, which is
    ``replaced`` and has ``numbers_replaced``; ``again``: makes ``now`` and ``current`` again, if they are not
    to be kept."""
    outcome = fits(now, current, library, range(len(library)) if which is None else which)
    if not outcome.which:
        return []
    base = against or current
    held_out = np.array([fit.held_out for fit in outcome.fits])
    per_part = _per_part(now, base, held_out)
    relief = base.prior_penalty - np.array([fit.prior_penalty for fit in outcome.fits])
    relief -= [
        _own_penalty(library.candidates[k], f) for k, f in zip(outcome.which, outcome.fits, strict=True)
    ]
    gains = per_part.sum(axis=1) + relief
    errors = per_part.std(axis=1, ddof=1) / np.sqrt(BLOCKS) + 1e-12
    ts = per_part.mean(axis=1) / errors
    shares = 1 - held_out.mean(axis=1) / np.maximum(base.held_out.mean(axis=0), 1e-300)
    relieved = _relieved(gains, relief)
    ts = np.where(relieved, np.maximum(ts, LEAST_T), ts)
    tried = []
    for m, (k, fit, explained) in enumerate(zip(outcome.which, outcome.fits, outcome.explained, strict=True)):
        candidate = library.candidates[k]
        rows = list(candidate.rows)
        matters = float(np.max(explained / least[rows]))
        share = 1.0 if relieved[m] else float(shares[m, rows].max())
        columns = library.of_candidate(k)
        tried.append(
            Trial(
                candidate, columns, fit, float(gains[m]), float(ts[m]), matters, per_part[m], share,
                again or (lambda: (now, current)), replaced, numbers_replaced,
            )
        )  # fmt: skip
    # Those that gain alike stay in the catalogue's order.
    order = np.lexsort((outcome.which, -gains))
    return [tried[m] for m in order]


def _relieved(gains: Floats, relief: Floats) -> NDArray[np.bool_]:
    """Of which trials [M] the ``relief`` of the arm's numbers is most of the ``gains``: the residual is small
    either way, but these would be wrong. What gains more than such a one is judged no more strictly."""
    mostly = relief > np.maximum(0.5 * gains, RELIEF)
    if not mostly.any():
        return np.asarray(mostly)
    return np.asarray(relief > np.maximum(0.5 * np.minimum(gains, gains[mostly].max()), RELIEF))


def _own_penalty(candidate: Candidate, fit: Fit) -> float:
    """How far the coefficients are from their own prior, in units of log-likelihood."""
    return 0.0 if candidate.scale is None else float(np.sum((fit.x / candidate.scale) ** 2)) / 2


def _per_part(now: Problem, base: Fit, held_out: Floats) -> Floats:
    """What fits with errors ``held_out`` [..., BLOCKS, n] explain more than ``base`` of each part
    [..., BLOCKS], in units of log-likelihood."""
    floor = np.maximum(held_out.mean(axis=-2, keepdims=True), 1.0)
    change = (base.held_out - held_out) / floor
    return np.asarray(now.independent / BLOCKS / 2 * change.sum(axis=-1))


def gain_of(now: Problem, base: Fit, fit: Fit) -> float:
    """What ``fit`` explains more than ``base`` of all parts, in units of log-likelihood."""
    return float(_per_part(now, base, fit.held_out).sum()) + base.prior_penalty - fit.prior_penalty


def numbers_of(one: Trial) -> int:
    """Number of free parameters of a candidate that most motions can show."""
    return min(len(one.candidate.signs), BODY_NUMBERS) + len(one.candidate.values)


def evidence_threshold(now: Problem, numbers: int) -> float:
    """The gain [log-likelihood] that a candidate with so many free parameters must reach: as in BIC, with the
    cost of the choice."""
    return float((numbers + 3) * np.log(now.independent) / 2)
