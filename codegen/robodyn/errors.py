"""The one family of errors: what is wrong, where, what was found, what was expected, what to do.

Every error that robodyn raises on purpose is a :class:`RobodynError`; the command line prints its
message as one line and leaves with its ``exit_code``.
"""

from __future__ import annotations

from dataclasses import dataclass

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any, Self


@dataclass(frozen=True, slots=True)
class Place:
    """A place in a text file; line and column count from 1, as editors do."""

    file: str
    line: int | None = None
    column: int | None = None

    def __str__(self) -> str:
        parts = [self.file]
        if self.line is not None:
            parts.append(str(self.line))
            if self.column is not None:
                parts.append(str(self.column))
        return ":".join(parts)

    def to_dict(self) -> dict[str, Any]:
        """As JSON has it."""
        return {"file": self.file, "line": self.line, "column": self.column}


def did_you_mean(word: str, words: Iterable[str]) -> str | None:
    """What an error asks if one of ``words`` is close to ``word``; the closest of them."""
    import difflib

    close = difflib.get_close_matches(word, list(words), n=1)
    return f"did you mean {close[0]!r}?" if close else None


def escaped(text: str) -> str:
    """``text`` with its control characters written out, so that a terminal does not obey them."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


class RobodynError(Exception):
    """Base of all errors raised on purpose.

    Parameters
    ----------
    what: what is wrong, without a full stop.
    where: the place, if the error has one.
    found, expected: what stood there and what should have.
    remedy: what to do about it.
    """

    exit_code = 1

    def __init__(
        self,
        what: str,
        *,
        where: Place | None = None,
        found: str | None = None,
        expected: str | None = None,
        remedy: str | None = None,
    ) -> None:
        self.what = what
        self.where = where
        self.found = found
        self.expected = expected
        self.remedy = remedy
        super().__init__(self.message())

    def at(self, where: Place) -> Self:
        """The same error with the place ``where``."""
        self.where = where
        self.args = (self.message(),)
        return self

    def message(self) -> str:
        """The whole error on one line: ``file:line:column: what; found ...; expected ...; do``."""
        parts = [self.what]
        if self.found is not None:
            parts.append(f"found {self.found}")
        if self.expected is not None:
            parts.append(f"expected {self.expected}")
        if self.remedy is not None:
            parts.append(self.remedy)
        text = "; ".join(parts)
        if self.where is not None:
            text = f"{self.where}: {text}"
        return " ".join(text.split())

    def to_dict(self) -> dict[str, Any]:
        """As JSON has it (:func:`error_schema`): all parts, None where there is none, and the whole line."""
        return {
            "what": self.what,
            "where": None if self.where is None else self.where.to_dict(),
            "found": self.found,
            "expected": self.expected,
            "remedy": self.remedy,
            "message": self.message(),
            "exit_code": self.exit_code,
        }


def error_schema() -> dict[str, Any]:
    """The JSON Schema of ``{"error": ...}``, what ``--json`` prints of a command that fails."""
    text = {"type": ["string", "null"]}
    count = {"type": ["integer", "null"], "minimum": 1}
    place = {"file": {"type": "string"}, "line": count, "column": count}
    parts = {
        "what": {"type": "string", "description": "what is wrong"},
        "where": {
            "description": "the place in a file, where there is one; line and column count from 1",
            "type": ["object", "null"],
            "properties": place,
            "required": list(place),
            "additionalProperties": False,
        },
        "found": {**text, "description": "what stood there"},
        "expected": {**text, "description": "what should have"},
        "remedy": {**text, "description": "what to do"},
        "message": {"type": "string", "description": "all of it on one line"},
        "exit_code": {"type": "integer", "minimum": 1, "description": "the exit code of the command"},
    }
    error = {"type": "object", "properties": parts, "required": list(parts), "additionalProperties": False}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "What robodyn prints with --json where a command fails",
        "type": "object",
        "properties": {"error": error},
        "required": ["error"],
        "additionalProperties": False,
    }


class CheckError(RobodynError):
    """A check failed or was not met: a budget, ``--check``, ``verify``."""

    exit_code = 1


class InputError(RobodynError):
    """Bad input: a robot file, an option, an array of the wrong shape."""

    exit_code = 2


class OutputError(RobodynError):
    """The output could not be written, and the place is not to blame: a full disk, a device that fails."""

    exit_code = 74  # EX_IOERR


class ToolError(RobodynError):
    """A tool is missing or failed: a compiler, a library."""

    exit_code = 3
