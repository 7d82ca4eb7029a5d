"""Workers read logs by their paths: a path must lead them to the file that it leads to here."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from robodyn.cluster.work import WrongWorker
from robodyn.logs.content import digest
from robodyn.logs.second_file import files_of


def absolute_source(source: str) -> str:
    """``source`` with absolute paths, whatever folder a worker was started in."""
    return "+".join(str(Path(part).absolute()) for part in files_of(source))


def check_same_file(source: str, content: str | None, reason: str) -> None:
    """Hold the file that a worker has read at ``source`` to be the one that is here: it came to the hash
    ``content`` (None: to none); ``reason`` is what the worker says.

    A log that cannot be read here either is compared with nothing.

    Raises
    ------
    WrongWorker: it is another.
    """
    here = _digest_here(source)
    if here is not None and here != content:
        raise _other_file(source, reason)


def check_changed(sources: Sequence[str], hashes: Sequence[str], reason: str) -> None:
    """A worker says that logs no longer have these ``hashes``: hold one of them to have changed here, too.

    Raises
    ------
    WrongWorker: none has: the worker sees others.
    """
    if all(_digest_here(source) == content for source, content in zip(sources, hashes, strict=True)):
        raise _other_file(", ".join(sources), reason)


def _digest_here(source: str) -> str | None:
    try:
        return digest(source)
    except OSError:
        return None


def _other_file(sources: str, reason: str) -> WrongWorker:
    return WrongWorker(
        f"a worker does not see the same file as this process: {sources}",
        found=reason,
        expected="the same file under the same path for this process and all workers",
        remedy="put the logs on a file system that all of them share, such as a network drive",
    )
