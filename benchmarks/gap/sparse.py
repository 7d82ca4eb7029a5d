"""A symbolic regression: sparse sums of products of sines, cosines, rates and accelerations, by PySINDy.

Each joint's torque for itself, from a library without any knowledge of the arm: products of up to two sines
and cosines of joint positions; one of them with an acceleration or a product of two velocities; and the
joint's velocity and its sign. Terms below a threshold are dropped again and again (Brunton, Proctor and Kutz
2016); the threshold is the one that does best on pieces of the fitted samples that are left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, combinations_with_replacement

import numpy as np
from benchmarks.gap.recordings import Floats, Motion

from robodyn.robot.model import Robot

#: Shares of the largest coefficient (of columns of the same size) below which a term is dropped.
THRESHOLDS = (0.01, 0.03, 0.1, 0.3)
RIDGE = 1e-2
#: Pieces of the fitted samples, of which every fifth is left out to choose the threshold.
_PIECES = 25


def fit(robot: Robot, motions: Sequence[Motion]) -> tuple[Floats, ...]:
    """Residuals [K, n] of each of ``motions``, by sums that were fitted to their fitted samples."""
    revolute = [link.joint.kind == "revolute" for link in robot.links]
    tables = [library(revolute, m) for m in motions]
    columns = np.concatenate([x[m.fitted] for x, m in zip(tables, motions, strict=True)])
    tau = np.concatenate([m.tau[m.fitted] for m in motions])
    size = np.sqrt((columns**2).mean(axis=0))
    size[size == 0] = 1
    left = [m.tau.copy() for m in motions]
    for j in range(robot.n):
        friction = np.concatenate([_friction(m, j)[m.fitted] for m in motions])
        spread = np.sqrt((friction**2).mean(axis=0))
        x = _sparse(np.hstack([columns / size, friction / spread]), tau[:, j])
        for rest, table, m in zip(left, tables, motions, strict=True):
            rest[:, j] -= np.hstack([table / size, _friction(m, j) / spread]) @ x
    return tuple(left)


def _friction(m: Motion, j: int) -> Floats:
    return np.column_stack([m.qd[:, j], np.sign(m.qd[:, j])])


def library(revolute: Sequence[bool], m: Motion) -> Floats:
    """The terms [K, p] that all joints share."""
    one = np.ones(len(m.t))
    single = [one]
    for j, turns in enumerate(revolute):
        single += [np.sin(m.q[:, j]), np.cos(m.q[:, j])] if turns else [m.q[:, j]]
    pairs = [a * b for a, b in combinations(single[1:], 2)]
    rates = [a * b for a, b in combinations_with_replacement(m.qd.T, 2)]
    moved = [a * b for a in single for b in (*m.qdd.T, *rates)]
    return np.column_stack([*single, *pairs, *moved])


def _sparse(columns: Floats, tau: Floats) -> Floats:
    from pysindy import STLSQ

    scale = np.sqrt((tau**2).mean())
    test = np.arange(len(tau)) * _PIECES // len(tau) % 5 == 4
    best: tuple[float, float] | None = None
    for threshold in THRESHOLDS:
        x = STLSQ(threshold=threshold, alpha=RIDGE).fit(columns[~test], tau[~test, None] / scale).coef_[0]
        error = float(((columns[test] @ x - tau[test] / scale) ** 2).mean())
        if best is None or error < best[0]:
            best = error, threshold
    assert best
    x = STLSQ(threshold=best[1], alpha=RIDGE).fit(columns, tau[:, None] / scale).coef_[0]
    return np.asarray(x * scale, dtype=np.float64)
