"""Rows of numbers that no arm has made, and a model that is fitted to them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.members import Fit, Member, Model, solve
from robodyn.diagnose.select.rows import Rows
from robodyn.robot import load

Floats = NDArray[np.float64]


def rows_of_numbers(count: int, sigma: Floats, unresolved: Floats, correlation: float = 1.0) -> Rows:
    """Rows [count, n] of noise ``sigma`` [n], with friction of which some say a set, in ten blocks."""
    n = len(sigma)
    blocks = np.arange(count).reshape(10, -1)[:, 1:-1]
    return Rows(
        load("puma560_3dof", warn=lambda _: None), (), blocks, np.full(n, 0.01), unresolved, 0.01 * sigma,
        sigma, np.full(n, correlation), np.full(n, 2.0), np.full(n, 0.01),
    )  # fmt: skip


def fit_of(rows: Rows, y: Floats, own: Floats, slopes: Floats, members: tuple[Member, ...] = ()) -> Fit:
    """The fit to ``y`` [N, n] of ``own`` numbers [N, n, p] that are held, and of free ones, whose ``slopes``
    [N, n, P] are these."""
    columns: Any = np.concatenate([own, slopes], axis=2)
    held = np.concatenate([np.ones(own.shape[2]), np.zeros(slopes.shape[2])])
    x, cost = solve(columns, held, y, rows.weight)
    return Fit(Model(rows, own, members), y, columns, held, x, cost)
