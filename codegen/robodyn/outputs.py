"""Files that robodyn writes: all of a command's or none, never through a link, and not over other people's.

A file is robodyn's if it says so (:data:`SENTENCE`), or, where its format has no room for that (JSON, CSV,
descriptions that are meant to be edited), if it is as the :data:`LIST` beside it says.
"""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from hashlib import file_digest, sha256
from pathlib import Path
from typing import Final

from robodyn.errors import InputError
from robodyn.files import cannot_write, label, open_regular, read_text

#: What a file says that is generated: whoever edits it has been told. A version may stand in it.
SENTENCE: Final = "Written by robodyn; do not edit, generate again."
_SENTENCE: Final = re.compile(
    rb"Written by robodyn[^;\n]{0,60};\s+(?:do not edit|generate again|write it again|to be committed)"
    rb"|Written by robodyn\Z"  # the comment of an archive
    rb'|<meta name="generator" content="robodyn '
)
#: The hashes of what else robodyn wrote into a folder, as ``sha256sum --check`` reads them.
LIST: Final = ".robodyn.sha256"
_HEAD: Final = f"# {SENTENCE.partition(';')[0]}; do not edit: by these hashes it knows its files again.\n"
_LONGEST_LIST: Final = 1 << 26  # bytes
_TEMPORARY: Final = ".robodyn.{process}.{file}.tmp"
#: What to do where a path cannot be written.
ELSEWHERE: Final = "choose another path with -o, or free some space there"


def write_files(
    folder: Path,
    files: Mapping[str, str | bytes],
    *,
    force: bool | None = None,
    named: bool = False,
    remedy: str = ELSEWHERE,
) -> list[Path]:
    """Write ``files`` (path relative to ``folder`` -> text or bytes) atomically; return the paths.

    All are checked by :func:`check_outputs`, then written under temporary names in their folders, and renamed
    only when all of them are complete. On an error the temporary files, and the folders created for them, are
    removed again. ``remedy`` is what an error of the system says to do.

    Raises
    ------
    InputError: as of :func:`check_outputs`, or the path cannot be written.
    OutputError: the disk is full, or the device fails.
    """
    contents = {name: each.encode() if isinstance(each, str) else each for name, each in files.items()}
    check_outputs(folder, contents, force=force, named=named, remedy=remedy)
    if not named and (listing := _listing(folder, contents)) is not None:
        contents[LIST] = listing
    targets = {folder / name: content for name, content in contents.items()}
    path = folder
    new_folders: list[Path] = []
    temporary: list[Path] = []
    try:
        new_folders = _missing_folders(target.parent for target in targets)
        for path, content in targets.items():
            path.parent.mkdir(parents=True, exist_ok=True)
            temporary.append(path.parent / _TEMPORARY.format(process=os.getpid(), file=len(temporary)))
            _create(temporary[-1], content)
        for path, source in zip(targets, temporary, strict=True):
            source.replace(path)
    except BaseException as error:
        _remove(temporary, new_folders)
        if isinstance(error, OSError):
            raise cannot_write(label(path), error, remedy) from error
        raise
    return [folder / name for name in files]


def check_outputs(
    folder: Path,
    files: Mapping[str, bytes | None] | Iterable[str],
    *,
    force: bool | None = None,
    named: bool = False,
    remedy: str = ELSEWHERE,
) -> None:
    """Refuse what :func:`write_files` must not replace, before anything is written.

    ``files``: paths relative to ``folder``, with their contents where they are known: a file that has them
    already is in nobody's way. ``named``: the command line names these paths themselves, as of ``-o FILE``,
    and what is there is replaced as every program does it. Else the names are robodyn's, and what is there
    must be, too, unless ``force`` (None: the command has no ``--force``). A link is never followed: it is
    refused, or with ``force`` replaced; one on the way from ``folder`` to the file is always refused.

    Raises
    ------
    InputError: something is in the way.
    """
    contents = files if isinstance(files, Mapping) else dict.fromkeys(files)
    path = folder
    try:
        hashes = None if named or force else _listed(folder)
        for name, content in contents.items():
            path = folder / name
            if not named:
                _check_parents(folder, name)
            _check_target(path, content, force=force, hashes=hashes, name=name, remedy=remedy)
    except OSError as error:
        raise cannot_write(label(path), error, remedy) from error


def remove_leftovers(folders: Iterable[Path]) -> None:
    """Remove the temporary files that a killed process has left in ``folders``; none may be writing there."""
    _remove(
        [path for folder in folders for path in folder.glob(_TEMPORARY.format(process="*", file="*"))], []
    )


def replace_file(path: Path, content: bytes) -> None:
    """Let ``path``, whose folder is there, be a file with this ``content``: whole or not at all. A link is
    replaced.

    Raises
    ------
    OSError: it cannot be written.
    """
    temporary = path.parent / _TEMPORARY.format(process=os.getpid(), file="one")
    try:
        _create(temporary, content)
        temporary.replace(path)
    except BaseException:
        _remove([temporary], [])
        raise


