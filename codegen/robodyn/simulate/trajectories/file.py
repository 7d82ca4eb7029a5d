"""Motions from CSV files: ``t,q1..qn`` and, where they are known, ``qd1..qdn`` and ``qdd1..qddn``."""

from __future__ import annotations

import re
from collections import Counter
from functools import partial
from os import PathLike
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.files import read_text
from robodyn.simulate.trajectories.spline import end_rates, hermite, least_jerk
from robodyn.simulate.trajectories.trajectory import Trajectory, uneven_sample

Floats = NDArray[np.float64]

#: Largest file of a motion or of torques [bytes].
LARGEST = 1 << 28

_SAMPLES = 7  # what missing rates at the ends are estimated from
_HEADER = "t,q1..qn, then qd1..qdn and qdd1..qddn or not"


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
    name = Path(path).name
    columns, table, lines = _read(Path(path), name, n)
    where = partial(Place, name)
    t = table[:, columns["t"][0]]
    step = (t[-1] - t[0]) / (len(t) - 1)
    uneven = uneven_sample(t)
    if uneven is not None:
        raise InputError(
            "the times are not even",
            where=where(lines[uneven]),
            found=f"t = {t[uneven]:.9g}",
            expected=f"{t[0] + step * uneven:.9g}: one sample every {step:.6g} s"
            if step > 0
            else "rising times",
            remedy="sample the motion at even times",
        )
    times = step * np.arange(len(t))
    q = table[:, columns["q"]]
    qd = table[:, columns["qd"]] if "qd" in columns else None
    qdd = table[:, columns["qdd"]] if "qdd" in columns else None
    if (qd is None or qdd is None) and len(t) < _SAMPLES:
        raise InputError(
            "too few samples to find the rates from",
            where=where(lines[-1]),
            found=f"{len(t)}",
            expected=f"{_SAMPLES} or more, or columns qd and qdd",
        )
    kinds = [kind for kind in ("q", "qd", "qdd") if kind in columns]
    if qd is None:
        qd, bend = least_jerk(times, q, *end_rates(times, q))
        qdd = bend if qdd is None else qdd
    elif qdd is None:
        qdd, _ = least_jerk(times, qd, *end_rates(times, qd))
    provenance = {"kind": "file", "file": name, "columns": kinds, "first": float(t[0])}
    return Trajectory(times, q, qd, qdd, provenance, partial(hermite, times, q, qd, qdd))


def _read(path: Path, name: str, n: int | None) -> tuple[dict[str, list[int]], Floats, list[int]]:
    """Columns by kind, the table [K, columns] and the line of each sample."""
    text = read_text(path, LARGEST, "a motion, such as motion.csv", name)
    rows = [(i, line) for i, line in enumerate(text.splitlines(), 1) if line.strip()]
    if not rows:
        raise InputError("the file is empty", where=Place(name, 1), expected=_HEADER)
    first, header = rows[0]
    names = [cell.strip() for cell in header.split(",")]
    columns = _columns(names, Place(name, first), n)
    lines = [i for i, _ in rows[1:]]
    if len(lines) < 2:
        raise InputError(
            "a motion needs samples",
            where=Place(name, rows[-1][0]),
            found=str(len(lines)),
            expected="two or more",
        )
    wanted = sorted(k for kind in columns.values() for k in kind)
    for i, line in rows[1:]:
        if line.count(",") != len(names) - 1:
            raise InputError(
                "a line of the wrong length",
                where=Place(name, i),
                found=f"{line.count(',') + 1} cells",
                expected=f"{len(names)}, as the header has",
            )
    table = np.empty((len(lines), len(wanted)))  # no larger than the text, now that its lines are whole
    for sample, (i, line) in enumerate(rows[1:]):
        cells = line.split(",")
        for column, k in enumerate(wanted):
            try:
                table[sample, column] = float(cells[k])
            except ValueError:
                raise _not_number(name, i, names[k], cells[k]) from None
        if not np.isfinite(table[sample]).all():
            k = next(k for column, k in enumerate(wanted) if not np.isfinite(table[sample, column]))
            raise _not_number(name, i, names[k], cells[k])
    at = {k: column for column, k in enumerate(wanted)}
    return {kind: [at[k] for k in places] for kind, places in columns.items()}, table, lines


def _columns(names: list[str], where: Place, n: int | None) -> dict[str, list[int]]:
    """Places of ``t``, ``q`` and of those rates that are there, joint by joint."""
    repeated = sorted(name for name, times in Counter(names).items() if times > 1)
    if repeated:
        listed = ", ".join(repeated[:8])
        raise InputError("a column stands twice", where=where, found=listed[:200], expected=_HEADER)
    joints = [int(match[1]) for name in names if (match := re.fullmatch(r"q([1-9][0-9]{0,3})", name))]
    count = n or max(joints, default=1)
    there = {name: place for place, name in enumerate(names)}
    missing = [name for name in ("t", *(f"q{j + 1}" for j in range(count))) if name not in there]
    if missing:
        raise InputError(
            f"there is no column {', '.join(missing[:8])}",
            where=where,
            found=", ".join(names)[:200],
            expected=_HEADER,
            remedy="separate the columns by commas" if any(";" in x or "\t" in x for x in names) else None,
        )
    if n is not None and max(joints) > n:
        raise InputError(
            "the motion is of another arm", where=where, found=f"{max(joints)} joints", expected=str(n)
        )
    columns = {"t": [there["t"]], "q": [there[f"q{j + 1}"] for j in range(count)]}
    for kind in ("qd", "qdd"):
        own = [f"{kind}{j + 1}" for j in range(count)]
        known = [name for name in own if name in there]
        if known and len(known) < count:
            raise InputError(
                f"some columns of {kind} are missing",
                where=where,
                found=", ".join(known)[:200],
                expected=f"{own[0]} to {own[-1]}, or none of them",
            )
        if known:
            columns[kind] = [there[name] for name in own]
    return columns


def _not_number(file: str, line: int, column: str, cell: str) -> InputError:
    return InputError(
        f"{column} is not a finite number",
        where=Place(file, line),
        found=repr(cell.strip()[:40]),
        expected="such as 0.25",
    )
