"""Targets by name: what to generate for a processor, and the compiler flags that go with it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from robodyn.errors import InputError
from robodyn.ir.signature import ScalarType

Contraction = Literal["off", "on"]


@dataclass(frozen=True, slots=True)
class Target:
    """What is chosen for a processor; each choice yields to its own option.

    ``lanes`` is how many sines its vectors take at once (1: no vectors), ``registers`` how many values it
    keeps at hand, ``objective`` what searches make small, ``flags`` are for gcc and clang alike.
    """

    name: str
    scalar: ScalarType
    contraction: Contraction
    objective: str
    lanes: int
    registers: int
    flags: str
    why: str
    trig: Literal["builtin"] = "builtin"
    order: Literal["registers"] = "registers"

    def compiled(self, contraction: Contraction) -> str:
        """The flags, for ``contraction``."""
        return f"{self.flags} -ffp-contract={'fast' if contraction == 'on' else 'off'} -fno-math-errno"


_THUMB = "-std=c99 -O2 -mthumb"
_DESK = "-std=c99 -O2"
_SAME = "the bits are those of every other target"
_FUSED = "a fused multiply-add costs what a product does"

TARGETS: dict[str, Target] = {
    target.name: target
    for target in (
        Target(
            "cortex-m3", "float", "off", "weighted:cortex-m3", 1, 8,
            f"{_THUMB} -mcpu=cortex-m3 -mfloat-abi=soft", "floating point in software",
        ),
        Target(
            "cortex-m4f", "float", "off", "weighted:cortex-m4", 1, 30,
            f"{_THUMB} -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard",
            "a fused multiply-add takes three cycles, a product and a sum two",
        ),
        Target(
            "cortex-m7", "double", "off", "weighted:cortex-m7", 1, 15,
            f"{_THUMB} -mcpu=cortex-m7 -mfpu=fpv5-d16 -mfloat-abi=hard", _SAME,
        ),
        Target("x86-64", "double", "off", "weighted:x86-64", 4, 16, _DESK, "no fused multiply-add"),
        Target("x86-64-v3", "double", "on", "weighted:x86-64-v3", 4, 16, f"{_DESK} -march=x86-64-v3", _FUSED),
        Target("x86-64-v4", "double", "on", "weighted:x86-64-v3", 4, 16, f"{_DESK} -march=x86-64-v4", _FUSED),
        Target("aarch64", "double", "on", "weighted:x86-64-v3", 4, 30, _DESK, _FUSED),
    )
}  # fmt: skip


def target_named(name: str) -> Target:
    """The target called ``name``.

    Raises
    ------
    InputError: there is none.
    """
    if name not in TARGETS:
        import difflib

        close = difflib.get_close_matches(name, TARGETS, n=1)
        raise InputError(
            f"unknown target {name!r}",
            expected=f"one of {', '.join(TARGETS)}",
            remedy=f"did you mean {close[0]!r}?" if close else None,
        )
    return TARGETS[name]
