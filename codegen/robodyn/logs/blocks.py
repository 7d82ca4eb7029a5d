"""Logs block by block, or whole: tables whose columns have the usual names as they stand, all others by a
map; second encoders may be in a file of their own, ``arm.csv+arm_secondary.csv``."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.logs.assemble import Block, assemble
from robodyn.logs.content import split_pair
from robodyn.logs.dialect import is_known, joint_of, number_of
from robodyn.logs.formats import format_of, open_recording, readable
from robodyn.logs.limits import EARLIEST, LATEST, SAME_TIME
from robodyn.logs.mapping import GROUPS, JOINTS, Channel, LogMap
from robodyn.logs.recording import Recording
from robodyn.logs.resolve import usual_map
from robodyn.logs.windows import Rows, cut, joined_rows, length_of
from robodyn.robot.model import Robot

#: The groups of columns of a file with second encoders only.
LINKS = ("t", "ql")
_NO_NAMES = "write a first line with the names of the columns"


def log_blocks(
    path: str | os.PathLike[str], n: int | None, mapping: LogMap | None, robot: Robot | None, *, whole: bool
) -> Iterator[Block]:
    """The log in the file ``path``, as :func:`~robodyn.logs.log.read_log` has the parameters: in blocks, or
    in one if ``whole``. A block may have no rows, but notes.

    Raises
    ------
    InputError: no such file, or not such a log; with file, line and column of what is wrong.
    ToolError: the library for its format is missing.
    """
    n = robot.n if n is None and robot is not None else n
    if n is not None and n < 1:
        raise InputError("a log is of one joint or more", found=f"n = {n}")
    name, second = split_pair(os.fspath(path))
    with readable(label(name)):
        first = usual_table(name, n) if mapping is None else None
        links = None
        if first is not None and second is not None:
            links = usual_table(second, first.layout.n, LINKS)
        if first is None or (second is not None and links is None):
            recording = open_recording(name)
            if mapping is None:
                mapping = usual_map(recording, robot)
            elif mapping.is_usual:
                mapping = replace(usual_map(recording, robot), conditions=mapping.conditions)
            if second is not None:
                mapping = with_second(mapping, second)
            yield from assemble(recording, mapping, n, robot, whole=whole)
        else:
            rows = first.blocks(whole=whole)
            for block in rows if links is None else _joined(rows, links, whole):
                is_dated = length_of(block) > 0 and EARLIEST <= float(block["t"][0]) < LATEST
                yield Block(block, began=0.0 if is_dated else None, ignored=first.layout.ignored)


@dataclass(frozen=True, slots=True)
class Layout:
    """Which columns of a file are what: ``groups`` has ``t``, ``q``, ``tau`` and perhaps ``qd``, ``qdd`` and
    ``ql``, each with the positions of its columns, from 0; ``ignored`` are the names of all others.
    ``linked`` are the joints (from 0) that have a column of ``ql``, in its order."""

    n: int
    groups: Mapping[str, tuple[int, ...]]
    ignored: tuple[str, ...]
    linked: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class UsualTable:
    """A ``recording`` that is one table whose columns have the usual names: which are what, ``layout``."""

    recording: Recording
    layout: Layout

    def blocks(self, *, whole: bool) -> Iterator[Rows]:
        """Its rows, block by block or in one: t [k], and groups [k, n]."""
        names, stream = self.recording.names, self.recording.streams[0]
        groups = {group: [names[k] for k in places] for group, places in self.layout.groups.items()}
        tables = (
            iter([self.recording.read(stream, groups, None)])
            if whole
            else self.recording.blocks(stream, groups, None)
        )
        for table in tables:
            rows = {**table.groups, "t": table.groups["t"][:, 0]}
            if "ql" in rows and len(self.layout.linked) < self.layout.n:  # NaN for all other joints
                rows["ql"] = np.full((table.rows, self.layout.n), np.nan)
                rows["ql"][:, list(self.layout.linked)] = table.groups["ql"]
            yield rows


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


# --- second encoders --------------------------------------------------------------------------------------


def with_second(mapping: LogMap, file: str) -> LogMap:
    """``mapping`` with the second encoders in a second ``file``: as it says, else ``ql1`` and so on.

    Raises
    ------
    InputError: there are no such columns.
    """
    channel = mapping.groups.get("ql")
    if channel is None:
        recording = open_recording(file)
        columns = {column for stream in recording.streams for column in stream.columns}
        joints = tuple(j for j in range(1, JOINTS) if f"ql{j}" in columns)
        if not joints:
            raise InputError(
                "the file lacks columns of second encoders",
                where=Place(recording.file),
                found="no ql1, ql2, ...",
                expected="one of them or more, or a map with ql",
            )
        channel = Channel(tuple(f"ql{j}" for j in joints), Place(recording.file), joints=joints)
    return replace(mapping, groups={**mapping.groups, "ql": replace(channel, file=file)})


def _joined(blocks: Iterator[Rows], links: UsualTable, whole: bool) -> Iterator[Rows]:
    """The ``blocks`` with the second encoders in ``links``, row by row."""
    file = links.recording.file
    tables = links.blocks(whole=whole)
    waiting: list[Rows] = []
    rows = 0
    near: float | None = None
    in_first = in_second = np.array(False)
    for block in blocks:
        t, ql = block["t"], block.get("ql")
        count = sum(map(length_of, waiting))
        while count < len(t) and (part := next(tables, None)) is not None:
            waiting.append(part)
            count += length_of(part)
        if count < len(t):
            raise _not_as_many(file, rows + count, rows + len(t) + sum(map(length_of, blocks)))
        together = joined_rows(waiting)
        waiting = [cut(together, len(t))]
        times, second = together["t"][: len(t)], together["ql"][: len(t)]
        if near is None:
            steps = np.diff(t)
            near = SAME_TIME * float(np.median(steps[steps > 0])) if (steps > 0).any() else 0.0
        apart = np.flatnonzero(~(np.abs(times - t) <= near) & ~(np.isnan(times) & np.isnan(t)))
        if len(apart):
            k = int(apart[0])
            raise InputError(
                "the two files are not of the same times",
                where=Place(file),
                found=f"t = {times[k]:.9g} s in row {rows + k + 1}",
                expected=f"{t[k]:.9g} s, as in the first file",
                remedy="write both at the same times",
            )
        rows += len(t)
        if ql is not None:
            in_first = in_first | ~np.isnan(ql).all(axis=0)
            in_second = in_second | ~np.isnan(second).all(axis=0)
            both = np.flatnonzero(in_first & in_second)
            if len(both):
                raise InputError(
                    "a joint has two second encoders",
                    where=Place(file),
                    found=f"ql{both[0] + 1} in both files",
                    remedy="delete one of the columns",
                )
            second = np.where(np.isnan(ql), second, ql)
        yield {**block, "ql": second}
    more = sum(map(length_of, [*waiting, *tables]))
    if more:
        raise _not_as_many(file, rows + more, rows)


def _not_as_many(file: str, rows: int, beside: int) -> InputError:
    """What to say of a second ``file`` with other ``rows`` than the first has."""
    return InputError(
        "the two files are not of the same samples",
        where=Place(file),
        found=f"{rows} rows",
        expected=f"{beside}, as in the first file",
        remedy="write both at the same times",
    )


# --- usual names ------------------------------------------------------------------------------------------


def layout_of(
    names: Sequence[str], n: int | None, where: Place, wanted: Sequence[str] = GROUPS, *, named: bool = True
) -> Layout:
    """The layout of a file whose columns are called ``names``; ``n`` joints, None: as many as it numbers.

    ``wanted``: the groups that are looked for; ``named``: whether the file names its columns itself.

    Raises
    ------
    InputError: columns are missing, or there twice.
    """

    def listed(names: Sequence[str]) -> str:
        more = f" and {len(names) - 8} more" if len(names) > 8 else ""
        return ", ".join(names[:8]) + more

    twice = sorted(name for name, count in Counter(names).items() if count > 1 and is_known(name))
    if twice:
        what, remedy = "the log has two columns with the same name", "delete or rename all but one"
        raise InputError(what, where=where, found=listed(twice), remedy=remedy)
    known = [each for each in map(joint_of, names) if each is not None]
    joints = max((number for group, number in known if group != "ql"), default=1) if n is None else n
    at = {name: position for position, name in enumerate(names)}
    groups: dict[str, tuple[int, ...]] = {}
    for group in (each for each in wanted if each != "ql"):
        is_optional = group in ("qd", "qdd")
        columns = ["t"] if group == "t" else [f"{group}{i}" for i in range(1, joints + 1)]
        missing = [name for name in columns if name not in at]
        if is_optional and len(missing) == len(columns):
            continue
        if missing:
            all_of = "t,q1,tau1" if joints == 1 else f"t,q1..q{joints},tau1..tau{joints}"
            raise InputError(
                "the log lacks columns",
                where=where,
                found=f"no {listed(missing)}",
                expected=f"all of {columns[0]}..{columns[-1]}, or none" if is_optional else all_of,
                remedy=_header_remedy(names, at) if named else _NO_NAMES,
            )
        groups[group] = tuple(at[name] for name in columns)
    linked = tuple(i for i in range(joints) if f"ql{i + 1}" in at)
    if "q" not in wanted and not linked:
        raise InputError(
            "the file lacks columns of second encoders",
            where=where,
            found=f"no ql1..ql{joints}",
            expected="t and one of them or more",
            remedy="name the columns so: ql1 is the encoder at the link of joint 1 [rad or m]",
        )
    if linked:
        groups["ql"] = tuple(at[f"ql{i + 1}"] for i in linked)
    read = {position for group in groups.values() for position in group}
    return Layout(joints, groups, tuple(x for k, x in enumerate(names) if k not in read), linked)


def _header_remedy(names: Sequence[str], known: Mapping[str, int]) -> str | None:
    if len(names) == 1 and not names[0].startswith("#"):
        for mark, word in ((";", "semicolons"), ("\t", "tabs"), (" ", "spaces")):
            if mark in names[0]:
                return f"separate the columns by commas, not {word} (and write decimals with a point)"
    if names and all(number_of(name.encode()) is not None for name in names):
        return _NO_NAMES
    if names and names[0].startswith("#"):
        return "delete the lines above the names of the columns, and the #"
    if "q0" in known:
        return "number the joints from 1"
    if any(not is_known(name) and is_known(name.lower()) for name in names):
        return "write the names in small letters"
    if "t" not in known and any(is_known(name) for name in names):
        return "call the time t [s]"
    return "name the columns so, in any order, in SI units"
