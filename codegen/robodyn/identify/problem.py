"""The fit: weighted squares of the rows, a prior about the description, bodies that are possible.

Unknown are the parameters of the layout, those of bodies that some logs carried beside, and gains of the
torque channels. A torque that is logged is ``(1 + gain)`` times what columns and parameters make of it; this
is linearised about the last gains, which takes no other pass over the rows.

Weights are those of the joints' noise, by their residuals, divided by how long residuals stay alike: samples
that say the same are one. The prior of a link has heavy tails (Student's t): a description that the logs
contradict loses its say instead of dragging the fit.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats, Indices
from robodyn.identify.consistent import Cone, inside, minimum
from robodyn.identify.limits import LEAST_NOISE, PRIOR_FREEDOM, ROUNDS, START_SHARE
from robodyn.identify.normal import Block, Layout


@dataclass(frozen=True, slots=True, eq=False)
class Unknowns:
    """What is fitted, z: the ``layout``'s parameters, ten of each of ``bodies`` that logs carried, a gain of
    each joint if ``gains``. ``mean`` and ``sd`` are their prior; ``free``: those that are not held at
    ``mean``; ``positive``: those that must not be negative; ``carried``: which body (from 0) each log had,
    -1: none; ``sizes`` of links and bodies; ``rigid``: those of them whose pseudo-inertia is to be
    positive."""

    layout: Layout
    bodies: int
    gains: bool
    mean: Floats
    sd: Floats
    free: NDArray[np.bool_]
    positive: Indices
    carried: tuple[int, ...]
    sizes: tuple[tuple[float, float], ...]
    rigid: NDArray[np.bool_]

    @property
    def size(self) -> int:
        """How many numbers z has."""
        return len(self.mean)

    def body(self, k: int) -> Indices:
        """Those of the body ``k`` (from 0): links first."""
        n = self.layout.n
        start = 10 * k if k < n else self.layout.size + 10 * (k - n)
        return start + np.arange(10)

    @property
    def gain(self) -> Indices:
        """Gains by joint [n], or none."""
        count = self.layout.n if self.gains else 0
        return self.layout.size + 10 * self.bodies + np.arange(count)

    @property
    def cone(self) -> Cone:
        """What they must obey."""
        bodies = tuple(self.body(k) for k in np.flatnonzero(self.rigid).tolist())
        sizes = tuple(self.sizes[k] for k in np.flatnonzero(self.rigid).tolist())
        positive = self.positive[self.free[self.positive]]
        return Cone.of(bodies, sizes, positive)

    def parameters(self, z: Floats, log: int) -> Floats:
        """The layout's parameters in a log: what it carried is part of the last link."""
        x = z[: self.layout.size].copy()
        if self.carried[log] >= 0:
            x[self.layout.link(self.layout.n - 1)] += z[self.body(self.layout.n + self.carried[log])]
        return x

    def scales(self, z: Floats) -> Floats:
        """What torques are multiplied by [n]: 1 + gain."""
        return 1 + z[self.gain] if self.gains else np.ones(self.layout.n)

    def places(self, log: int, joint: int) -> tuple[Indices, Indices]:
        """Of the columns of a ``joint`` their places in z, and which columns these are: those of a body that
        is carried stand in two places."""
        columns = self.layout.columns(joint)
        which = np.arange(len(columns))
        if self.carried[log] < 0:
            return columns, which
        last = np.flatnonzero(columns == self.layout.link(self.layout.n - 1)[0])[0] + np.arange(10)
        body = self.body(self.layout.n + self.carried[log])
        return np.concatenate([columns, body]), np.concatenate([which, last])

    def start(self) -> Floats:
        """Values inside the cone, near the prior's."""
        z = self.mean.copy()
        for k in np.flatnonzero(self.rigid).tolist():
            z[self.body(k)] = inside(z[self.body(k)], *self.sizes[k], START_SHARE)
        at = self.positive[self.free[self.positive]]
        z[at] = np.maximum(z[at], START_SHARE * self.sd[at])
        return z


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """A fit: values ``z``; ``weights`` [n] of the joints (1 / variance / correlation); ``curvature`` [p, p]
    of the data, and that of the ``prior`` (diagonal); ``noise`` [n]: RMS of what is left."""

    z: Floats
    weights: Floats
    curvature: Floats
    prior: Floats
    noise: Floats


