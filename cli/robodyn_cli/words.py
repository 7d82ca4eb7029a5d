"""The words of the library's tables, for shells that complete them.

Importing a table may take half a second, which is long between two keys. So its words are remembered in the
folder of caches, as long as no file of robodyn changes.
"""

from __future__ import annotations

import contextlib
import importlib
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Final

import robodyn
import robodyn_cli
from robodyn.errors import RobodynError
from robodyn.version import VERSION
from robodyn_cli.common import write_file

_PACKAGES: Final = (*robodyn.__path__, *robodyn_cli.__path__)
"""The folders with the tables."""

_HELP: Final = ("purpose", "title")
"""Attributes of a record that say in a few words what it is."""


def words(source: str) -> dict[str, str]:
    """The words of a table and what each is, which may be empty; ``source`` is ``module:name`` of a tuple, a
    mapping, or a function that returns the words."""
    module, _, name = source.partition(":")
    table: Any = getattr(importlib.import_module(module), name)
    listed = table() if callable(table) else table
    records = listed.values() if isinstance(listed, Mapping) else listed
    return dict(zip((str(getattr(word, "id", word)) for word in listed), map(_help, records), strict=True))


def _help(record: Any) -> str:
    return next((text for name in _HELP if isinstance(text := getattr(record, name, None), str)), "")


def remembered(source: str) -> dict[str, str]:
    """:func:`words`, from the cache if they are there."""
    import json

    from robodyn.toolchain.cache import content_key, default_root

    root = default_root()
    if root is None:
        return words(source)
    path = root / f"words-{content_key([_PACKAGES, VERSION])}.json"
    changed = max(time for folder in _PACKAGES for time in _changes(folder))
    try:
        known = json.loads(path.read_text(encoding="utf-8"))
        if known["changed"] == changed and source in known["words"]:
            return {str(word): str(text) for word, text in known["words"][source].items()}
        tables = known["words"] if known["changed"] == changed else {}
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        tables = {}
    table = words(source)
    _write(path, json.dumps({"changed": changed, "words": {**tables, source: table}}))
    return table


def _changes(folder: Path | str) -> Iterator[int]:
    """When the folders and the sources below ``folder`` were changed [ns]."""
    yield Path(folder).stat().st_mtime_ns
    for entry in os.scandir(folder):
        if entry.is_dir():
            if entry.name != "__pycache__":
                yield from _changes(entry.path)
        elif entry.name.endswith(".py"):
            yield entry.stat().st_mtime_ns


def _write(path: Path, text: str) -> None:
    """Write ``text`` whole or not at all; a folder that cannot be written costs time only."""
    with contextlib.suppress(OSError, RobodynError):
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)  # as the cache of kernels wants it
        write_file(path, text)
