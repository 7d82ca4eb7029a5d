"""What C kernels with sines and arctangents of our own still take from ``math.h``, for builds without a
library: absolute values and square roots, to the same bits (IEEE 754 rounds both correctly)."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from robodyn.emit.unit import OF_LIBM, Unit, calls

#: What is there without a library.
FREESTANDING = frozenset({"abs", "sqrt"})
#: Where the compiler has an instruction for the square root of a float, of a double.
_INSTRUCTION = "defined(__SSE2__) || defined(__aarch64__) || {}"
_FLOAT = "(defined(__ARM_FP) && ((__ARM_FP & 4) != 0)) || defined(__riscv_fsqrt)"
_DOUBLE = "(defined(__ARM_FP) && ((__ARM_FP & 8) != 0)) || (defined(__riscv_fsqrt) && (__riscv_flen >= 64))"


def freestanding_calls(unit: Unit) -> frozenset[str]:
    """Those of :data:`FREESTANDING` that kernels of ``unit`` call; none where they need a library anyway."""
    called = frozenset(calls(unit) & OF_LIBM)
    return called if unit.builtin and called <= FREESTANDING else frozenset()


def freestanding_context(unit: Unit, spelt: Callable[[Fraction], str]) -> dict[str, Any] | None:
    """What the template is told, numbers ``spelt`` in C; None where nothing of it is called."""
    called = freestanding_calls(unit)
    if not called:
        return None
    single = unit.functions[0][0].scalar == "float"
    # Digits behind the first, and the power of two (twice an even one) that makes a subnormal number normal.
    digits, power, bias = (23, 24, 127) if single else (52, 54, 1023)
    word = 8 if single else 16
    return {
        "called": called,
        "suffix": "f" if single else "",
        "instruction": _INSTRUCTION.format(_FLOAT if single else _DOUBLE),
        "digits": digits,
        "bias": bias,
        "size": f"0x7{'f' * (word - 1)}u",
        "unit": f"{1 << digits:#x}u",
        "fraction": f"{(1 << digits) - 1:#x}u",
        "infinite": f"{(2 * bias + 1) << digits:#x}u",
        "zero": spelt(Fraction(0)),
        "one": spelt(Fraction(1)),
        "up": spelt(Fraction(2) ** power),
        "down": spelt(Fraction(1, 2 ** (power // 2))),
    }
