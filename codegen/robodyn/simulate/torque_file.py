"""Torques of the motors over time from CSV files: ``t,tau1..taun``, an even sample a line."""

from __future__ import annotations

import math
import re
from collections import Counter
from os import PathLike
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.files import read_text
from robodyn.simulate.trajectories.file import LARGEST
from robodyn.simulate.trajectories.trajectory import uneven_sample

Floats = NDArray[np.float64]


def read_torques(path: str | PathLike[str], n: int) -> tuple[Floats, float]:
    """The table [K, n] (N m or N) in the CSV file ``path``, and the time [s] from row to row.

    Columns are found by name, in any order; others are passed over, so that a log will do. Times are counted
    from the first row. A single row is one torque for all time; its period is infinite.

    Raises
    ------
    InputError: an unreadable file, a column that is missing, torques of another arm, a cell that is no finite
        number, times that are not even; with file and line.
    """
    name = Path(path).name
    header, rows = _rows(Path(path), name)
    columns = _columns(header[1], n, Place(name, header[0]))
    table = np.empty((len(rows), n + 1))
    for k, (line, text) in enumerate(rows):
        cells = [cell.strip() for cell in text.split(",")]
        if len(cells) != len(header[1]):
            raise InputError(
                "a line of the wrong length",
                where=Place(name, line),
                found=f"{len(cells)} cells",
                expected=f"{len(header[1])}, as the header has",
            )
        for place, column in enumerate(columns):
            table[k, place] = _number(cells[column], header[1][column], Place(name, line))
    t = table[:, 0]
    if len(t) == 1:
        return table[:, 1:].copy(), math.inf
    period = float((t[-1] - t[0]) / (len(t) - 1))
    uneven = uneven_sample(t)
    if uneven is not None:
        raise InputError(
            "the times are not even",
            where=Place(name, rows[uneven][0]),
            found=f"t = {t[uneven]:.9g}",
            expected=f"a row every {period:.6g} s" if period > 0 else "rising times",
            remedy="fill the gaps, or sample the torques at even times",
        )
    return table[:, 1:].copy(), period


def _rows(path: Path, name: str) -> tuple[tuple[int, list[str]], list[tuple[int, str]]]:
    """The cells of the header and the rows, each with the number of its line."""
    text = read_text(path, LARGEST, "torques, such as torques.csv", name)
    rows = [(i, line) for i, line in enumerate(text.splitlines(), 1) if line.strip()]
    if len(rows) < 2:
        raise InputError(
            "there are no torques in the file",
            where=Place(name),
            found="the header only" if rows else "nothing",
            expected="t,tau1..taun and a row or more",
        )
    first, header = rows[0]
    return (first, [cell.strip() for cell in header.split(",")]), rows[1:]


def _columns(names: list[str], n: int, where: Place) -> list[int]:
    """Places of ``t`` and of ``tau1`` to ``taun``."""
    wanted = ["t", *(f"tau{i}" for i in range(1, n + 1))]
    counts = Counter(names)
    twice = sorted(name for name in wanted if counts[name] > 1)
    missing = [name for name in wanted if name not in counts]
    if twice or missing:
        raise InputError(
            f"there {'are two columns' if twice else 'is no column'} {', '.join((twice or missing)[:8])}",
            where=where,
            found=", ".join(names)[:200],
            expected=f"t,tau1..tau{n}" if n > 1 else "t,tau1",
            remedy="separate the columns by commas" if any(";" in x or "\t" in x for x in names) else None,
        )
    joints = [int(match[1]) for match in (re.fullmatch(r"tau([1-9][0-9]{0,3})", x) for x in names) if match]
    if max(joints) > n:
        raise InputError(
            "the torques are of another arm",
            where=where,
            found=f"tau{max(joints)}",
            expected=f"{n} joint{'s' if n > 1 else ''}",
        )
    return [names.index(name) for name in wanted]


def _number(cell: str, column: str, where: Place) -> float:
    try:
        value = float(cell)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InputError(
            f"{column} is not a finite number", where=where, found=repr(cell[:40]), expected="such as 0.25"
        )
    return value
