"""What every place where work runs offers: independent pieces in, results out, whatever happens to one."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Protocol

from robodyn.cluster.work import outcome


@dataclass(frozen=True, slots=True)
class Done:
    """A piece of work has come to ``value``."""

    value: Any


@dataclass(frozen=True, slots=True)
class Failed:
    """A piece of work has come to nothing: ``error`` is what its function raised, or why it was given up."""

    error: Exception


class Cluster(Protocol):
    """Processes that work."""

    @property
    def count(self) -> int:
        """How many processes there are, now."""
        ...

    def each(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, tuple[Any, ...]]]
    ) -> Iterator[tuple[Any, Done | Failed]]:
        """Of each task, a key and arguments, the key and what ``function`` of the arguments comes to.

        Tasks are taken when there is room for them, and results are handed out as they come, in any order.
        What ``function`` raises is a result, too. ``function`` can be imported by its name; arguments and
        values can be pickled.

        Raises
        ------
        ToolError: there is nothing left to work with.
        """
        ...


class ThisProcess:
    """The process that asks does the work, one piece after the other."""

    count = 1

    def each(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, tuple[Any, ...]]]
    ) -> Iterator[tuple[Any, Done | Failed]]:
        """As of :class:`Cluster`, in the order of the tasks."""
        for key, arguments in tasks:
            done, value = outcome(function, arguments)
            yield key, Done(value) if done else Failed(value)


@dataclass(frozen=True, slots=True)
class Security:
    """The files, in PEM, by which a scheduler and who asks it know each other: the certificate of the
    ``authority`` that both trust, the ``certificate`` of who asks and its ``key`` (empty: it stands in the
    certificate's file)."""

    authority: str
    certificate: str
    key: str = ""
