"""What goes into one header and one source: functions with their programs, and words about them."""

from __future__ import annotations

from dataclasses import dataclass, field

from robodyn.counts.count import Count, count
from robodyn.ir.program import Program
from robodyn.ir.signature import Signature
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True)
class Unit:
    """What goes into one header and one source: a robot's functions with their programs.

    ``sc`` describes the elements of the array of given sines and cosines, if there is one; ``notes`` are
    lines for the head of the file; ``misra``: C with products within sums in parentheses. ``builtin``: with
    our own sine, cosine and arctangent, those of ``lanes`` angles at a time. ``early_writes``: results are
    written as soon as they are there. ``contraction``, on or off, stands in a pragma; ``target`` is a note on
    the processor; ``options`` are those it was written with, as on the command line;
    ``readable``: every value is named after its step of the recursion.
    """

    robot: Robot
    functions: tuple[tuple[Signature, Program], ...]
    sc: tuple[str, ...] = ()
    notes: tuple[str, ...] = field(default=())
    misra: bool = False
    builtin: bool = False
    lanes: int = 4
    early_writes: bool = False
    contraction: str | None = None
    target: str | None = None
    options: str = ""
    readable: bool = False


#: What is libm's, whoever makes the sines.
OF_LIBM = frozenset({"tanh", "sqrt", "abs", "exp", "pow"})
#: What is libm's unless it is built in.
BUILTIN = frozenset({"sin", "cos", "atan2"})


def calls(unit: Unit) -> set[str]:
    """The operations of all functions."""
    parts = (part for _, program in unit.functions for part in program.parts())
    return {operation.op for part in parts for operation in part.operations}


def needs_libm(unit: Unit) -> bool:
    """Whether the C of ``unit`` includes what is libm's."""
    return not unit.builtin or bool(calls(unit) & OF_LIBM)


def has_sines(unit: Unit) -> bool:
    """Whether a function of ``unit`` calls our own sine and cosine."""
    return unit.builtin and any(count(program).sincos for _, program in unit.functions)


def has_arctangents(unit: Unit) -> bool:
    """Whether a function of ``unit`` calls our own arctangent."""
    return unit.builtin and "atan2" in calls(unit)


def builtin_words(unit: Unit) -> str:
    """What of the functions that a library would have is built in: the beginning of a sentence."""
    if not has_arctangents(unit):
        return "Sine and cosine are built in"
    return f"{'Sine, cosine and arctangent are' if has_sines(unit) else 'The arctangent is'} built in"


def counted(program: Program) -> str:
    """The operations of ``program`` in words."""
    if program.iteration is None:
        return counted_text(count(program))
    start, step, finish = map(count, program.parts())
    steps = program.iteration.rows * program.iteration.most
    beside = f"{start.total + finish.total} operations beside them; {count(program).total} in all at most"
    return f"{steps} steps at most, each of {counted_text(step)}; {beside}"


def counted_text(count: Count) -> str:
    parts = [str(count), f"{count.neg} unary minus", f"{count.sincos} sine/cosine"]
    if count.other:
        parts.append(f"{count.other} other calls")
    return "; ".join(parts)


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
