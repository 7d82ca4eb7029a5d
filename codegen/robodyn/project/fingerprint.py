"""Whether anything changed: the hash of all that the kernels of a robot depend on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any, Final

from robodyn.project.reading import Entry
from robodyn.resources import RECORDS
from robodyn.toolchain.cache import content_key
from robodyn.toolchain.sources import digest, file_key, folder_key, own_key
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
    records = cache(folder_key)  # many robots may lie in one folder
    return {
        entry.name: content_key(
            {
                "robodyn": [VERSION, own_key()],
                "description": _description(Path(entry.robot), entry.settings),
                "records": records(Path(entry.robot).parent / RECORDS),
                "arguments": [entry.command, *entry.arguments],
            }
        )
        for entry in entries
    }


def _description(path: Path, settings: Mapping[str, Any]) -> str:
    if path.suffix.lower() not in _INCLUDING:
        return file_key(path)
    if path.suffix.lower() == ".xacro" or b"<include" in path.read_bytes():
        from robodyn.formats.arm import how_files_are_read
        from robodyn.formats.loading import text_of

        without = settings.get("without", [])
        with how_files_are_read(
            {}, str(settings.get("model", "")), [without] if isinstance(without, str) else without
        ):
            return digest(text_of(path).encode())
    from importlib.metadata import PackageNotFoundError, version

    try:
        return f"{file_key(path)} mujoco {version('mujoco')}"
    except PackageNotFoundError:  # an arm in URDF or SDF, or one that is refused
        return file_key(path)
