"""What shows at several joints: coupled motors, loads, the base, wrong numbers of the arm."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.select.library.candidate import Candidate, Context
from robodyn.diagnose.select.library.limits import (
    COUPLED_BEYOND_SHARE,
    COUPLED_FARTHEST,
    LINK_WRONG,
    LOAD_REACH,
    LOAD_SHARE,
    LOAD_SIZE,
    PAIR_RATIOS,
    TILT,
)
from robodyn.effects.effect import Effect, Site
from robodyn.effects.traits import Shown
from robodyn.identify.prior import sizes_of as sizes_of_links
from robodyn.kernels.array_dynamics import PARAMETERS, Model, physical
from robodyn.robot.model import AXES
from robodyn.simulate.sensors import measured_slopes


def pairs(c: Context, effect: Effect, shown: Shown, j: int, k: int) -> Iterator[Candidate]:
    """A motor of joint ``j`` that turns with ``k``, further in: on both joints. No shaft reaches far, but
    what far ones would explain is not noise either."""
    s, equation = c.signals, effect.equation
    assert equation is not None
    share = COUPLED_BEYOND_SHARE if j - k > 1 else 0.0
    for ratio in PAIR_RATIOS:
        u, rate = s.qd[:, j] + ratio * s.qd[:, k], s.qdd[:, j] + ratio * s.qdd[:, k]
        site = Site(True, qd=u, qdd=rate, direction=c.model.direction_of(u, {j: 1.0, k: ratio}))
        parts = [
            np.asarray(equation({name: float(name == one) for name in effect.linear}, site))
            for one in effect.linear
        ]
        columns = np.stack([np.stack([x, ratio * x], axis=1) for x in parts], axis=2)

        def read(x: Floats, ratio: float = ratio) -> dict[str, float | str]:
            names = dict(zip(effect.linear, (float(v) for v in x), strict=True))
            return {"with": float(k + 1), "ratio": ratio, **names}

        yield Candidate(
            effect.id, j + 1, (j, k), columns, tuple(1 for _ in parts), read, shown.order,
            feasible=shown.feasible, least_share=share, likely=lambda x: j - k <= COUPLED_FARTHEST,
        )  # fmt: skip


def numbers(c: Context, effect: Effect, shown: Shown) -> Iterator[Candidate]:
    """What the rigid arm's own numbers would change: a body at the tip, a turned base, a link that is not as
    described."""
    fold = effect.traits.fold
    if effect.traits.body:
        yield _body(c, effect, shown)
    elif fold is not None and fold.into == "gravity":
        yield _tilt(c, effect, shown)
    elif fold is not None and fold.into == "link":  # from the tip: there they are fewest
        rows, Y, sizes = tuple(range(c.n)), _regressor(c), usual_sizes(c.model)
        for k in range(c.n - 1, -1, -1):
            link = c.model.robot.links[k]
            share = LINK_WRONG if link.confidence is None else float(link.inertial_share)
            yield Candidate(
                effect.id,
                k + 1,
                rows,
                Y[:, :, k],
                (0,) * 10,
                _standard,
                shown.order,
                coarse=True,
                scale=share * sizes[k],
            )


def _regressor(c: Context) -> Floats:
    """Torques [K, n, n, 10] by the numbers of each link; of coarse signals."""
    key = ("regressor", 0)
    if key not in c.kept:
        c.kept[key] = c.model.regressor(c.slow.q, c.slow.qd, c.slow.qdd)
    Y: Floats = c.kept[key]
    return Y


def without_regressor(c: Context) -> None:
    """Let go of the torques by the numbers of each link: they take much memory, and once all candidates have
    their columns nobody needs them."""
    c.kept.pop(("regressor", 0), None)


def regressor_seen(c: Context) -> Floats:
    """Torques [N, n, 10 n] by the numbers of all links, as the torque channel shows them, filtered and
    thinned like the torque."""
    key = ("regressor", 1)
    if key not in c.kept:
        s = c.slow
        flat = _regressor(c).reshape(len(s.q), c.n, -1)
        flat = measured_slopes(flat, s.t, c.model.robot.effects, s.tau)
        c.kept[key] = c.slow.thinned(c.slow.filtered(flat)).copy()
    Y: Floats = c.kept[key]
    return Y


def rotors_seen(c: Context) -> Floats:
    """Torques [N, n, n] by the rotor of each joint, as :func:`regressor_seen`."""
    s = c.slow
    columns = measured_slopes(s.qdd[:, :, None] * np.eye(c.n), s.t, c.model.robot.effects, s.tau)
    return np.asarray(s.thinned(s.filtered(columns)))


def _body(c: Context, effect: Effect, shown: Shown) -> Candidate:
    def read(x: Floats) -> dict[str, float | str]:
        names = ("mass", "com_x", "com_y", "com_z", *(f"inertia_{axes}" for axes in AXES))
        return dict(zip(names, (float(v) for v in physical(x)), strict=True))

    return Candidate(
        effect.id, None, tuple(range(c.n)), _regressor(c)[:, :, -1], (1, *(0,) * 9), read, shown.order,
        coarse=True, feasible=lambda x: bool(x[0] > 0 and np.linalg.norm(x[1:4]) < LOAD_REACH * x[0]),
        scale=sizes_of(LOAD_SHARE * float(c.model.standard_parameters()[:, 0].sum()), LOAD_SIZE),
    )  # fmt: skip


def sizes_of(mass: float, length: float) -> Floats:
    """Standard parameters [10] that are usual of a body of a mass [kg] and a length [m]."""
    return np.asarray(max(mass, 1e-6) * np.concatenate([[1.0], np.full(3, length), np.full(6, length**2)]))


def usual_sizes(model: Model) -> Floats:
    """Standard parameters [n, 10] that are usual of the arm's links."""
    return np.stack([sizes_of(mass, length) for mass, length in sizes_of_links(model.robot)])


def _tilt(c: Context, effect: Effect, shown: Shown) -> Candidate:
    gx, gy, gz = (float(g) for g in c.model.robot.gravity)
    # d g / d tilt_x and d g / d tilt_y
    tilts = [_gravity_by(c, turned) for turned in ((0.0, -gz, gy), (gz, 0.0, -gx))]
    return Candidate(
        effect.id, None, tuple(range(c.n)), np.stack(tilts, axis=2), (0, 0),
        lambda x: {"tilt_x": float(x[0]), "tilt_y": float(x[1])}, shown.order, coarse=True,
        feasible=lambda x: bool(np.abs(x).max() < TILT),
    )  # fmt: skip


def _standard(x: Floats) -> dict[str, float | str]:
    return dict(zip(PARAMETERS, (float(v) for v in x), strict=True))


def _gravity_by(c: Context, change: tuple[float, float, float]) -> Floats:
    """Torques [K, n] by a change of gravity (they are linear in it); of coarse signals."""
    s, zeros = c.slow, np.zeros_like(c.slow.q)
    x, y, z = (Fraction(g) for g in change)
    return Model(replace(c.model.robot, gravity=(x, y, z))).rigid_torque(s.q, zeros, zeros)
