"""Parts of JSON that others may have written: of the right kind, or the error says which is not."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from robodyn.errors import InputError, Place

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,63}\Z")


@dataclass(frozen=True, slots=True)
class Part:
    """A ``value`` of the JSON in ``file`` at ``path``, which is to be ``whole`` ("a diagnosis"); ``remedy``
    is what to do if it is not."""

    value: Any
    file: str
    whole: str
    remedy: str
    path: str = ""

    def wrong(self, expected: str) -> InputError:
        """The error: what stands here, and what should."""
        what = f"this is not {self.whole}"
        return InputError(
            f"{what}: {self.path}" if self.path else what,
            where=Place(self.file),
            found=_shown(self.value),
            expected=expected,
            remedy=self.remedy,
        )

    def get(self, key: str) -> Part | None:
        """The value of ``key`` in this object; None where there is none, or null."""
        value = self.object().get(key)
        return None if value is None else self._inner(key, value)

    def need(self, key: str, expected: str) -> Part:
        """The value of ``key`` in this object, which must be there."""
        part = self.get(key)
        if part is None:
            raise self._inner(key, None).wrong(expected)
        return part

    def object(self) -> dict[str, Any]:
        """This, an object."""
        if not isinstance(self.value, dict):
            raise self.wrong("a JSON object")
        return self.value

    def items(self) -> Iterator[tuple[str, Part]]:
        """Keys and values of this object, whose keys are names."""
        for key, value in self.object().items():
            if not _NAME.match(key):
                raise self.wrong("names as keys")
            yield key, self._inner(key, value)

    def each(self) -> list[Part]:
        """The values of this list."""
        if not isinstance(self.value, list):
            raise self.wrong("a list")
        return [Part(value, self.file, self.whole, self.remedy, f"{self.path}[{k}]")
                for k, value in enumerate(self.value)]  # fmt: skip

    def name(self) -> str:
        """This, the name of an effect or of a parameter."""
        if not isinstance(self.value, str) or not _NAME.match(self.value):
            raise self.wrong("a name, such as coulomb_friction")
        return self.value

    def text(self) -> str:
        """This, a word or two that can be printed."""
        if not isinstance(self.value, str) or len(self.value) > 1000 or not self.value.isprintable():
            raise self.wrong("a short text")
        return self.value

    def number(self, low: float = -math.inf, high: float = math.inf) -> float:
        """This, a number from ``low`` to ``high``."""
        plain = isinstance(self.value, (int, float)) and not isinstance(self.value, bool)
        if not plain or not low <= self.value <= high:
            between = f" from {low:g} to {high:g}" if high < math.inf else f", {low:g} or more"
            raise self.wrong("a number" + (between if low > -math.inf else ""))
        return float(self.value)

    def joint(self) -> int:
        """This, the number of a joint."""
        if not isinstance(self.value, (int, float)) or isinstance(self.value, bool):
            raise self.wrong("the number of a joint, from 1")
        if self.value != int(self.value) or not 1 <= self.value < 1000:
            raise self.wrong("the number of a joint, from 1")
        return int(self.value)

    def _inner(self, key: str, value: Any) -> Part:
        return Part(value, self.file, self.whole, self.remedy, f"{self.path}.{key}" if self.path else key)


def _shown(value: Any) -> str:
    """What stands there, in a few words."""
    if value is None or isinstance(value, bool):
        return {None: "nothing", True: "true", False: "false"}[value]
    if isinstance(value, dict):
        return "an object" if value else "an empty object"
    if isinstance(value, list):
        return f"a list of {len(value)}"
    text = repr(value)
    text = text if len(text) <= 40 else f"{text[:36]}..."
    return text if text.isprintable() else ascii(text)[1:-1]
