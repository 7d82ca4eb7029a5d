"""Where in a TOML file a key stands. tomllib reads values only, so it is asked what the first lines say."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

from robodyn.errors import Place

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
        try:
            return self._line(path)
        except _TooIntricate:
            return Place(self.file)

    def _line(self, path: Sequence[Key]) -> Place:
        """As :meth:`of`."""
        lines = [f"{line}\n" for line in self.text.split("\n")]  # where tomllib and editors break them
        first, last = 0, len(lines)
        if not path or not _has(self._before(lines, last)[1], path):
            return Place(self.file)
        while last - first > 1:  # the beginning of ``last`` lines has it, that of ``first`` lines does not
            middle = (first + last) // 2
            whole, data = self._before(lines, middle)
            if _has(data, path):
                last = whole
            else:
                first = middle
        begun, _ = self._before(lines, last - 1)
        while begun < last - 1 and _says_nothing(lines[begun]):
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


def _says_nothing(line: str) -> bool:
    text = line.strip()
    return not text or text.startswith("#")
