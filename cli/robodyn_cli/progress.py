"""How far a long command is: one line on a terminal, written over; nothing in a pipe."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager

import click


class Line:
    """A line on stderr that is written over, a few times a second at most."""

    def __init__(self) -> None:
        self.shown = sys.stderr.isatty()
        self._last = -math.inf
        self._width = 0

    def tell(self, text: str) -> None:
        """Show ``text`` in place of what the line said before."""
        now = time.monotonic()
        if not self.shown or now - self._last < 0.2:
            return
        self._last = now
        self._echo("\r" + text.ljust(self._width))
        self._width = len(text)

    def clear(self) -> None:
        """Leave the line empty."""
        if self._width:
            self._echo("\r" + " " * self._width + "\r")
            self._width = 0

    def _echo(self, text: str) -> None:
        try:
            click.echo(text, nl=False, err=True)
        except OSError:  # the terminal is gone, and nobody watches: that is no error
            self.shown = False


@contextmanager
def line() -> Iterator[Line]:
    """A line that is gone when the work is done or has failed."""
    shown = Line()
    try:
        yield shown
    finally:
        shown.clear()
