"""Logs: what a robot's controller, or a simulation in its place, records of a motion.

As text: ``t,q1..qn,qd1..qdn,qdd1..qddn,tau1..taun`` in SI units, a line a sample; velocities and
accelerations may be absent, and ``ql1..`` may follow: second encoders, on the links. Parquet has the same
columns. Where a log comes from is told by the file beside
it, ``LOG.csv.json``, which depends on nothing but the run: no time of day, no place in a file system.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.logs.assemble import Block
from robodyn.logs.blocks import log_blocks
from robodyn.logs.mapping import LogMap
from robodyn.logs.streams import CONDITION, Mean, mean_of
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Log:
    """Samples of a motion: ``t`` [K] (s); ``q``, ``qd``, ``qdd`` [K, n] (rad or m, per second, per second
    squared), the rates None where they were not recorded; ``tau`` [K, n] (N m or N).

    ``ql`` [K, n] are second encoders, behind the gears (rad or m): NaN throughout for joints that have none,
    None where no joint has one. ``provenance`` is what :func:`provenance` says of a run; ``ignored`` are the
    columns of a file that were not read; ``notes`` say what was done to bring its streams together.
    ``began``: when t = 0 was [s since 1970, UTC], None where its times are no dates; ``conditions``: means of
    the columns that a map calls so. NaN and infinity may stand anywhere.

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
    notes: tuple[str, ...] = ()
    began: float | None = None
    conditions: Mapping[str, Mean] = field(default_factory=dict)

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
    def date(self) -> float | None:
        """When its first sample was recorded [s since 1970, UTC]; None where its times are no dates."""
        return None if self.began is None or not np.isfinite(self.t[0]) else self.began + float(self.t[0])

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
        from robodyn.logs.formats.parquet import write_parquet

        return write_parquet(self.columns, self.arrays())

    def files(self, name: str) -> dict[str, str | bytes]:
        """The log called ``name`` (by its ending text or Parquet), and ``NAME.json`` with its provenance.

        Raises
        ------
        ToolError: it is to be Parquet, and pyarrow is missing.
        """
        from robodyn.logs.formats.parquet import FORMAT
        from robodyn.logs.provenance import provenance_text

        is_parquet = name.lower().endswith(FORMAT.suffixes)
        content = self.parquet() if is_parquet else self.csv()
        return {name: content, f"{name}.json": provenance_text(self.provenance)}

    def _groups(self) -> list[tuple[str, Floats]]:
        groups = (
            ("q", self.q), ("qd", self.qd), ("qdd", self.qdd), ("tau", self.tau), ("ql", self.ql)
        )  # fmt: skip
        return [(name, array) for name, array in groups if array is not None]

    def _joints(self, group: str) -> tuple[int, ...]:
        """The joints (from 0) that have columns of that ``group``."""
        return self.linked if group == "ql" else tuple(range(self.n))


def write_csv(names: Sequence[str], columns: Sequence[Floats]) -> str:
    """The text of a log: the header, and a line a sample; ``columns`` are ``[K]`` each. Every number is the
    shortest that reads back as the same double."""
    rows = (",".join(map(repr, row)) for row in np.column_stack(columns).tolist())
    return "\n".join([",".join(names), *rows, ""])


#: A log, its file, or what hands it over and keeps nothing of it: a long one is let go once it was looked at.
LogSource = Log | str | os.PathLike[str] | Callable[[], Log]


# --- reading ----------------------------------------------------------------------------------------------


def log_of(source: LogSource, n: int) -> Log:
    """The log of ``n`` joints that ``source`` is, names or hands over.

    Raises
    ------
    InputError: no such file, or not such a log.
    """
    if isinstance(source, Log):
        return source
    return source() if callable(source) else read_log(source, n)


def read_log(
    path: str | os.PathLike[str],
    n: int | None = None,
    *,
    mapping: LogMap | None = None,
    robot: Robot | None = None,
) -> Log:
    """The log in the file ``path``: text, Parquet, npz, MATLAB, MCAP, rosbag2 or JSON, by its ending.

    ``A.csv+B.csv`` is the log in A.csv with the columns of second encoders, ``ql1..``, in B.csv.
    ``n``: how many joints are read; None: as many as ``robot`` has, or the columns number. ``mapping`` says
    which columns are what and in which units; ``robot`` has the gears that it may leave to the description.
    Without a map the columns have the names of :attr:`Log.columns`, in any order; all others are listed in
    ``ignored``, and joint states of a bag go by the joints' names. NaN and infinity are read, words are not.

    Raises
    ------
    InputError: no such file, or not such a log; with file, line and column of what is wrong.
    ToolError: the library for its format is missing.
    """
    [block] = log_blocks(path, n, mapping, robot, whole=True)
    return log_of_block(block)


def log_of_block(block: Block) -> Log:
    """The log whose samples are the rows of ``block``."""
    rows = block.rows
    readings = {
        name.removeprefix(CONDITION): mean_of(each)
        for name, each in rows.items()
        if name.startswith(CONDITION)
    }
    return Log(
        rows["t"], rows["q"], rows.get("qd"), rows.get("qdd"), rows["tau"], {}, block.ignored,
        rows.get("ql"), block.notes, block.began, {**readings, **block.apart},
    )  # fmt: skip
