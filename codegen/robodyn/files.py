"""Files that others wrote, read within bounds: nothing is waited for, and nothing is read beyond a limit."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterable
from io import FileIO
from pathlib import Path
from stat import S_ISREG
from typing import Any

from robodyn.errors import InputError, OutputError, Place, RobodynError

MIB = 1 << 20
#: Errors of a disk or a system that has no more room, or fails.
_SYSTEM = {
    getattr(errno, name, None)
    for name in ("ENOSPC", "EDQUOT", "EFBIG", "EIO", "EMFILE", "ENFILE", "ENOMEM", "ENOBUFS")
} - {None}
_LEVELS, _DEEP = 100, "values nested too deeply"


def label(path: str | os.PathLike[str]) -> str:
    """``path`` for messages: what a file system allows and a terminal does not print is escaped."""
    text = os.fspath(path)
    return text if text.isprintable() else ascii(text)[1:-1]


def open_regular(path: str | os.PathLike[str], expected: str, name: str | None = None) -> FileIO:
    """The regular file ``path``, open for reading, unbuffered; a read that would wait returns None.

    A pipe or a device is not even opened: reading it could take for ever. ``expected`` says what the file
    should be, ``name`` what messages call it.

    Raises
    ------
    InputError: it is something else than a regular file.
    OSError, ValueError: the system refuses, or the path is none.
    """
    if not S_ISREG(Path(path).stat().st_mode):
        raise InputError("this is not a regular file", where=Place(name or label(path)), expected=expected)
    return open(path, "rb", buffering=0, opener=_without_waiting)


def read_start(path: str | os.PathLike[str], most: int, expected: str, name: str | None = None) -> bytes:
    """The first ``most`` bytes of the regular file ``path``, or all of it; as :func:`open_regular`.

    Some files of /proc call themselves regular and make a reader wait all the same: there it is told not to,
    and :class:`BlockingIOError` says it.
    """
    with open_regular(path, expected, name) as file:
        data = bytearray()
        while len(data) < most:
            piece = file.read(min(MIB, most - len(data)))
            if piece is None:
                raise BlockingIOError(errno.EAGAIN, "nothing to read yet")
            if not piece:
                break
            data += piece
        return bytes(data)


def read_bytes(path: str | os.PathLike[str], most: int, expected: str, name: str | None = None) -> bytes:
    """All of the regular file ``path``, which has at most ``most`` bytes.

    Raises
    ------
    InputError: there is no such file, it cannot be read, it is something else or too large.
    """
    name = name or label(path)
    try:
        data = read_start(path, most + 1, expected, name)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise InputError(
            "the file cannot be read", where=Place(name), found=reason.lower(), expected=expected
        ) from None
    if len(data) > most:
        raise InputError(
            "the file is too large",
            where=Place(name),
            found=f"more than {most // MIB} MiB",
            expected=f"{expected}, at most {most // MIB} MiB",
        )
    return data


def read_text(path: str | os.PathLike[str], most: int, expected: str, name: str | None = None) -> str:
    """As :func:`read_bytes`, the text: UTF-8, with or without byte order mark.

    Raises
    ------
    InputError: as :func:`read_bytes`, or it is not UTF-8.
    """
    name = name or label(path)
    return decoded(read_bytes(path, most, expected, name), name)


def decoded(data: bytes, name: str) -> str:
    """The text of the file that messages call ``name``: UTF-8, with or without byte order mark.

    Raises
    ------
    InputError: it is not UTF-8; with the place of the first wrong byte.
    """
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise InputError(
            "the file is not UTF-8 text", where=Place(name, 1, 1), found="UTF-16", remedy="save it as UTF-8"
        )
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        before = data[: error.start]
        line = before.count(b"\n") + 1
        column = len(before[before.rfind(b"\n") + 1 :].decode("utf-8", "replace")) + 1
        raise InputError(
            "the file is not UTF-8 text",
            where=Place(name, line, column),
            found=f"byte 0x{data[error.start]:02x}",
            remedy="save it as UTF-8",
        ) from None


def cannot_write(place: str, error: OSError, remedy: str) -> RobodynError:
    """The error of a ``place`` that could not be written: whose fault it is stands here alone.

    :class:`OutputError` where there is no room or the device fails, :class:`InputError` where the place is
    wrong: a folder that may not be written, a file in the way, a read-only disk.
    """
    kind = OutputError if error.errno in _SYSTEM else InputError
    return kind(f"cannot write {place}: {error.strerror or error}", remedy=remedy)


def parsed_json(text: str | bytes) -> Any:
    """What the JSON ``text`` says. Its numbers are finite, its words can be printed, and it is not nested
    so deeply that code that goes through it would fail.

    Raises
    ------
    ValueError: this is not JSON, or JSON that goes beyond those bounds or is nested too deeply.
    """
    import json

    try:
        data = json.loads(text, parse_constant=_no_number, parse_float=_float, parse_int=_int)
        json.dumps(data, ensure_ascii=False).encode()
    except RecursionError:
        raise ValueError(_DEEP) from None
    except UnicodeEncodeError:
        raise ValueError("half of a surrogate pair in a word") from None
    level = [data]
    for _ in range(_LEVELS):
        level = [inner for each in level for inner in _inside(each)]
        if not level:
            return data
    raise ValueError(_DEEP)


def _inside(value: Any) -> Iterable[Any]:
    if isinstance(value, dict):
        return value.values()
    return value if isinstance(value, list) else ()


def _no_number(word: str) -> float:
    raise ValueError(f"{word}, which is no number of JSON")


def _float(digits: str) -> float:
    value = float(digits)
    if value in (float("inf"), float("-inf")):
        raise ValueError(f"{_short(digits)}, which no double holds")
    return value


def _int(digits: str) -> int:
    if len(digits) > 300:
        raise ValueError(f"{_short(digits)}, which no double holds")
    return int(digits)


def _short(digits: str) -> str:
    return digits if len(digits) <= 24 else f"{digits[:20]}..."


def _without_waiting(path: str, flags: int) -> int:
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))
