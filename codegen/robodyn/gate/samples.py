"""How a log was sampled: rows that were sent twice, angles that begin anew each turn, smoothed signals."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from robodyn.arrays import Floats, Mask
from robodyn.gate import limits
from robodyn.gate.flag import Flag, chunks, count, named, spans_of
from robodyn.logs.log import Log
from robodyn.robot.model import Robot


def unwrapped(log: Log, robot: Robot, flags: list[Flag]) -> Log:
    """``log`` with angles that go on where they began anew at a turn."""
    q = log.q
    for j, link in enumerate(robot.links):
        if link.joint.kind != "revolute":
            continue
        with np.errstate(invalid="ignore", over="ignore"):
            step = np.diff(log.q[:, j])
            turns = np.abs(np.abs(step) - 2 * math.pi) < limits.TURN_NEAR
        rows = np.flatnonzero(turns)
        usual = np.abs(step[np.isfinite(step) & ~turns])
        if not len(rows) or not len(usual) or np.quantile(usual, 0.99) > limits.TURN_NEAR:
            continue
        if q is log.q:
            q = log.q.copy()
        offset = np.zeros(len(q))
        offset[rows + 1] = -2 * math.pi * np.sign(step[rows])
        q[:, j] += np.cumsum(offset)
        text = f"begins anew at a turn, {count(len(rows), 'time')}: taken as going on"
        flags.append(Flag("wrapped", f"q{j + 1}", spans_of(rows + 1, log.t), text, (j + 1,)))
    return log if q is log.q else replace(log, q=q)


def fresh(log: Log, flags: list[Flag]) -> tuple[Log, Mask | None]:
    """``log`` with the times at which its source took the rows, and a mask [K] of the rows that only repeat
    the one before while the arm moves on; None: there are none.

    Where the source is a little slower than what wrote the log, a row is sent twice now and then and the
    others are more and more late in between: they are spread evenly over the time.
    """
    if log.samples < 4 or not (np.diff(log.t) > 0).all():
        return log, None
    same = _same(log)
    if not limits.FEWEST_REPEATS <= same.sum() <= limits.MOST_REPEATS * len(same):
        return log, None
    step = np.abs(np.diff(log.q, axis=0))
    with np.errstate(invalid="ignore"):
        usual = np.nanquantile(step[~same], 0.9, axis=0)
        least = np.nanmin(np.where(step > 0, step, np.inf), axis=0)
    # In a joint that moves by a few steps of its encoder from row to row, equal rows are no sign.
    fine = (usual > 8 * least) & np.isfinite(usual)
    speed = np.where(fine, step / np.where(usual > 0, usual, 1), 0).max(axis=1)
    rows = np.flatnonzero(same)  # row k + 1 repeats row k
    inner = rows[(rows > 0) & (rows < len(same) - 1)]
    inner = inner[(speed[inner - 1] > limits.REPEAT_SPEED) & (speed[inner + 1] > limits.REPEAT_SPEED)]
    if len(inner) < limits.FEWEST_REPEATS:
        return log, None
    repeats = np.zeros(log.samples, dtype=bool)
    # A slower source shows where the arm hardly moves as well.
    lone = rows[(rows > 0) & (rows < len(same) - 1)]
    lone = lone[~same[lone - 1] & ~same[lone + 1]]
    steps, apart = np.diff(log.t), np.diff(lone)
    even = bool((np.abs(steps / np.median(steps) - 1) < 0.5).all())
    even = even and len(apart) >= 2 and bool(apart.std() < limits.REPEAT_EVENLY * apart.mean())
    inner, t = lone if even else inner, log.t.copy()
    repeats[inner + 1] = True
    text = f"{count(len(inner))} the same as the row before in every digit, left out"
    if even:
        kept = np.flatnonzero(~repeats)
        t[kept] = np.linspace(log.t[0], log.t[-1], len(kept))
        t[inner + 1] = (t[inner] + t[inner + 2]) / 2
        period = float((log.t[-1] - log.t[0]) / (len(kept) - 1))
        text += f", and the others, up to {1e3 * period:.3g} ms late, spread evenly: their source is slower"
        text += f" ({1 / period:.4g} a second)"
    flags.append(Flag("repeated_rows", "all", spans_of(inner + 1, log.t), text))
    return replace(log, t=t), repeats


def _same(log: Log) -> Mask:
    """Which rows [K - 1] are followed by one with the same positions and torques."""
    same = np.empty(log.samples - 1, dtype=bool)
    for rows in chunks(log.samples - 1):
        after = slice(rows.start + 1, rows.stop + 1)
        alike = (table[rows] == table[after] for table in (log.q, log.tau))
        same[rows] = np.logical_and(*(each.all(axis=1) for each in alike))
    return same


def floor_of(
    tau: Floats, segments: Sequence[slice], period: float, white: Floats, flags: list[Flag]
) -> Floats:
    """The noise [n] of torques ``tau`` [K, n] that a fit is to believe: ``white`` [n] as differences from
    sample to sample show it, or where those show next to none, because the signals were smoothed, what is
    above the motion instead."""
    from scipy.signal import periodogram

    size = np.array([float(np.std(x)) for x in tau.T])
    smooth = (white < limits.SMOOTH_SHARE * size) & (size > 0)
    if not smooth.any():
        return white
    length = max(part.stop - part.start for part in segments) // limits.SPECTRUM_PIECES
    if length < 64:
        return white
    powers, f = [], np.fft.rfftfreq(length, period)
    for part in segments:
        for start in range(part.start, part.stop - length + 1, length):
            _, power = periodogram(
                tau[start : start + length], 1 / period, window="hann", detrend="linear", axis=0
            )
            powers.append(power)
    low, high = (max(share * 0.5 / period, least) for share, least in limits.SPECTRUM_BAND)
    band = (f >= low) & (f <= high)
    # What is above the motion, and as much of its density below.
    spectrum = np.median(powers, axis=0)
    level = np.sqrt(np.median(spectrum[band], axis=0) * low + spectrum[f >= low].sum(axis=0) * f[1])
    # Where nothing is left there either, the noise is not to be had from the torque alone.
    floor = np.where(smooth, np.maximum(np.maximum(white, level), limits.UNKNOWN_SHARE * size), white)
    joints = [j + 1 for j in np.flatnonzero(smooth & (floor > 3 * white)).tolist()]
    if joints:
        own = [j - 1 for j in joints]
        text = (
            f"from sample to sample next to no noise ({white[own].min():.2g} to {white[own].max():.2g} N m "
            f"or N): smoothed before it was logged; {floor[own].min():.2g} to {floor[own].max():.2g} is taken"
        )
        flags.append(Flag("smoothed", named("tau", joints), (), text, tuple(joints)))
    return floor
