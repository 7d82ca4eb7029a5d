"""Forward selection: what all joints lack first, then one effect after another, each beside those before."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.beside import Library
from robodyn.diagnose.select.choice import Trial, best_of, trials, without_columns
from robodyn.diagnose.select.common import common
from robodyn.diagnose.select.fit import Fit, Problem, fitted, less
from robodyn.diagnose.select.library import Candidate, Context
from robodyn.diagnose.select.limits import MOST_EFFECTS, MOST_KINDS, SURE
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect

Floats = NDArray[np.float64]
#: An effect's id and its joint (from 1), None where it is of the whole robot.
Key = tuple[str, int | None]


@dataclass(frozen=True, slots=True, eq=False)
class Named:
    """A selected effect, ids of what explains as much, and the trials ``beside`` it, best first;
    ``is_common``: most joints lack it."""

    trial: Trial
    rivals: tuple[str, ...]
    confidence: float
    x: Floats
    stderr: Floats
    beside: tuple[Trial, ...] = ()
    is_common: bool = False


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
    is_grouped = False
    for _ in range(MOST_EFFECTS):
        which = _untaken(library, findings, known, rough=rough, links=links, most=most)
        tried = _tried(start, now, current, findings, library, which, least)
        begun = begun or [without_columns(one) for one in tried]
        best = best_of(now, current, tried, least, contexts, rough=rough)
        if not is_grouped:
            group = common(now, current, library, which, least)
            # One thing that explains more than friction everywhere (a delay) may look like that.
            if group.trials and (best is None or best[0].gain < group.gain):
                is_grouped = True
                several = _kinds(group.trials, most - len({effect for effect, _ in known}))
                for one in several:
                    one = replace(one, columns=one.columns.copy())
                    findings.append(Named(one, (), SURE, one.fit.x, np.zeros(0), is_common=True))
                for one in several:
                    tell(one.candidate.name)
                now = _with(start, findings)
                current = fitted(now)
                continue
        if best is None:
            break
        one, rivals, confidence = best
        findings = [each for k, each in enumerate(findings) if k not in one.replaced]
        one = replace(one, columns=one.columns.copy())
        beside = tuple(without_columns(each) for each in tried[:40])
        findings.append(Named(one, rivals, confidence, one.fit.x, np.zeros(0), beside))
        now = _with(start, findings)
        current = fitted(now)
        tell(one.candidate.name)
        if one.candidate.definition.traits.reevaluate:
            break  # the model is to be evaluated anew before more is looked for
    return Chosen(findings, now, current, begun)


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
        and (links or not _is_of_link(c))
        and (len(kinds) < most or c.effect in kinds)
        and not _is_covered(c, taken)
    ]


def _kinds(trials: Sequence[Trial], most: int) -> list[Trial]:
    """The trials, best first, of the first ``most`` kinds of effects among them."""
    kinds = list(dict.fromkeys(one.candidate.effect for one in trials))[: max(1, most)]
    return [one for one in trials if one.candidate.effect in kinds]


def _is_of_link(candidate: Candidate) -> bool:
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
            tried += trials(now, current, library, least, group)
            continue
        others = _with(start, [one for k, one in enumerate(findings) if k not in replaced])
        fit = fitted(others)
        tried += trials(others, fit, library, least, group, against=current, replaced=replaced)
    return sorted(tried, key=lambda one: -one.gain)


def special_cases(candidate: Candidate) -> set[str]:
    """Ids of the effects that a law has as special cases."""
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
