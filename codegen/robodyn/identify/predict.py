"""What a model says that a log should show: its compiled kernel along the log, and its sensors."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects.traits import Acts
from robodyn.gate.gate import Gate
from robodyn.identify.twist import behind_motors
from robodyn.kernels.array_dynamics import Model
from robodyn.kernels.kernel import Kernel
from robodyn.logs.limits import MOTION_WIDER
from robodyn.logs.signals import Signals, knee, motion_cutoff, rates, smoothed_motion
from robodyn.robot.model import Robot
from robodyn.simulate.sensors import acting_on, measured_torque


@lru_cache(maxsize=8)
def kernel_of(robot: Robot) -> Kernel:
    """The compiled inverse dynamics of ``robot``, quickly generated."""
    from robodyn.kernels.robot_kernel import compile as compile_kernel

    return compile_kernel(robot, functions=["inverse_dynamics"], optimize="fast", mode="abi")


def agreement(robot: Robot, gate: Gate) -> float | None:
    """How far, as a share of the largest torque, the compiled kernel is from the same equations on arrays
    along a log; None where the model remembers, which the arrays do not."""
    kernel = kernel_of(robot)
    if kernel.signatures["inverse_dynamics"].states:
        return None
    most, size, model = 0.0, 1e-300, Model(robot)
    for part in gate.segments:
        _, q, qd, qdd = smooth_motion(gate, part)
        tau = kernel.inverse_dynamics(q, qd, qdd)
        most = max(most, float(np.abs(tau - model.torque(q, qd, qdd)).max()))
        size = max(size, float(np.abs(tau).max()))
    return most / size


def offsets(robot: Robot) -> Floats:
    """Encoder offsets [n] of the model: measured less true."""
    return _sums(robot, "position")


def delays(robot: Robot) -> Floats:
    """How late [n] the model knows the torque channels to be [s]."""
    return _sums(robot, "delay")


def gains(robot: Robot) -> Floats:
    """Gains [n] of the model's torque channels: measured is (1 + gain) times true."""
    return _sums(robot, "gain")


def biases(robot: Robot) -> Floats:
    """What the model knows the torque channels to show too much [n]."""
    return _sums(robot, "bias")


def _sums(robot: Robot, acts: Acts) -> Floats:
    """By joint [n], the sum of what so acts on a channel; an entry of the whole robot is one of every
    joint."""
    sums = np.zeros(robot.n)
    for entry, channel in acting_on(robot.effects, acts):
        joints = slice(None) if entry.joint is None else entry.joint - 1
        sums[joints] += entry.number(channel.parameter)
    return sums


def model_torque(
    robot: Robot,
    t: Floats,
    q: Floats,
    qd: Floats,
    qdd: Floats,
    tau: Floats | None = None,
    *,
    compiled: bool = True,
    rest: Floats | None = None,
) -> Floats:
    """What the torque channel of ``robot`` shows [K, n] along measured positions, evenly sampled. What it
    showed, ``tau`` [K, n], tells of joints with springs how they were twisted at first. Not ``compiled``: by
    the same equations on arrays where nothing remembers, which spares a model that is only tried its C.
    ``rest`` [n]: speeds below which directions are not resolved, so that dry friction is on average as
    much less; what remembers knows its own."""
    model, q = Model(robot, sticking=rest), q - offsets(robot)
    remembers = any(entry.definition.memory is not None for entry in robot.effects)
    if model.couplers or not (compiled or remembers):  # a kernel can only look back
        torque = behind_motors(model, q, qd, qdd, float(t[1] - t[0]), tau)
        return measured_torque(torque.total, t, robot.effects)
    kernel = kernel_of(robot)
    more: dict[str, Any] = {}
    if kernel.signatures["inverse_dynamics"].states:
        more["dt"] = float(t[1] - t[0])
    whole = kernel.inverse_dynamics(q, qd, qdd, **more)
    if rest is not None:
        whole = whole + model.torque(q, qd, qdd) - Model(robot).torque(q, qd, qdd)
    return measured_torque(whole, t, robot.effects)


def given_torque(tau: Floats, robot: Robot) -> Floats:
    """Of commands [K, n], what the drives of ``robot`` gave: no more than their limits."""
    torque = np.array(tau)
    for entry, channel in acting_on(robot.effects, "limit"):
        if entry.joint and entry.text(channel.who) == "drive":
            limit = entry.number(channel.parameter)
            torque[:, entry.joint - 1] = np.clip(torque[:, entry.joint - 1], -limit, limit)
    return torque


def smooth_motion(gate: Gate, part: slice) -> tuple[Floats, Floats, Floats, Floats]:
    """Times, filtered positions and their rates of an even part of a log."""
    t, q = gate.log.t[part], gate.log.q[part]
    period = float((t[-1] - t[0]) / (len(t) - 1))
    cutoff = motion_cutoff(q, 1 / period, knee(q, 1 / period), MOTION_WIDER)
    smooth = smoothed_motion(q, 1 / period, cutoff)
    qd = rates(smooth, period)
    return t, smooth, qd, rates(qd, period)


def predicted(robot: Robot, gate: Gate, rest: Floats | None = None) -> Floats:
    """The torques [K, n] that ``robot`` predicts along a log; ``rest`` as in :func:`model_torque`."""
    torque = np.zeros_like(gate.log.tau)
    for part in gate.segments:
        torque[part] = model_torque(robot, *smooth_motion(gate, part), gate.log.tau[part], rest=rest)
    return torque


def lacking(robot: Robot, gate: Gate, rest: Floats | None = None) -> Floats:
    """What ``robot`` does not explain of a log [K, n]: the torque as logged (the command as far as the drive
    could give it) less the predicted one; ``rest`` as in :func:`model_torque`."""
    return given_torque(gate.log.tau, robot) - predicted(robot, gate, rest)


def signals_seen(gate: Gate) -> Signals:
    """The whole log's motion, for pictures."""
    parts = [smooth_motion(gate, part) for part in gate.segments]
    t, q, qd, qdd = (np.concatenate([part[k] for part in parts]) for k in range(4))
    count = len(t)
    return Signals(t, q, qd, qdd, gate.log.tau[:count], 1.0, 1, 0)
