"""The formats of logs, one file each: every module here has a ``FORMAT``, and every command reads it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import label, open_regular
from robodyn.logs.recording import Recording
from robodyn.registry import Registry
from robodyn.tools import Library


@dataclass(frozen=True, slots=True)
class LogFormat:
    """A format: its ``name``, the ``suffixes`` of its files, what messages call it (``title``), and what
    opens a file (its path, what messages call it, and whether values may be missing).

    ``library`` reads it. ``is_guarded``: whether it is read in a process of its own, with limits; so is every
    format whose bytes a library takes apart. ``is_table``: whether it is one table, whose columns may have
    the usual names. ``folders``: whether a folder with such files is a log. ``mark``: what a file has at its
    beginning, or 512 bytes behind it, where the suffix alone does not tell. ``remedy``: what to do where a
    file is damaged or the library is missing.
    """

    name: str
    suffixes: tuple[str, ...]
    title: str
    open: Callable[[Path, str, bool], Recording]
    library: Library | None = None
    is_guarded: bool = True
    is_table: bool = False
    folders: bool = False
    mark: bytes = b""
    remedy: str = ""


FORMATS: Final = Registry("robodyn.logs.formats", "FORMAT", LogFormat)


def format_of(path: str | os.PathLike[str]) -> LogFormat:
    """The format of the file or folder ``path``, by its suffix, and by its mark where that does not tell;
    text if none claims it."""
    place = Path(path)
    is_folder = place.is_dir()
    text = FORMATS["text"]
    if not is_folder and place.name.lower().endswith(text.suffixes):
        return text  # without a look at the others
    claims = [
        each
        for each in FORMATS.values()
        if (each.folders if is_folder else place.name.lower().endswith(each.suffixes))
    ]
    if len(claims) > 1 and place.is_file():
        with open_regular(place, "a log", label(path)) as source:
            head = source.read(520) or b""
        claims = [each for each in claims if head.find(each.mark) in (0, 512)][:1] or claims[-1:]
    return claims[-1] if claims else text


def is_log(path: Path) -> bool:
    """Whether ``path`` is a log by its name: a file with a suffix of one, or a folder with a recording.
    ``LOG.csv.json`` is none: it tells where LOG.csv comes from."""
    if path.is_dir():
        return any(
            each.name == "metadata.yaml" or each.name.lower().endswith(one.suffixes)
            for one in FORMATS.values()
            if one.folders
            for each in path.iterdir()
        )
    suffixes = tuple(suffix for each in FORMATS.values() for suffix in each.suffixes)
    name = path.name.lower()
    is_beside = name.endswith(".json") and name.removesuffix(".json").endswith(suffixes)
    return name.endswith(suffixes) and not is_beside and path.is_file()


def open_recording(path: str | os.PathLike[str], *, gaps: bool = True) -> Recording:
    """Look into the file ``path``. ``gaps``: whether a value may be missing in a table, and is NaN then.

    Raises
    ------
    InputError: there is no such file, or it is damaged.
    ToolError: the library for its format is missing.
    """
    file, place = label(path), Path(path)
    with readable(file):
        format = format_of(place)
        if not format.is_guarded:
            return format.open(place, file, gaps)
        if format.library is not None and not format.library.present():
            raise format.library.missing(where=Place(file), otherwise=format.remedy)
        from robodyn.logs.guard import open_guarded

        if not place.is_dir():
            open_regular(place, f"a log, such as log{format.suffixes[0]}", file).close()
        return open_guarded(format, place, file, gaps)


@contextmanager
def readable(file: str) -> Iterator[None]:
    """What the system says of ``file`` becomes an error of ours.

    Raises
    ------
    InputError: it cannot be read, or does not fit into memory.
    """
    try:
        yield
    except (OSError, ValueError, LookupError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise InputError("the log cannot be read", where=Place(file), found=reason.lower()) from None
    except MemoryError:
        raise InputError(
            "the log does not fit into memory",
            where=Place(file),
            remedy="take a part of it, or fewer samples a second",
        ) from None
