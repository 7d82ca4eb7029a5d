"""Progress of a long command: one updated line on a terminal, nothing in a pipe."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager

import click


class Line:
    """A line on stderr that is updated at most a few times a second."""

    def __init__(self) -> None:
        self.shown = sys.stderr.isatty()
        self._last = -math.inf
        self._width = 0

    def tell(self, text: str) -> None:
        """Replace the text of the line by ``text``."""
        now = time.monotonic()
        if not self.shown or now - self._last < 0.2:
            return
        self._last = now
        self._echo("\r" + text.ljust(self._width))
        self._width = len(text)

    def clear(self) -> None:
        """Clear the line."""
        if self._width:
            self._echo("\r" + " " * self._width + "\r")
            self._width = 0

    def _echo(self, text: str) -> None:
        try:
            click.echo(text, nl=False, err=True)
        except OSError:  # the terminal is gone: not an error
            self.shown = False


@contextmanager
def line() -> Iterator[Line]:
    """A line that is cleared when the work is done or has failed."""
    shown = Line()
    try:
        yield shown
    finally:
        shown.clear()
