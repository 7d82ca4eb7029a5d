"""Where the data that comes with robodyn lies: the bundled robots and the templates."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import Literal

from robodyn.errors import ToolError

Kind = Literal["robots", "templates"]
_KINDS = ("robots", "templates")
#: The folder of records of best programs, beside the robot files.
RECORDS = "records"


def from_here(path: Path) -> Path:
    """``path`` as one would write it in the working folder: relative where it lies below that."""
    with contextlib.suppress(OSError, ValueError):  # no working folder, or a path elsewhere
        return path.relative_to(Path.cwd())
    return path


def data_dir(kind: Kind) -> Path:
    """Folder of the bundled ``robots`` or ``templates``.

    In an installed wheel it is ``robodyn/_data/<kind>``; in a checkout or an editable install it is
    ``<kind>`` at the top of the repository, two levels above the package.

    Raises
    ------
    ValueError: ``kind`` is neither of the two.
    ToolError: neither folder is there; the installation is incomplete.
    """
    if kind not in _KINDS:
        raise ValueError(f"no data of kind {kind!r}: expected one of {', '.join(_KINDS)}")
    package = Path(__file__).resolve().parent
    candidates = (package / "_data" / kind, package.parent.parent / kind)
    for folder in candidates:
        if folder.is_dir():
            return folder
    raise ToolError(
        f"the bundled {kind} are missing from this installation",
        found=f"neither {candidates[0]} nor {candidates[1]}",
        expected=f"a folder of {kind}",
        remedy="install robodyn again (pip install --force-reinstall robodyn)",
    )


def bundled_robot(name: str) -> Path | None:
    """The file of the bundled robot ``name`` (``puma560`` or ``puma560.yaml``); None where there is none.

    Raises
    ------
    ToolError: the folder of the robots is missing from the installation.
    """
    stem = name.removesuffix(".yaml")
    return next((path for path in data_dir("robots").glob("*.yaml") if path.stem == stem), None)
