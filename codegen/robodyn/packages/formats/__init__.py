"""The formats of packages, one file each: every module here has a ``FORMAT``, and is called as that is.

A module is imported when its format is asked for; nothing else has to name it.
"""

from __future__ import annotations

import difflib
import importlib
import pkgutil
from collections.abc import Iterator, Mapping
from functools import cache
from typing import Final

from robodyn.errors import InputError
from robodyn.packages.format import Format

__all__ = ["FORMATS", "format_named"]


@cache
def _names() -> tuple[str, ...]:
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__)))


@cache
def _read(name: str) -> Format:
    record = importlib.import_module(f"{__name__}.{name}").FORMAT
    assert isinstance(record, Format)
    assert record.name == name, f"{name}.py: its format is called {record.name}"
    return record


class _Formats(Mapping[str, Format]):
    def __getitem__(self, name: str) -> Format:
        if name not in _names():
            raise KeyError(name)
        return _read(name)

    def __contains__(self, name: object) -> bool:
        return name in _names()

    def __iter__(self) -> Iterator[str]:
        return iter(_names())

    def __len__(self) -> int:
        return len(_names())


#: Formats by name, in the order of their names.
FORMATS: Final[Mapping[str, Format]] = _Formats()


def format_named(name: str) -> Format:
    """The format called ``name``.

    Raises
    ------
    InputError: there is none; says which there are.
    """
    if name in FORMATS:
        return FORMATS[name]
    close = difflib.get_close_matches(name, FORMATS, n=1)
    raise InputError(
        f"unknown format of a package {name!r}",
        expected=f"one of {', '.join(FORMATS)}",
        remedy=f"did you mean {close[0]!r}?" if close else None,
    )
