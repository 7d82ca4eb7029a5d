"""The formats of packages, one file each: every module here has a ``FORMAT``, and is called as that is.

A module is imported when its format is asked for; nothing else has to name it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from robodyn.errors import InputError, did_you_mean
from robodyn.packages.format import Format
from robodyn.registry import Registry

__all__ = ["FORMATS", "format_named"]

#: Formats by name, in the order of their names.
FORMATS: Final[Mapping[str, Format]] = Registry(__name__, "FORMAT", Format)


def format_named(name: str) -> Format:
    """The format called ``name``.

    Raises
    ------
    InputError: there is none; says which there are.
    """
    if name in FORMATS:
        return FORMATS[name]
    raise InputError(
        f"unknown format of a package {name!r}",
        expected=f"one of {', '.join(FORMATS)}",
        remedy=did_you_mean(name, FORMATS),
    )
