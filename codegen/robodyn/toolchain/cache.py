"""Compiled kernels, and those of projects, are kept by the hash of everything that went into them.

An entry is a folder ``<root>/<key>`` with the library (or another file that stands for it), the sources it
was made of and ``entry.json``, which holds the library's hash. It is built in a temporary folder beside it
and renamed when finished, so that an entry is either whole or absent and processes that race are no danger
to each other: the first one that finishes wins. Any of it may be deleted at any time.
"""

from __future__ import annotations

import atexit
import functools
import hashlib
import json
import logging
import os
import shutil
import stat
import tempfile
from collections.abc import Callable
from pathlib import Path

_log = logging.getLogger("robodyn.toolchain")


def default_root() -> Path | None:
    """``$ROBODYN_CACHE``, else ``$XDG_CACHE_HOME/robodyn``, else ``~/.cache/robodyn``.

    None where that is nowhere: there is no home folder, or no working folder that it could lie in.
    """
    root = _default()
    return root if isinstance(root, Path) else None


def _default() -> Path | str:
    """The folder of :func:`default_root`, or why there is none."""
    own = os.environ.get("ROBODYN_CACHE")
    if own:
        try:
            return Path(own).expanduser().absolute()
        except RuntimeError:
            return f"ROBODYN_CACHE={own} is in the home folder of a user that has none"
        except OSError as error:
            return f"ROBODYN_CACHE={own} is relative to a folder that is gone ({error.strerror})"
    shared = os.environ.get("XDG_CACHE_HOME")
    if shared and Path(shared).is_absolute():
        return Path(shared) / "robodyn"
    try:
        return Path.home() / ".cache" / "robodyn"
    except RuntimeError:
        return "there is no home folder"


class Cache:
    """Finished libraries under ``root``, which defaults to :func:`default_root`.

    What is loaded from here runs with the user's rights. So the folder must belong to the user (or to
    root) and be writable by nobody else, and no folder above it may be one in which anybody could replace
    it. A folder that is not so, or cannot be written, is not used: ``reason`` then says why, and what is
    built goes to a temporary folder that lives as long as the process.
    """

    def __init__(self, root: Path | None = None) -> None:
        wanted = root if root is not None else _default()
        self.reason: str | None = _unusable(wanted) if isinstance(wanted, Path) else wanted
        usable = isinstance(wanted, Path) and self.reason is None
        self.root = Path(wanted) if usable else _scratch(os.getpid())
        if self.reason is not None:
            _log.warning("compiled kernels are not kept: %s", self.reason)

    def fetch(self, key: str, build: Callable[[Path], str]) -> Path:
        """The library of entry ``key``; if it is not there, ``build(folder)`` makes it.

        ``build`` writes into an empty folder and returns the library's file name. Whatever it raises is
        passed on, and leaves nothing behind.
        """
        cached = self.find(key)
        if cached is not None:
            return cached
        try:
            folder = Path(tempfile.mkdtemp(prefix="unfinished-", dir=self.root))
        except OSError as error:
            if self.root == _scratch(os.getpid()):
                raise
            self.reason = f"{self.root} cannot be written ({error.strerror})"
            _log.info("compiled kernels are not kept: %s", self.reason)
            self.root = _scratch(os.getpid())
            return self.fetch(key, build)
        try:
            library = build(folder)
            _seal(folder, library)
            return self._publish(folder, self.root / key)
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def find(self, key: str) -> Path | None:
        """The library of entry ``key``, if that is there and undamaged."""
        return _library(self.root / key)

    def discard(self, key: str) -> None:
        """Remove entry ``key``, of which something besides the library is damaged."""
        shutil.rmtree(self.root / key, ignore_errors=True)

    def _publish(self, folder: Path, entry: Path) -> Path:
        """Rename a finished folder to its place, unless another process was there first."""
        while True:
            try:
                folder.rename(entry)
            except OSError:
                if not entry.exists():
                    raise
            library = _library(entry)
            if library is not None:
                return library
            # A damaged entry (a full disk, a crash of the machine): out of the way, and again.
            broken = Path(tempfile.mkdtemp(prefix="broken-", dir=self.root))
            try:
                entry.rename(broken / "entry")
            except FileNotFoundError:
                pass  # another process was quicker
            finally:
                shutil.rmtree(broken, ignore_errors=True)


def content_key(content: object) -> str:
    """A file name made from the hash of ``content`` (anything that JSON can say)."""
    text = json.dumps(content, sort_keys=True, ensure_ascii=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:40]


def _library(entry: Path) -> Path | None:
    """The library of a finished, undamaged entry."""
    try:
        record = json.loads((entry / "entry.json").read_text(encoding="utf-8"))
        library = entry / str(record["library"])
        whole = hashlib.sha256(library.read_bytes()).hexdigest() == record["sha256"]
    except (OSError, ValueError, KeyError, TypeError):
        return None
    return library if whole else None


def _seal(folder: Path, library: str) -> None:
    """Write ``entry.json`` last, and everything to the disk before the rename can be."""
    binary = folder / library
    record = {"library": library, "sha256": hashlib.sha256(binary.read_bytes()).hexdigest()}
    note = folder / "entry.json"
    note.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
    for path in (binary, note):
        with path.open("rb+") as file:
            os.fsync(file.fileno())


def _unusable(root: Path) -> str | None:
    """Why ``root`` cannot be trusted or made; None if all is well."""
    try:
        root.mkdir(mode=0o700, parents=True, exist_ok=True)
        real = root.resolve(strict=True)
        state = real.stat()
        above = [(folder, folder.stat()) for folder in real.parents]
    except OSError as error:
        return f"{root} cannot be used ({error.strerror})"
    if not hasattr(os, "geteuid"):  # Windows: the profile folder is the user's own
        return None
    if state.st_uid not in (os.geteuid(), 0):
        return f"{root} belongs to another user"
    if state.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        return f"others may write to {root} (chmod go-w {root})"
    for folder, outer in above:
        if outer.st_mode & stat.S_IWOTH and not outer.st_mode & stat.S_ISVTX:
            return f"anybody may write to {folder}, above {root}"
    return None


@functools.cache
def _scratch(process: int) -> Path:
    """The temporary folder of this process, removed when it ends."""
    folder = Path(tempfile.mkdtemp(prefix="robodyn-"))

    def remove() -> None:
        if os.getpid() == process:  # not in a child that was forked
            shutil.rmtree(folder, ignore_errors=True)

    atexit.register(remove)
    return folder
