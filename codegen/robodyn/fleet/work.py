"""What is done to logs in whatever process is free: a log's digest, a unit's diagnosis."""

from __future__ import annotations

import json
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from struct import Struct
from typing import TYPE_CHECKING, Final

from robodyn.errors import InputError, RobodynError
from robodyn.fleet.sources.fleet import IN_LOG, ArmType
from robodyn.logs.content import digest

if TYPE_CHECKING:
    from robodyn.fleet.digest import Digest
    from robodyn.logs.log import Log
    from robodyn.logs.mapping import LogMap
    from robodyn.logs.streams import Mean
    from robodyn.robot.model import Robot

#: When a log began stands before its digest.
_BEGAN: Final = Struct("<d")


class Changed(RobodynError):
    """A log was written while it was read, or is another where it was read."""


def digest_log(arm: ArmType, sources: Sequence[str], hashes: Sequence[str]) -> bytes:
    """The digest of a log of an ``arm``, whose files had one hash, and when it began, as :func:`digested` has
    them.

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
        for part in pieces(sources[0], robot.n, mapping=mapping, robot=robot, most=PIECE):
            notes.append((part.date, part.conditions))
            yield part

    with _unchanged(sources, hashes):
        value = digest_of(arm, noted())
        means = together(conditions for _, conditions in notes)
        conditions = {name: mean.value for name, mean in means.items() if mean.count}
        began = next((date for date, _ in notes if date is not None), IN_LOG)
        return _BEGAN.pack(began) + replace(value, conditions=conditions).to_bytes()


def digested(data: bytes) -> tuple[float, Digest]:
    """When a log began [s since 1970, UTC; nan: it does not say], and its digest, of :func:`digest_log`."""
    from robodyn.fleet.digest import Digest

    return _BEGAN.unpack_from(data)[0], Digest.from_bytes(data[_BEGAN.size :])


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
    from robodyn.identify.known import with_covariance_of
    from robodyn.logs.log import read_log

    robot, mapping = _described(arm)
    if arm.covariance is not None:
        robot = with_covariance_of(robot, arm.covariance, arm.spec)
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


def why(error: Exception, sources: Sequence[str]) -> str:
    """What an ``error`` says of logs, without the path of a file: others have the same content."""
    if not isinstance(error, RobodynError):
        return f"robodyn fails at it: {type(error).__name__}: {error}"
    files = {file for source in sources for file in (source, *source.split("+"))}
    if error.where is None or error.where.file not in files:
        return str(error)
    line = "" if error.where.line is None else f"line {error.where.line}: "
    return f"{line}{InputError(error.what, found=error.found, expected=error.expected, remedy=error.remedy)}"


def unreadable(error: OSError) -> str:
    """Why a log cannot be read."""
    return (error.strerror or str(error)).lower()


def hash_here(source: str) -> tuple[str | None, str]:
    """The hash of a log, or None and why it cannot be read."""
    try:
        return digest(source), ""
    except OSError as error:
        return None, unreadable(error)


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
    try:
        yield
    finally:
        for source, content in zip(sources, hashes, strict=True):
            here, reason = hash_here(source)
            if here is None:
                raise Changed(f"{source} cannot be read any more: {reason}") from None
            if here != content:
                raise Changed(
                    f"{source} was written while it was read", remedy="run it again when it is complete"
                )