# --- what is in the way ---------------------------------------------------------------------------------


def _check_parents(folder: Path, name: str) -> None:
    """Hold the folders between ``folder`` and its file ``name`` to be none that lie elsewhere."""
    parent = folder
    for part in Path(name).parts[:-1]:
        parent = parent / part
        if parent.is_symlink():
            raise InputError(
                f"{label(parent)} is a symbolic link, through which nothing is written",
                found=f"-> {label(parent.readlink())}",
                expected="a folder, or nothing",
                remedy="remove the link, or choose another output",
            )


def _check_target(
    path: Path,
    content: bytes | None,
    *,
    force: bool | None,
    hashes: Mapping[str, str] | None,
    name: str,
    remedy: str,
) -> None:
    """As :func:`check_outputs`, of one file; ``hashes``: those of robodyn's files by name; None: whose it is
    does not matter."""
    otherwise = "" if force is None else ", or replace it with --force"
    if path.is_symlink():
        if force:
            return
        raise InputError(
            f"{label(path)} is a symbolic link, through which nothing is written",
            found=f"-> {label(path.readlink())}",
            expected="a file, or nothing",
            remedy=f"remove the link{otherwise}",
        )
    if not path.exists():
        return
    if not path.is_file():
        raise InputError(f"cannot write {label(path)}", found="something that is not a file", remedy=remedy)
    if hashes is None or _has_content(path, content) or says_robodyn(path):
        return
    listed = hashes.get(name)
    if listed is not None and listed == _hash(path):
        return
    since = "which robodyn did not write" if listed is None else "which was edited since robodyn wrote it"
    raise InputError(
        f"{label(path)} is in the way, {since}",
        expected="nothing there, or what robodyn wrote there before",
        remedy=f"move it away, choose another output{otherwise}",
    )


def is_marked(data: bytes) -> bool:
    """Whether a file with this content says that robodyn wrote it and nobody is to edit it."""
    return _SENTENCE.search(data) is not None


def says_robodyn(path: Path) -> bool:
    """:func:`is_marked` of the file at ``path``; what cannot be read is not."""
    try:
        with open_regular(path, "a file of robodyn") as file:
            before = b""
            while piece := file.read(1 << 20):
                if is_marked(before + piece):
                    return True
                before = piece[-256:]
    except (OSError, ValueError, InputError):
        pass
    return False


def _has_content(path: Path, content: bytes | None) -> bool:
    if content is None or path.stat().st_size != len(content):
        return False
    return _hash(path) == sha256(content).hexdigest()


def _hash(path: Path) -> str | None:
    try:
        with open_regular(path, "a file of robodyn") as file:
            return file_digest(file, "sha256").hexdigest()
    except OSError:
        return None


# --- the list of files that do not say whose they are ---------------------------------------------------


def _listing(folder: Path, contents: Mapping[str, bytes]) -> bytes | None:
    """The list in ``folder`` once ``contents`` are there; None: it stays as it is."""
    before = _listed(folder)
    hashes = {name: sha256(data).hexdigest() for name, data in contents.items() if not is_marked(data)}
    after = {name: each for name, each in before.items() if name not in contents} | hashes
    if after == before:
        return None
    lines = [f"{each}  {name}\n" for name, each in sorted(after.items())]
    return "".join([_HEAD, *lines]).encode()


def _listed(folder: Path) -> dict[str, str]:
    """The hashes that the list in ``folder`` has, by name.

    Raises
    ------
    InputError: the list is a link, or something else.
    """
    path = folder / LIST
    if not path.is_symlink() and not path.exists():
        return {}
    if path.is_symlink() or not says_robodyn(path):
        raise InputError(
            f"{label(path)} is not the list that robodyn writes there",
            found="a symbolic link" if path.is_symlink() else "something else",
            remedy="remove it",
        )
    lines = read_text(path, _LONGEST_LIST, "a list of robodyn's files").splitlines()
    return {line[66:]: line[:64] for line in lines if not line.startswith("#")}


# --- writing --------------------------------------------------------------------------------------------


def _create(path: Path, content: bytes) -> None:
    """Write the new file ``path``. What a process of this number left there is removed, and a link that
    somebody puts there is an error ("x"), not followed."""
    path.unlink(missing_ok=True)
    with path.open("xb") as file:
        file.write(content)


def _missing_folders(folders: Iterable[Path]) -> list[Path]:
    """The folders and parent folders that do not exist yet, deepest first."""
    missing = {level for folder in folders for level in (folder, *folder.parents) if not level.exists()}
    return sorted(missing, key=lambda level: len(level.parts), reverse=True)


def _remove(temporary: Sequence[Path], folders: Sequence[Path]) -> None:
    for path in temporary:
        with contextlib.suppress(OSError):  # report the original error, not this one
            path.unlink(missing_ok=True)
    for folder in folders:
        with contextlib.suppress(OSError):
            if folder.is_dir() and not any(folder.iterdir()):
                folder.rmdir()
