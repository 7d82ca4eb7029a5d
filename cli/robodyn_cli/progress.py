"""Progress of a long command: one updated line on a terminal, nothing in a pipe.

Where the stages of the work are known with what each usually costs, the line says about how long the rest
will take: what was done tells how this machine and these data compare with the usual.
"""

from __future__ import annotations

import math
import sys
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Final

import click

#: [s] More must be left to be told.
_SOON: Final = 1.0


class Line:
    """A line on stderr that is updated at most a few times a second."""

    def __init__(self) -> None:
        self.shown = sys.stderr.isatty()
        self._last = -math.inf
        self._width = 0

    def tell(self, text: str, *, at_once: bool = False) -> None:
        """Replace the text of the line by ``text``; not a moment after the last, unless ``at_once``."""
        now = time.monotonic()
        if not self.shown or (now - self._last < 0.2 and not at_once):
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


class Countdown:
    """What a work is at, and about how long the rest of it takes. ``stages``: those that it goes through in
    their order, with their usual costs [s]; one that comes again costs as much again."""

    #: So far from the usual [-] may a machine seem by the first stages.
    _SLOWEST: Final = 20.0

    def __init__(self, stages: Mapping[str, float], now: float) -> None:
        self._costs = dict(stages)
        self._order = list(stages)
        self._stage = -1
        self._begun = now
        self._spent, self._usual = 0.0, 0.0

    def enter(self, what: str, now: float) -> None:
        """The work is at ``what``: a stage, or something in the present one."""
        if what not in self._costs:
            return
        if self._stage >= 0:
            self._spent += now - self._begun
            self._usual += self._costs[self._order[self._stage]]
        self._stage, self._begun = self._order.index(what), now

    def left(self, now: float) -> float | None:
        """About how long the rest takes [s]; None before the first stage."""
        if self._stage < 0:
            return None
        pace = 1.0
        if self._usual > 0:
            pace = min(max(self._spent / self._usual, 1 / self._SLOWEST), self._SLOWEST)
        own, *later = (pace * self._costs[name] for name in self._order[self._stage :])
        return max(own - (now - self._begun), 0.0) + sum(later)

    def words(self, now: float) -> str:
        """For people; empty where little is left."""
        left = self.left(now)
        return "" if left is None else _in_words(left)


class Pace:
    """About how long the rest of a stage takes that consists of many pieces of one kind, by those that are
    done."""

    def __init__(self) -> None:
        self._stage, self._begun, self._before = "", 0.0, 0

    def words(self, stage: str, done: int, of: int, now: float) -> str:
        """For people, of a ``stage`` with ``done`` pieces ``of`` all; empty where little is left, or nothing
        was done yet."""
        if stage != self._stage:
            self._stage, self._begun, self._before = stage, now, done
        own = done - self._before
        return _in_words((now - self._begun) / own * (of - done)) if own > 0 else ""


def _in_words(left: float) -> str:
    """``left`` [s] for people; empty where it is little."""
    if left < _SOON:
        return ""
    if left < 90:
        step = 1 if left < 20 else 5
        return f"; about {step * math.ceil(left / step)} s left"
    return f"; about {math.ceil(left / 60)} min left"


@contextmanager
def countdown(shown: Line, head: str, stages: Mapping[str, float]) -> Iterator[Callable[[str], None]]:
    """A function that is told of the work's stages and of what happens in them; the line follows each second,
    and says after ``head`` and what is done how long the rest takes. In a pipe it does nothing."""
    if not shown.shown:
        yield lambda what: None
        return
    clock, over, lock = Countdown(stages, time.monotonic()), threading.Event(), threading.Lock()
    at = ""

    def show(*, at_once: bool = False) -> None:
        if at:
            shown.tell(f"{head}: {at}{clock.words(time.monotonic())}", at_once=at_once)

    def tell(what: str) -> None:
        nonlocal at
        with lock:
            at = what
            clock.enter(what, time.monotonic())
            show(at_once=what in stages)

    def follow() -> None:
        while not over.wait(1.0):
            with lock:
                show()

    follower = threading.Thread(target=follow, daemon=True)
    follower.start()
    try:
        yield tell
    finally:
        over.set()
        follower.join()


@contextmanager
def line() -> Iterator[Line]:
    """A line that is cleared when the work is done or has failed."""
    shown = Line()
    try:
        yield shown
    finally:
        shown.clear()


@contextmanager
def messages() -> Iterator[Callable[[str], None]]:
    """What says on such a line what a command is at."""
    with line() as shown:
        yield lambda text: shown.tell(f"robodyn: {text}")
