"""The files that a command writes: where they go, and whether they are up to date."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

import click

from robodyn.errors import CheckError, InputError
from robodyn.outputs import write_files
from robodyn_cli.output import as_json, echo_json, printable, talk

#: Help of ``--force`` where robodyn chooses the names of files.
FORCE: Final = "Also replace files that robodyn did not write, and links."

#: Help of ``--force`` where the command line names the file.
FORCE_FILE: Final = "Overwrite an existing file."


def write_file(path: Path, content: str | bytes, *, force: bool | None = None) -> None:
    """Write the file that the command line names: what is there is replaced, but no link.

    Raises
    ------
    InputError, OutputError: as of :func:`robodyn.outputs.write_files`.
    """
    write_files(path.parent, {path.name: content}, named=True, force=force)


def write_product(base: Path, folder: Path, files: Mapping[str, str | bytes], *, force: bool) -> None:
    """Write what robodyn names, ``files`` into ``folder``; of its path below ``base``, which the command line
    names, no part may be a link.

    Raises
    ------
    InputError, OutputError: as of :func:`robodyn.outputs.write_files`.
    """
    paths = {str((folder / name).relative_to(base)): content for name, content in files.items()}
    write_files(base, paths, force=force)


def output_folder(text: str) -> Path:
    """The folder or file named by the option ``-o``.

    Raises
    ------
    InputError: the name is empty, for instance from an unset variable.
    """
    if not text:
        raise InputError("the path after -o is empty", remedy="use -o . for this folder")
    return Path(text)


def new_file(text: str, *, force: bool) -> Path:
    """The file named by the option ``-o``, where nothing is unless ``force``, not even a broken link.

    Raises
    ------
    InputError: the name is empty, or something is there.
    """
    path = output_folder(text)
    if os.path.lexists(path) and not force:
        raise InputError(
            f"{printable(path)} already exists",
            remedy="choose another path with -o, or overwrite it with --force",
        )
    return path


def write_or_echo(text: str, path: Path | None, *, force: bool, joints: int) -> None:
    """Write ``text`` to the file of ``-o`` and say so; without one it is the result on stdout."""
    if path is not None:
        write_file(path, text, force=force)
        talk(f"robodyn: wrote {printable(path)}: {joints} joints")
    elif not as_json():
        click.echo(text, nl=False)


def picture_file(text: str, kinds: Sequence[str] = (".svg",)) -> Path:
    """The path of a picture of one of these ``kinds``.

    Raises
    ------
    InputError: the name does not end so.
    """
    path = Path(text)
    if path.suffix.lower() not in kinds:
        expected = f"a name that ends in {' or '.join(kinds)}"
        raise InputError("no picture of this kind is written", found=repr(text), expected=expected)
    return path


def report_up_to_date(robot: str, folder: Path, files: Mapping[str, str | bytes]) -> None:
    """Compare ``folder`` with what would be written there, and say so.

    Raises
    ------
    CheckError: a file is missing, or differs.
    """
    different = [name for name, content in files.items() if not _is_in(folder / name, content)]
    if different:
        raise CheckError(
            f"{', '.join(printable(folder / name) for name in different)}: not up to date",
            remedy="run the same command without --check",
        )
    if as_json():
        echo_json({"robot": robot, "checked": [str(folder / file) for file in files]})
    else:
        click.echo(f"{robot}: {len(files)} files in {printable(folder)} are up to date")


def _is_in(path: Path, content: str | bytes) -> bool:
    """Whether the file has these bytes; line endings matter."""
    try:
        return path.read_bytes() == (content.encode() if isinstance(content, str) else content)
    except OSError:
        return False
