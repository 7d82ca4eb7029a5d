"""Logs: what a robot's controller, or a simulation in its place, records of a motion.

As text: ``t,q1..qn,qd1..qdn,qdd1..qddn,tau1..taun`` in SI units, a line a sample; velocities and
accelerations may be absent, and ``ql1..`` may follow: second encoders, on the links. Parquet has the same
columns. Where a log comes from is told by the file beside
it, ``LOG.csv.json``, which depends on nothing but the run: no time of day, no place in a file system.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.logs.assemble import Arrays, assemble
from robodyn.logs.columns import GROUPS, LINKS, Layout, layout_of
from robodyn.logs.conditions import Mean, mean_of
from robodyn.logs.formats import FORMATS, format_of, open_recording, readable
from robodyn.logs.limits import EARLIEST, LATEST
from robodyn.logs.mapping import LogMap
from robodyn.logs.provenance import provenance_text
from robodyn.logs.recording import Recording, Table
from robodyn.logs.second_file import Joining, not_as_many, split_pair, spread, with_second
from robodyn.logs.shortest import write_csv
from robodyn.logs.usual import usual_map
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


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
        content = self.parquet() if name.lower().endswith(FORMATS["parquet"].suffixes) else self.csv()
        return {name: content, f"{name}.json": provenance_text(self.provenance)}

    def _groups(self) -> list[tuple[str, Floats]]:
        groups = (
            ("q", self.q), ("qd", self.qd), ("qdd", self.qdd), ("tau", self.tau), ("ql", self.ql)
        )  # fmt: skip
        return [(name, array) for name, array in groups if array is not None]

    def _joints(self, group: str) -> tuple[int, ...]:
        """The joints (from 0) that have columns of that ``group``."""
        return self.linked if group == "ql" else tuple(range(self.n))


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
    if robot is not None and n is None:
        n = robot.n
    if n is not None and n < 1:
        raise InputError("a log is of one joint or more", found=f"n = {n}")
    name, second = split_pair(os.fspath(path))
    with readable(label(name)):
        tables = usual_tables(name, second, n) if mapping is None else None
    if tables is None:
        return _of_recording(name, second, mapping, n, robot)
    first, links = tables
    with readable(label(name)):
        log = log_of_arrays(first.read(), first.layout.ignored)
    if links is None:
        return log
    file = links.recording.file
    with readable(file):
        arrays = links.read()
    if len(arrays.t) != log.samples:
        raise not_as_many(file, len(arrays.t), log.samples)
    return replace(log, ql=Joining(file).joined(log.t, log.ql, arrays.t, arrays.groups["ql"]))


@dataclass(frozen=True, slots=True)
class UsualTable:
    """A ``recording`` that is one table whose columns have the usual names: which are what, ``layout``."""

    recording: Recording
    layout: Layout

    @property
    def groups(self) -> dict[str, list[str]]:
        """The names of its columns, group by group."""
        names = self.recording.names
        return {group: [names[k] for k in places] for group, places in self.layout.groups.items()}

    def read(self) -> Arrays:
        """All of its rows."""
        return self._arrays(self.recording.read(self.recording.streams[0], self.groups, None))

    def blocks(self) -> Iterator[Arrays]:
        """Its rows, block by block."""
        return map(self._arrays, self.recording.blocks(self.recording.streams[0], self.groups, None))

    def _arrays(self, table: Table) -> Arrays:
        t = table.groups["t"][:, 0]
        groups = {group: columns for group, columns in table.groups.items() if group not in ("t", "ql")}
        if "ql" in table.groups:
            groups["ql"] = spread(table.groups["ql"], self.layout)
        is_dated = len(t) > 0 and EARLIEST <= float(t[0]) < LATEST
        return Arrays(t, groups, (), 0.0 if is_dated else None)


def usual_tables(name: str, second: str | None, n: int | None) -> tuple[UsualTable, UsualTable | None] | None:
    """The table in the file ``name``, and that of second encoders in the file ``second``, if both are tables
    whose columns have the usual names.

    Raises
    ------
    InputError: one of them lacks columns.
    """
    if second is not None and not format_of(second).is_table:
        return None
    first = usual_table(name, n)
    if first is None or second is None:
        return None if first is None else (first, None)
    links = usual_table(second, first.layout.n, LINKS)
    return None if links is None else (first, links)


def usual_table(name: str, n: int | None, wanted: Sequence[str] = GROUPS) -> UsualTable | None:
    """The table in the file ``name`` with the groups ``wanted`` of ``n`` joints; None where a map must say
    which columns are what: it is no table, or states units.

    Raises
    ------
    InputError: it lacks columns.
    """
    if not format_of(name).is_table:
        return None
    recording = open_recording(name, gaps=False)
    if recording.streams[0].units and wanted == GROUPS:
        return None
    where = Place(recording.file, recording.line)
    return UsualTable(recording, layout_of(recording.names, n, where, wanted, named=recording.named))


def _of_recording(
    name: str, second: str | None, mapping: LogMap | None, n: int | None, robot: Robot | None
) -> Log:
    """The log in a file of any format, by a map."""
    recording = open_recording(name)
    mapping = map_for(recording, second, mapping, robot)
    with readable(recording.file):
        arrays = assemble(recording, mapping, n, robot, open_recording)
    return log_of_arrays(arrays, ())


def map_for(recording: Recording, second: str | None, mapping: LogMap | None, robot: Robot | None) -> LogMap:
    """The map of ``recording``: usual names where ``mapping`` says none; encoders of a ``second`` file."""
    if mapping is None:
        mapping = usual_map(recording, robot)
    elif mapping.is_usual:
        mapping = replace(usual_map(recording, robot), conditions=mapping.conditions)
    return mapping if second is None else with_second(mapping, open_recording(second), second)


def log_of_arrays(arrays: Arrays, ignored: tuple[str, ...]) -> Log:
    """The log that ``arrays`` are."""
    groups = arrays.groups
    conditions = {**{name: mean_of(each) for name, each in arrays.readings.items()}, **arrays.apart}
    return Log(
        arrays.t, groups["q"], groups.get("qd"), groups.get("qdd"), groups["tau"], {}, ignored,
        groups.get("ql"), arrays.notes, arrays.began, conditions,
    )  # fmt: skip
