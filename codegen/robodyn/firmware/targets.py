"""Processors that an image is made for: how the compiler is told, and which of qemu's boards has one."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from dataclasses import dataclass

from robodyn.errors import InputError
from robodyn.ir.signature import ScalarType


@dataclass(frozen=True, slots=True)
class Target:
    """A processor. ``hardware`` names the scalar types that its floating-point unit has; for the others the
    compiler calls its own library (libgcc: ``__aeabi_fadd`` and the like)."""

    name: str
    title: str
    flags: tuple[str, ...]
    machine: str
    hardware: tuple[ScalarType, ...]


_ALL = (
    Target(
        "cortex-m3",
        "Cortex-M3, no floating-point unit",
        ("-mcpu=cortex-m3", "-mthumb", "-mfloat-abi=soft"),
        "mps2-an385",
        (),
    ),
    Target(
        "cortex-m4f",
        "Cortex-M4F, floating-point unit for float",
        ("-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"),
        "mps2-an386",
        ("float",),
    ),
    Target(
        "cortex-m7",
        "Cortex-M7, floating-point unit for float and double",
        ("-mcpu=cortex-m7", "-mthumb", "-mfpu=fpv5-d16", "-mfloat-abi=hard"),
        "mps2-an500",
        ("float", "double"),
    ),
)

#: Processors by name.
TARGETS: dict[str, Target] = {target.name: target for target in _ALL}


def targets_named(names: Sequence[str]) -> tuple[Target, ...]:
    """The processors called ``names``; all of them where there is no name.

    Raises
    ------
    InputError: one is unknown, or named twice.
    """
    for name in names:
        if name not in TARGETS:
            close = difflib.get_close_matches(name, TARGETS, n=1)
            raise InputError(
                f"there is no firmware for the target {name!r}",
                expected=f"some of {', '.join(TARGETS)}",
                remedy=f"did you mean {close[0]!r}?" if close else None,
            )
    if len(set(names)) != len(names):
        raise InputError("a target is named twice", found=", ".join(names))
    return tuple(TARGETS[name] for name in names) or _ALL
