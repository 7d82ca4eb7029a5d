"""All solutions of a pose by Newton's method from many random starts: slow, and of nobody's formulas.

It proves no set complete, but what it finds must be in one.
"""

from __future__ import annotations

import numpy as np
from benchmarks.inverse_kinematics.chain import Chain, Floats
from benchmarks.inverse_kinematics.positions import drawn
from benchmarks.inverse_kinematics.sets import SAME, Answers

#: Starts a pose, and steps from each.
STARTS, STEPS = 256, 40
#: What is left of the pose where a start has arrived (rotation's numbers; position, m), and the most that a
#: step moves a joint (rad, m).
_ARRIVED, _LONGEST = 1e-12, 0.5
#: Added to the squares of the singular values, so that steps stay short beside a singularity.
_DAMPING = 1e-10


def search(chain: Chain, poses: Floats, near: Floats, redundant: int | None, starts: int = STARTS) -> Answers:
    """The distinct solutions of ``poses`` [N, 4, 4] that so many random starts lead to; the redundant joint
    stays where ``near`` [N, n] has it."""
    sets = [
        _solutions(chain, pose, row, redundant, starts, k)
        for k, (pose, row) in enumerate(zip(poses, near, strict=True))
    ]
    most = max(1, *(len(rows) for rows in sets))
    q, exists = np.zeros((len(poses), most, chain.n)), np.zeros((len(poses), most), dtype=bool)
    for k, rows in enumerate(sets):
        q[k, : len(rows)], exists[k, : len(rows)] = rows, True
    return Answers(q, exists)


def _solutions(
    chain: Chain, pose: Floats, near: Floats, redundant: int | None, starts: int, index: int
) -> Floats:
    free = [i for i in range(chain.n) if i != redundant]
    q = drawn(chain, starts, f"starts {index}")
    if redundant is not None:
        q[:, redundant] = near[redundant]
    for _ in range(STEPS):
        J, left = chain.jacobians(q)[:, :, free], _left(chain, pose, q)
        square = J @ J.transpose(0, 2, 1) + _DAMPING * np.eye(6)
        step = np.einsum(
            "kij,kj->ki", J.transpose(0, 2, 1), np.linalg.solve(square, left[:, :, None])[:, :, 0]
        )
        longest = np.abs(step).max(axis=1, keepdims=True)
        q[:, free] += step * np.minimum(1.0, _LONGEST / np.maximum(longest, _LONGEST))
    arrived = q[np.abs(_left(chain, pose, q)).max(axis=1) < _ARRIVED]
    arrived[:, chain.revolute] = np.mod(arrived[:, chain.revolute] + np.pi, 2 * np.pi) - np.pi
    distinct: list[Floats] = []
    for row in arrived:
        if not any(_apart(chain, row, other) < SAME for other in distinct):
            distinct.append(row)
    return np.array(distinct).reshape(-1, chain.n)


def _left(chain: Chain, pose: Floats, q: Floats) -> Floats:
    """The way from the tool at ``q`` [N, n] to the pose: position, half the rotation's skew part [N, 6]."""
    at = chain.poses(q)
    R = pose[:3, :3] @ at[:, :3, :3].transpose(0, 2, 1)
    skew = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], axis=1) / 2
    turned = (
        np.trace(R, axis1=1, axis2=2)[:, None] < 1.0
    )  # by more than a right angle: the skew part shrinks again
    length = np.linalg.norm(skew, axis=1, keepdims=True)
    skew = np.where(turned, skew / np.maximum(length, 1e-3), skew)
    return np.concatenate([pose[:3, 3] - at[:, :3, 3], skew], axis=1)


def _apart(chain: Chain, a: Floats, b: Floats) -> float:
    difference = a - b
    turns = np.where(chain.revolute, np.round(difference / (2 * np.pi)), 0.0)
    return float(np.abs(difference - 2 * np.pi * turns).max())
