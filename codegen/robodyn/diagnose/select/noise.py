"""What of the rows is noise: what no candidate explains at a joint, however many numbers it takes.

A fit of everything at once leaves the noise and no structure; the sensors' own noise is its floor.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.diagnose.select.families import Family
from robodyn.diagnose.select.library import regressor_seen
from robodyn.diagnose.select.limits import BLOCKS, TOLERANCE
from robodyn.diagnose.select.remainder import remainder
from robodyn.diagnose.select.rows import Rows, with_noise
from robodyn.effects.catalogue import CATALOGUE
from robodyn.kernels.array_dynamics import Model as ArrayModel
from robodyn.robot.model import Robot


def rest_of(robot: Robot, rows: Rows) -> Floats:
    """What ``robot`` leaves of the logs [N, n], filtered."""
    model = ArrayModel(robot, sticking=rows.speeds)
    return np.concatenate([remainder(model, c) for c in rows.contexts])


def _numbers(rows: Rows) -> Floats:
    """Torques [N, n, p] by all numbers of the links, by rotors, and what is constant."""
    by_links = np.concatenate([regressor_seen(c) for c in rows.contexts])
    more = np.stack([np.ones_like(rows.seen("q")), rows.seen("qd"), rows.seen("qdd")], axis=2)
    return np.concatenate([by_links, more], axis=2)


def _unexplained(
    y: Floats, others: Floats, found: Sequence[Family], j: int, moves: NDArray[np.bool_]
) -> tuple[Floats, int]:
    """What is left [N] at joint ``j`` (from 0) of ``y`` [N] by all that is linear there, where it ``moves``
    [N] (0 elsewhere), and how many numbers that took."""
    parts: list[NDArray[Any]] = [others]
    for one in found:
        if j in one.rows and one.scale is None and not one.first.fixed and not one.second:
            few = one.columns[:: max(1, len(one.columns) // 4)]
            parts.append(few[:, :, one.rows.index(j)].transpose(1, 0, 2).reshape(len(y), -1))
    A = np.concatenate(parts, axis=1).astype(np.float64) * moves[:, None]
    A, y = A / np.maximum(np.sqrt(np.mean(A**2, axis=0)), 1e-300), y * moves
    U, sizes, _ = np.linalg.svd(A[:, np.abs(A).max(axis=0) > 0], full_matrices=False)
    U = U[:, sizes > TOLERANCE * sizes[0]]
    return y - U @ (U.T @ y), U.shape[1]


def with_noise_of(rows: Rows, found: Sequence[Family], dry: Floats) -> Rows:
    """The ``rows`` with the noise that all candidates ``found`` leave of them, and its correlation. At rest a
    joint with ``dry`` friction [n], or with some that is described, says nothing of noise."""
    rest, others = rest_of(rows.robot, rows), _numbers(rows)
    n = rows.n
    sigma, correlation = np.zeros(n), np.ones(n)
    for j in range(n):
        moves = _moves(rows, j) | (rows.level[j] + dry[j] == 0)
        count = int(moves.sum())
        left, numbers = _unexplained(rest[:, j], others[:, j], found, j, moves)
        left, numbers = _pursued(left, numbers, found, j, moves)
        sigma[j] = np.sqrt(left @ left / max(count - numbers, count / 4))
        correlation[j] = _correlation(left, rows.rate)
    return with_noise(rows, np.maximum(sigma, rows.floor), correlation, rows.level)


def _pursued(
    left: Floats, numbers: int, found: Sequence[Family], j: int, moves: NDArray[np.bool_]
) -> tuple[Floats, int]:
    """The same less what candidates of known size explain, the best three one after another."""
    n = len(left)
    own = [one for one in found if j in one.rows and one.first.fixed]
    for _ in range(3):
        best = float(left @ left) * (1 - 10 * np.log(n) / n)
        rest = None
        for one in own:
            z = one.columns[:, :, one.rows.index(j), 0].astype(np.float64) * moves
            sizes = np.maximum(np.sum(z * z, axis=1), 1e-300)
            gains = (z @ left) ** 2 / sizes
            k = int(np.argmax(gains))
            if left @ left - gains[k] < best:
                best = float(left @ left - gains[k])
                rest = left - z[k] * (z[k] @ left) / sizes[k]
        if rest is None:
            break
        left, numbers = rest, numbers + 3
    return left, numbers


def _correlation(left: Floats, rate: float) -> float:
    """How many rows say what one says: the sum of the autocorrelation while it is positive (Geyer 1992)."""
    size = float(left @ left)
    if size <= 0:
        return 1.0
    lags = range(1, max(2, min(int(rate), len(left) // 2)))
    each = np.array([float(left[:-lag] @ left[lag:]) / size for lag in lags])
    negative = np.flatnonzero(each < 0)
    return float(max(1.0, 1 + 2 * each[: negative[0] if len(negative) else None].sum()))


def dry_friction(rows: Rows, found: Sequence[Family]) -> Floats:
    """Dry friction [n] (N m or N) beside what is described, as rows in motion show it, where it is three
    standard errors or more."""
    rest = rest_of(rows.robot, rows)
    return np.array([_dry(rest[:, j], rows, found, j) for j in range(rows.n)])


def _dry(y: Floats, rows: Rows, found: Sequence[Family], j: int) -> float:
    steps = [
        one for one in found if one.first.joint == j + 1 and not one.second and _is_step(one.first.effect)
    ]
    if not steps:
        return 0.0
    q = np.concatenate([c.signals.thinned(c.signals.q[:, j]) for c in rows.contexts])
    qd, qdd = rows.seen("qd")[:, j], rows.seen("qdd")[:, j]
    smooth = np.stack([qd, qdd, np.ones_like(q), q, np.sin(q), np.cos(q)], axis=1)
    A = np.concatenate([steps[0].columns[0, :, 0].astype(np.float64), smooth], axis=1)
    size = np.maximum(np.sqrt(np.mean(A**2, axis=0)), 1e-300)
    at_rest = np.clip(rows.unresolved[:, j], 0.0, 1.0)
    moves = _moves(rows, j)
    variance, level, error = np.where(moves, 1.0, 1e6), 0.0, 0.0
    for _ in range(5):  # least squares with weights by what the last one left, and what it left at rest open
        w = 1 / np.sqrt(variance)
        x = np.linalg.lstsq(A / size * w[:, None], y * w, rcond=1e-8)[0] / size
        left = y - A @ x
        level = max(0.0, float(x[0]))
        white = float(np.median(left[moves] ** 2)) / 0.455  # the median of a squared normal deviate
        variance = np.maximum(white, left**2 / 4) + (rows.level[j] + level) ** 2 * at_rest
        normal = (A / size).T @ (A / size / variance[:, None])
        error = float(np.sqrt(np.linalg.pinv(normal)[0, 0])) / size[0]
    return level if level > 3 * error else 0.0


def _moves(rows: Rows, j: int) -> NDArray[np.bool_]:
    """Which rows [N] know the direction of joint ``j`` (from 0); all, if those are less than a block."""
    moves = np.asarray(rows.unresolved[:, j] < 0.5)
    return moves if moves.mean() > 1 / BLOCKS else np.ones_like(moves)


def _is_step(effect: str) -> bool:
    """Whether it is the plain step of dry friction."""
    fold = CATALOGUE[effect].traits.fold
    return fold is not None and fold.key == "coulomb"
