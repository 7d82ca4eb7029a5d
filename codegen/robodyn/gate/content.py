"""What the motion of a log shows of each joint, and what its sensors leave of it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats, Mask
from robodyn.gate import limits
from robodyn.gate.flag import Flag, long_runs, motions, named
from robodyn.gate.grid import Grid
from robodyn.gate.smooth import Smooth
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True)
class JointContent:
    """What a log has of one joint: whether it ``moves``, the ``torque_step`` of the quantisation (0: none),
    the standard deviation ``torque_noise``, and the ``limit`` where the torque is cut off (infinity: none).
    """

    joint: int
    moves: bool
    torque_step: float
    torque_noise: float
    limit: float


def content(
    grid: Grid,
    smooth: Smooth,
    robot: Robot,
    *,
    moves: Mask,
    torque_step: Floats,
    torque_noise: Floats,
    flags: list[Flag],
) -> tuple[tuple[JointContent, ...], Mask]:
    """What there is of each joint, and where torques are cut off (a mask [K, n])."""
    log, n = grid.log, robot.n
    velocity = np.where(smooth.inside[:, None], smooth.qd, 0.0)
    top = np.quantile(np.abs(velocity[smooth.inside]), 0.99, axis=0)
    goes = (np.abs(velocity) > limits.STILL_SPEED * np.where(top > 0, top, np.inf)) & moves
    cuts = [_cut_off(log.tau[:, j], goes[:, j], float(torque_step[j])) for j in range(n)]
    cut = np.stack([at for _, at in cuts], axis=1)
    _tell_motion(log.q, velocity, goes, moves, robot, flags)
    for j, (limit, at) in enumerate(cuts):
        if limit < math.inf:
            text = f"stays at {limit:.6g} in {at.mean():.2%} of the samples: cut off there"
            flags.append(Flag("saturation", f"tau{j + 1}", grid.spans(np.flatnonzero(at)), text, (j + 1,)))
        ends = robot.links[j].joint.limits.position
        if ends is not None:
            (low, high), q = map(float, ends), log.q[:, j]
            room = 0.05 * (high - low)
            beyond = np.flatnonzero((q < low - room) | (q > high + room))
            if len(beyond):
                text = f"{q.min():.4g} to {q.max():.4g} is beyond the limits {low:.4g} to {high:.4g}"
                flags.append(Flag("beyond_limits", f"q{j + 1}", grid.spans(beyond), text, (j + 1,)))
    same = (np.diff(log.q, axis=0) == 0).all(axis=1)
    for kind, mask, text in (
        ("standstill", ~goes.any(axis=1), "no joint moves in"),
        ("constant", np.r_[False, same] | np.r_[same, False], "the same in every digit in"),
    ):
        rows = np.flatnonzero(long_runs(np.asarray(mask), math.ceil(limits.STANDSTILL / grid.period)))
        if len(rows):
            share = f"{len(rows) / len(goes):.0%} of the samples"
            flags.append(Flag(kind, "q", grid.spans(rows), f"{text} {share}"))
    joints = tuple(
        JointContent(j + 1, bool(moves[j]), float(torque_step[j]), float(torque_noise[j]), cuts[j][0])
        for j in range(n)
    )
    return joints, cut


def _tell_motion(
    q: Floats, velocity: Floats, goes: Mask, moves: Mask, robot: Robot, flags: list[Flag]
) -> None:
    """Flags on what is missing from the motion."""
    ahead, back = (np.clip(s * velocity, 0, None).sum(axis=0) for s in (1, -1))
    one_way = moves & (np.minimum(ahead, back) <= limits.ONE_WAY_SHARE * (ahead + back))
    least = motions(robot, limits.NARROW_ANGLE)
    turns = [np.count_nonzero(np.diff(np.sign(v[g]))) for v, g in zip(velocity.T, goes.T, strict=True)]
    for kind, which, text in (
        ("motionless", ~moves, "does not move"),
        ("one_way", one_way, "moves in one direction only"),
        ("narrow", moves & (np.ptp(q, axis=0) < least), "moves over a small part of its range"),
        (
            "few_reversals",
            moves & ~one_way & (np.array(turns) < limits.FEW_REVERSALS),
            f"turns round less than {limits.FEW_REVERSALS} times",
        ),
    ):
        joints = [j + 1 for j in np.flatnonzero(which).tolist()]
        if joints:
            flags.append(Flag(kind, named("q", joints), (), text, tuple(joints)))


def steps_of(x: Floats) -> Floats:
    """The steps [n] in which the columns of ``x`` [K, n] change from sample to sample; 0: none."""
    result = np.zeros(x.shape[1])
    for j in range(x.shape[1]):
        change = np.abs(np.diff(x[:, j]))
        change = change[change > 1e-9 * max(float(np.abs(x[:, j]).max()), 1e-9)]
        if len(change) < 20:
            continue
        step = float(change.min())
        count = np.rint(change / step)
        # Differences of the numbers as they are written are off by their rounding, so the mean is taken.
        step = float(change.sum() / count.sum())
        near = np.abs(change / step - np.rint(change / step)) < 0.05
        few = len(np.unique(np.rint(change / step))) < 0.2 * len(change)
        if near.mean() > 0.99 and few:
            result[j] = step
    return result


def _cut_off(tau: Floats, goes: Mask, step: float) -> tuple[float, Mask]:
    """Where samples pile up at an extreme value of ``tau`` [K]: the value, and a mask [K]."""
    none = np.zeros(len(tau), dtype=bool)
    moving = tau[goes]
    if len(moving) < 10 * limits.PILED_SAMPLES:
        return math.inf, none
    limit, at = math.inf, none
    for sign in (1.0, -1.0):
        end = float((sign * moving).max())
        near = max(1e-6 * float(np.abs(moving).max()), 0.51 * step)
        depth = end - sign * moving
        piled = int(np.count_nonzero(depth <= near))
        beside = np.count_nonzero((depth > near) & (depth <= 6 * near)) / 5
        most = max(
            limits.PILED_SAMPLES, limits.PILED_SHARE * len(moving), limits.PILE_FACTOR * max(beside, 1)
        )
        if piled >= most:
            limit = min(limit, abs(end))
            at = at | (end - sign * tau <= near)
    return limit, at
