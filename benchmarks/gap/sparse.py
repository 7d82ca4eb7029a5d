"""A symbolic regression: sparse sums of products of sines, cosines, rates and accelerations, by PySINDy.

Each joint's torque for itself, from a library without any knowledge of the arm: products of up to two sines
and cosines of joint positions; one of them with an acceleration or a product of two velocities; and the
joint's velocity and its sign. Terms are added one by one, by orthogonal least squares (FROLS, Billings 2013):
dropping small ones again and again, as PySINDy does by default, keeps hundreds of them, which nearly cancel.
How many is what does best on pieces of the fitted samples that are left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, combinations_with_replacement

import numpy as np
from benchmarks.gap.recordings import Floats, Mask, Motion
from numpy.typing import NDArray

from robodyn.robot.model import Robot

#: Terms of a joint at most, and how many samples are used to choose them, evenly.
TERMS = 40
SAMPLES = 1500
#: Pieces of the fitted samples, of which every fifth is left out to choose how many terms.
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
    from pysindy import FROLS

    every = max(1, len(tau) // SAMPLES)
    test = np.arange(len(tau)) * _PIECES // len(tau) % 5 == 4
    search = FROLS(max_iter=TERMS, unbias=False).fit(columns[~test][::every], tau[~test, None][::every])
    best = (np.inf, np.zeros(0, dtype=int))
    for coefficients in search.history_:
        terms = np.flatnonzero(coefficients[0])
        error = float(((tau - columns[:, terms] @ _fitted(columns, tau, terms, ~test))[test] ** 2).mean())
        if error < best[0]:
            best = error, terms
    x = np.zeros(columns.shape[1])
    x[best[1]] = _fitted(columns, tau, best[1], np.ones(len(tau), dtype=bool))
    return x


def _fitted(columns: Floats, tau: Floats, terms: NDArray[np.int_], rows: Mask) -> Floats:
    x, *_ = np.linalg.lstsq(columns[rows][:, terms], tau[rows], rcond=None)
    return np.asarray(x, dtype=np.float64)
