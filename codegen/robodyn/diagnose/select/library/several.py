"""What shows at several joints: coupled motors, loads, the base, delays, wrong numbers of the arm."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.library.candidate import Candidate, Context
from robodyn.diagnose.select.rigid import PARAMETERS, Model, physical
from robodyn.robot.model import AXES

Floats = NDArray[np.float64]


def coupling(c: Context, j: int, k: int) -> Iterator[Candidate]:
    """A motor of joint ``j`` that turns with ``k``, further in: on both joints."""
    s = c.signals
    for ratio in (1.0, -1.0):
        u, rate = s.qd[:, j] + ratio * s.qd[:, k], s.qdd[:, j] + ratio * s.qdd[:, k]
        parts = [rate, u, np.sign(u)]
        columns = np.stack([np.stack([x, ratio * x], axis=1) for x in parts], axis=2)

        def read(x: Floats, k: int = k, ratio: float = ratio) -> dict[str, float | str]:
            names = dict(zip(("inertia", "viscous", "coulomb"), (float(v) for v in x), strict=True))
            return {"with": float(k + 1), "ratio": ratio, **names}

        yield Candidate("motor_coupling", j + 1, (j, k), columns, (1, 1, 1), read, 5)


def whole(c: Context) -> Iterator[Candidate]:
    """Of the whole robot, and wrong numbers of its links, from the tip: there they are fewest."""
    s, rows = c.slow, tuple(range(c.n))
    Y = c.model.regressor(s.q, s.qd, s.qdd)

    def body(x: Floats) -> dict[str, float | str]:
        names = ("mass", "com_x", "com_y", "com_z", *(f"inertia_{axes}" for axes in AXES))
        return dict(zip(names, (float(v) for v in physical(x)), strict=True))

    yield Candidate(
        "payload", None, rows, Y[:, :, -1], (1, *(0,) * 9), body, 6, coarse=True,
        feasible=lambda x: bool(x[0] > 0 and np.linalg.norm(x[1:4]) < 0.7 * x[0]),
    )  # fmt: skip
    gx, gy, gz = (float(g) for g in c.model.robot.gravity)
    # d g / d tilt_x and d g / d tilt_y
    tilts = [_gravity_by(c, turned) for turned in ((0.0, -gz, gy), (gz, 0.0, -gx))]
    yield Candidate(
        "base_tilt", None, rows, np.stack(tilts, axis=2), (0, 0),
        lambda x: {"tilt_x": float(x[0]), "tilt_y": float(x[1])}, 3, coarse=True,
        feasible=lambda x: bool(np.abs(x).max() < 0.3),
    )  # fmt: skip
    late = -np.gradient(s.filtered(c.at_slow.total), s.period, axis=0)
    yield Candidate(
        "time_delay", None, rows, late[:, :, None], (1,), lambda x: {"delay": float(x[0])}, 2, coarse=True
    )
    for k in range(c.n - 1, -1, -1):
        yield Candidate("inertial_error", k + 1, rows, Y[:, :, k], (0,) * 10, _standard, 8, coarse=True)


def _standard(x: Floats) -> dict[str, float | str]:
    return dict(zip(PARAMETERS, (float(v) for v in x), strict=True))


def _gravity_by(c: Context, change: tuple[float, float, float]) -> Floats:
    """Torques [K, n] by a change of gravity (they are linear in it); of coarse signals."""
    s, zeros = c.slow, np.zeros_like(c.slow.q)
    x, y, z = (Fraction(g) for g in change)
    return Model(replace(c.model.robot, gravity=(x, y, z))).evaluate(s.q, zeros, zeros).rigid
