"""Files that commands about logs share: the logs themselves, the description's text, the output folder."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from robodyn.errors import InputError
from robodyn_cli import progress
from robodyn_cli.common import printable, talk

if TYPE_CHECKING:
    from robodyn.logs.log import Log


def result_folder(text: str) -> Path:
    """The folder of ``-o``, which need not exist yet.

    Raises
    ------
    InputError: the text is empty, or a file is there.
    """
    if not text:
        raise InputError("the path after -o is empty", remedy="use -o . for this folder")
    folder = Path(text)
    if folder.exists() and not folder.is_dir():
        raise InputError(
            f"cannot write to {printable(folder)}", found="a file", remedy="choose another path with -o"
        )
    return folder


def spare_inputs(outputs: Iterable[Path], inputs: Sequence[str]) -> None:
    """Refuse to overwrite an input, as a second run on its own result would.

    Raises
    ------
    InputError: an output is an input.
    """
    for output in outputs:
        for source in inputs:
            if output.exists() and Path(source).exists() and output.samefile(source):
                raise InputError(
                    f"{printable(output)} is an input and would be overwritten",
                    remedy="choose another folder with -o",
                )


def read_logs(paths: Sequence[str], joints: int, shown: progress.Line) -> tuple[list[Log], list[str]]:
    """The logs at ``paths`` with as many ``joints``, and their hashes; a word on those that are the same.

    Raises
    ------
    InputError: a file is missing or no log.
    """
    from robodyn.logs.log import read_log

    logs, hashes = [], []
    for path in paths:
        shown.tell(f"robodyn: reading {printable(path)}")
        logs.append(read_log(path, joints))
        hashes.append(hash_of(path))
    for k, path in enumerate(paths):
        if hashes[k] in hashes[:k]:
            shown.clear()
            first = printable(paths[hashes.index(hashes[k])])
            talk(f"robodyn: warning: {printable(path)} is identical to {first} and adds no evidence")
    return logs, hashes


def hash_of(source: str) -> str:
    """SHA-256 of the file or files of a log."""
    from robodyn.logs.second_file import files_of

    digests = []
    for path in files_of(source):
        with Path(path).open("rb") as file:
            digests.append(hashlib.file_digest(file, "sha256").hexdigest())
    return digests[0] if len(digests) == 1 else hashlib.sha256("+".join(digests).encode()).hexdigest()


def description_of(spec: str) -> str:
    """The text of the robot description ``spec``."""
    from robodyn.robot import bundled_text

    path = Path(spec)
    return path.read_bytes().decode("utf-8-sig") if path.is_file() else bundled_text(spec)
