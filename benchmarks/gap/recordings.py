"""Real logs as the yardstick sees them, read and filtered without any code of ours.

The rule, the same for every tool: positions go through a zero-phase fourth-order Butterworth low-pass and are
differentiated twice by central differences; torque is left raw. A log is divided into ten equal blocks, of
which the first 70 % are fitted and the last 30 % held out; 1 % of the log at either end is neither.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, filtfilt

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

ORDER = 4
#: Share of a log that is cut at either end.
EDGE = 0.01
BLOCKS = 10
#: Share of a block that is fitted.
FITTED = 0.7
#: Steps of time may differ by this share before a raster is needed.
JITTER = 0.02


@dataclass(frozen=True, slots=True)
class Recording:
    """A log as it was recorded: ``t`` [K] (s), ``q``, ``tau`` [K, n] (rad or m; N m or N)."""

    name: str
    t: Floats
    q: Floats
    tau: Floats


@dataclass(frozen=True, slots=True)
class Motion:
    """Filtered ``q``, ``qd``, ``qdd`` and raw ``tau`` [K, n] at even times ``t`` [K]; ``fitted`` [K] and
    ``held_out`` [K] say which samples are which, and neither is true at the ends."""

    name: str
    t: Floats
    q: Floats
    qd: Floats
    qdd: Floats
    tau: Floats
    fitted: Mask
    held_out: Mask


def read(path: str | Path) -> Recording:
    """The columns t, q1.., tau1.. of a CSV file."""
    with Path(path).open(newline="") as file:
        rows = csv.reader(file)
        head = [name.strip() for name in next(rows)]
        table = np.array([[float(cell) for cell in row] for row in rows])
    column = {name: k for k, name in enumerate(head)}
    n = 0
    while f"q{n + 1}" in column:
        n += 1
    q, tau = (table[:, [column[f"{what}{j + 1}"] for j in range(n)]] for what in ("q", "tau"))
    return Recording(Path(path).stem, table[:, column["t"]], q, tau)


def motion(recording: Recording, cutoff: float, raster: float | None = None) -> Motion:
    """The recording by the rule, low-passed at ``cutoff`` [Hz].

    ``raster`` [s] sets uneven samples on even times first, by straight lines between them.

    Raises
    ------
    ValueError: the samples are uneven and there is no raster.
    """
    t, q, tau = recording.t, recording.q, recording.tau
    if raster is not None:
        even = np.arange(t[0], t[-1], raster)
        q, tau = (np.column_stack([np.interp(even, t, x) for x in table.T]) for table in (q, tau))
        t = even
    steps = np.diff(t)
    period = float(np.median(steps))
    if np.abs(steps - period).max() > JITTER * period:
        raise ValueError(f"{recording.name}: steps of {steps.min():.4g} to {steps.max():.4g} s need a raster")
    smooth = filtfilt(*butter(ORDER, cutoff, fs=1 / period), q, axis=0)
    qd = np.gradient(smooth, period, axis=0)
    qdd = np.gradient(qd, period, axis=0)
    fitted, held_out = blocks(len(t))
    return Motion(recording.name, t, smooth, qd, qdd, tau, fitted, held_out)


def blocks(count: int) -> tuple[Mask, Mask]:
    """Which of ``count`` samples are fitted, and which are held out."""
    edge = int(EDGE * count)
    fitted, held_out = np.zeros(count, dtype=bool), np.zeros(count, dtype=bool)
    bounds = np.linspace(0, count, BLOCKS + 1).astype(int)
    for start, end in pairwise(bounds):
        split = start + int(FITTED * (end - start))
        fitted[start:split] = True
        held_out[split:end] = True
    inner = np.zeros(count, dtype=bool)
    inner[edge : count - edge] = True
    return fitted & inner, held_out & inner


def shares(residuals: Sequence[Floats], torques: Sequence[Floats]) -> Floats:
    """100 RMS of the residuals over RMS of the torques [n], over all logs."""
    left, size = (sum((x**2).sum(axis=0) for x in tables) for tables in (residuals, torques))
    return np.asarray(100 * np.sqrt(left / size), dtype=np.float64)


def rms(tables: Sequence[Floats]) -> Floats:
    """Root of the mean square [n] over all rows of all ``tables`` [K, n]."""
    return np.asarray(np.sqrt((np.concatenate(tables) ** 2).mean(axis=0)), dtype=np.float64)
