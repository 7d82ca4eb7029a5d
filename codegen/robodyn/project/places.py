"""Where in a TOML file a key stands. tomllib reads values only, so it is asked what the first lines say."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from robodyn.errors import Place


@dataclass(frozen=True, slots=True)
class Places:
    """The places of what ``text`` says, which messages call ``file``. The text is valid TOML."""

    file: str
    text: str

    def of(self, *path: str) -> Place:
        """The line where the key ``path`` is stated, or the table that has it, and the column where that
        line begins to say something; the file alone if the key is nowhere."""
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
        while True:
            try:
                return most, tomllib.loads("".join(lines[:most]))
            except tomllib.TOMLDecodeError:
                most -= 1


def _has(data: Any, path: Sequence[str]) -> bool:
    for key in path:
        if not isinstance(data, dict) or key not in data:
            return False
        data = data[key]
    return True


def _says_nothing(line: str) -> bool:
    text = line.strip()
    return not text or text.startswith("#")
