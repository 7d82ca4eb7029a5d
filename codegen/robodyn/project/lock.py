"""``robodyn.lock``: the counts of every function and the hashes of all files, to be committed."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from robodyn.errors import InputError, Place
from robodyn.files import label, read_text
from robodyn.project.product import Counts
from robodyn.project.tables import LARGEST_FILE, parsed

_HEAD: Final = """\
# Written by robodyn build; to be committed. The operations of every function as robodyn flops counts them,
# and the SHA-256 of every file. robodyn build --check fails where a count grows or a file differs.
version = 1
"""
_BARE: Final = re.compile(r"[A-Za-z0-9_-]+")


@dataclass(frozen=True, slots=True)
class Locked:
    """What a lock file says of a robot: the folder of its output, counts by function and kind, and hashes of
    the files in that folder."""

    output: str
    counts: Counts
    files: Mapping[str, str]


Lock = Mapping[str, Locked]


def lock_text(lock: Lock) -> str:
    """The text of a lock file, robots sorted by name: one line a function and a file."""
    lines = [_HEAD]
    for name, locked in sorted(lock.items()):
        table = f"robots.{_key(name)}"
        lines += [f"[{table}]", f"output = {_string(locked.output)}", "", f"[{table}.counts]"]
        for function, counts in locked.counts.items():
            pairs = ", ".join(f"{kind} = {count}" for kind, count in counts.items())
            lines.append(f"{_key(function)} = {{ {pairs} }}")
        lines += ["", f"[{table}.files]"]
        lines += [f"{_key(file)} = {_string(sha256)}" for file, sha256 in locked.files.items()]
        lines.append("")
    return "\n".join(lines).rstrip("\n") + "\n"


def read_lock(path: Path) -> Lock | None:
    """The lock file at ``path``; None where there is none.

    Raises
    ------
    InputError: it is no lock file, or one of another robodyn.
    """
    if not path.exists():
        return None
    name = label(path)
    text = read_text(path, LARGEST_FILE, "a lock file of robodyn build", name)
    data = parsed(text, name)
    try:
        if data["version"] != 1:
            raise ValueError
        return {
            robot: Locked(str(table["output"]), _counts(table["counts"]), _hashes(table["files"]))
            for robot, table in data["robots"].items()
        }
    except (KeyError, TypeError, ValueError, AttributeError):
        raise InputError(
            "this is not a lock file of this robodyn",
            where=Place(name),
            expected="version = 1 and a table for each robot",
            remedy="remove it and run robodyn build",
        ) from None


def _counts(table: Any) -> Counts:
    counts = {function: dict(kinds) for function, kinds in table.items()}
    if not all(isinstance(count, int) for kinds in counts.values() for count in kinds.values()):
        raise ValueError
    return counts


def _hashes(table: Any) -> dict[str, str]:
    return {str(file): str(sha256) for file, sha256 in table.items()}


def _key(word: str) -> str:
    return word if _BARE.fullmatch(word) else _string(word)


def _string(text: str) -> str:
    """A basic string of TOML, which JSON spells the same."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
