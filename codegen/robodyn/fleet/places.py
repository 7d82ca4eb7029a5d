"""Where the files of a unit lie in the folder of a fleet's results."""

from __future__ import annotations

import hashlib
import re
from typing import Final
from urllib.parse import quote

#: What stands in a folder's name as it is; all else by its bytes, as in addresses.
_PLAIN: Final = re.compile(r"[\w .+()=,@-]")
#: Bytes of a folder's name that every file system takes, with some room.
_LONGEST: Final = 120


def unit_folder(type: str, unit: str) -> str:
    """The folder of a ``unit``, relative to that of the results: ``units/TYPE/UNIT``.

    Names may be any text: what a path or a file system could misunderstand is written as ``%`` and two
    digits, and of a long name the end is a hash of all of it. Two units have two folders.
    """
    return f"units/{_name(type)}/{_name(unit)}"


def address(path: str) -> str:
    """The relative address, for a link, of a file or folder."""
    return quote(path)


def _name(text: str) -> str:
    name = "".join(c if _PLAIN.match(c) else quote(_bytes(c), safe="") for c in text) or "%"
    if name.startswith("."):  # hidden, or the folder above
        name = name.replace(".", "%2E")
    if len(name.encode()) <= _LONGEST:
        return name
    digest = hashlib.sha256(_bytes(text)).hexdigest()[:16]
    return name.encode()[: _LONGEST - 20].decode(errors="ignore") + f"%-{digest}"


def _bytes(text: str) -> bytes:
    """Its bytes; names of files may hold some that are no text."""
    return text.encode(errors="surrogatepass")
