"""Normal equations by block and joint: all that a fit needs to know of the rows, in bounded memory.

The matrix of all rows is never there: a few hundred samples at a time are turned into columns, weighted, and
added to the Gram matrix of their block and joint. Everything after (weights of joints, folds, priors, gains
of torques, several loads, intervals by block) is arithmetic on these.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats, Indices
from robodyn.dynamics.arm import Arm
from robodyn.identify.regressor import Links
from robodyn.identify.rows import Rows

_OWN = ("viscous", "coulomb", "rotor", "offset")


@dataclass(frozen=True, slots=True, eq=False)
class Layout:
    """Where parameters stand: ten of each of ``n`` links, then those of each joint by ``own``: of viscous
    friction, Coulomb friction, rotor, offset, those that are fitted."""

    n: int
    own: tuple[str, ...]

    @property
    def size(self) -> int:
        """How many parameters there are."""
        return (10 + len(self.own)) * self.n

    def link(self, k: int) -> Indices:
        """Those of the link ``k`` (from 0)."""
        return 10 * k + np.arange(10)

    def joint(self, name: str) -> Indices:
        """Of every joint that which is ``name`` (one of :attr:`own`) [n]."""
        return 10 * self.n + len(self.own) * np.arange(self.n) + self.own.index(name)

    def columns(self, joint: int) -> Indices:
        """Parameters that the torque of a joint (from 0) may depend on, in order."""
        own = 10 * self.n + len(self.own) * joint + np.arange(len(self.own))
        return np.concatenate([np.arange(10 * joint, 10 * self.n), own])


def layout_of(n: int, *, rotors: bool, offsets: bool) -> Layout:
    """The layout for an arm of ``n`` joints."""
    wanted = {"rotor": rotors, "offset": offsets}
    return Layout(n, tuple(name for name in _OWN if wanted.get(name, True)))


@dataclass(frozen=True, slots=True, eq=False)
class Block:
    """The rows of a stretch of a log: by joint ``gram`` [p_j, p_j], ``right`` [p_j] and ``square`` [n] of
    weighted torques, ``weight`` [n] of samples; and products ``late`` [p_j + 2] of the column of a torque
    that is read late, with the columns, the torque and itself."""

    log: int
    held_out: bool
    gram: tuple[Floats, ...]
    right: tuple[Floats, ...]
    square: Floats
    weight: Floats
    late: tuple[Floats, ...]

    def misfit(self, layout: Layout, x: Floats) -> Floats:
        """Weighted squares [n] of what parameters ``x`` leave."""
        left = []
        for j, (G, b) in enumerate(zip(self.gram, self.right, strict=True)):
            own = x[layout.columns(j)]
            left.append(float(self.square[j] - 2 * own @ b + own @ G @ own))
        return np.asarray(np.maximum(np.array(left), 0.0))


def columns_of(arm: Arm, layout: Layout, rows: Rows, part: slice) -> list[Floats]:
    """By joint the columns [p_j, M] of some of the rows."""
    Y = Links.along(arm, rows.q[part], rows.qd[part], rows.qdd[part]).regressor()
    own = {"viscous": rows.qd, "coulomb": rows.way, "rotor": rows.qdd, "offset": np.ones_like(rows.q)}
    stacked = []
    for j in range(layout.n):
        extra = np.stack([own[name][part, j] for name in layout.own])
        stacked.append(np.concatenate([Y[j, 10 * j :], extra]))
    return stacked


def blocks_of(
    arm: Arm,
    layout: Layout,
    pieces: Sequence[Rows],
    models: Sequence[tuple[Floats, Floats]] | None = None,
    weights: Sequence[Floats] | None = None,
    knees: Floats | None = None,
) -> tuple[list[Block], list[Floats]]:
    """The blocks of all rows, which count by the ``weights`` [M, n] of each piece; and what is left [M, n] of
    each by its log's of the ``models``: parameters [p] and what torques are multiplied by [n]. What is left,
    weighted, beyond the ``knees`` [n] has less weight (Huber)."""
    sums: dict[tuple[int, int], _Sum] = {}
    residuals = []
    for k, rows in enumerate(pieces):
        left = np.zeros_like(rows.tau)
        for part in chunks_of(rows.block):
            block = int(rows.block[part.start])
            into = sums.setdefault((rows.log, block), _Sum(layout, rows.log, bool(rows.held_out[block])))
            for j, A in enumerate(columns_of(arm, layout, rows, part)):
                tau = rows.tau[part, j]
                weight = rows.used[part, j].astype(np.float64)
                if weights is not None:
                    weight *= weights[k][part, j]
                if models is not None:
                    x, scale = models[rows.log]
                    left[part, j] = (tau - scale[j] * (x[layout.columns(j)] @ A)) * rows.used[part, j]
                if knees is not None:
                    size = np.abs(left[part, j]) * np.sqrt(weight)
                    weight *= np.minimum(1.0, knees[j] / np.maximum(size, 1e-300))
                into.add(j, A, tau, rows.late[part, j], weight)
        residuals.append(left)
    return [sums[key].block() for key in sorted(sums)], residuals


def chunks_of(block: Indices, longest: int = 256) -> list[slice]:
    """Runs of one block, none ``longest`` or longer: columns are made for as many samples at a time."""
    ends = np.flatnonzero(np.diff(block)) + 1
    parts = []
    for a, b in zip([0, *ends.tolist()], [*ends.tolist(), len(block)], strict=True):
        parts += [slice(k, min(k + longest, b)) for k in range(a, b, longest)]
    return parts


class _Sum:
    """A block in the making."""

    def __init__(self, layout: Layout, log: int, held_out: bool) -> None:
        sizes = [len(layout.columns(j)) for j in range(layout.n)]
        self.log, self.held_out = log, held_out
        self.gram = [np.zeros((p, p)) for p in sizes]
        self.right = [np.zeros(p) for p in sizes]
        self.late = [np.zeros(p + 2) for p in sizes]
        self.square, self.weight = np.zeros(layout.n), np.zeros(layout.n)

    def add(self, j: int, A: Floats, tau: Floats, late: Floats, weight: Floats) -> None:
        """Samples of joint ``j``: columns [p_j, M], torques, their rates and weights [M]."""
        weighted = A * weight
        self.gram[j] += weighted @ A.T
        self.right[j] += weighted @ tau
        self.square[j] += float(weight @ tau**2)
        self.weight[j] += float(weight.sum())
        self.late[j] += np.concatenate([weighted @ late, [(weight * tau) @ late, (weight * late) @ late]])

    def block(self) -> Block:
        """What has been added."""
        return Block(
            self.log, self.held_out, tuple(self.gram), tuple(self.right), self.square, self.weight,
            tuple(self.late),
        )  # fmt: skip
