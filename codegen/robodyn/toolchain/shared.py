"""Compile C sources to a shared library, as bytes."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

from robodyn.toolchain.compiler import C_FLAGS, find_c

#: How names of shared libraries end, by the system.
_SUFFIXES: Final = {"darwin": ".dylib", "win32": ".dll"}


def library_suffix() -> str:
    """How the name of a shared library ends on this system."""
    return _SUFFIXES.get(sys.platform, ".so")


def shared_library(
    files: Mapping[str, str],
    name: str,
    *,
    cc: str | None = None,
    flags: Sequence[str] = C_FLAGS,
    extension: bool = False,
) -> bytes:
    """The shared library ``name`` of the C sources among ``files`` ({path: text}), for this machine.

    Paths may have folders; each source finds headers in its own, others by ``-I`` in ``flags``.
    ``extension``: a module that Python loads. No path of this machine is in it, so that the same compiler
    gives the same bytes.

    Raises
    ------
    ToolError: there is no compiler, or it refuses the files.
    """
    compiler = find_c(cc)
    with tempfile.TemporaryDirectory(prefix="robodyn-") as place:
        folder = Path(place)
        for path, text in files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text, encoding="utf-8", newline="\n")
        sources = [path for path in files if path.endswith(".c")]
        objects = [compiler.compile(source, flags=flags, folder=folder) for source in sources]
        compiler.link(objects, name, flags=flags, folder=folder, extension=extension)
        return (folder / name).read_bytes()
