"""One candidate beside what is known already, and the best of all: which pass, and which are rivals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.beside import Library, fits
from robodyn.diagnose.select.fit import Columns, Fit, Problem
from robodyn.diagnose.select.library import Candidate, Context
from robodyn.diagnose.select.library.prepared import prepared
from robodyn.diagnose.select.limits import (
    BLOCKS,
    BODY_NUMBERS,
    CLOSE,
    LEAST_SHARE,
    LEAST_T,
    MANY_POWER,
    NEARLY,
    OSCILLATOR_DIRECTIONS,
    OSCILLATOR_FARTHEST,
    OSCILLATOR_GAIN,
    OSCILLATOR_STARTS,
    REFINING_ROUNDS,
    RELIEF,
    REPLACING_SHARE,
    REPLACING_T,
    ROUGH,
    ROUGH_SHARE,
    ROUGH_T,
    ROUGH_TIE,
    TIE,
    TIE_LOSS,
)
from robodyn.effects.catalogue import CATALOGUE
from robodyn.gate.limits import ONE_WAY_SHARE

Floats = NDArray[np.float64]

#: What is the same in a joint that moves in one direction only.
_LEVELS = [id for id, known in CATALOGUE.items() if known.traits.one_way == "level"]


@dataclass(frozen=True, slots=True, eq=False)
class Trial:
    """A candidate beside what was chosen before: its columns [N, rows, c], the fit, the ``gain`` in units of
    log-likelihood, its ``t`` over the parts, the RMS that it explains at its best joint, as a share of what
    would matter; ``share``: of the mean square that is left at its best joint, in parts that were not fitted,
    what it takes away; ``beside``: gives the problem in which it was tried, with its fit (they are as large
    as the log, and made again where they are needed); ``replaced``: the places in the list of what was chosen
    before of those that it stands for."""

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
    again: Callable[[], tuple[Problem, Fit]] | None = None,
) -> list[Trial]:
    """Each candidate of the library (or those ``which``) beside what is known in ``now``, with its fit
    ``current``, best first; ``against``: the fit that it is compared with, if that has more in it, which is
    ``replaced``; ``again``: makes ``now`` and ``current`` again, if they are not to be kept."""
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
    # The residual is small either way: the arm's numbers would be wrong.
    relieved = relief > np.maximum(0.5 * gains, RELIEF)
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
                again or (lambda: (now, current)), replaced,
            )
        )  # fmt: skip
    # Those that gain alike stay in the catalogue's order.
    order = np.lexsort((outcome.which, -gains))
    return [tried[m] for m in order]


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


def best_of(
    now: Problem, current: Fit, tried: Sequence[Trial], least: Floats, contexts: Sequence[Context],
    *, rough: bool,
) -> tuple[Trial, tuple[str, ...], float] | None:  # fmt: skip
    """The candidate to take, its rivals, and how sure that is; ``rough``: the log has more in it than the
    library."""

    def passes(one: Trial) -> bool:
        c = one.candidate
        wanted = evidence_threshold(now, numbers_of(one))
        if c.definition.coupler is not None:  # a link moves smoother than its motor and hides encoder noise
            wanted += now.independent / 2 * float(np.sum((now.encoder_noise / now.sigma) ** 2))
        better = int(np.sum(one.per_part > 0))
        steady = one.t >= LEAST_T or (one.t >= LEAST_T / 2 and better >= BLOCKS - 1)
        steady = steady or (one.t >= LEAST_T / 3 and better >= BLOCKS - 2 and one.gain > 10 * wanted)
        if rough and c.definition.kind != "sensor":  # parts differ by what is not in the library
            steady = steady or (one.t >= ROUGH_T and one.gain > 2 * wanted)
        least_share = (ROUGH_SHARE if rough else REPLACING_SHARE) if one.replaced else LEAST_SHARE
        if one.share < least_share and (rough or not c.local):
            return False
        if one.replaced and one.t < REPLACING_T:
            return False
        if c.local:
            steady = one.t >= 1 and one.gain > 3 * wanted
        return bool(
            steady and one.matters >= 1 and one.gain > wanted and np.any(one.fit.x) and c.feasible(one.fit.x)
        )

    one_way = _one_way(contexts)
    good = [one for one in nearest(now, current, tried, least, contexts) if passes(one)]
    # Two levels by direction cannot be identified from one direction.
    good = [
        one
        for one in good
        if not one.candidate.definition.traits.both_ways or not one_way[one.candidate.rows[0]]
    ]
    if not good:
        return None
    # Of each effect at each place the best of its grid, refined.
    best: dict[tuple[str, int | None], Trial] = {}
    for one in good:
        best.setdefault((one.candidate.effect, one.candidate.joint), one)
    top = max(one.gain for one in best.values())
    for key, one in best.items():
        if one.candidate.values and one.gain > 0.5 * top:
            best[key] = _refined(current, one, least, contexts)
    unlikely = [one for one in best.values() if not one.candidate.likely(one.fit.x)]
    best = {key: one for key, one in best.items() if one.candidate.likely(one.fit.x)}
    if not best:
        return None
    most = max(best.values(), key=lambda one: one.gain)
    left = np.median(most.fit.held_out[:, list(most.candidate.rows)], axis=0).max()
    if rough or left > ROUGH:  # nothing explains it all: candidates with many numbers must gain more
        ranked = sorted(best.values(), key=lambda one: -one.gain / numbers_of(one) ** MANY_POWER)
    else:
        ranked = sorted(best.values(), key=lambda one: -one.gain)
    winner = ranked[0]
    loss = ROUGH_TIE if rough else TIE_LOSS
    ties = [one for one in ranked[1:] if _tied(now, winner, one, loss)]
    simplest = min([winner, *ties], key=lambda one: (one.candidate.order, -one.gain))
    hidden = [one for one in unlikely if one.gain >= winner.gain or _tied(now, winner, one, loss)]
    hidden = [one for one in hidden if set(one.candidate.rows) & set(winner.candidate.rows)]
    others = [one for one in [winner, *ties, *hidden] if one is not simplest]
    names = [one.candidate.effect for one in others if not _contains(one.candidate, simplest.candidate)]
    if one_way[simplest.candidate.rows[0]] and simplest.candidate.effect in _LEVELS:
        names += _LEVELS
    rivals = tuple(dict.fromkeys(name for name in names if name != simplest.candidate.effect))
    confidence = 0.95 if not rivals else max(0.5, 0.9 / (1 + 0.3 * len(rivals)))
    return simplest, rivals, confidence


def _one_way(contexts: Sequence[Context]) -> NDArray[np.bool_]:
    """Which joints [n] move in one direction only."""
    forth = sum(np.maximum(c.signals.qd, 0).sum(axis=0) for c in contexts)
    back = sum(np.maximum(-c.signals.qd, 0).sum(axis=0) for c in contexts)
    return np.asarray(np.minimum(forth, back) < ONE_WAY_SHARE * np.maximum(forth, back))


def numbers_of(one: Trial) -> int:
    """Number of free parameters of a candidate that most motions can show."""
    return min(len(one.candidate.signs), BODY_NUMBERS) + len(one.candidate.values)


def evidence_threshold(now: Problem, numbers: int) -> float:
    """The gain [log-likelihood] that a candidate with so many free parameters must reach: as in BIC, with the
    cost of the choice."""
    return float((numbers + 3) * np.log(now.independent) / 2)


def nearest(
    now: Problem, current: Fit, tried: Sequence[Trial], least: Floats, contexts: Sequence[Context]
) -> list[Trial]:
    """The trials, best first, and of oscillators the best of the grid refined: one that is slightly out of
    tune runs in phase for a while and then fits worse than none."""
    kept, count = list(tried), dict[tuple[str, int | None], int]()
    least_gain = max(
        OSCILLATOR_GAIN * max((one.gain for one in tried), default=0.0), evidence_threshold(now, 3)
    )
    for one in tried:
        key = (one.candidate.effect, one.candidate.joint)
        if not one.candidate.reach or one.gain < least_gain:
            continue
        count[key] = count.get(key, 0) + 1
        if count[key] <= OSCILLATOR_STARTS and sum(count.values()) <= 2 * OSCILLATOR_STARTS:
            kept.append(_refined(current, one, least, contexts))
    return sorted(kept, key=lambda one: -one.gain)


def _contains(wide: Candidate, narrow: Candidate) -> bool:
    if wide.joint != narrow.joint:
        return False
    return narrow.effect in (*wide.beside, *wide.definition.traits.contains)


def _tied(now: Problem, winner: Trial, other: Trial, loss: float) -> bool:
    """Whether ``other`` explains what ``winner`` does, as far as the log can tell; ``loss``: the share of the
    gain that does not count."""
    if not set(winner.candidate.rows) & set(other.candidate.rows) or other.gain < 0.5 * winner.gain:
        return False
    if other.gain > (1 - loss) * winner.gain:
        return True
    # Where nearly all is explained, a small share of the gain may be much more than noise, or no more.
    left = np.maximum(winner.fit.held_out.mean(axis=0), 1.0)
    apart = float(((other.fit.held_out - winner.fit.held_out) / left).sum()) * now.independent / BLOCKS / 2
    if apart < CLOSE and other.gain > NEARLY * winner.gain:
        return True
    worse = winner.per_part - other.per_part
    error = float(worse.std(ddof=1)) / np.sqrt(BLOCKS) + 1e-12
    return bool(winner.gain - other.gain < TIE * error * BLOCKS)


def _refined(current: Fit, one: Trial, least: Floats, contexts: Sequence[Context]) -> Trial:
    """The candidate with its nonlinear values improved, one factor at a time; those of an oscillator all at
    once in random directions, for it has many optima."""
    again, beside = one.candidate.again, one.beside
    assert again is not None
    assert beside is not None
    problem, fit = beside()

    def at(settings: Sequence[dict[str, float]]) -> list[Trial]:
        several = [[again(c, values) for values in settings] for c in contexts]
        columns = zip(*(prepared(c, each) for c, each in zip(contexts, several, strict=True)), strict=True)
        pairs = [(parts[0][0], np.concatenate([part for _, part in parts])) for parts in columns]
        return trials(
            problem, fit, Library.of(pairs), least, against=current, replaced=one.replaced, again=beside
        )

    if one.candidate.reach:
        return _wandered(one, at)
    spread, fine = one.candidate.spread
    for _ in range(REFINING_ROUNDS):
        start, settings = dict(one.candidate.values), list[dict[str, float]]()
        for name, value in start.items():
            for factor in (1 / spread, spread):
                other = value * factor
                if name == "efficiency":
                    other = 1 - (1 - value) * factor
                    if not 0.05 < other < 0.995:
                        continue
                settings.append({**start, name: other})
        best = at(settings)[0] if settings else one
        better = best if best.gain > one.gain else one
        if better is one:
            spread = spread**0.5
            if spread < fine:
                break
        one = better
    return one


def _wandered(one: Trial, at: Callable[[Sequence[dict[str, float]]], list[Trial]]) -> Trial:
    """The best of steps in random directions, shorter and shorter."""
    rng, start = np.random.default_rng(0), one.candidate.values
    size = np.array([one.candidate.reach[name] for name in start])
    for _ in range(REFINING_ROUNDS):
        settings = one.candidate.values
        steps = np.exp(size * rng.standard_normal((OSCILLATOR_DIRECTIONS, len(size))))
        wanted = []
        for row in steps:
            values = {name: settings[name] * float(f) for name, f in zip(settings, row, strict=True)}
            if all(
                1 / OSCILLATOR_FARTHEST < x / start[name] < OSCILLATOR_FARTHEST for name, x in values.items()
            ):
                wanted.append(values)
        if not wanted:
            continue
        best = at(wanted)[0]
        size = size * (1.0 if best.gain > one.gain else 0.6)
        one = best if best.gain > one.gain else one
    return one
