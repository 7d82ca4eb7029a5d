"""What the motion of a log shows of each joint, and what its sensors leave of it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.gate.flag import Flag, Floats, Rows, named
from robodyn.gate.grid import Grid
from robodyn.gate.limits import (
    FEW_REVERSALS,
    LOAD_STATES,
    NARROW_ANGLE,
    NARROW_WAY,
    ONE_WAY_SHARE,
    PILE_FACTOR,
    PILED_SAMPLES,
    PILED_SHARE,
    RESOLUTION_SAMPLES,
    STANDSTILL,
    STILL_SPEED,
)
from robodyn.gate.rates import moving_joints
from robodyn.gate.smooth import Smooth
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import Robot

Mask = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class JointContent:
    """What a log has of one joint.

    ``low, high``: its range [rad or m]; ``speed``: 99th percentile of its speed, per s; ``reversals`` of its
    direction; ``still``: share of the samples at which it stands; ``forward``: share of its way that is
    in the positive direction. ``load``: the model's torque, largest and RMS [N m or N], ``drive`` and
    ``brake``: shares of the moving samples in which the load is lifted and lowered. ``position_step,
    torque_step``: of the quantisation, 0 where there is none; ``position_noise, torque_noise``: standard
    deviations. ``limit``: where the torque is cut off (infinity: nowhere), ``limited``: share of samples
    there. ``lag``: of the logged velocity [s], NaN where not seen. ``unexplained``: share of the torque's
    variance that friction and the model leave; NaN where the torque tells nothing.
    """

    joint: int
    moves: bool
    low: float
    high: float
    speed: float
    reversals: int
    still: float
    forward: float
    load: tuple[float, float]
    drive: float
    brake: float
    position_step: float
    torque_step: float
    position_noise: float
    torque_noise: float
    limit: float
    limited: float
    lag: float
    unexplained: float


def content(
    grid: Grid,
    smooth: Smooth,
    robot: Robot,
    parameters: Mapping[str, float] | None,
    *,
    steps: tuple[Floats, Floats],
    noise: tuple[Floats, Floats],
    lag: Floats,
    unexplained: Floats | None,
    flags: list[Flag],
) -> tuple[tuple[JointContent, ...], Mask]:
    """What there is of each joint, and where torques are cut off (a mask [K, n])."""
    log, n = grid.log, robot.n
    inside = smooth.inside
    moving = set(moving_joints(smooth, noise[0]))
    velocity = np.where(inside[:, None], smooth.qd, 0.0)
    top = np.quantile(np.abs(velocity[inside]), 0.99, axis=0) if inside.any() else np.zeros(n)
    goes = np.abs(velocity) > STILL_SPEED * np.where(top > 0, top, np.inf)
    goes[:, [j for j in range(n) if j not in moving]] = False
    loads, drives, brakes = _quadrants(smooth, goes, robot, parameters)
    cut = np.zeros(log.q.shape, dtype=bool)
    contents = []
    for j in range(n):
        limit, at = _cut_off(log.tau[:, j], goes[:, j], float(steps[1][j]))
        cut[:, j] = at
        direction = np.sign(velocity[goes[:, j], j])
        ahead, back = (float(np.clip(s * velocity[inside, j], 0, None).sum()) for s in (1, -1))
        contents.append(
            JointContent(
                joint=j + 1,
                moves=j in moving,
                low=float(log.q[:, j].min()),
                high=float(log.q[:, j].max()),
                speed=float(top[j]) if j in moving else 0.0,
                reversals=int(np.count_nonzero(np.diff(direction))),
                still=1 - float(goes[inside, j].mean()) if inside.any() else 1.0,
                forward=ahead / (ahead + back) if j in moving and ahead + back > 0 else 0.5,
                load=(float(np.abs(loads[:, j]).max()), float(np.sqrt((loads[:, j] ** 2).mean()))),
                drive=drives[j],
                brake=brakes[j],
                position_step=float(steps[0][j]),
                torque_step=float(steps[1][j]),
                position_noise=float(noise[0][j]),
                torque_noise=float(noise[1][j]),
                limit=limit,
                limited=float(at.mean()),
                lag=float(lag[j]),
                unexplained=math.nan if unexplained is None else float(unexplained[j]),
            )
        )
    _say(contents, grid, goes, cut, robot, flags)
    return tuple(contents), cut


def steps_of(x: Floats) -> Floats:
    """The steps [n] in which the columns of ``x`` [K, n] change from sample to sample; 0: none."""
    result = np.zeros(x.shape[1])
    for j in range(x.shape[1]):
        change = np.abs(np.diff(x[:RESOLUTION_SAMPLES, j]))
        change = change[change > 1e-9 * max(float(np.abs(x[:RESOLUTION_SAMPLES, j]).max()), 1e-9)]
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


def _quadrants(
    smooth: Smooth, goes: Mask, robot: Robot, parameters: Mapping[str, float] | None
) -> tuple[Floats, list[float], list[float]]:
    """The model's torques at some samples, and by joint the shares that drive and that brake."""
    rows = np.flatnonzero(smooth.inside)
    if not len(rows):
        return np.zeros((1, robot.n)), [0.0] * robot.n, [0.0] * robot.n
    rows = rows[np.linspace(0, len(rows) - 1, min(LOAD_STATES, len(rows))).astype(int)]
    torque = Model(robot, parameters).torque(smooth.q[rows], smooth.qd[rows], smooth.qdd[rows])
    power = torque * smooth.qd[rows]
    drive, brake = [], []
    for j in range(robot.n):
        own = power[goes[rows, j], j]
        drive.append(float((own > 0).mean()) if len(own) else 0.0)
        brake.append(float((own < 0).mean()) if len(own) else 0.0)
    return torque, drive, brake


