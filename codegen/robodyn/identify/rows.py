"""The rows that an arm is fitted to: filtered torques and motion of logs, thinned to what their band holds.

Positions go through a zero-phase filter and are differentiated; torques and directions of motion go through
the same filter (Gautier 1997). What the description has beside rigid links, rotors, viscous and Coulomb
friction (springs, couplings, sensors) is taken off the torque, and stays as it is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.gate.gate import Gate
from robodyn.identify.limits import (
    FOLDS,
    SUB_BLOCKS,
    TRAIN_SHARE,
)
from robodyn.identify.predict import biases, delays, gains, model_torque, offsets
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.signals import Signals, signals_of
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """Samples [M] of one log, thinned: ``q, qd, qdd`` [M, n], directions of motion ``way``, how little these
    are resolved (``unresolved``: 1 - s^2), torques ``tau`` and their rates ``late`` (-dtau/dt) [M, n], all
    filtered; ``used`` [M, n]: whether a torque can be relied on; ``block`` [M] is which block of the log each
    is of, ``held_out`` [blocks] which of these a first fit leaves out; ``log``: which of the logs;
    ``signals``: what they were thinned from."""

    q: Floats
    qd: Floats
    qdd: Floats
    way: Floats
    unresolved: Floats
    tau: Floats
    late: Floats
    used: NDArray[np.bool_]
    block: NDArray[np.intp]
    held_out: NDArray[np.bool_]
    log: int
    signals: Signals

    @property
    def step(self) -> float:
        """Time between samples [s]."""
        return self.signals.every * self.signals.period

    @property
    def cutoff(self) -> float:
        """Of the filter [Hz]."""
        return self.signals.cutoff

    def unfiltered(self) -> Rows:
        """As many times more samples as tell where a torque jumps, unfiltered; those of directions are of the
        rows as they are."""
        s = self.signals
        step = max(1, s.every // 4)
        part = slice(s.edge, len(s.t) - s.edge, step)
        near = np.minimum(np.arange(len(s.t[part])) * step // s.every, len(self.block) - 1)
        return replace(
            self, q=s.q[part], qd=s.qd[part], qdd=s.qdd[part], way=s.qd[part], tau=s.tau[part],
            used=self.used[near], block=self.block[near],
        )  # fmt: skip

    def at_rest_below(self, speeds: Floats) -> Rows:
        """The same rows with directions that are resolved from other ``speeds`` [n] on."""
        way = direction(self.signals.qd, speeds)
        unresolved = np.clip(_seen(self.signals, 1 - way**2), 0.0, 1.0)
        return replace(self, way=_seen(self.signals, way), unresolved=unresolved)


def _seen(s: Signals, x: Floats) -> Floats:
    """``x`` [K, ...] filtered and thinned."""
    return s.thinned(s.filtered(x))


def direction(qd: Floats, speeds: Floats) -> Floats:
    """Mean directions s of velocities [K, n] that are resolved from ``speeds`` [n] on; signs where these are
    0."""
    return np.divide(qd, speeds, out=np.sign(qd), where=np.abs(qd) < speeds)


def bare(robot: Robot) -> Robot:
    """``robot`` without its effects, save what is in plain keys."""
    return replace(robot, effects=())


def rows_of(
    robot: Robot,
    gate: Gate,
    log: int,
    left_out: Sequence[tuple[float, float]] = (),
    late: float = 0.0,
) -> list[Rows]:
    """The rows of a log that has passed its ``gate``, a piece for each of its segments; torques in windows of
    time that are ``left_out`` [s] do not count, nor what the filter brings of them. What effects do is
    taken off the torque, which is read ``late`` [s]. Directions of motion are resolved as far as the
    encoders' noise lets them be."""
    count = gate.log.samples
    edges, held_out = blocks_of(count)
    pieces = []
    for part in gate.segments:
        piece = Log(gate.log.t[part], gate.log.q[part] - offsets(robot), None, None, gate.log.tau[part])
        signals = signals_of(piece)
        K = len(signals.t)
        tau = true_torque(robot, piece, late)[:K]
        known = kept_torque(robot, piece, signals.q, signals.qd, signals.qdd)
        if known is not None:
            tau = tau - known
        block = np.searchsorted(edges, part.start + np.arange(K), side="right") - 1
        used = ~gate.saturated[part][:K]
        for start, end in left_out:
            reach = 1 / signals.cutoff
            used &= ((signals.t < start - reach) | (signals.t > end + reach))[:, None]
        if not len(signals.thinned(signals.t)):
            continue
        signals = replace(signals, tau=tau)
        q, qd, qdd = (signals.thinned(x) for x in (signals.q, signals.qd, signals.qdd))
        rates = -np.gradient(signals.filtered(tau), signals.period, axis=0)
        rows = Rows(
            q, qd, qdd, qd, qd, _seen(signals, tau), signals.thinned(rates), used[signals.used],
            block[signals.used], held_out, log, signals,
        )  # fmt: skip
        pieces.append(rows.at_rest_below(signals.speed_noise))
    return pieces


def blocks_of(samples: int) -> tuple[Floats, NDArray[np.bool_]]:
    """Where the blocks of a log begin [B], and which of them a first fit leaves out: of each of ten equal
    folds the last 30 %; what is left of it is cut into further blocks."""
    starts, held_out = [], []
    for fold in range(FOLDS):
        for k in range(SUB_BLOCKS):
            starts.append((fold + TRAIN_SHARE * k / SUB_BLOCKS) / FOLDS * samples)
            held_out.append(False)
        starts.append((fold + TRAIN_SHARE) / FOLDS * samples)
        held_out.append(True)
    return np.array(starts), np.array(held_out)


def true_torque(robot: Robot, log: Log, more: float = 0.0) -> Floats:
    """Torques [K, n] as they were before the sensors that the description knows: lag, offset, gain; ``more``
    [s]: a lag that it does not know.

    Raises
    ------
    InputError: nothing of a torque passes its channel, so that it is not observed.
    """
    passed = 1 + gains(robot)
    if not passed.all():
        raise InputError(
            f"{robot.name}: the torque of joint {int(np.argmin(np.abs(passed))) + 1} is not observed",
            found="torque_gain with gain -1: of the true torque nothing is measured",
            expected="a gain other than -1",
            remedy="state the gain of the torque channel, or leave the effect out",
        )
    tau = log.tau.copy()
    late = delays(robot) + more
    for j in np.flatnonzero(late):
        tau[:, j] = np.interp(log.t + late[j], log.t, tau[:, j])
    return np.asarray((tau - biases(robot)) / passed)


def kept_torque(robot: Robot, log: Log, q: Floats, qd: Floats, qdd: Floats) -> Floats | None:
    """What effects of the description add to the torque [K, n] of the rigid arm with rotors, viscous and
    Coulomb friction; None where there are none."""
    drives = tuple(entry for entry in robot.effects if entry.definition.traits.channel is None)
    drives = tuple(entry for entry in drives if entry.definition.place != "outside")
    if not drives:
        return None
    count = len(q)
    whole = model_torque(replace(robot, effects=drives), log.t[:count], q, qd, qdd, log.tau[:count])
    return np.asarray(whole - Model(bare(robot)).torque(q, qd, qdd))
