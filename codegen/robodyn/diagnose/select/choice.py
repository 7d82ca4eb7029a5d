"""The best of all candidates: which pass, and which are rivals."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.beside import Library
from robodyn.diagnose.select.fit import Fit, Problem
from robodyn.diagnose.select.library import Candidate, Context
from robodyn.diagnose.select.library.prepared import prepared
from robodyn.diagnose.select.limits import (
    ALONE,
    BLOCKS,
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
    REPLACING_SHARE,
    REPLACING_T,
    ROUGH,
    ROUGH_SHARE,
    ROUGH_T,
    ROUGH_TIE,
    SURE,
    TIE,
    TIE_LOSS,
)
from robodyn.diagnose.select.trial import Trial, evidence_threshold, numbers_of, trials
from robodyn.effects.catalogue import CATALOGUE
from robodyn.gate.limits import ONE_WAY_SHARE

Floats = NDArray[np.float64]

#: Effects that are a constant torque, and so indistinguishable, in a joint that moves in one direction only.
_CONSTANT_IN_ONE_DIRECTION = [id for id, known in CATALOGUE.items() if known.traits.one_way == "level"]


def best_of(
    now: Problem, current: Fit, tried: Sequence[Trial], least: Floats, contexts: Sequence[Context],
    *, rough: bool,
) -> tuple[Trial, tuple[str, ...], float] | None:  # fmt: skip
    """The candidate to add to the model, its rivals and the confidence in it; None if no candidate passes.
    ``rough``: the log shows effects that the library does not have."""

    def passes(one: Trial) -> bool:
        c = one.candidate
        if one.is_as_simple:  # no more parameters than what it replaces: the evidence decides
            is_better = one.gain > CLOSE and one.t >= REPLACING_T
            return bool(is_better and one.matters >= 1 and c.feasible(one.fit.x))
        least_gain = evidence_threshold(now, numbers_of(one))
        if c.definition.coupler is not None:  # an elastic joint smooths encoder noise: ask for more evidence
            least_gain += now.independent / 2 * float(np.sum((now.encoder_noise / now.sigma) ** 2))
        better = int(np.sum(one.per_part > 0))
        steady = one.t >= LEAST_T or (one.t >= LEAST_T / 2 and better >= BLOCKS - 1)
        steady = steady or (one.t >= LEAST_T / 3 and better >= BLOCKS - 2 and one.gain > 10 * least_gain)
        if rough and c.definition.kind != "sensor":  # effects missing in the library make the parts differ
            steady = steady or (one.t >= ROUGH_T and one.gain > 2 * least_gain)
        least_share = (ROUGH_SHARE if rough else REPLACING_SHARE) if one.replaced else LEAST_SHARE
        if one.share < max(least_share, c.least_share) and (rough or not c.local):
            return False
        if one.replaced and one.t < REPLACING_T:
            return False
        if c.local:
            steady = one.t >= 1 and one.gain > 3 * least_gain
        return bool(
            steady
            and one.matters >= 1
            and one.gain > least_gain
            and np.any(one.fit.x)
            and c.feasible(one.fit.x)
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
    # For each effect at each joint, take the best candidate of the grid and refine it.
    best: dict[tuple[str, int | None], Trial] = {}
    for one in good:
        best.setdefault((one.candidate.effect, one.candidate.joint), one)
    top = max(one.gain for one in best.values())
    for key, one in best.items():
        if one.candidate.values and one.gain > 0.5 * top:
            best[key] = _refine(current, one, least, contexts)
    several = list(best.values())
    unlikely = [one for one in several if not _is_likely(now, one, several, rough=rough)]
    best = {key: one for key, one in best.items() if not any(one is each for each in unlikely)}
    if not best:
        return None
    most = max(best.values(), key=lambda one: one.gain)
    left = np.median(most.fit.held_out[:, list(most.candidate.rows)], axis=0).max()
    if rough or left > ROUGH:  # none explains the log: one with many parameters must gain more
        ranked = sorted(best.values(), key=lambda one: -one.gain / numbers_of(one) ** MANY_POWER)
    else:
        ranked = sorted(best.values(), key=lambda one: -one.gain)
    winner = ranked[0]
    loss = ROUGH_TIE if rough else TIE_LOSS
    ties = [one for one in ranked[1:] if _is_tied(now, winner, one, loss)]
    simplest = min([winner, *ties], key=lambda one: (one.candidate.order, -one.gain))
    hidden = [one for one in unlikely if one.gain >= winner.gain or _is_tied(now, winner, one, loss)]
    hidden = [one for one in hidden if set(one.candidate.rows) & set(winner.candidate.rows)]
    others = [one for one in [winner, *ties, *hidden] if one is not simplest]
    names = [one.candidate.effect for one in others if not _contains(one.candidate, simplest.candidate)]
    if one_way[simplest.candidate.rows[0]] and simplest.candidate.effect in _CONSTANT_IN_ONE_DIRECTION:
        names += _CONSTANT_IN_ONE_DIRECTION
    rivals = tuple(dict.fromkeys(name for name in names if name != simplest.candidate.effect))
    return simplest, rivals, confidence_of(rivals)


def confidence_of(rivals: Sequence[str]) -> float:
    """Confidence in an effect that has these rivals. Three or more rivals bring it below one half."""
    return SURE if not rivals else 0.9 / (1 + 0.3 * len(rivals))


def _one_way(contexts: Sequence[Context]) -> NDArray[np.bool_]:
    """Which joints [n] move in one direction only."""
    forth = sum(np.maximum(c.signals.qd, 0).sum(axis=0) for c in contexts)
    back = sum(np.maximum(-c.signals.qd, 0).sum(axis=0) for c in contexts)
    return np.asarray(np.minimum(forth, back) < ONE_WAY_SHARE * np.maximum(forth, back))


def nearest(
    now: Problem, current: Fit, tried: Sequence[Trial], least: Floats, contexts: Sequence[Context]
) -> list[Trial]:
    """The trials, best first, with refined copies of the best oscillators of the grid. An oscillator that is
    slightly out of tune stays in phase only for a while and then fits worse than no oscillator."""
    all_trials, count = list(tried), dict[tuple[str, int | None], int]()
    least_gain = max(
        OSCILLATOR_GAIN * max((one.gain for one in tried), default=0.0), evidence_threshold(now, 3)
    )
    for one in tried:
        key = (one.candidate.effect, one.candidate.joint)
        if not one.candidate.reach or one.gain < least_gain:
            continue
        count[key] = count.get(key, 0) + 1
        if count[key] <= OSCILLATOR_STARTS and sum(count.values()) <= 2 * OSCILLATOR_STARTS:
            all_trials.append(_refine(current, one, least, contexts))
    return sorted(all_trials, key=lambda one: -one.gain)


def _is_likely(now: Problem, one: Trial, others: Sequence[Trial], *, rough: bool) -> bool:
    """Whether a candidate may be named. An implausible one may be named only if it alone explains the log
    down to the noise; in a ``rough`` log no candidate does."""
    return one.candidate.likely(one.fit.x) or (not rough and _stands_alone(now, one, others))


def _stands_alone(now: Problem, one: Trial, others: Sequence[Trial]) -> bool:
    """Whether a candidate leaves only noise at its joints and no other candidate fits as well."""
    rows = list(one.candidate.rows)
    left = float(np.median(one.fit.held_out[:, rows], axis=0).max())
    return left < ALONE and not any(_is_tied(now, one, each, TIE_LOSS) for each in others if each is not one)


def _contains(wide: Candidate, narrow: Candidate) -> bool:
    if wide.joint != narrow.joint:
        return False
    return narrow.effect in (*wide.beside, *wide.definition.traits.contains)


def _is_tied(now: Problem, winner: Trial, other: Trial, loss: float) -> bool:
    """Whether the log cannot distinguish ``other`` from ``winner``. A difference of less than the share
    ``loss`` of the gain is ignored."""
    if not set(winner.candidate.rows) & set(other.candidate.rows) or other.gain < 0.5 * winner.gain:
        return False
    if other.gain > (1 - loss) * winner.gain:
        return True
    # Once nearly everything is explained, even a small share of the gain may be significant: test it.
    left = np.maximum(winner.fit.held_out.mean(axis=0), 1.0)
    gap = float(((other.fit.held_out - winner.fit.held_out) / left).sum()) * now.independent / BLOCKS / 2
    if gap < CLOSE and other.gain > NEARLY * winner.gain:
        return True
    worse = winner.per_part - other.per_part
    error = float(worse.std(ddof=1)) / np.sqrt(BLOCKS) + 1e-12
    return bool(winner.gain - other.gain < TIE * error * BLOCKS)


def _refine(current: Fit, one: Trial, least: Floats, contexts: Sequence[Context]) -> Trial:
    """The candidate with its nonlinear parameters improved, one at a time. An oscillator has many local
    optima: its parameters are varied together, in random directions."""
    rebuild, restore = one.candidate.again, one.beside
    assert rebuild is not None
    assert restore is not None
    problem, fit = restore()

    def trials_at(settings: Sequence[dict[str, float]]) -> list[Trial]:
        several = [[rebuild(c, values) for values in settings] for c in contexts]
        columns = zip(*(prepared(c, each) for c, each in zip(contexts, several, strict=True)), strict=True)
        pairs = [(parts[0][0], np.concatenate([part for _, part in parts])) for parts in columns]
        return trials(
            problem,
            fit,
            Library.of(pairs),
            least,
            against=current,
            again=restore,
            replaced=one.replaced,
            numbers_replaced=one.numbers_replaced,
        )

    if one.candidate.reach:
        return _random_search(one, trials_at)
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
        best = trials_at(settings)[0] if settings else one
        better = best if best.gain > one.gain else one
        if better is one:
            spread = spread**0.5
            if spread < fine:
                break
        one = better
    return one


def _random_search(one: Trial, trials_at: Callable[[Sequence[dict[str, float]]], list[Trial]]) -> Trial:
    """The best candidate of a random search, whose steps become shorter when none improves the fit."""
    rng, start = np.random.default_rng(0), one.candidate.values
    size = np.array([one.candidate.reach[name] for name in start])
    for _ in range(REFINING_ROUNDS):
        settings = one.candidate.values
        steps = np.exp(size * rng.standard_normal((OSCILLATOR_DIRECTIONS, len(size))))
        settings_in_reach = []
        for row in steps:
            values = {name: settings[name] * float(f) for name, f in zip(settings, row, strict=True)}
            if all(
                1 / OSCILLATOR_FARTHEST < x / start[name] < OSCILLATOR_FARTHEST for name, x in values.items()
            ):
                settings_in_reach.append(values)
        if not settings_in_reach:
            continue
        best = trials_at(settings_in_reach)[0]
        size = size * (1.0 if best.gain > one.gain else 0.6)
        one = best if best.gain > one.gain else one
    return one
