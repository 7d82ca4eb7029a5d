"""The data gate: what of a log can be used, and what is to be known of it before anything is fitted.

A log that would lead a fit astray is refused: garbage, times out of order, other units, signs or columns than
the robot's. All else is told in flags with rows and times.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats, Mask
from robodyn.errors import InputError, Place
from robodyn.gate import limits
from robodyn.gate.content import JointContent, content, steps_of
from robodyn.gate.flag import Flag, Span, count, long_runs, motions, refuse
from robodyn.gate.grid import on_grid
from robodyn.gate.links import check_links, with_usable_links
from robodyn.gate.model import check_model
from robodyn.gate.rates import check_rates
from robodyn.gate.rows import usable
from robodyn.gate.samples import floor_of, fresh, unwrapped
from robodyn.gate.smooth import noise_of, smoothed
from robodyn.gate.stuck import check_stuck
from robodyn.logs.log import Log
from robodyn.robot.coupling import no_couplings
from robodyn.robot.masses import require_masses
from robodyn.robot.model import Robot

__all__ = ["Flag", "Gate", "JointContent", "Span", "inspect"]


@dataclass(frozen=True, slots=True, eq=False)
class Gate:
    """A log that has passed.

    ``log`` [K rows] is evenly sampled, each ``period`` [s], in each of the ``segments``; between them time is
    missing. It is the log that was given, array for array, where that has no fault. ``qd`` or ``qdd`` is
    None where it was not logged or cannot be used. ``saturated`` [K, n]: where torques are cut off.
    ``resting`` [K, n]: where a joint stands still for a while, so that stiction makes its torque unknown
    within the level of its friction; a reversal is no rest. ``rows`` [K]: about which row (from 0) of the
    given log each sample is. ``joints``: what there is of each; ``flags``: all that was found.
    """

    log: Log
    segments: tuple[slice, ...]
    period: float
    rows: NDArray[np.intp]
    saturated: NDArray[np.bool_]
    resting: NDArray[np.bool_]
    joints: tuple[JointContent, ...]
    flags: tuple[Flag, ...]

    def flags_of(self, kind: str) -> tuple[Flag, ...]:
        """The flags of that ``kind``."""
        return tuple(flag for flag in self.flags if flag.kind == kind)

    @property
    def stands(self) -> bool:
        """Whether the arm stands still throughout, but for what a hand moves it."""
        return bool(self.flags_of("at_rest"))

    @property
    def torque_noise(self) -> Floats:
        """Standard deviations [n] of what is white in the torques [N m or N]."""
        return np.array([one.torque_noise for one in self.joints])


def inspect(
    log: Log,
    robot: Robot,
    parameters: Mapping[str, float] | None = None,
    *,
    source: str | None = None,
    most: int = limits.MOST_SAMPLES,
    windows: int = limits.WINDOWS,
    thinned: int | None = None,
    is_one_of_many: bool = False,
) -> Gate:
    """Look at ``log`` of ``robot`` before anything is fitted.

    ``parameters``: values of the robot's run-time parameters; ``source``: what the log is called in messages;
    ``most``: as many samples are kept at most, of a longer log in so many ``windows``, and so that no more
    than ``thinned`` are left where they are filtered and thinned (:mod:`robodyn.logs.signals`);
    ``is_one_of_many``: see :func:`robodyn.gate.model.check_model`.

    Raises
    ------
    InputError: the log cannot be used, with rows, columns and times; or masses that nobody states.
    """
    require_masses(robot)
    no_couplings(robot, "a log beside a model")
    try:
        return _inspect(log, robot.at(parameters or {}), most, windows, thinned, is_one_of_many)
    except InputError as error:
        raise error if source is None else error.at(Place(source)) from None


def _inspect(
    log: Log, robot: Robot, most: int, windows: int, thinned: int | None, is_one_of_many: bool
) -> Gate:
    if log.n != robot.n:
        refuse(
            f"the log is not of {robot.name}",
            found=f"{log.n} joints",
            expected=f"{robot.n}",
            remedy="name the robot that the log is of",
        )
    flags: list[Flag] = []
    if log.ignored:
        listed = ", ".join(log.ignored[:8]) + (", ..." if len(log.ignored) > 8 else "")
        text = f"{count(len(log.ignored), 'column')} not read: {robot.name} has {count(robot.n, 'joint')}"
        flags.append(Flag("ignored", listed, (), text))
    log, repeats = fresh(unwrapped(log, robot, flags), flags)
    log = with_usable_links(log, flags)
    rows = usable(log, flags, repeats)
    some = rows.index[rows.parts[0][0] : rows.parts[0][1]][:20_000]
    steps = steps_of(log.q[some]), steps_of(log.tau[some])
    grid = on_grid(log, rows, most, flags, windows, thinned)
    del log, rows  # a long one is large; what is used of it is on the grid
    stuck = check_stuck(grid, robot, flags)
    smooth = smoothed(grid.log, grid.segments, grid.period, stuck)
    if not smooth.inside.any():
        refuse(
            "the log is in pieces that are too short",
            found=f"{count(len(grid.segments), 'piece')}, none of {2 * limits.SMOOTHING_LEAST} samples",
            expected="pieces of half a second, or some seconds without gaps",
            remedy="record a longer motion, without gaps",
        )
    noise = noise_of(grid.log.q, grid.segments), noise_of(grid.log.tau, grid.segments)
    slow = motions(robot, limits.REST_SPEED)
    still = resting(grid.log.q, grid.segments, grid.period, noise=noise[0], steps=steps[0], slow=slow)
    floor = floor_of(grid.log.tau, grid.segments, grid.period, noise[1], flags)
    check_links(grid.log)
    # What moves visibly.
    moves = np.ptp(smooth.q[smooth.inside], axis=0) > np.maximum(30 * noise[0], 1e-3)
    rates, accelerations = check_rates(smooth, robot, grid.period, flags, moves)
    moving = np.asarray(~still.all(axis=1))
    check_model(smooth, moving, grid.period, robot, flags, is_one_of_many=is_one_of_many)
    used = grid.log
    if not rates or not accelerations:
        used = replace(used, qd=used.qd if rates else None, qdd=used.qdd if accelerations else None)
    joints, saturated = content(
        grid, smooth, robot, moves=moves, torque_step=steps[1], torque_noise=floor, flags=flags
    )
    if (np.ptp(grid.log.q, axis=0) <= motions(robot, limits.LEAST_ANGLE)).all() or not moves.any():
        flags.append(Flag("at_rest", "q", (), "no joint moves: only contacts show"))
    length = sum(part.stop - part.start for part in grid.segments) * grid.period
    if 1 / grid.period < limits.SLOW_RATE:
        text = f"{1 / grid.period:.4g} samples a second: too few for effects at reversals, delay, elasticity"
        flags.append(Flag("slow_sampling", "t", (), text))
    if length < limits.SHORT_LOG:
        flags.append(Flag("short", "t", (), f"{length:.3g} s of motion: too little to be sure of much"))
    return Gate(used, grid.segments, grid.period, grid.rows(), saturated, still, joints, tuple(flags))


def resting(
    q: Floats, segments: Sequence[slice], period: float, *, noise: Floats, steps: Floats, slow: Floats
) -> Mask:
    """Where [K, n] joints with positions ``q`` [K, n] stand still, for :data:`.limits.REST_TIME` at least, so
    that a reversal is no rest: stiction holds them there with any torque within its level.

    ``noise``, ``steps`` [n]: the standard deviation of the positions' noise, and the step of their encoders;
    ``slow`` [n]: what stands still whatever its top speed.
    """
    reach = max(limits.SMOOTHING_LEAST // 2, round(limits.SMOOTHING_REACH / (2 * period)))
    least = max(3, round(limits.REST_TIME / period))
    speed = np.zeros_like(q)
    for part in segments:
        x = q[part]
        places = np.arange(len(x))
        before, after = np.maximum(places - reach, 0), np.minimum(places + reach, len(x) - 1)
        speed[part] = np.abs(x[after] - x[before]) / (np.maximum(after - before, 1)[:, None] * period)
    top = np.quantile(speed[:: max(1, len(speed) // 20_000)], 0.99, axis=0)
    # A step of the encoder in the window looks like a speed, and so does noise at both of its ends.
    unsure = (1.01 * steps + limits.REST_NOISE * np.sqrt(2) * noise) / (2 * reach * period)
    still = speed < np.maximum(np.maximum(limits.STILL_SPEED * top, slow), unsure)
    for part in segments:
        for j in range(q.shape[1]):
            still[part, j] = long_runs(still[part, j], least)
    return np.asarray(still)
