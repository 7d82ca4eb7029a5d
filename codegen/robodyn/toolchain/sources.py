"""Robodyn's own sources, as a key: two installations whose keys are equal do the same."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from robodyn.resources import data_dir
from robodyn.toolchain.cache import content_key


@cache
def own_key() -> str:
    """The hash of robodyn's own sources and data: in a checkout they change under the same version."""
    package = Path(__file__).resolve().parents[1]
    folders = (package, data_dir("templates"), data_dir("robots"))
    return content_key([folder_key(folder) for folder in folders])


def file_key(path: Path) -> str:
    """The hash of a file's content."""
    try:
        return digest(path.read_bytes())
    except OSError:  # whoever loads it says what is wrong
        return "unreadable"


def folder_key(folder: Path) -> str:
    """The hash of all files in ``folder`` and below: their names and contents."""
    if not folder.is_dir():
        return ""
    files = sorted(_files(str(folder)))
    return content_key([(path[len(str(folder)) :], file_key(Path(path))) for path in files])


def digest(data: bytes) -> str:
    """What says that two files are the same."""
    return hashlib.sha256(data).hexdigest()


def _files(folder: str) -> Iterator[str]:
    """The paths of all files below ``folder`` that Python did not compile itself."""
    with os.scandir(folder) as there:
        for each in there:
            if each.is_dir(follow_symlinks=False):
                if each.name != "__pycache__":
                    yield from _files(each.path)
            elif each.is_file():
                yield each.path