def normal(unknowns: Unknowns, blocks: Sequence[Block], weights: Floats, z: Floats) -> tuple[Floats, Floats]:
    """Curvature [p, p] and right-hand side [p] of the weighted squares, linearised about the gains of z."""
    H, h = np.zeros((unknowns.size, unknowns.size)), np.zeros(unknowns.size)
    scale = unknowns.scales(z)
    for carried in sorted(set(unknowns.carried)):
        own = [block for block in blocks if unknowns.carried[block.log] == carried]
        if not own:
            continue
        x = unknowns.parameters(z, own[0].log)
        for j in range(unknowns.layout.n):
            places, which = unknowns.places(own[0].log, j)
            G = np.sum([block.gram[j] for block in own], axis=0)
            b = np.sum([block.right[j] for block in own], axis=0)
            s, w = scale[j], weights[j]
            _add(H, places, w * s * s * G[np.ix_(which, which)])
            if not unknowns.gains:
                np.add.at(h, places, w * b[which])
                continue
            # A torque is s A x + (A x0) (gain - last gain), about x0 and the last gain s - 1.
            at, last = unknowns.gain[j], x[unknowns.layout.columns(j)]
            curved = G @ last
            np.add.at(h, places, w * s * (b + (s - 1) * curved)[which])
            np.add.at(H, (places, at), w * s * curved[which])
            np.add.at(H, (at, places), w * s * curved[which])
            H[at, at] += w * float(last @ curved)
            h[at] += w * (float(last @ b) + (s - 1) * float(last @ curved))
    return H, h


def misfits(unknowns: Unknowns, blocks: Sequence[Block], z: Floats) -> Floats:
    """Weighted squares [blocks, n] that z leaves."""
    scale = unknowns.scales(z)
    left = []
    for block in blocks:
        x = unknowns.parameters(z, block.log)
        own = []
        for j, s in enumerate(scale):
            at = s * x[unknowns.layout.columns(j)]
            own.append(float(block.square[j] - 2 * at @ block.right[j] + at @ block.gram[j] @ at))
        left.append(own)
    return np.asarray(np.maximum(np.array(left), 0.0))


def scores(unknowns: Unknowns, blocks: Sequence[Block], weights: Floats, z: Floats) -> Floats:
    """Gradients [blocks, p] of half the weighted squares at z, less is better."""
    scale = unknowns.scales(z)
    gradients = np.zeros((len(blocks), unknowns.size))
    for row, block in zip(gradients, blocks, strict=True):
        x = unknowns.parameters(z, block.log)
        for j, (s, w) in enumerate(zip(scale, weights, strict=True)):
            places, which = unknowns.places(block.log, j)
            at = x[unknowns.layout.columns(j)]
            slope = w * (s * block.gram[j] @ at - block.right[j])
            np.add.at(row, places, s * slope[which])
            if unknowns.gains:
                row[unknowns.gain[j]] += at @ slope
    return gradients


def solve(unknowns: Unknowns, blocks: Sequence[Block], likeness: Floats, *, rounds: int = ROUNDS) -> Solution:
    """The best z for some blocks. ``likeness`` [n]: how many samples of a joint say what one says."""
    z, free, cone = unknowns.start(), np.flatnonzero(unknowns.free), unknowns.cone
    start = z.copy()
    count = np.maximum(np.sum([block.weight for block in blocks], axis=0), 1e-300)
    torque = np.sum([block.square for block in blocks], axis=0)
    least = count * LEAST_NOISE**2
    weights = count / np.maximum(torque, least) / likeness
    precision = 1 / unknowns.sd**2
    squares = torque
    for _ in range(rounds):
        H, h = normal(unknowns, blocks, weights, z)
        total, right = H + np.diag(precision), h + precision * unknowns.mean
        z = minimum(total, right, cone, start, free)
        squares = misfits(unknowns, blocks, z).sum(axis=0)
        squares = np.maximum(squares, 1e-10 * torque)
        weights = count / np.maximum(squares, least) / likeness
        precision = _precision(unknowns, z)
    H, _ = normal(unknowns, blocks, weights, z)
    return Solution(z, weights, H, precision, np.sqrt(squares / count))


def _precision(unknowns: Unknowns, z: Floats) -> Floats:
    """That of the prior [p]: less for links whose numbers are farther off than they should be."""
    precision = 1 / unknowns.sd**2
    for k in range(len(unknowns.sizes)):
        body = unknowns.body(k)
        off = float(((z[body] - unknowns.mean[body]) ** 2 * precision[body]).sum())
        precision[body] *= min(1.0, (PRIOR_FREEDOM + len(body)) / (PRIOR_FREEDOM + off))
    return precision


def _add(H: Floats, places: Indices, block: Floats) -> None:
    """``block`` [p, p] onto ``H`` at ``places``, which may repeat."""
    np.add.at(H, (places[:, None], places[None, :]), block)
