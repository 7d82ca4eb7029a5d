"""The tables of a TOML file, read with the place of whatever is wrong in them.

tomllib reads values only: where a key stands, it is asked what the first lines say.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from robodyn.errors import InputError, Place, did_you_mean
from robodyn.resources import bundled_robot

#: A robodyn.toml or robodyn.lock with more bytes is refused [bytes]: thousands of robots need less.
LARGEST_FILE: Final = 8 << 20
#: For a key of many parts tomllib takes some 13 ns for each square of their number, and a key stands on one
#: line. A file with more squares of dots on its lines is refused: a second or two, and no table needs them.
MOST_SQUARES: Final = 100_000_000


def parsed(text: str, name: str) -> dict[str, Any]:
    """What the TOML ``text`` of the file that messages call ``name`` says.

    Raises
    ------
    InputError: it is no TOML; with line and column. Or its keys have too many parts.
    """
    dots = [line.count(".") for line in text.split("\n")]
    if sum(count**2 for count in dots) > MOST_SQUARES:
        most = max(dots)
        raise InputError(
            "this file has lines with too many dots", where=Place(name, dots.index(most) + 1),
            found=f"{most} in a line", remedy="spread lists over lines, and give keys fewer parts",
        )  # fmt: skip
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # TOMLDecodeError, or a number of too many digits
        words, _, place = (str(error) or "values nested too deeply").rpartition(" (at ")
        at = re.fullmatch(r"line (\d+), column (\d+)\)", place)
        line = text.count("\n") + 1 if place.startswith("end of") else int(at[1]) if at else None
        raise InputError(
            "this is not TOML",
            where=Place(name, line, int(at[2]) if at else None),
            found=words or place,
            remedy="mend the file (https://toml.io describes the format)",
        ) from None


def shown(value: Any) -> str:
    """A value of a TOML file for a message: its kind where it is a table, else the beginning of it."""
    if isinstance(value, dict):
        return "a table"
    text = str(value).lower() if isinstance(value, bool) else repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


class Tables:
    """What the TOML ``text`` of the file that messages call ``name`` says, and where.

    Raises
    ------
    InputError: it is no TOML; with line and column.
    """

    def __init__(self, text: str, name: str) -> None:
        self.data, self.places = parsed(text, name), Places(name, text)

    def table(self, *at: Key) -> dict[str, Any]:
        """The table ``at``, empty where there is none.

        Raises
        ------
        InputError: something else is there.
        """
        table: Any = self.data
        for key in at:
            inner: Any = table[key] if isinstance(key, int) else table.get(key, {})
            if not isinstance(inner, dict) and (key == at[-1] or not isinstance(inner, list)):
                raise InputError(
                    f"{key} is not a table",
                    where=self.places.of(*at),
                    found=shown(inner),
                    expected=f"[{'.'.join(map(str, at))}] and keys below it",
                )
            table = inner
        return dict(table)

    def check_keys(self, at: tuple[Key, ...], words: Iterable[str]) -> None:
        """Hold the keys of the table ``at`` to the ``words`` there are.

        Raises
        ------
        InputError: one is none of them.
        """
        words = tuple(words)
        for name in self.table(*at):
            if name not in words:
                raise self.unknown(at, name, words)

    def text(self, at: tuple[Key, ...], value: Any, what: str = "a path", expected: str = "a text") -> str:
        """``value``, which stands ``at``, a text that is not empty.

        Raises
        ------
        InputError: it is something else.
        """
        if not isinstance(value, str) or not value or "\0" in value:
            raise InputError(
                f"{at[-1]} is not {what}", where=self.places.of(*at), found=shown(value), expected=expected
            )
        return value

    def description(self, at: tuple[Key, ...], value: Any, folder: Path) -> str:
        """The path of the description that the ``value`` at ``at`` names: as seen from ``folder``, else the
        bundled robot's.

        Raises
        ------
        InputError: there is neither.
        """
        text = self.text(at, value)
        path = folder / text
        bundled = None if path.is_file() else bundled_robot(text)
        if bundled is not None:
            return str(bundled)
        if not path.is_file():
            from robodyn.robot.bundled import bundled_names

            raise InputError(
                "there is neither a description nor a bundled robot of this name",
                where=self.places.of(*at),
                found=shown(text),
                expected="a path, as seen from this file's folder, or a name that robodyn robots lists",
                remedy=did_you_mean(text, bundled_names()) or "say where it is: robot = 'arms/arm.yaml'",
            )
        return str(path)

    def unknown(self, at: tuple[Key, ...], name: str, words: tuple[str, ...]) -> InputError:
        """What to say of the key ``name`` of the table ``at``, which is none of the ``words``."""
        inside = f" in [{'.'.join(key for key in at if isinstance(key, str))}]" if at else ""
        return InputError(
            f"unknown key {name!r}{inside}",
            where=self.places.of(*at, name),
            expected=f"one of {', '.join(words)}",
            remedy=did_you_mean(name, words),
        )


# --- places -----------------------------------------------------------------------------------------------

#: What leads to a value: the names of tables and keys, and places (from 0) in lists of tables.
Key = str | int
#: What a line looks like that may begin a table or a key; lines inside of a long value mostly do not.
_BEGINS: Final = re.compile(r"\s*\[|.*=")

#: So many lines that look so are tried.
_TRIES: Final = 200


@dataclass(frozen=True, slots=True)
class Places:
    """The places of what ``text`` says, which messages call ``file``. The text is valid TOML."""

    file: str
    text: str

    def of(self, *path: Key) -> Place:
        """The line where the key ``path`` is stated, or the table that has it, and the column where that
        line begins to say something; the file alone if the key is nowhere."""
        lines = [f"{line}\n" for line in self.text.split("\n")]  # where tomllib and editors break them
        first, last = 0, len(lines)
        try:
            if not path or not _has(self._before(lines, last)[1], path):
                return Place(self.file)
            while last - first > 1:  # the beginning of ``last`` lines has it, that of ``first`` does not
                middle = (first + last) // 2
                whole, data = self._before(lines, middle)
                first, last = (first, whole) if _has(data, path) else (middle, last)
            begun, _ = self._before(lines, last - 1)
        except _TooIntricate:
            return Place(self.file)
        while begun < last - 1 and (not lines[begun].strip() or lines[begun].lstrip().startswith("#")):
            begun += 1
        line = lines[begun]
        return Place(self.file, begun + 1, len(line) - len(line.lstrip()) + 1)

    @staticmethod
    def _before(lines: Sequence[str], most: int) -> tuple[int, dict[str, Any]]:
        """The longest beginning of at most ``most`` lines that ends no value in its middle: how many lines
        it has, and what it says."""
        for _ in range(_TRIES):
            while 0 < most < len(lines) and not _BEGINS.match(lines[most]):
                most -= 1
            try:
                return most, tomllib.loads("".join(lines[:most]))
            except tomllib.TOMLDecodeError:
                most -= 1
        raise _TooIntricate


class _TooIntricate(ValueError):
    """The text has long values in which too many lines look as if they began another."""


def _has(data: Any, path: Sequence[Key]) -> bool:
    for key in path:
        inside = range(len(data)) if isinstance(data, list) else data if isinstance(data, dict) else ()
        if key not in inside:
            return False
        data = data[key]
    return True
