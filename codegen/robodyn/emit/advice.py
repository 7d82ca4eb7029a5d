"""What the head of a file says of compiling it and of its arrays, in languages whose compilers may fuse."""

from __future__ import annotations

from robodyn.emit.unit import Unit, builtin_words


def advice(unit: Unit) -> tuple[str, ...]:
    """Target, bits, and where results may be written."""
    notes: tuple[str, ...] = () if unit.target is None else (unit.target,)
    if unit.builtin:
        notes += (
            f"{builtin_words(unit)}: no libm. "
            + (
                "Products and sums may be fused (-ffp-contract=fast): bits depend on the compiler."
                if unit.contraction == "on"
                else "The same bits on every machine with IEEE arithmetic, in C and in Fortran, where "
                "products and sums are not fused: -ffp-contract=off (gcc -std=c99 implies it; gfortran 12.0 "
                "to 12.2 with -mfma needs -fno-tree-slp-vectorize too)."
            ),
        )
    if unit.early_writes:
        notes += (
            "Results are written early: they may take the place of q, qd or qdd (the very same array), and "
            "must not overlap them otherwise.",
        )
    return notes
