"""The arm's numbers fitted to a reading of a log, and how well seven eighths of the log predict the other.

The torque of the description is added to the rigid regressor (Atkeson, An and Hollerbach 1986) of all links
with a Gaussian about the description's numbers, and by joint what rubs, leans or is a rotor. How likely a
reading is is the held-out log-likelihood of blocks (Breiman and Spector 1992), with what the numbers have to
bear against their prior; rows that say the same count once together.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache

import numpy as np

from robodyn.arrays import Floats
from robodyn.gate import limits
from robodyn.gate.readings import Reading
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import Robot
from robodyn.robot.values import ZERO

#: Which columns of a joint's own rub: a bias, a slope with its position and its acceleration, as of springs
#: and rotors; then friction with the speed, its direction, between the two, and with the load.
_RUBS = np.array([False, False, False, True, True, True, True])
_OWN = len(_RUBS)


@dataclass(frozen=True, slots=True, eq=False)
class States:
    """Samples of a log, [K, n] each, in :data:`.limits.BLOCKS` of one length each; ``torque`` reads
    them so many seconds later. Where ``way``, the direction of motion, is not resolved, dry friction is a set
    (Karnopp 1985): a torque counts by its square."""

    q: Floats
    qd: Floats
    qdd: Floats
    way: Floats
    torque: Callable[[float], Floats]


@dataclass(frozen=True, slots=True, eq=False)
class Table:
    """A reading along the log: ``columns`` [n, K, r + 8] (rigid, of the joint, torque less the model's), the
    model's torque ``model`` [n, K], weights [n, K], by which factor torques were multiplied [n], and the
    variance [n] that filters leave of them."""

    columns: Floats
    model: Floats
    weight: Floats
    factor: Floats
    floor: Floats

    def grams(self, extra: Floats | None = None) -> Floats:
        """Products of columns in each block [B, n, L, L], with an ``extra`` column [n, K] before all."""
        A = self.columns if extra is None else np.concatenate([extra[..., None], self.columns], axis=2)
        blocks = A.reshape(len(A), limits.BLOCKS, -1, A.shape[2]).swapaxes(0, 1)
        weights = self.weight.reshape(len(A), limits.BLOCKS, -1, 1).swapaxes(0, 1)
        return np.asarray(blocks.swapaxes(2, 3) @ (blocks * weights))

    @property
    def counts(self) -> Floats:
        """Rows of each block by weight [B, n]."""
        return np.asarray(self.weight.reshape(len(self.weight), limits.BLOCKS, -1).sum(axis=2).T)


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """Numbers ``x`` [..., r] less the description's, those of the joints ``own`` [..., n, 7], variances left
    [..., n], what the prior has against them [...], and standard error of the first number."""

    x: Floats
    own: Floats
    variance: Floats
    penalty: Floats
    error: Floats


class ArmFit:
    """Fits of the arm of ``robot`` to readings of ``states``."""

    def __init__(self, robot: Robot, states: States) -> None:
        self.states, self.n = states, robot.n
        self._robot = _without_friction(robot)
        self._model = Model(self._robot)
        sd = _prior(robot, self._model)
        x = np.random.default_rng(0).standard_normal((3, 5 * robot.n, robot.n))
        Y = self._model.regressor(*x).reshape(-1, len(sd)) * sd
        size, directions = np.linalg.svd(Y, full_matrices=False)[1:]
        #: The numbers by base parameters [10 n, r] (Gautier 1991), the prior's deviation of each being 1.
        self._base = sd[:, None] * directions[size > 1e-9 * size[0]].T
        self.r = self._base.shape[1]
        #: Bias and friction, without what is like a pendulum.
        self.friction = self.r + np.array([0, 3, 4, 5])
        self._along = lru_cache(8)(self._states)
        #: How many rows say the same, by joint.
        self.same = np.ones(robot.n)

    def table(self, reading: Reading) -> Table:
        """The ``reading`` along the log."""
        columns, model = self._along(
            reading.order, reading.scale, reading.zero, reading.gravity, reading.down, reading.clock
        )
        channels, factor = list(reading.tau_order), np.array(reading.tau_scale)
        tau = self.states.torque(reading.late)[:, channels] * factor
        table = np.concatenate([columns, (tau.T - model)[..., None]], axis=2)
        floor = (limits.FILTER_SHARE * tau.std(axis=0)) ** 2 + 1e-18
        return Table(table, model, (self.states.way[:, channels] ** 2).T, np.abs(factor), floor)

    def _states(
        self, order: tuple[int, ...], scale: tuple[float, ...], zero: tuple[float, ...], gravity: str,
        down: tuple[float, ...], clock: float,
    ) -> tuple[Floats, Floats]:  # fmt: skip
        """The columns [n, K, r + 7] of states read so, and the model's torque [n, K]."""
        s = self.states
        q, qd, qdd, way = (x[:, list(order)] * np.array(scale) for x in (s.q, s.qd, s.qdd, s.way))
        q, qd, qdd = q - np.array(zero), clock * qd, clock**2 * qdd
        arm = self._under(down) if down else self._model
        Y, m = arm.regressor(q, qd, qdd), arm.torque(q, qd, qdd)
        if gravity != "whole":
            m = m - self._model.torque(q, 0 * q, 0 * q)
        if gravity == "none":
            Y = Y - self._model.regressor(q, 0 * q, 0 * q)
        Y = (Y.reshape(q.size, -1) @ self._base).reshape(*q.shape, -1)
        size = np.sqrt((qd**2).mean(axis=0)) + 1e-12
        own = [np.ones_like(q), q - q.mean(axis=0), qdd, qd, way, np.tanh(qd / size), np.abs(m) * way]
        table = np.stack(own, axis=2).swapaxes(0, 1)
        table = table / (np.sqrt((table**2).mean(axis=1, keepdims=True)) + 1e-12)
        return np.concatenate([Y.swapaxes(0, 1), table], axis=2), m.T

    def _under(self, gravity: Sequence[float]) -> Model:
        """The arm under another ``gravity`` [3], in the frame that it is described in."""
        x, y, z = map(Fraction, gravity)
        return Model(replace(self._robot, gravity=(x, y, z)))

    def gravity(self, table: Table) -> Floats:
        """The gravity [3] under which the arm as described leaves least of the torques beside friction."""
        q = self.states.q
        bare, *parts = (self._under(g).torque(q, 0 * q, 0 * q).T for g in np.eye(4, 3, -1).tolist())
        gravity = np.stack([part - bare for part in parts], axis=2)  # [n, K, 3]
        y = table.columns[..., -1:] + gravity @ np.array([*map(float, self._robot.gravity)])[:, None]
        A, weight = np.concatenate([gravity, y], axis=2), np.sqrt(table.weight)[..., None]
        rows = []
        for a, w, columns in zip(A, weight, table.columns, strict=True):
            friction = w * columns[:, self.friction]
            left = w * a - friction @ np.linalg.lstsq(friction, w * a, rcond=1e-9)[0]
            rows.append(left / (np.linalg.norm(left[:, -1]) + 1e-12))
        left = np.concatenate(rows)
        return np.asarray(np.linalg.lstsq(left[:, :3], left[:, 3], rcond=1e-9)[0])

    def solve(self, grams: Floats, counts: Floats, floor: Floats, looseness: float) -> Solution:
        """Least squares of ``grams`` [..., n, L, L] of ``counts`` [..., n] rows, the numbers' deviations
        ``looseness`` times what the description says. Friction that drives a joint is none."""
        extra = grams.shape[-1] - self.r - _OWN - 1
        r, o = self.r + extra, slice(self.r + extra, -1)
        precision = np.r_[np.full(extra, 1e-12), np.full(self.r, looseness**-2.0)]
        outer = [*range(r), -1]
        O, C = grams[..., o, o], grams[..., o, outer]
        ridge = 1e-9 * (np.trace(O, axis1=-2, axis2=-1)[..., None] + 1e-12) * np.ones(_OWN)
        inner = grams[..., outer, :][..., outer]
        variance = inner[..., -1, -1] / np.maximum(counts, 1e-9) + floor
        x = own = H = np.zeros(0)
        for turn in range(4):
            taken = np.linalg.solve(O + ridge[..., None] * np.eye(_OWN), C)
            S = inner - C.swapaxes(-1, -2) @ taken
            w = 1 / (variance * self.same)
            H = (w[..., None, None] * S).sum(axis=-3)
            H[..., range(r), range(r)] += precision
            x = np.linalg.solve(H[..., :r, :r], H[..., :r, -1:])[..., 0]
            z = np.concatenate([x, -np.ones((*x.shape[:-1], 1))], axis=-1)[..., None, :]
            own = -(taken @ z[..., None])[..., 0]
            power = (O[..., 3, :] * own * _RUBS).sum(axis=-1)
            if turn in (1, 2):
                ridge = np.where((power < 0)[..., None] & _RUBS, 1e9 * np.abs(ridge) + 1e9, ridge)
            squares = np.einsum("...i,...nij,...j->...n", z[..., 0, :], S, z[..., 0, :])
            variance = np.maximum(squares, 0) / np.maximum(counts, 1e-9) + floor
        penalty = 0.5 * (precision[extra:] * x[..., extra:] ** 2).sum(axis=-1)
        error = np.sqrt(np.linalg.inv(H[..., :r, :r])[..., 0, 0])
        return Solution(x, own, variance, penalty, error)

    def whole(self, table: Table, looseness: float = 1.0, extra: Floats | None = None) -> Solution:
        """The fit to all blocks."""
        return self.solve(table.grams(extra).sum(axis=0), table.counts.sum(axis=0), table.floor, looseness)

    def score(self, table: Table, solution: Solution) -> Floats:
        """Log-likelihood of a row by joint [n], in the fit to all blocks."""
        return np.asarray(np.log(table.factor) - 0.5 * np.log(solution.variance))

    def held_out(self, table: Table, looseness: float) -> Floats:
        """Log-likelihood of a row in each block by joint [B, n], in the fit to the others."""
        grams, counts = table.grams(), table.counts
        others = self.solve(grams.sum(axis=0) - grams, counts.sum(axis=0) - counts, table.floor, looseness)
        z = self._local(others)
        squares = np.einsum("bni,bnij,bnj->bn", z, grams, z) / np.maximum(counts, 1e-9)
        return np.asarray(np.log(table.factor) - 0.5 * np.log(squares + table.floor))

    def _local(self, solution: Solution) -> Floats:
        x = np.repeat(solution.x[..., None, :], self.n, axis=-2)
        return np.concatenate([x, solution.own, -np.ones((*x.shape[:-1], 1))], axis=-1)

    def alike(self, table: Table, solution: Solution) -> Floats:
        """How many rows say the same [n]: by the autocorrelation of what is left of each torque, to where it
        first is none."""
        left = np.einsum("nkl,nl->nk", table.columns, self._local(solution))
        e = left * np.sqrt(table.weight)
        power = np.abs(np.fft.rfft(e, 2 * e.shape[1], axis=1)) ** 2
        rho = np.fft.irfft(power, axis=1)[:, : e.shape[1] // limits.BLOCKS]
        rho = rho / np.maximum(rho[:, :1], 1e-300)
        until = np.cumprod(rho > 0, axis=1)
        return np.asarray(np.maximum(1.0, 2 * (rho * until).sum(axis=1) - 1))


def _without_friction(robot: Robot) -> Robot:
    """``robot`` without friction, which is fitted."""
    links = tuple(replace(k, joint=replace(k.joint, viscous=ZERO, coulomb=ZERO)) for k in robot.links)
    kinds = [(e, e.definition) for e in robot.effects]
    effects = tuple(e for e, kind in kinds if not (kind.dissipative and kind.level == "joint"))
    return replace(robot, links=links, effects=effects)


def _prior(robot: Robot, model: Model) -> Floats:
    """Standard deviations [10 n] about the description's numbers: each link's confidence in the size of its
    mass, first and second moments; the last link may bear a load."""
    phi = model.standard_parameters()
    reach = [
        math.hypot(*(float(x) for x in (k.joint.a, k.joint.d) if isinstance(x, Fraction)))
        for k in robot.links
    ]
    least, length = 0.02 * float(phi[:, 0].max()), max(*reach, 0.05)
    sd = []
    for k, link in enumerate(robot.links):
        share = limits.UNSTATED_CONFIDENCE if link.confidence is None else float(link.inertial_share)
        mass = max(float(phi[k, 0]), least, 1e-6)
        size = np.sqrt(float(np.abs(phi[k, 4:]).max()) / mass)
        size = max(
            size, float(np.linalg.norm(phi[k, 1:4])) / mass, 0.5 * max(reach[k + 1 : k + 2], default=0.0)
        )
        sd.append(share * mass * np.r_[1, np.full(3, size), np.full(6, size**2)])
    load = limits.LOAD_SHARE * float(phi[:, 0].sum())
    sd[-1] = np.hypot(sd[-1], load * np.r_[1, np.full(3, 0.5 * length), np.full(6, 0.25 * length**2)])
    return np.concatenate(sd)
