"""What all joints have: viscous and dry friction and rotor inertia, looked for at all joints at once.

A description that was taken from a mechanical model has none of them, so that every joint lacks the same
three. Looked for one by one, the first is fitted to what the others leave, and a name that explains a little
of everything (a turned base, a delay, a coupling) is taken before them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.beside import Library
from robodyn.diagnose.select.fit import Fit, Problem, fitted
from robodyn.diagnose.select.library import Candidate
from robodyn.diagnose.select.limits import BLOCKS, COMMON_JOINTS, COMMON_PARTS, COMMON_T
from robodyn.diagnose.select.trial import Trial, evidence_threshold, gain_of, trials

Floats = NDArray[np.float64]


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


def common(start: Problem, current: Fit, library: Library, which: Sequence[int], least: Floats) -> Group:
    """What most joints lack beside what is known already, with its fit ``current``, of the candidates
    ``which``; empty if few joints lack it. ``least`` [n]: what matters, in units of the noise."""
    chosen = _plain(library, which)
    moving = {library.candidates[k].joint for k in chosen}
    while chosen:
        whole = start
        for k in chosen:
            whole = whole.with_columns(library.candidates[k].rows, library.of_candidate(k))
        together = fitted(whole)
        at = start.A.shape[2]
        positive = [k for i, k in enumerate(chosen) if together.known[at + i] > 0]
        if len(positive) < len(chosen):
            chosen = positive
            continue
        tried = [_beside(whole, at + i, library, k, least) for i, k in enumerate(chosen)]
        leaving = [i for i, one in enumerate(tried) if not _stays(start, one)]
        if not leaving:
            # Rotors alone are no drives: what links are heavier would pass for them.
            joints = {one.candidate.joint for one in tried if one.candidate.definition.dissipative}
            alone = len(moving) == 1 and len(tried) > 1  # a drive on its own
            if len(joints) < max(2, COMMON_JOINTS * len(moving)) and not alone:
                break
            return Group(tuple(sorted(tried, key=lambda one: -one.gain)), gain_of(start, current, together))
        del chosen[min(leaving, key=lambda i: tried[i].gain)]
    return Group((), 0.0)


def _plain(library: Library, which: Sequence[int]) -> list[int]:
    """Of each common effect at each joint that moves the simplest candidate."""
    best: dict[tuple[str, int | None], int] = {}
    for k in which:
        candidate = library.candidates[k]
        key = (candidate.effect, candidate.joint)
        if not is_common(candidate) or candidate.stand_in or candidate.values:
            continue
        if np.any(library.of_candidate(k)) and (
            key not in best or candidate.order < library.candidates[best[key]].order
        ):
            best[key] = k
    return list(best.values())


def _beside(whole: Problem, at: int, library: Library, k: int, least: Floats) -> Trial:
    """The trial of candidate ``k``, whose column of the problem is ``at``, beside the others."""
    others = whole.without_column(at)
    (one,) = trials(others, fitted(others), library, least, [k])
    return replace(one, beside=None)  # the problem is as large as the log


def _stays(start: Problem, one: Trial) -> bool:
    """Whether what it explains matters, is more than chance, and is there in most parts of the log."""
    parts = int(np.sum(one.per_part > 0))
    steady = one.t >= COMMON_T or parts >= COMMON_PARTS * BLOCKS
    return bool(steady and one.matters >= 1 and one.gain > evidence_threshold(start, 1))
