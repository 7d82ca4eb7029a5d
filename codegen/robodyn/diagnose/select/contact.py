"""Contact with something outside: a burst in time that a force on one link explains.

It is looked for before anything else, and its window is left out of the fit: what happens once in a log
cannot be judged on parts of it that were left out."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.fit import Problem
from robodyn.diagnose.select.library import Candidate, Context
from robodyn.diagnose.select.limits import (
    BURST_EXPLAINED,
    BURST_FACTOR,
    BURST_GAP,
    BURST_LENGTH,
    BURST_SHARE,
    START_SPEED,
    START_TIME,
)
from robodyn.dynamics.kinematics import frames, jacobian
from robodyn.effects.rigid import CONTACT

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Contact:
    """A contact: ``mask`` [N] of the problem's rows, the candidate and its forces ``x`` [3] in N."""

    mask: NDArray[np.bool_]
    candidate: Candidate
    columns: Floats
    x: Floats
    stderr: Floats
    explained: float


def contact_in(c: Context, start: Problem) -> Contact | None:
    """The contact that stands out of the residual of one log, if there is one."""
    window = _window(c, start)
    if window is None:
        return None
    mask, begin, end = window
    s = c.slow
    placed = frames(c.model.arm, c.model.motion(s.q, s.qd, s.qdd))
    zeros = np.zeros(len(s.t))
    best: Contact | None = None
    for link in range(1, c.n + 1):
        rows = jacobian(c.model.arm, placed, link=link)[:3]
        full = -np.stack(
            [np.stack([entry + zeros for entry in row], axis=1) for row in rows], axis=2
        )  # [K, n, 3]
        columns = s.thinned(full)
        A = (columns / start.sigma[None, :, None])[mask].reshape(-1, 3)
        b = start.rest[mask].reshape(-1)
        x, *_ = np.linalg.lstsq(A, b, rcond=1e-6)
        left = b - A @ x
        explained = 1 - float(left @ left) / float(b @ b)
        if best is not None and explained <= best.explained:
            continue
        spread = np.linalg.pinv(A.T @ A) * float(left @ left) / len(left) * start.thin
        edges = {"start": float(begin), "end": float(end), "link": float(link)}

        def read(v: Floats, edges: dict[str, float] = edges) -> dict[str, float | str]:
            forces = {f"force_{axis}": float(f) for axis, f in zip("xyz", v, strict=True)}
            return {**edges, **forces}

        candidate = Candidate(CONTACT.id, None, tuple(range(c.n)), full, (0, 0, 0), read, 5, coarse=True)
        masked = columns * mask[:, None, None]
        error: Floats = np.sqrt(np.diag(spread)).astype(np.float64)
        best = Contact(mask, candidate, masked, x.astype(np.float64), error, explained)
    return best if best is not None and best.explained > BURST_EXPLAINED else None


def _window(c: Context, start: Problem) -> tuple[NDArray[np.bool_], float, float] | None:
    """Where in time the residual bursts: rows of the problem, beginning and end [s]."""
    s = c.slow
    t = s.thinned(s.t)
    energy = np.sum(start.rest**2, axis=1)
    step = float(t[1] - t[0])
    wide = max(1, int(0.1 / step))
    smooth = np.convolve(energy, np.ones(wide) / wide, mode="same")
    middle = float(np.median(smooth))
    loud = np.nonzero(smooth > BURST_FACTOR * max(middle, start.n))[0]
    if not len(loud):
        return None
    cuts = np.nonzero(np.diff(loud) > BURST_GAP / step)[0]
    bursts = np.split(loud, cuts + 1)
    burst = max(bursts, key=lambda rows: float(energy[rows].sum()))
    first, last = int(burst[0]), int(burst[-1])
    excess = np.maximum(energy - 2 * middle, 0.0)
    if (last - first) > BURST_LENGTH * len(t) or excess[first : last + 1].sum() < BURST_SHARE * excess.sum():
        return None
    if _sticks(c, start, t, slice(first, last + 1)):
        return None
    mask = np.zeros(len(t), bool)
    mask[first : last + 1] = True
    return mask, float(t[first]), float(t[last])


def _sticks(c: Context, start: Problem, t: Floats, burst: slice) -> bool:
    """Whether a burst is of joints that set out or come to rest: friction holds them with any torque."""
    if t[burst][-1] > t[0] + START_TIME and t[burst][0] < t[-1] - START_TIME:
        return False
    speed = np.abs(c.slow.thinned(c.slow.qd))
    slow = speed[burst] < START_SPEED * speed.max(axis=0)
    squares = start.rest[burst] ** 2
    return bool(squares[slow].sum() > squares.sum() / 2)
