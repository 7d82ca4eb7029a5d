"""What all joints have: viscous and dry friction and rotor inertia, looked for at all joints at once.

A description that was taken from a mechanical model has none of them, so that every joint lacks the same
three. Looked for one by one, the first is fitted to what the others leave, and a name that explains a little
of everything (a turned base, a delay, a coupling) is taken before them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.choice import Trial, evidence_threshold, gain_of, trial
from robodyn.diagnose.select.fit import Fit, Problem, fitted
from robodyn.diagnose.select.library import Candidate
from robodyn.diagnose.select.limits import BLOCKS, COMMON_JOINTS, COMMON_PARTS, COMMON_T

Floats = NDArray[np.float64]
Pair = tuple[Candidate, Floats]


def is_common(candidate: Candidate) -> bool:
    """Whether every joint of a description has a number for it."""
    fold = candidate.definition.traits.fold
    return fold is not None and fold.into == "joint"


@dataclass(frozen=True, slots=True, eq=False)
class Group:
    """Trials of what most joints lack, each beside all the others, largest gain first, and the ``gain`` of
    all together in units of log-likelihood."""

    trials: tuple[Trial, ...]
    gain: float


def common(start: Problem, current: Fit, library: Sequence[Pair], least: Floats) -> Group:
    """What most joints lack beside what is known already, with its fit ``current``; empty if few joints lack
    it. ``least`` [n]: what matters, in units of the noise."""
    chosen = _plain(library)
    moving = {c.joint for c, _ in chosen}
    while chosen:
        together = fitted(_with(start, chosen))
        at = start.A.shape[2]
        negative = {k for k in range(len(chosen)) if together.known[at + k] <= 0}
        if negative:
            chosen = [pair for k, pair in enumerate(chosen) if k not in negative]
            continue
        trials = [_beside(start, chosen, k, least) for k in range(len(chosen))]
        leaving = [k for k, one in enumerate(trials) if not _stays(start, one)]
        if not leaving:
            joints = {one.candidate.joint for one in trials}
            if len(joints) < max(2, COMMON_JOINTS * len(moving)):
                break
            return Group(tuple(sorted(trials, key=lambda one: -one.gain)), gain_of(start, current, together))
        del chosen[min(leaving, key=lambda k: trials[k].gain)]
    return Group((), 0.0)


def _plain(library: Sequence[Pair]) -> list[Pair]:
    """Of each common effect at each joint that moves the simplest candidate."""
    best: dict[tuple[str, int | None], Pair] = {}
    for candidate, columns in library:
        key = (candidate.effect, candidate.joint)
        if not is_common(candidate) or candidate.stand_in or candidate.values or not np.any(columns):
            continue
        if key not in best or candidate.order < best[key][0].order:
            best[key] = (candidate, columns)
    return list(best.values())


def _with(start: Problem, chosen: Sequence[Pair]) -> Problem:
    """The problem with all of their columns known."""
    for candidate, columns in chosen:
        start = start.with_columns(candidate.rows, columns)
    return start


def _beside(start: Problem, chosen: Sequence[Pair], k: int, least: Floats) -> Trial:
    """The trial of one of them beside the others."""
    others = _with(start, [pair for i, pair in enumerate(chosen) if i != k])
    candidate, columns = chosen[k]
    return trial(others, fitted(others), candidate, columns, least)


def _stays(start: Problem, one: Trial) -> bool:
    """Whether what it explains matters, is more than chance, and is there in most parts of the log."""
    parts = int(np.sum(one.per_part > 0))
    steady = one.t >= COMMON_T or parts >= COMMON_PARTS * BLOCKS
    return bool(steady and one.matters >= 1 and one.gain > evidence_threshold(start, 1))
