"""The rows that an arm is fitted to: filtered torques and motion of logs, thinned to what their band holds.

Positions go through a zero-phase filter and are differentiated; torques and the steps of dry friction go
through the same filter (Gautier 1997). What the description has beside rigid links, rotors, viscous and
Coulomb friction (springs, couplings, sensors) is taken off the torque, and stays as it is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError
from robodyn.gate.gate import Gate
from robodyn.identify.limits import (
    FOLDS,
    REST_FACTOR,
    SUB_BLOCKS,
    TRAIN_SHARE,
)
from robodyn.identify.predict import biases, delays, gains, model_torque, offsets
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.signals import signals_of
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """Samples [M] of one log, thinned: ``q, qd, qdd`` [M, n], directions of motion ``way`` and torques
    ``tau`` [M, n], both filtered; ``used`` [M, n]: whether a torque can be relied on; ``block`` [M] is
    which block of the log each is of, ``held_out`` [blocks] which of these a first fit leaves out; ``log``:
    which of the logs; ``step`` [s] between samples; ``cutoff`` [Hz]."""

    q: Floats
    qd: Floats
    qdd: Floats
    way: Floats
    tau: Floats
    used: NDArray[np.bool_]
    block: NDArray[np.intp]
    held_out: NDArray[np.bool_]
    log: int
    step: float
    cutoff: float


def bare(robot: Robot) -> Robot:
    """``robot`` without its effects, save what is in plain keys."""
    return replace(robot, effects=())


def rows_of(
    robot: Robot,
    gate: Gate,
    log: int,
    left_out: Sequence[tuple[float, float]] = (),
) -> list[Rows]:
    """The rows of a log that has passed its ``gate``, a piece for each of its segments; torques in windows of
    time that are ``left_out`` [s] do not count, nor what the filter brings of them. What effects do is
    taken off the torque."""
    count = gate.log.samples
    edges, held_out = blocks_of(count)
    pieces = []
    for part in gate.segments:
        piece = Log(gate.log.t[part], gate.log.q[part] - offsets(robot), None, None, gate.log.tau[part])
        signals = signals_of(piece)
        K = len(signals.t)
        tau = true_torque(robot, piece)[:K]
        known = kept_torque(robot, piece, signals.q, signals.qd, signals.qdd)
        if known is not None:
            tau = tau - known
        way = direction(signals.qd, rest_band(signals.acceleration_noise, signals.cutoff))
        block = np.searchsorted(edges, part.start + np.arange(K), side="right") - 1
        used = ~gate.saturated[part][:K]
        for start, end in left_out:
            reach = 1 / signals.cutoff
            used &= ((signals.t < start - reach) | (signals.t > end + reach))[:, None]
        q, qd, qdd, way, tau = (
            signals.thinned(x)
            for x in (signals.q, signals.qd, signals.qdd, signals.filtered(way), signals.filtered(tau))
        )
        if len(q):
            thin = slice(signals.edge, K - signals.edge, signals.every)
            step = signals.every * signals.period
            used, block = used[thin], block[thin]
            pieces.append(Rows(q, qd, qdd, way, tau, used, block, held_out, log, step, signals.cutoff))
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


def direction(qd: Floats, band: Floats) -> Floats:
    """Signs of velocities [K, n]; below the ``band`` [n], where noise decides them, as a ramp."""
    return np.clip(qd / np.maximum(band, 1e-12), -1.0, 1.0)


def rest_band(acceleration_noise: Floats | None, cutoff: float) -> Floats:
    """Velocities [n] below which the encoders' noise decides the sign."""
    noise = np.zeros(1) if acceleration_noise is None else acceleration_noise
    return np.asarray(REST_FACTOR * noise / (2 * np.pi * cutoff))


def true_torque(robot: Robot, log: Log) -> Floats:
    """Torques [K, n] as they were before the sensors that the description knows: lag, offset, gain.

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
    late = delays(robot)
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
