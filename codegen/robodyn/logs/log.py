"""Logs: what a robot's controller, or a simulation in its place, records of a motion.

As text: ``t,q1..qn,qd1..qdn,qdd1..qddn,tau1..taun`` in SI units, a line a sample; velocities and
accelerations may be absent, and ``ql1..`` may follow: second encoders, on the links. Parquet has the same
columns. Where a log comes from is told by the file beside
it, ``LOG.csv.json``, which depends on nothing but the run: no time of day, no place in a file system.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.logs.columns import GROUPS, LINKS, Layout
from robodyn.logs.csv_file import read_csv, write_csv
from robodyn.logs.parquet_file import read_parquet, write_parquet
from robodyn.logs.provenance import provenance_text
from robodyn.logs.second_file import joined, split_pair, spread

Floats = NDArray[np.float64]

_PARQUET = (".parquet", ".pq")


@dataclass(frozen=True, slots=True, eq=False)
class Log:
    """Samples of a motion: ``t`` [K] (s); ``q``, ``qd``, ``qdd`` [K, n] (rad or m, per second, per second
    squared), the rates None where they were not recorded; ``tau`` [K, n] (N m or N).

    ``ql`` [K, n] are second encoders, behind the gears (rad or m): NaN throughout for joints that have none,
    None where no joint has one. ``provenance`` is what :func:`provenance` says of a run; ``ignored`` are the
    columns of a file that were not read. NaN and infinity may stand anywhere.

    Raises
    ------
    InputError: the arrays do not fit together.
    """

    t: Floats
    q: Floats
    qd: Floats | None
    qdd: Floats | None
    tau: Floats
    provenance: Mapping[str, Any] = field(default_factory=dict)
    ignored: tuple[str, ...] = ()
    ql: Floats | None = None

    def __post_init__(self) -> None:
        for name in ("t", "q", "qd", "qdd", "tau", "ql"):
            value = getattr(self, name)
            if value is not None:
                object.__setattr__(self, name, np.asarray(value, dtype=np.float64))
        shape = self.q.shape
        fits = len(shape) == 2 and shape[0] > 0 and shape[1] > 0 and self.t.shape == shape[:1]
        if not fits or any(array.shape != shape for _, array in self._groups()):
            columns = [("t", self.t), *self._groups()]
            raise InputError(
                "the arrays of a log do not fit together",
                found=", ".join(f"{name} {list(array.shape)}" for name, array in columns),
                expected="t [K] and all others [K, n], K and n at least 1",
            )

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.q.shape[1])

    @property
    def samples(self) -> int:
        """Number of samples, K."""
        return len(self.t)

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of its columns, in the order of the text."""
        return ("t", *(f"{name}{i + 1}" for name, _ in self._groups() for i in self._joints(name)))

    @property
    def linked(self) -> tuple[int, ...]:
        """The joints (from 0) that have a second encoder."""
        if self.ql is None:
            return ()
        return tuple(j for j in range(self.n) if not np.isnan(self.ql[:, j]).all())

    def arrays(self) -> list[Floats]:
        """Its columns, [K] each."""
        return [self.t, *(array[:, i] for name, array in self._groups() for i in self._joints(name))]

    def csv(self) -> str:
        """Its text: shortest numbers that read back as the same doubles, lines that end in a newline."""
        return write_csv(self.columns, self.arrays())

    def parquet(self) -> bytes:
        """The bytes of a Parquet file of the same columns.

        Raises
        ------
        ToolError: pyarrow is missing.
        """
        return write_parquet(self.columns, self.arrays())

    def files(self, name: str) -> dict[str, str | bytes]:
        """The log called ``name`` (by its ending text or Parquet), and ``NAME.json`` with its provenance.

        Raises
        ------
        ToolError: it is to be Parquet, and pyarrow is missing.
        """
        content = self.parquet() if name.lower().endswith(_PARQUET) else self.csv()
        return {name: content, f"{name}.json": provenance_text(self.provenance)}

    def _groups(self) -> list[tuple[str, Floats]]:
        groups = (
            ("q", self.q), ("qd", self.qd), ("qdd", self.qdd), ("tau", self.tau), ("ql", self.ql)
        )  # fmt: skip
        return [(name, array) for name, array in groups if array is not None]

    def _joints(self, group: str) -> tuple[int, ...]:
        """The joints (from 0) that have columns of that ``group``."""
        return self.linked if group == "ql" else tuple(range(self.n))


# --- reading ----------------------------------------------------------------------------------------------


def read_log(path: str | os.PathLike[str], n: int | None = None) -> Log:
    """The log in the file ``path``: Parquet if its name ends in .parquet or .pq, else text.

    ``A.csv+B.csv`` is the log in A.csv with the columns of second encoders, ``ql1..``, in B.csv.
    ``n``: how many joints are read; None: as many as the columns number. Columns are found by name, in any
    order; all others are listed in ``ignored``. NaN and infinity are read, words are not.

    Raises
    ------
    InputError: no such file, or not such a log; with file, line and column of what is wrong.
    ToolError: it is Parquet, and pyarrow is missing.
    """
    if n is not None and n < 1:
        raise InputError("a log is of one joint or more", found=f"n = {n}")
    name, second = split_pair(os.fspath(path))
    layout, tables = _read(name, n)
    ql = spread(tables.get("ql"), layout)
    log = Log(
        tables["t"][:, 0], tables["q"], tables.get("qd"), tables.get("qdd"), tables["tau"], {},
        layout.ignored, ql,
    )  # fmt: skip
    if second is None:
        return log
    other, more = _read(second, log.n, LINKS)
    return replace(log, ql=joined(log.t, log.ql, more["t"][:, 0], spread(more["ql"], other), label(second)))


def _read(name: str, n: int | None, wanted: Sequence[str] = GROUPS) -> tuple[Layout, dict[str, Floats]]:
    """The groups ``wanted`` of the file called ``name``."""
    file = label(name)
    try:
        read = read_parquet if name.lower().endswith(_PARQUET) else read_csv
        return read(Path(name), file, n, wanted)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise InputError("the log cannot be read", where=Place(file), found=reason.lower()) from None
    except MemoryError:
        raise InputError(
            "the log does not fit into memory",
            where=Place(file),
            remedy="take a part of it, or fewer samples a second",
        ) from None
