"""Candidates and models set beside each other: which foretells more, which is the simpler, what excludes
what."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import product
from statistics import NormalDist

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.select.families import Family, Key
from robodyn.diagnose.select.library import Candidate
from robodyn.diagnose.select.limits import PRACTICAL
from robodyn.diagnose.select.members import Fit
from robodyn.diagnose.select.rows import Rows
from robodyn.diagnose.select.score import Trial, held_out
from robodyn.effects.catalogue import CATALOGUE
from robodyn.kernels.array_dynamics import physical
from robodyn.robot.model import AXES, Robot


def is_other_law(one: Family, key: Key) -> bool:
    """Whether a joint that has the law ``key`` would have another one in its place: a joint has one law of
    dry friction."""
    return (
        one.first.joint is not None
        and one.first.joint == key[1]
        and bool(special_cases(one.key[0]) & special_cases(key[0]))
    )


def rubs_at(one: Trial, j: int) -> bool:
    """Whether it is a law of dissipation at joint ``j`` (from 0)."""
    return one.family.first.definition.dissipative and one.family.first.joint == j + 1


def is_sum_of_others(one: Trial, tried: Sequence[Trial]) -> bool:
    """Whether an effect of two joints foretells no more than its special cases at each of them do: a motor
    that drives two joints is more than two joints that rub."""
    first = one.family.first
    if first.definition.level != "pair":
        return False
    plain = first.definition.traits.contains
    best = [
        max(
            (each.gain for each in tried if each.family.key[0] in plain and each.family.rows == [j]),
            default=0.0,
        )
        for j in one.family.rows
    ]
    return min(best) > 0 and sum(best) >= one.gain


def is_of_link(candidate: Candidate) -> bool:
    """Whether it is an error of one link's numbers, or a load, which is a part of the last link."""
    fold = candidate.definition.traits.fold
    return candidate.definition.traits.body or (fold is not None and fold.into == "link")


def ahead(gains: Floats) -> float:
    """By how many standard errors of a normal deviate what foretells more by ``gains`` [B, nats] of blocks is
    ahead: as often as signs that are drawn for the blocks bring about as much (a randomisation test, Fisher
    1935: blocks tell very unlike amounts). A standard error is a nat at least."""
    whole = float(gains.sum())
    chance = float(np.mean(_signs(len(gains)) @ np.abs(gains) >= whole - 1e-9 * np.abs(gains).sum()))
    return min(NormalDist().inv_cdf(min(1 - chance, 1 - 1e-9)) if chance < 1 else -np.inf, whole)


@lru_cache(maxsize=4)
def _signs(count: int) -> Floats:
    """All ways in which so many signs can be drawn [2^count, count]."""
    return np.array(list(product((-1.0, 1.0), repeat=count)))


def foretells(one: Fit, other: Fit) -> float:
    """What a model foretells more than another one [nats]."""
    return float((held_out(other) - held_out(one)).sum() / 2)


def _is_unlikely(one: Trial, robot: Robot) -> bool:
    """Whether it is rare in arms, or contradicts what the description states of a link."""
    first = one.family.first
    fold = first.definition.traits.fold
    if fold is not None and fold.into == "link" and first.joint is not None:
        return robot.links[first.joint - 1].confidence is not None
    return first.definition.level == "pair"


def is_level(one: Trial, best: Trial, threshold: float, robot: Robot) -> bool:
    """Whether it foretells as much as the ``best``: within a standard error (Breiman et al. 1984), or but for
    what of so many would be chance, the ``threshold`` [nats]; or, where the best is unlikely, but for what is
    worth no name at the joint where that is most."""
    if ahead(best.gains - one.gains) <= 1 or best.gain - one.gain < threshold:
        return True
    ratio = (best.after / np.maximum(one.after, 1e-300)).min()
    return _is_unlikely(best, robot) and bool(1 - np.sqrt(ratio) < PRACTICAL)


def special_cases(id: str) -> set[str]:
    """Ids of the effects that a law of a joint has as special cases, and in whose place it stands."""
    traits = CATALOGUE[id].traits
    if CATALOGUE[id].level != "joint":
        return set()
    return {*traits.contains, *([traits.steady[0]] if traits.steady else [])}


def overlap(one: Trial, other: Trial) -> float:
    """The share of the ``other``'s gain that ``one`` has at the same joints."""
    whole = np.maximum(other.at, 0)
    return float(np.minimum(np.maximum(one.at, 0), whole).sum() / max(whole.sum(), 1e-300))


def read_link(candidate: Candidate, x: Floats, rows: Rows) -> dict[str, float | str]:
    """The catalogue's parameters of standard parameters [10] that are more."""
    fold = candidate.definition.traits.fold
    if fold is None or fold.into != "link" or candidate.joint is None:
        return dict(candidate.read(x))
    old = rows.contexts[0].model.standard_parameters()[candidate.joint - 1]
    names = ("mass", "com_x", "com_y", "com_z", *AXES)
    pairs = zip(names, physical(old), physical(old + x), strict=True)
    return {f"delta_{name}": float(b - a) for name, a, b in pairs}
