"""Motions and torques from CSV files, an even sample a line: ``t,q1..qn`` and, where they are known,
``qd1..qdn`` and ``qdd1..qddn``; ``t,tau1..taun``."""

from __future__ import annotations

import math
import re
from collections import Counter
from dataclasses import dataclass
from functools import partial
from os import PathLike
from pathlib import Path

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.files import read_text
from robodyn.simulate.trajectories.trajectory import Trajectory, end_rates, hermite, least_jerk, uneven_sample

#: Largest file of a motion or of torques [bytes].
LARGEST = 1 << 28

_SAMPLES = 7  # what missing rates at the ends are estimated from


def from_file(path: str | PathLike[str], n: int | None = None) -> Trajectory:
    """The motion in the CSV file ``path`` (s, rad or m), of ``n`` joints if that is known.

    Columns may stand in any order; others than ``t q qd qdd`` are passed over. Missing rates are those of the
    spline of degree five through what is given, whose end rates are those of the polynomial through the seven
    samples there. Times are counted from the first sample.

    Raises
    ------
    InputError: an unreadable file, a column that is missing, a cell that is no finite number, uneven
        times; with the file and the line.
    """
    table = _Table.read(Path(path), "a motion", "t,q1..qn, then qd1..qdn and qdd1..qddn or not")
    groups = table.groups("q", n, ("qd", "qdd"))
    t = table.even_times()
    if len(t) < 2:
        where = Place(table.name, table.lines[-1][0])
        raise InputError("a motion needs samples", where=where, found=str(len(t)), expected="two or more")
    times = (t[-1] - t[0]) / (len(t) - 1) * np.arange(len(t))
    q, qd, qdd = groups["q"], groups.get("qd"), groups.get("qdd")
    if (qd is None or qdd is None) and len(t) < _SAMPLES:
        raise InputError(
            "too few samples to find the rates from",
            where=Place(table.name, table.lines[-1][0]),
            found=f"{len(t)}",
            expected=f"{_SAMPLES} or more, or columns qd and qdd",
        )
    if qd is None:
        qd, bend = least_jerk(times, q, *end_rates(times, q))
        qdd = bend if qdd is None else qdd
    elif qdd is None:
        qdd, _ = least_jerk(times, qd, *end_rates(times, qd))
    provenance = {"kind": "file", "file": table.name, "columns": list(groups), "first": float(t[0])}
    return Trajectory(times, q, qd, qdd, provenance, partial(hermite, times, q, qd, qdd))


def read_torques(path: str | PathLike[str], n: int) -> tuple[Floats, float]:
    """The table [K, n] (N m or N) in the CSV file ``path``, and the time [s] from row to row.

    Columns are found by name, in any order; others are passed over, so that a log will do. Times are counted
    from the first row. A single row is one torque for all time; its period is infinite.

    Raises
    ------
    InputError: an unreadable file, a column that is missing, torques of another arm, a cell that is no finite
        number, times that are not even; with file and line.
    """
    table = _Table.read(Path(path), "torques", f"t,tau1..tau{n}" if n > 1 else "t,tau1")
    tau = table.groups("tau", n)["tau"]
    t = table.even_times()
    return tau, float((t[-1] - t[0]) / (len(t) - 1)) if len(t) > 1 else math.inf


@dataclass(frozen=True, slots=True)
class _Table:
    """The lines of a CSV file below its header, with their numbers, and the ``columns`` that it names."""

    name: str
    what: str
    expected: str
    header: int
    columns: tuple[str, ...]
    lines: list[tuple[int, str]]

    @classmethod
    def read(cls, path: Path, what: str, expected: str) -> _Table:
        text = read_text(path, LARGEST, f"{what}, such as {what.split()[-1]}.csv", path.name)
        lines = [(i, line) for i, line in enumerate(text.splitlines(), 1) if line.strip()]
        if not lines:
            raise InputError("the file is empty", where=Place(path.name, 1), expected=expected)
        columns = tuple(cell.strip() for cell in lines[0][1].split(","))
        return cls(path.name, what, expected, lines[0][0], columns, lines[1:])

    def groups(self, group: str, n: int | None, optional: tuple[str, ...] = ()) -> dict[str, Floats]:
        """The columns [K, n] of a ``group``, and of the ``optional`` ones that are there."""
        where, counts = Place(self.name, self.header), Counter(self.columns)
        numbers = [int(m[1]) for m in (re.fullmatch(rf"{group}([1-9][0-9]{{0,3}})", c) for c in counts) if m]
        joints = range(1, (n or max(numbers, default=1)) + 1)
        wanted = {kind: [f"{kind}{j}" for j in joints] for kind in (group, *optional)}
        twice = [c for c in ("t", *(c for names in wanted.values() for c in names)) if counts[c] > 1]
        if twice:
            found = ", ".join(twice[:8])
            raise InputError("a column stands twice", where=where, found=found, expected=self.expected)
        missing = [name for name in ("t", *wanted[group]) if name not in counts]
        if missing:
            is_other = any(";" in name or "\t" in name for name in self.columns)
            raise InputError(
                f"there is no column {', '.join(missing[:8])}",
                where=where,
                found=", ".join(self.columns)[:200],
                expected=self.expected,
                remedy="separate the columns by commas" if is_other else None,
            )
        if max(numbers) > len(joints):
            what = f"{self.what} of another arm"
            raise InputError(what, where=where, found=f"{max(numbers)} joints", expected=str(n))
        groups = {}
        for kind, names in wanted.items():
            known = [name for name in names if name in counts]
            if known and len(known) < len(names):
                raise InputError(
                    f"some columns of {kind} are missing",
                    where=where,
                    found=", ".join(known)[:200],
                    expected=f"{names[0]} to {names[-1]}, or none of them",
                )
            if known:
                groups[kind] = self.numbers(names)
        return groups

    def numbers(self, names: list[str]) -> Floats:
        """The numbers [K, m] in the columns ``names``, all of them finite."""
        for i, line in self.lines:
            if line.count(",") != len(self.columns) - 1:
                raise InputError(
                    "a line of the wrong length",
                    where=Place(self.name, i),
                    found=f"{line.count(',') + 1} cells",
                    expected=f"{len(self.columns)}, as the header has",
                )
        places = [self.columns.index(name) for name in names]
        table = np.empty((len(self.lines), len(places)))  # no larger than the text: its lines are whole
        for k, (i, line) in enumerate(self.lines):
            cells = line.split(",")
            for column, place in enumerate(places):
                try:
                    table[k, column] = float(cells[place])
                except ValueError:
                    table[k, column] = math.nan
                if not math.isfinite(table[k, column]):
                    raise InputError(
                        f"{names[column]} is not a finite number",
                        where=Place(self.name, i),
                        found=repr(cells[place].strip()[:40]),
                        expected="such as 0.25",
                    )
        return table

    def even_times(self) -> Floats:
        """The times [K] of the lines."""
        if not self.lines:
            where = Place(self.name, self.header)
            raise InputError(
                f"{self.what} without samples", where=where, expected=f"{self.expected}, and rows"
            )
        t = self.numbers(["t"])[:, 0]
        uneven = uneven_sample(t) if len(t) > 1 else None
        if uneven is not None:
            step = (t[-1] - t[0]) / (len(t) - 1)
            even = f"{t[0] + step * uneven:.9g}: one sample every {step:.6g} s"
            raise InputError(
                "the times are not even",
                where=Place(self.name, self.lines[uneven][0]),
                found=f"t = {t[uneven]:.9g}",
                expected=even if step > 0 else "rising times",
                remedy="fill the gaps, or sample at even times",
            )
        return t
