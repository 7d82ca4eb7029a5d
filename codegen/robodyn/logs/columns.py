"""The columns of a log, found by their names: what a file of any kind must have."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from robodyn.errors import InputError, Place

#: Largest log [numbers in the columns that are read]: 2 GiB of doubles, more than any simulation writes.
LARGEST = 1 << 28

#: The groups of columns of a log, and those of a file with second encoders only.
GROUPS = ("t", "q", "qd", "qdd", "tau", "ql")
LINKS = ("t", "ql")

_NO_NAMES = "write a first line with the names of the columns"
_INDEXED = re.compile(r"(q|qd|qdd|tau|ql)([1-9][0-9]{0,2})\Z")


@dataclass(frozen=True, slots=True)
class Layout:
    """Which columns of a file are what: ``groups`` has ``t``, ``q``, ``tau`` and perhaps ``qd``, ``qdd`` and
    ``ql``, each with the positions of its columns, from 0; ``ignored`` are the names of all others.
    ``linked`` are the joints (from 0) that have a column of ``ql``, in its order."""

    n: int
    width: int
    groups: Mapping[str, tuple[int, ...]]
    ignored: tuple[str, ...]
    linked: tuple[int, ...] = ()

    @property
    def wanted(self) -> tuple[int, ...]:
        """Positions of all columns that are read, group after group."""
        return tuple(position for group in self.groups.values() for position in group)


def layout_of(
    names: Sequence[str], n: int | None, where: Place, wanted: Sequence[str] = GROUPS, *, named: bool = True
) -> Layout:
    """The layout of a file whose columns are called ``names``; ``n`` joints, None: as many as it numbers.

    ``wanted``: the groups that are looked for; ``named``: whether the file names its columns itself.

    Raises
    ------
    InputError: columns are missing, or there twice.
    """
    twice = sorted(name for name, count in Counter(names).items() if count > 1 and is_known(name))
    if twice:
        raise InputError(
            "the log has two columns with the same name",
            where=where,
            found=_short(twice),
            remedy="delete or rename all but one",
        )
    numbers = [int(match[2]) for match in map(_INDEXED.match, names) if match and match[1] != "ql"]
    joints = max(numbers, default=1) if n is None else n
    at = {name: position for position, name in enumerate(names)}
    groups: dict[str, tuple[int, ...]] = {}
    for group in wanted:
        if group == "ql":
            continue
        columns = ["t"] if group == "t" else [f"{group}{i}" for i in range(1, joints + 1)]
        missing = [name for name in columns if name not in at]
        if len(missing) == len(columns) and group in ("qd", "qdd"):
            continue
        if missing:
            optional = group in ("qd", "qdd")
            raise InputError(
                "the log lacks columns",
                where=where,
                found=f"no {_short(missing)}",
                expected=f"all of {columns[0]}..{columns[-1]}, or none" if optional else _expected(joints),
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
    ignored = tuple(name for position, name in enumerate(names) if position not in read)
    return Layout(joints, len(names), groups, ignored, linked)


def is_known(name: str) -> bool:
    """Whether ``name`` is one that a column of a log has."""
    return name == "t" or _INDEXED.match(name) is not None


def _short(names: Sequence[str]) -> str:
    listed = ", ".join(names[:8])
    return listed if len(names) <= 8 else f"{listed} and {len(names) - 8} more"


def _expected(n: int) -> str:
    """The required columns, in words; qd and qdd may be there too."""
    return "t,q1,tau1" if n == 1 else f"t,q1..q{n},tau1..tau{n}"


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


def number_of(cell: bytes) -> float | None:
    """The double nearest to what the cell says, or None."""
    try:
        return None if b"_" in cell else float(cell)
    except ValueError:
        return None
