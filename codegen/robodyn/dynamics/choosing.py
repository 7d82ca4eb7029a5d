"""Choosing between ways to write the same values, over any scalar."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

#: Ways to write one vector of values.
Ways = Sequence[Sequence[Any]]


class Chooser(Protocol):
    """Chooses what takes the fewest operations beside what it has chosen before; the first where operations
    are not counted."""

    def __call__(self, choices: Sequence[Ways]) -> Sequence[Sequence[Any]]:
        """Of the ways to write each of some vectors those that together take the fewest."""
        ...

    def apart(self, ways: Sequence[Callable[[], Sequence[Any]]]) -> Sequence[Any]:
        """The values of the way that takes the fewest with all that it chooses itself, each being tried as if
        the others were not."""
        ...


class First:
    """The first of each: numbers are computed one way only."""

    def __call__(self, choices: Sequence[Ways]) -> Sequence[Sequence[Any]]:
        """The first way of each."""
        return [ways[0] for ways in choices]

    def apart(self, ways: Sequence[Callable[[], Sequence[Any]]]) -> Sequence[Any]:
        """The values of the first way."""
        return ways[0]()
