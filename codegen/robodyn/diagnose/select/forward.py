"""Forward selection: what all joints lack first, then one effect after another, each beside those before."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.beside import Library
from robodyn.diagnose.select.choice import best_of, confidence_of
from robodyn.diagnose.select.common import Group, common
from robodyn.diagnose.select.fit import Fit, Problem, covariance, fitted, less
from robodyn.diagnose.select.library import Candidate, Context
from robodyn.diagnose.select.limits import CLOSE, MOST_EFFECTS, MOST_KINDS, MOST_VAGUE, SURE
from robodyn.diagnose.select.trial import Trial, numbers_of, trials, without_columns
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect

Floats = NDArray[np.float64]
#: An effect's id and its joint (from 1), None where it is of the whole robot.
Key = tuple[str, int | None]


@dataclass(frozen=True, slots=True, eq=False)
class Named:
    """A selected effect, ids of what explains as much, and the trials ``beside`` it, best first; its
    coefficients ``x`` [c], and by columns of ``spread`` [c, c] how they go together, each a standard error
    (the sum of the columns' outer products is their covariance), of which ``by_prior`` [c, c] comes from
    their own prior; ``is_common``: most joints lack it."""

    trial: Trial
    rivals: tuple[str, ...]
    confidence: float
    x: Floats
    spread: Floats
    beside: tuple[Trial, ...] = ()
    is_common: bool = False
    by_prior: Floats = field(default_factory=lambda: np.zeros((0, 0)))


@dataclass(frozen=True, slots=True, eq=False)
class Chosen:
    """What was chosen, one after another; the problem with all of it, its fit, the trials of the first
    step."""

    findings: list[Named]
    now: Problem
    current: Fit
    trials: list[Trial]


def forward(
    start: Problem,
    library: Library,
    least: Floats,
    contexts: Sequence[Context],
    *,
    known: frozenset[Key],
    rough: bool,
    links: bool = True,
    most: int = MOST_KINDS,
    progress: Callable[[str], object] | None,
) -> Chosen:
    """One effect after another until none passes, or the columns of all others change; errors of the arm's
    own numbers only with ``links``; ``most`` kinds of effects are named; ``known``: what the model has of
    earlier passes, whose numbers are to be refined and not sought again."""
    tell = progress or (lambda _: None)
    findings: list[Named] = []
    now, current = start, fitted(start)
    begun: list[Trial] = []
    tried: list[Trial] | None = None  # beside what is chosen by now
    group = Group((), 0.0)
    refused = set[Key]()
    is_grouped = False
    for _ in range(MOST_EFFECTS):
        if tried is None:
            which = _untaken(library, findings, known, rough=rough, links=links, most=most)
            which = [k for k in which if _key(library.candidates[k]) not in refused]
            tried = _tried(start, now, current, findings, library, which, least)
            group = Group((), 0.0) if is_grouped else common(now, current, library, which, least)
            begun = begun or [without_columns(one) for one in tried]
        best = best_of(now, current, tried, least, contexts, rough=rough)
        # One thing that explains more than friction everywhere (a delay) may look like that.
        if group.trials and (best is None or best[0].gain < group.gain):
            is_grouped, tried = True, None
            for one in _kinds(group.trials, most - len({effect for effect, _ in known})):
                tell(one.candidate.name)
                one = replace(one, columns=one.columns.copy(), beside=None)
                findings.append(Named(one, (), SURE, one.fit.x, np.zeros(0), is_common=True))
            findings = _without_vague(start, findings)
            now = _with(start, findings)
            current = fitted(now)
            continue
        if best is None:
            break
        one, rivals, confidence = best
        one = replace(one, columns=one.columns.copy(), beside=None)
        beside = tuple(without_columns(each) for each in tried[:40])
        kept = [each for k, each in enumerate(findings) if k not in one.replaced]
        more = _with_new(start, kept, Named(one, rivals, confidence, one.fit.x, np.zeros(0), beside))
        if more is None:
            refused.add(_key(one.candidate))
            tried = [each for each in tried if _key(each.candidate) not in refused]
            continue
        findings, tried = more, None
        now = _with(start, findings)
        current = fitted(now)
        tell(one.candidate.name)
        if one.candidate.definition.traits.reevaluate:
            break  # the model is to be evaluated anew before more is looked for
    return Chosen(_with_as_simple(findings, tried or ()), now, current, begun)


def _with_as_simple(findings: list[Named], tried: Iterable[Trial]) -> list[Named]:
    """The findings with further rivals: laws that are as simple as they are, and of which the log does not
    say that they are worse; ``tried`` beside all of them."""
    for one in tried:
        name = one.candidate.effect
        for k in one.replaced if one.is_as_simple and one.gain > -CLOSE else ():
            if name not in findings[k].rivals:
                rivals = (*findings[k].rivals, name)
                findings[k] = replace(findings[k], rivals=rivals, confidence=confidence_of(rivals))
    return findings


def _untaken(
    library: Library,
    findings: Sequence[Named],
    known: frozenset[Key],
    *,
    rough: bool,
    links: bool,
    most: int,
) -> list[int]:
    """The candidates that may still be taken."""
    laws = {key for key in known if not CATALOGUE[key[0]].traits.several}
    taken = laws | {(f.trial.candidate.effect, f.trial.candidate.joint) for f in findings}
    kinds = {effect for effect, _ in known | taken}
    return [
        k
        for k, c in enumerate(library.candidates)
        if (c.effect, c.joint) not in taken
        and (rough or not c.rough)
        # There is more in such a friction than one law.
        and not (rough and c.in_place)
        # In a log with more in it than the catalogue has, whatever is cut off explains something.
        and not (rough and c.local and c.values)
        and (links or not is_of_link(c))
        and (len(kinds) < most or c.effect in kinds)
        and not _is_covered(c, taken)
    ]


def _with_new(start: Problem, kept: list[Named], new: Named) -> list[Named] | None:
    """The findings with a ``new`` one, without those of which nothing can be known beside it, its special
    cases and what explains less; None where nothing can be known of itself, or of what explains more."""
    was = _vague(start, kept)
    *is_vague, new_is_vague = _vague(start, [*kept, new])
    if new_is_vague:
        return None
    candidate = new.trial.candidate
    special = {*candidate.definition.traits.contains, *candidate.beside}
    findings = []
    for one, before, after in zip(kept, was, is_vague, strict=True):
        other = one.trial.candidate
        if not after or before:
            findings.append(one)
        elif one.trial.gain > new.trial.gain and not (
            other.effect in special and set(other.rows) <= set(candidate.rows)
        ):
            return None
    return [*findings, new]


def _without_vague(start: Problem, findings: list[Named]) -> list[Named]:
    """The findings of which something is known."""
    while True:
        vague = _vague(start, findings)
        if not any(vague):
            return findings
        weakest = min((k for k, each in enumerate(vague) if each), key=lambda k: findings[k].trial.gain)
        findings = [one for k, one in enumerate(findings) if k != weakest]


def _vague(start: Problem, findings: Sequence[Named]) -> list[bool]:
    """Of which of the findings, fitted together, nothing is known to better than about itself."""
    p = _with(start, findings)
    fit = fitted(p)
    spread = covariance(p, fit)
    vague, at = [], p.nuisance
    for one in findings:
        c = 0 if one.trial.candidate.fixed else one.trial.columns.shape[2]
        part = slice(at, at + c)
        vague.append(bool(c) and _is_vague(one.trial.candidate, fit.known[part], spread[part, part]))
        at += c
    return vague


def _is_vague(candidate: Candidate, x: Floats, spread: Floats) -> bool:
    """Whether the sizes of an effect, the parameters in which it is linear and how far others are from where
    there is nothing of it, are not known to better than about themselves; ``x`` [c] are its coefficients,
    ``spread`` [c, c] their covariance."""
    none = candidate.definition.traits.nothing

    def sizes_at(x: Floats) -> dict[str, float]:
        values = candidate.read(x)
        names = {*candidate.definition.linear, *none} & set(values)
        return {name: float(values[name]) - none.get(name, 0.0) for name in names}

    sizes = {name: size for name, size in sizes_at(x).items() if size}
    if not sizes:
        return bool(np.all(np.sqrt(np.maximum(np.diag(spread), 0.0)) > MOST_VAGUE * np.abs(x)))
    steps = np.diag(np.maximum(1e-3 * np.abs(x), 1e-6 * np.abs(x).max()))
    moved = [sizes_at(x + step) for step in steps]
    for name, size in sizes.items():
        slope = (np.array([each[name] for each in moved]) - size) / np.diag(steps)
        if np.sqrt(max(float(slope @ spread @ slope), 0.0)) < MOST_VAGUE * abs(size):
            return False
    return True


def _key(candidate: Candidate) -> Key:
    return candidate.effect, candidate.joint


def _kinds(trials: Sequence[Trial], most: int) -> list[Trial]:
    """The trials, best first, of the first ``most`` kinds of effects among them."""
    kinds = list(dict.fromkeys(one.candidate.effect for one in trials))[: max(1, most)]
    return [one for one in trials if one.candidate.effect in kinds]


def is_of_link(candidate: Candidate) -> bool:
    """Whether it is an error of the arm's own numbers."""
    fold = candidate.definition.traits.fold
    return fold is not None and fold.into == "link"


def _tried(
    start: Problem,
    now: Problem,
    current: Fit,
    findings: Sequence[Named],
    library: Library,
    which: Sequence[int],
    least: Floats,
) -> list[Trial]:
    """Trials of the candidates ``which``, best first; a law stands in the place of its special cases."""
    groups: dict[tuple[int, ...], list[int]] = {}
    for k in which:
        groups.setdefault(_replaced(library.candidates[k], findings), []).append(k)
    tried = []
    for replaced, group in groups.items():
        if not replaced:
            group = [k for k in group if not library.candidates[k].in_place]
            tried += trials(now, current, library, least, group)
            continue
        again = partial(_fitted_without, start, tuple(findings), replaced)
        numbers = sum(numbers_of(findings[k].trial) for k in replaced)
        tried += trials(
            *again(), library, least, group, against=current, again=again, replaced=replaced,
            numbers_replaced=numbers,
        )  # fmt: skip
    return sorted(tried, key=lambda one: -one.gain)


def _fitted_without(
    start: Problem, findings: Sequence[Named], replaced: tuple[int, ...]
) -> tuple[Problem, Fit]:
    """The problem with all findings but those ``replaced`` known, and its fit."""
    others = _with(start, [one for k, one in enumerate(findings) if k not in replaced])
    return others, fitted(others)


def special_cases(candidate: Candidate) -> set[str]:
    """Ids of the effects that a law has as special cases, and in whose place it stands."""
    if candidate.in_place:
        return set(candidate.definition.traits.contains)
    return set() if candidate.joint is None else special_cases_of(candidate.definition)


def special_cases_of(effect: Effect) -> set[str]:
    """Ids of the effects that a law of a joint has as special cases, and in whose place it stands."""
    traits = effect.traits
    if effect.level != "joint":
        return set()
    special = {*traits.contains, *([traits.steady[0]] if traits.steady else [])}
    return special - set(traits.one_law_with)


def _is_covered(candidate: Candidate, taken: Iterable[Key]) -> bool:
    """Whether a law at the same joint has the candidate as a special case."""
    return any(
        joint == candidate.joint and candidate.effect in special_cases_of(CATALOGUE[effect])
        for effect, joint in taken
    )


def _replaced(candidate: Candidate, findings: Sequence[Named]) -> tuple[int, ...]:
    """Places of the findings at the same joint of which a law takes the place: its special cases, and other
    laws of the same place in the drive with the same special cases, since a joint has one friction law."""
    special = special_cases(candidate)
    if not special:
        return ()
    return tuple(
        k
        for k, one in enumerate(findings)
        if one.trial.candidate.joint == candidate.joint
        and (
            one.trial.candidate.effect in special
            or (
                one.trial.candidate.definition.place == candidate.definition.place
                and special & special_cases(one.trial.candidate)
            )
        )
    )


def _with(start: Problem, findings: Sequence[Named]) -> Problem:
    """The problem with the columns of all findings known, or taken off where their size is known."""
    for one in findings:
        candidate, columns = one.trial.candidate, one.trial.columns
        if candidate.fixed:
            start = less(start, candidate.rows, columns[:, :, 0])
        else:
            start = start.with_columns(candidate.rows, columns, candidate.scale)
    return start
