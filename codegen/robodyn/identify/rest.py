"""Rest: below which speed a joint's direction of motion is not resolved, and what its torque then says.

At rest dry friction is a set and not a value. Of a speed v that is not resolved the sign is +1 or -1 with the
mean s = v / v0 (at most 1), so that friction of the level F has the mean F s and the variance F^2 (1 - s^2):
a row at rest says that its torque lies within the level, by its first two moments (Karnopp 1985).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats
from robodyn.dynamics.arm import Arm
from robodyn.identify.normal import Layout, chunks_of, columns_of
from robodyn.identify.plain import shortest
from robodyn.identify.rows import Rows, direction


@dataclass(frozen=True, slots=True, eq=False)
class Rest:
    """What is known of joints at rest [n]: ``speeds`` below which directions are not resolved; ``sigma``: RMS
    of what is left of rows whose direction is; ``spread``: standard deviation of the torque at rest."""

    speeds: Floats
    sigma: Floats
    spread: Floats

    @property
    def wider(self) -> Floats:
        """By how much the variance at rest is larger than that of what is left beside [n], as a multiple."""
        return np.asarray((self.spread / np.maximum(self.sigma, 1e-300)) ** 2)

    def weights(self, rows: Rows) -> Floats:
        """What rows count beside those whose direction is resolved [M, n]."""
        return np.asarray(1 / (1 + self.wider * rows.unresolved))

    @property
    def silent(self) -> Floats:
        """Speeds [n] below which a joint's torque says less of it than that it lies within its friction: the
        set is wider than what is left beside."""
        return np.asarray(self.speeds * np.sqrt(np.maximum(0.0, 1 - 1 / np.maximum(self.wider, 1e-300))))


def half_decades(rms: Floats, noise: Floats, decades: int = 4) -> Floats:
    """Speeds [m, n] of which one may be that of rest: half decades from the ``rms`` speeds [n] down, as far
    as the encoders' ``noise`` [n] lets a speed be told from rest. Four ``decades`` below, none is resolved
    by a log."""
    return np.asarray(np.maximum(rms * 10.0 ** (-0.5 * np.arange(2 * decades + 1)[:, None]), noise))


def rest_speeds(arm: Arm, layout: Layout, pieces: Sequence[Rows]) -> Floats:
    """Speeds [n] below which directions are not resolved: of half decades that with which least squares of
    the joint's own torque leave least of the blocks that are not held out."""
    count = sum(len(rows.qd) for rows in pieces)
    usual = np.sqrt(sum((rows.qd**2).sum(axis=0) for rows in pieces) / max(count, 1))
    noise = np.max([rows.signals.speed_noise for rows in pieces], axis=0)
    tried = half_decades(usual, noise)
    sizes = [len(layout.columns(j)) + len(tried) for j in range(layout.n)]
    grams = [np.zeros((size, size)) for size in sizes]  # all columns, and directions by every speed tried
    rights, squares = [np.zeros(size) for size in sizes], np.zeros(layout.n)
    for rows in (piece.unfiltered() for piece in pieces):
        ways = [direction(rows.qd, speeds) for speeds in tried]
        for part in chunks_of(rows.block):
            if rows.held_out[rows.block[part.start]]:
                continue
            for j, own in enumerate(columns_of(arm, layout, rows, part)):
                used = rows.used[part, j].astype(np.float64)
                A = np.concatenate([own, [way[part, j] for way in ways]]) * used
                tau = rows.tau[part, j] * used
                grams[j] += A @ A.T
                rights[j] += A @ tau
                squares[j] += tau @ tau
    best = []
    for j, (G, b) in enumerate(zip(grams, rights, strict=True)):
        p = len(b) - len(tried)
        left = []
        for k in range(len(tried)):
            use = np.ones(len(b), dtype=bool)
            use[p:] = False
            use[p + k] = True
            use[p - len(layout.own) + layout.own.index("coulomb")] = False
            x = shortest(G, b, use)
            left.append(float(squares[j] - 2 * x @ b + x @ G @ x))
        best.append(tried[int(np.argmin(left)), j])
    return np.array(best)


def rest_of(speeds: Floats, sigma: Floats, pieces: Sequence[Rows], left: Sequence[Floats]) -> Rest:
    """Rest below ``speeds`` [n], by what is ``left`` [M, n] of each piece: the variance at rest is how fast
    squares grow with 1 - s^2."""
    squares = np.concatenate(left) ** 2
    u = np.concatenate([rows.unresolved for rows in pieces])
    u = u - u.mean(axis=0)
    slope = (squares * u).sum(axis=0) / np.maximum((u**2).sum(axis=0), 1e-300)
    return Rest(speeds, sigma, np.sqrt(np.maximum(slope, 0.0)))
