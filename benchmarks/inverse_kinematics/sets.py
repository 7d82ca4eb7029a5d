"""Sets of solutions: which are the same, which only one side has, and how well each gives its pose again."""

from __future__ import annotations

from dataclasses import asdict, dataclass

import numpy as np
from benchmarks.inverse_kinematics.chain import Chain, Floats
from numpy.typing import NDArray

Bools = NDArray[np.bool_]

#: [rad, m] How far apart the same solution of two programs may be. Where the smallest singular value of the
#: Jacobian is 1e-6 a rounding error of 1e-15 moves it by 1e-9; nearer to a singularity it counts apart.
SAME = 1e-6
#: [1, m] What a solution may leave of the pose. Beyond that it is none.
CLOSES = 1e-8
#: Smallest singular value of the Jacobian (m, rad) under which a solution that one side alone has is said to
#: be at a singularity: two branches meet there, and rounding decides whether they exist.
SINGULAR = 1e-5


@dataclass(frozen=True, slots=True)
class Answers:
    """Solutions ``q`` [N, b, n] of N poses, and which of the b places hold one [N, b]."""

    q: Floats
    exists: Bools

    def part(self, which: slice) -> Answers:
        """Those of some poses."""
        return Answers(self.q[which], self.exists[which])


@dataclass(frozen=True, slots=True)
class Compared:
    """Two sets of solutions of the same poses, ``ours`` and ``theirs`` (how many, and how many poses)."""

    poses: int
    ours: int
    theirs: int
    #: Theirs that give the pose and that we do not have: away from singularities, and at one.
    missing: int
    missing_singular: int
    #: Ours that do not give the pose; and those that do and that they do not have, away from singularities
    #: and at one.
    invented: int
    only_ours: int
    only_ours_singular: int
    #: Theirs that do not give the pose.
    wrong: int
    #: Ours that stand twice in the set of one pose.
    twice: int
    #: The most that a solution leaves of the pose: of the rotation's numbers, of the position by the reach.
    closes: float
    closes_theirs: float

    def to_dict(self) -> dict[str, float]:
        """For JSON."""
        return asdict(self)


def closures(chain: Chain, poses: Floats, answers: Answers) -> Floats:
    """What the solutions leave of the poses [N, b]: the most of the rotation's numbers and of the position
    divided by the reach; 0 where there is none. Of arms with fewer than six joints only the place counts."""
    left = np.zeros(answers.exists.shape)
    pose, place = np.nonzero(answers.exists)
    difference = np.abs(chain.poses(answers.q[pose, place]) - poses[pose])[:, :3]
    difference[:, :, 3] /= chain.reach
    compared = difference if chain.n >= 6 else difference[:, :, 3:]
    left[pose, place] = compared.max(axis=(1, 2))
    return left


def matched(chain: Chain, a: Answers, b: Answers) -> Bools:
    """Whether places of ``a`` and ``b`` hold the same solution, modulo full turns [N, places of a, of b]."""
    return _same(chain, a, b, a.exists[:, :, None] & b.exists[:, None, :])


def doubled(chain: Chain, a: Answers) -> Bools:
    """Whether each place of ``a`` holds what an earlier place of the same pose holds already [N, b]."""
    earlier = np.tri(a.exists.shape[1], k=-1, dtype=bool)
    both = a.exists[:, :, None] & a.exists[:, None, :] & earlier
    return np.asarray(_same(chain, a, a, both).any(axis=2))


def _same(chain: Chain, a: Answers, b: Answers, pairs: Bools) -> Bools:
    """Of ``pairs`` [N, places of a, of b], those that are one solution."""
    pose, i, j = np.nonzero(pairs)
    difference = a.q[pose, i] - b.q[pose, j]
    turns = np.where(chain.revolute, np.round(difference / (2 * np.pi)), 0.0)
    same = pairs.copy()
    same[pose, i, j] = np.abs(difference - 2 * np.pi * turns).max(axis=1) < SAME
    return same


def compared(
    chain: Chain, poses: Floats, ours: Answers, theirs: Answers, redundant: int | None = None
) -> Compared:
    """``ours`` beside ``theirs`` at ``poses`` [N, 4, 4]."""
    left, left_theirs = closures(chain, poses, ours), closures(chain, poses, theirs)
    same = matched(chain, ours, theirs)
    lone, lone_theirs = ours.exists & ~same.any(axis=2), theirs.exists & ~same.any(axis=1)
    good, good_theirs = left <= CLOSES, left_theirs <= CLOSES
    lost = _at_singularity(chain, theirs, lone_theirs & good_theirs, redundant)
    more = _at_singularity(chain, ours, lone & good, redundant)
    return Compared(
        poses=len(poses),
        ours=int(ours.exists.sum()),
        theirs=int(theirs.exists.sum()),
        missing=int((~lost).sum()),
        missing_singular=int(lost.sum()),
        invented=int((ours.exists & ~good).sum()),
        only_ours=int((~more).sum()),
        only_ours_singular=int(more.sum()),
        wrong=int((theirs.exists & ~good_theirs).sum()),
        twice=int(doubled(chain, ours).sum()),
        closes=float(left.max(initial=0.0)),
        closes_theirs=float(left_theirs[good_theirs].max(initial=0.0)),
    )


def total(parts: list[Compared]) -> Compared:
    """Several comparisons of one arm as one."""
    rows = [asdict(part) for part in parts]
    most = {"closes", "closes_theirs"}
    return Compared(**{key: (max if key in most else sum)(row[key] for row in rows) for key in rows[0]})


def _at_singularity(chain: Chain, answers: Answers, which: Bools, redundant: int | None) -> Bools:
    """Of each of ``which``, one after another: whether branches meet there."""
    J = chain.jacobians(answers.q[which])
    if redundant is not None:
        J = np.delete(J, redundant, axis=2)
    if not len(J):
        return np.zeros(0, dtype=bool)
    return np.linalg.svd(J, compute_uv=False)[:, -1] < SINGULAR