def _cut_off(tau: Floats, goes: Mask, step: float) -> tuple[float, Mask]:
    """Where samples pile up at an extreme value of ``tau`` [K]: the value, and a mask [K]."""
    none = np.zeros(len(tau), dtype=bool)
    moving = tau[goes]
    if len(moving) < 10 * PILED_SAMPLES:
        return math.inf, none
    limit, at = math.inf, none
    for sign in (1.0, -1.0):
        end = float((sign * moving).max())
        near = max(1e-6 * float(np.abs(moving).max()), 0.51 * step)
        depth = end - sign * moving
        piled = int(np.count_nonzero(depth <= near))
        beside = np.count_nonzero((depth > near) & (depth <= 6 * near)) / 5
        if piled >= max(PILED_SAMPLES, PILED_SHARE * len(moving)) and piled > PILE_FACTOR * max(beside, 1):
            limit = min(limit, abs(end))
            at = at | (end - sign * tau <= near)
    return limit, at


def _say(
    contents: Sequence[JointContent], grid: Grid, goes: Mask, cut: Mask, robot: Robot, flags: list[Flag]
) -> None:
    """Flags on what is missing from the motion."""

    def tell(kind: str, text: str, group: str, joints: Sequence[int]) -> None:
        if joints:
            flags.append(Flag(kind, named(group, joints), (), text, tuple(joints)))

    prismatic = [link.joint.kind == "prismatic" for link in robot.links]
    moving = [one for one in contents if one.moves]
    tell("motionless", "does not move", "q", [one.joint for one in contents if not one.moves])
    one_way = [one.joint for one in moving if not ONE_WAY_SHARE < one.forward < 1 - ONE_WAY_SHARE]
    tell("one_way", "moves in one direction only", "q", one_way)
    narrow = [
        one.joint
        for one in moving
        if one.high - one.low < (NARROW_WAY if prismatic[one.joint - 1] else NARROW_ANGLE)
    ]
    tell("narrow", "moves over a small part of its range", "q", narrow)
    few = [one.joint for one in moving if one.reversals < FEW_REVERSALS and one.joint not in one_way]
    tell("few_reversals", f"turns round less than {FEW_REVERSALS} times", "q", few)
    for one in contents:
        j = one.joint - 1
        if one.limit < math.inf:
            text = f"stays at {one.limit:.6g} in {one.limited:.2%} of the samples: cut off there"
            flags.append(
                Flag(
                    "saturation",
                    f"tau{one.joint}",
                    grid.spans(np.flatnonzero(cut[:, j])),
                    text,
                    (one.joint,),
                )
            )
        low_high = robot.links[j].joint.limits.position
        if low_high is not None:
            low, high = (float(x) for x in low_high)
            room = 0.05 * (high - low)
            beyond = np.flatnonzero((grid.log.q[:, j] < low - room) | (grid.log.q[:, j] > high + room))
            if len(beyond):
                text = f"{one.low:.4g} to {one.high:.4g} is beyond the limits {low:.4g} to {high:.4g}"
                flags.append(Flag("beyond_limits", f"q{one.joint}", grid.spans(beyond), text, (one.joint,)))
    idle = np.flatnonzero(~goes.any(axis=1))
    rest = [run for run in _runs(idle) if len(run) * grid.period >= STANDSTILL]
    if rest:
        rows = np.concatenate(rest)
        text = f"no joint moves in {len(rows) / len(goes):.0%} of the samples"
        flags.append(Flag("standstill", "q", grid.spans(rows), text))


def _runs(rows: Rows) -> list[Rows]:
    return np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1) if len(rows) else []
