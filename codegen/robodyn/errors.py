"""The one family of errors: what is wrong, where, what was found, what was expected, what to do.

Every error that robodyn raises on purpose is a :class:`RobodynError`; the command line prints its
message as one line and leaves with its ``exit_code``.
"""

from __future__ import annotations

from dataclasses import dataclass

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Self


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
