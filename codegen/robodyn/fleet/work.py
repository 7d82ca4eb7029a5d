"""What is done to a log in whatever process is free: reading its content, its digest, a unit's diagnosis."""

from __future__ import annotations

import json
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from struct import Struct
from typing import TYPE_CHECKING, Final

from robodyn.cluster.work import WrongWorker
from robodyn.errors import InputError, RobodynError
from robodyn.fleet.sources.fleet import IN_LOG, ArmType
from robodyn.logs.content import digest, files_of, signature

if TYPE_CHECKING:
    from robodyn.fleet.digest import Digest
    from robodyn.logs.log import Log
    from robodyn.logs.mapping import LogMap
    from robodyn.logs.streams import Mean
    from robodyn.robot.model import Robot

#: When a log began stands before its digest.
_BEGAN: Final = Struct("<d")


def contents(sources: Sequence[str]) -> list[tuple[str, str, int] | str]:
    """Of each log its hash, the signature of its files and when the youngest was written
    (:func:`robodyn.logs.content.signature`), or why it cannot be read."""

    read: list[tuple[str, str, int] | str] = []
    for source in sources:
        try:
            before, youngest = signature(source)
            read.append((digest(source), before, youngest))
        except OSError as error:
            read.append(f"the file cannot be read: {(error.strerror or str(error)).lower()}")
    return read


def digest_log(arm: ArmType, source: str, content: str) -> bytes:
    """The digest of the log ``source`` of an ``arm``, whose files had the hash ``content``, and when it
    began, as :func:`digested` has them.

    Raises
    ------
    InputError: it cannot be used.
    Changed: it is another by now, or not here.
    """
    from robodyn.fleet.digest import digest_of
    from robodyn.fleet.limits import PIECE
    from robodyn.logs.pieces import pieces
    from robodyn.logs.streams import together

    robot, mapping = _described(arm)
    notes: list[tuple[float | None, Mapping[str, Mean]]] = []

    def noted() -> Iterator[Log]:
        for part in pieces(source, robot.n, mapping=mapping, robot=robot, most=PIECE):
            notes.append((part.date, part.conditions))
            yield part

    with _unchanged([source], [content]):
        value = digest_of(arm, noted())
        means = together(conditions for _, conditions in notes)
        conditions = {name: mean.value for name, mean in means.items() if mean.count}
        began = next((date for date, _ in notes if date is not None), IN_LOG)
        return _BEGAN.pack(began) + replace(value, conditions=conditions).to_bytes()


def _described(arm: ArmType) -> tuple[Robot, LogMap | None]:
    """An arm, and the map of its logs."""
    from robodyn.logs.mapping import map_of_text
    from robodyn.robot.reader import read_text

    mapping = None if arm.mapping is None else map_of_text(arm.mapping, f"the map of {arm.name}")
    return read_text(arm.text, arm.spec, warn=lambda _: None), mapping


@contextmanager
def _unchanged(sources: Sequence[str], hashes: Sequence[str]) -> Iterator[None]:
    """What is worked out meanwhile, or what is said of a log that cannot be used, is of the logs with these
    hashes.

    Raises
    ------
    Changed: a log has another content when it has been read.
    """
    failure = None
    try:
        yield
    except Exception as error:
        failure = error
    for source, content in zip(sources, hashes, strict=True):
        here, reason = _digest_here(source)
        if here is None:
            raise Changed(f"{source} cannot be read any more: {reason}") from None
        if here != content:
            raise Changed(
                f"{source} was written while it was read", remedy="run it again when it is complete"
            )
    if failure is not None:
        raise failure


def digested(data: bytes) -> tuple[float, Digest]:
    """When a log began [s since 1970, UTC; nan: it does not say], and its digest, of :func:`digest_log`."""
    from robodyn.fleet.digest import Digest

    return _BEGAN.unpack_from(data)[0], Digest.from_bytes(data[_BEGAN.size :])


class Changed(RobodynError):
    """A log was written while it was read, or is another where it was read."""


def diagnose_unit(
    arm: ArmType,
    sources: Sequence[str],
    hashes: Sequence[str],
    files_of: Callable[..., Mapping[str, str]],
) -> bytes:
    """What a diagnosis of an ``arm``'s logs names, and the files that ``files_of`` makes of it, as
    :func:`unpacked` has them.

    Raises
    ------
    InputError: a log cannot be used.
    Changed: one is another by now, or not here.
    """
    from robodyn.diagnose.run import diagnose
    from robodyn.logs.log import read_log

    robot, mapping = _described(arm)
    with _unchanged(sources, hashes):
        logs = [read_log(source, robot.n, mapping=mapping, robot=robot) for source in sources]
        names = [Path(source).name for source in sources]
        diagnosis = diagnose(robot, logs, text=arm.text, names=names, hashes=hashes)
        effects = [(one.effect, one.joint) for one in diagnosis.findings]
        return zlib.compress(json.dumps([effects, dict(files_of(diagnosis))], sort_keys=True).encode(), 6)


def unpacked(data: bytes) -> tuple[list[tuple[str, int | None]], dict[str, str]]:
    """What :func:`diagnose_unit` packed: effects with their joints, the surest first, and files by their
    names."""
    named, files = json.loads(zlib.decompress(data))
    return [(effect, joint) for effect, joint in named], files


def why(error: Exception, source: str) -> str:
    """What an ``error`` says of a log, without the path of its file: others have the same content."""
    if not isinstance(error, RobodynError):
        return f"robodyn fails at it: {type(error).__name__}: {error}"
    if error.where is None or error.where.file not in (source, *source.split("+")):
        return str(error)
    line = "" if error.where.line is None else f"line {error.where.line}: "
    bare = InputError(error.what, found=error.found, expected=error.expected, remedy=error.remedy)
    return f"{line}{bare}"


# --- a path must lead a worker to the file that it leads to here ------------------------------------------


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
    if _digest_here(source)[0] not in (None, content):
        raise _other_file(source, reason)


def check_changed(sources: Sequence[str], hashes: Sequence[str], reason: str) -> None:
    """A worker says that logs no longer have these ``hashes``: hold one of them to have changed here, too.

    Raises
    ------
    WrongWorker: none has: the worker sees others.
    """
    if [_digest_here(source)[0] for source in sources] == list(hashes):
        raise _other_file(", ".join(sources), reason)


def _other_file(sources: str, reason: str) -> WrongWorker:
    return WrongWorker(
        f"a worker does not see the same file as this process: {sources}",
        found=reason,
        expected="the same file under the same path for this process and all workers",
        remedy="put the logs on a file system that all of them share, such as a network drive",
    )


def _digest_here(source: str) -> tuple[str | None, str]:
    """The hash of a log, or None and why it cannot be read."""
    try:
        return digest(source), ""
    except OSError as error:
        return None, (error.strerror or str(error)).lower()
