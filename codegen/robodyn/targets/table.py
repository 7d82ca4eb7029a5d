"""The table: every module in ``processors/`` is a target. A module is imported when its target is asked for.

A module is called as its target is, ``_`` for ``-``, and has it as ``TARGET``; nothing else has to name it.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Final

from robodyn.errors import InputError
from robodyn.targets import processors
from robodyn.targets.target import Target


@cache
def _names() -> tuple[str, ...]:
    modules = (module.name for module in pkgutil.iter_modules(processors.__path__))
    return tuple(sorted(name.replace("_", "-") for name in modules))


@cache
def _read(name: str) -> Target:
    module = importlib.import_module(f"{processors.__name__}.{name.replace('-', '_')}")
    target = module.TARGET
    assert isinstance(target, Target)
    assert target.name == name, f"{module.__file__}: its target is called {target.name}"
    return target


class _Table(Mapping[str, Target]):
    def __getitem__(self, name: str) -> Target:
        if name not in _names():
            raise KeyError(name)
        return _read(name)

    def __contains__(self, name: object) -> bool:
        return name in _names()

    def __iter__(self) -> Iterator[str]:
        return iter(_names())

    def __len__(self) -> int:
        return len(_names())


#: Targets by name, in the order of their names.
TARGETS: Final[Mapping[str, Target]] = _Table()


def all_targets() -> tuple[Target, ...]:
    """All of them; each has costs, so that searches can weigh operations for it."""
    return tuple(TARGETS.values())


def compiled_targets() -> tuple[Target, ...]:
    """Those that kernels are compiled for."""
    return tuple(target for target in all_targets() if target.flags is not None)


def firmware_targets() -> tuple[Target, ...]:
    """Those that have a board, hence a firmware image."""
    return tuple(target for target in all_targets() if target.board is not None)


def planned_targets() -> tuple[Target, ...]:
    """Those whose clock is known, so that a plan can be made for them."""
    return tuple(target for target in all_targets() if target.chip is not None)


def target_named(
    name: str,
    among: Iterable[Target] | None = None,
    *,
    what: str = "unknown target",
    others: str = "",
) -> Target:
    """The target called ``name``, or by one of its other names; ``among`` is all of them where it is None.

    Raises
    ------
    InputError: there is none. ``what`` begins the message, and ``others`` ends the list of what is expected.
    """
    if among is None and name in TARGETS:
        return TARGETS[name]
    known = {target.name: target for target in (all_targets() if among is None else among)}
    spellings = {alias: target for target in known.values() for alias in (target.name, *target.aliases)}
    if name not in spellings:
        import difflib

        close = difflib.get_close_matches(name, spellings, n=1)
        raise InputError(
            f"{what} {name!r}",
            expected=f"one of {', '.join(known)}{others}",
            remedy=f"did you mean {close[0]!r}?" if close else None,
        )
    return spellings[name]
