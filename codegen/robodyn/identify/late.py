"""How late torques are read: what a common delay of all torques of a log would take off the residuals.

A torque that is read late by d is less by d times its rate, to first order. The column -dtau/dt of each log
stands beside all that is fitted, and takes what the other columns leave of it (Frisch and Waugh 1933).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from robodyn.arrays import Floats
from robodyn.identify.consistent import solve_definite
from robodyn.identify.normal import Block
from robodyn.identify.problem import Solution, Unknowns, scores


def delays_of(
    unknowns: Unknowns, blocks: Sequence[Block], solution: Solution, likeness: Floats
) -> tuple[Floats, Floats]:
    """By how much [s] the torques of each log are late, and standard errors: not less than by blocks (Liang
    and Zeger 1986), nor than samples say that are ``likeness`` [n] times wider than the weights have it."""
    z, scale, free = solution.z, unknowns.scales(solution.z), np.flatnonzero(unknowns.free)
    H = (solution.curvature + np.diag(solution.prior))[np.ix_(free, free)]
    each = scores(unknowns, blocks, solution.weights, z)[:, free]
    found = []
    for log in range(len(unknowns.carried)):
        x, shared = unknowns.parameters(z, log), np.zeros(unknowns.size)
        size, scatter, slopes = 0.0, 0.0, np.zeros(len(blocks))
        for k, block in enumerate(blocks):
            if block.log != log:
                continue
            for j, (late, w) in enumerate(zip(block.late, solution.weights, strict=True)):
                places, which = unknowns.places(log, j)
                *products, torque, own = late
                columns = np.array(products)
                np.add.at(shared, places, w * scale[j] * columns[which])
                slopes[k] += w * (torque - scale[j] * float(x[unknowns.layout.columns(j)] @ columns))
                size += w * own
                scatter += w * own * likeness[j]
        taken = solve_definite(H, shared[free])
        left = max(size - float(shared[free] @ taken), 1e-300)
        slopes += each @ taken
        squares = float(slopes @ slopes) * len(blocks) / max(len(blocks) - 1, 1)
        found.append(
            (float(slopes.sum()) / left, np.sqrt(max(squares, scatter * left / size) if size else 0) / left)
        )
    delays, errors = np.array(found).T
    return delays, errors
