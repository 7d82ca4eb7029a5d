"""Of what files a log is, and whether they are the same as before."""

from __future__ import annotations

import hashlib
from pathlib import Path

from robodyn.logs.second_file import files_of


def input_files(source: str) -> list[Path]:
    """The files of a log: one, two of A.csv+B.csv, or those of a recording's folder."""
    files = []
    for name in files_of(source):
        path = Path(name)
        inside = sorted(inner for inner in path.iterdir() if inner.is_file()) if path.is_dir() else [path]
        files += inside
    return files


def digest(source: str) -> str:
    """SHA-256 of a log: of its file, or of the hashes of its files.

    Raises
    ------
    OSError: one of them cannot be read.
    """
    digests = []
    for path in input_files(source):
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
    states = [path.stat() for path in input_files(source)]
    text = " ".join(f"{state.st_size}@{state.st_mtime_ns}@{state.st_ctime_ns}" for state in states)
    return text, max((state.st_mtime_ns for state in states), default=0)
