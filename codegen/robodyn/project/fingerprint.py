"""Whether anything changed: the hash of all that the kernels of a robot depend on."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import Final

from robodyn.project.reading import Entry
from robodyn.resources import RECORDS, data_dir
from robodyn.toolchain.cache import content_key
from robodyn.version import VERSION

#: Formats whose files may take others in: what they come to counts, and not their bytes alone.
_INCLUDING: Final = (".xml", ".mjcf", ".xacro")


def fingerprints(entries: Iterable[Entry]) -> dict[str, str]:
    """By name of an entry the key of what robodyn writes for it: the same as long as its description, its
    options, the records that may be taken, and robodyn itself are the same.

    Raises
    ------
    InputError: a description cannot be read.
    """
    records = cache(_folder)  # many robots may lie in one folder
    return {
        entry.name: content_key(
            {
                "robodyn": [VERSION, _robodyn()],
                "description": _description(Path(entry.robot)),
                "records": records(Path(entry.robot).parent / RECORDS),
                "arguments": [entry.command, *entry.arguments],
            }
        )
        for entry in entries
    }


def digest(data: bytes) -> str:
    """What says that two files are the same."""
    return hashlib.sha256(data).hexdigest()


@cache
def _robodyn() -> str:
    """The hash of robodyn's own sources and data: in a checkout they change under the same version."""
    package = Path(__file__).resolve().parents[1]
    return content_key([_folder(package), _folder(data_dir("templates")), _folder(data_dir("robots"))])


def _description(path: Path) -> str:
    if path.suffix.lower() not in _INCLUDING:
        return _file(path)
    if path.suffix.lower() == ".xacro" or b"<include" in path.read_bytes():
        from robodyn.formats.loading import text_of

        return digest(text_of(path).encode())
    from importlib.metadata import PackageNotFoundError, version

    try:
        return f"{_file(path)} mujoco {version('mujoco')}"
    except PackageNotFoundError:  # an arm in URDF or SDF, or one that is refused
        return _file(path)


def _file(path: Path) -> str:
    try:
        return digest(path.read_bytes())
    except OSError:  # whoever loads it says what is wrong
        return "unreadable"


def _folder(folder: Path) -> str:
    """The hash of all files in ``folder`` and below: their names and contents."""
    if not folder.is_dir():
        return ""
    files = sorted(_files(str(folder)))
    return content_key([(path[len(str(folder)) :], _file(Path(path))) for path in files])


def _files(folder: str) -> Iterator[str]:
    """The paths of all files below ``folder`` that Python did not compile itself."""
    with os.scandir(folder) as there:
        for each in there:
            if each.is_dir(follow_symlinks=False):
                if each.name != "__pycache__":
                    yield from _files(each.path)
            elif each.is_file():
                yield each.path
