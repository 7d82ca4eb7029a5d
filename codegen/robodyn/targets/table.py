"""The table: every module in ``processors/`` is a target. A module is imported when its target is asked for.

A module is called as its target is, ``_`` for ``-``, and has it as ``TARGET``; nothing else has to name it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final

from robodyn.errors import InputError, did_you_mean
from robodyn.registry import Registry
from robodyn.targets.target import Target

#: Targets by name, in the order of their names.
TARGETS: Final[Mapping[str, Target]] = Registry(f"{__package__}.processors", "TARGET", Target)


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
        raise InputError(
            f"{what} {name!r}",
            expected=f"one of {', '.join(known)}{others}",
            remedy=did_you_mean(name, spellings),
        )
    return spellings[name]
