"""Files that an MJCF file includes or attaches: where they lie, and which of them may be read."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from robodyn.errors import InputError
from robodyn.files import label
from robodyn.formats.elements import Document, Element, read
from robodyn.formats.limits import FILES_INCLUDED
from robodyn.robot.names import shown


class Files:
    """The files beside the MJCF file ``top`` and below it, and those in ``folders``; None: no file at all."""

    def __init__(self, top: Path | None, folders: Iterable[str] = ()) -> None:
        self._folder = None if top is None else top.parent.resolve()
        self._roots = (
            [] if self._folder is None else [self._folder, *(Path(each).resolve() for each in folders)]
        )
        self._count = 0

    def read(self, element: Element, document: Document, folders: Iterable[Path]) -> tuple[Document, Path]:
        """The document that ``file`` of ``element`` names, and its path.

        ``folders``: a relative path counts from the first of them in which there is such a file. As in
        MuJoCo they are the folder of the model's own file, and that of the file in which ``element`` stands.

        Raises
        ------
        InputError: it is outside of the folders that may be read, missing, one too many or not XML.
        """
        where, name = document.place(element, "file"), element.attributes.get("file", "")
        if self._folder is None:
            raise InputError("a text that is no file cannot include others", where=where, found=shown(name))
        for folder in dict.fromkeys(folders):
            try:
                path = (folder / name).resolve()
            except (OSError, ValueError, RuntimeError):
                path = folder
            if not any(path.is_relative_to(root) and path != root for root in self._roots):
                raise InputError(
                    "the file that is included is outside of the folder",
                    where=where,
                    found=shown(name),
                    expected="a file beside this one, or below it",
                    remedy="copy it there, or state the folder that may be read: --arg 'find NAME=FOLDER'",
                )
            if path.is_file():
                break
        else:
            raise InputError("the file that is included is not there", where=where, found=shown(name))
        self._count += 1
        if self._count > FILES_INCLUDED:
            raise InputError("too many files are included", where=where, found=shown(name))
        return read(str(path), "MJCF", label(os.path.relpath(path, self._folder))), path
