"""Of what files a log is, and whether they are the same as before."""

from __future__ import annotations

import hashlib
from pathlib import Path


def split_pair(name: str) -> tuple[str, str | None]:
    """The two files that ``name`` stands for: ``A+B`` is A and B, unless a file is called so."""
    if "+" not in name or Path(name).exists():
        return name, None
    places = [k for k, mark in enumerate(name) if mark == "+"]
    # A plus may be part of a file's name: the parts that are there are meant.
    for k in places:
        if Path(name[:k]).is_file() and Path(name[k + 1 :]).is_file():
            return name[:k], name[k + 1 :]
    first = next((k for k in places if Path(name[:k]).exists()), places[0])
    return name[:first], name[first + 1 :]


def files_of(name: str) -> tuple[str, ...]:
    """The paths of the file or files that ``name`` stands for."""
    first, second = split_pair(name)
    return (first,) if second is None else (first, second)


def input_files(source: str) -> list[Path]:
    """The files of a log: one, two of A.csv+B.csv, or those of a recording's folder."""
    files = []
    for path in map(Path, files_of(source)):
        files += sorted(inner for inner in path.iterdir() if inner.is_file()) if path.is_dir() else [path]
    return files


def _without_pipes(source: str) -> list[Path]:
    """The files of a log.

    Raises
    ------
    OSError: one is a pipe or the like: whoever opens it may wait for ever.
    """
    files = input_files(source)
    for path in files:
        if path.exists() and not path.is_file():
            raise OSError(f"{path} is neither a file nor a folder")
    return files


def digest(source: str) -> str:
    """SHA-256 of a log: of its file, or of the hashes of its files.

    Raises
    ------
    OSError: one of them cannot be read.
    """
    digests = []
    for path in _without_pipes(source):
        with path.open("rb") as file:
            digests.append(hashlib.file_digest(file, "sha256").hexdigest())
    return digests[0] if len(digests) == 1 else hashlib.sha256("+".join(digests).encode()).hexdigest()


def signature(source: str) -> tuple[str, int]:
    """Sizes and times of a log's files, by which one sees that they were not written since; the time at
    which the youngest was [ns].

    Of the two times one can be set back (``cp -p``, ``touch -d``), that of the last change of the entry
    cannot.

    Raises
    ------
    OSError: one of them is not there.
    """
    states = [path.stat() for path in _without_pipes(source)]
    text = " ".join(f"{state.st_size}@{state.st_mtime_ns}@{state.st_ctime_ns}" for state in states)
    return text, max((state.st_mtime_ns for state in states), default=0)
