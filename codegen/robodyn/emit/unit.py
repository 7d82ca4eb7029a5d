"""What goes into one header and one source: functions with their programs, what they call, and words about
them.

At the end stand the rules of MISRA C:2012 that emitted C does not keep, and why. The rules' words are not
ours to print.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from robodyn.counts.count import Count, count
from robodyn.dynamics.functions import FUNCTIONS
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
    notes: tuple[str, ...] = ()
    misra: bool = False
    builtin: bool = False
    lanes: int = 4
    early_writes: bool = False
    contraction: str | None = None
    target: str | None = None
    options: str = ""
    readable: bool = False

    @property
    def single(self) -> bool:
        """Whether numbers are float."""
        return self.functions[0][0].scalar == "float"

    @property
    def states(self) -> tuple[str, ...]:
        """Members of the state struct, if a function has one."""
        return next((signature.states for signature, _ in self.functions if signature.states), ())

    @property
    def arrays(self) -> tuple[str, ...]:
        """The arguments of all functions by name, each once."""
        each = (array for s, _ in self.functions for array, _ in (*s.inputs, *s.outputs))
        return tuple(dict.fromkeys(each))


#: What is libm's, whoever makes the sines, and those of it that are there without a library.
OF_LIBM, FREESTANDING = frozenset({"tanh", "sqrt", "abs", "exp", "pow"}), frozenset({"abs", "sqrt"})
#: What is libm's unless it is built in.
BUILTIN = frozenset({"sin", "cos", "atan2"})


def calls(unit: Unit) -> set[str]:
    """The operations of all functions."""
    parts = (part for _, program in unit.functions for part in program.parts())
    return {operation.op for part in parts for operation in part.operations}


def needs_libm(unit: Unit) -> bool:
    """Whether the C of ``unit`` includes what is libm's."""
    return not unit.builtin or bool(calls(unit) & OF_LIBM)


def freestanding_calls(unit: Unit) -> frozenset[str]:
    """What of libm C kernels of ``unit`` call that is there without it; none where they need it anyway."""
    called = frozenset(calls(unit) & OF_LIBM)
    return called if unit.builtin and called <= FREESTANDING else frozenset()


def has_sines(unit: Unit) -> bool:
    """Whether a function of ``unit`` calls our own sine and cosine."""
    return unit.builtin and not calls(unit).isdisjoint({"sin", "cos"})


def has_arctangents(unit: Unit) -> bool:
    """Whether a function of ``unit`` calls our own arctangent."""
    return unit.builtin and "atan2" in calls(unit)


def counted(program: Program) -> str:
    """The operations of ``program`` in words."""
    if program.iteration is None:
        return _counted(count(program))
    start, step, finish = map(count, program.parts())
    steps = program.iteration.rows * program.iteration.most
    beside = f"{start.total + finish.total} operations beside them; {count(program).total} in all at most"
    return f"{steps} steps at most, each of {_counted(step)}; {beside}"


def _counted(count: Count) -> str:
    other = f"; {count.other} other calls" if count.other else ""
    return f"{count}; {count.neg} unary minus; {count.sincos} sine/cosine{other}"


def builtin_words(unit: Unit) -> str:
    """What of the functions that a library would have is built in: the beginning of a sentence."""
    if not has_arctangents(unit):
        return "Sine and cosine are built in"
    return f"{'Sine, cosine and arctangent are' if has_sines(unit) else 'The arctangent is'} built in"


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


#: Joints beyond which a pose leaves some free.
_POSED = 6


@dataclass(frozen=True, slots=True)
class Listing:
    """A list of solutions: a small function before the kernel, which has a place for every branch and a
    number for every flag. It puts the solutions that exist in front, in the order of the branches, the others
    behind them, writes what is true of each into one integer, and returns how many exist.

    ``symbol`` of the function in C and its ``name`` elsewhere, the kernel before it, ``branches`` and
    ``joints``; ``near``: whether it is given the reference too, because the arm is redundant or its one
    solution is searched for from there. Otherwise free joints are at 0. ``results``: names of
    the kernel's.
    """

    symbol: str
    name: str
    kernel: Signature
    branches: int
    joints: int
    near: bool
    results: tuple[str, ...]

    #: What is true of a solution, by the bit that says so; above them is the branch's number.
    ALL: ClassVar = {"EXISTS": 1, "WITHIN": 2, "SINGULAR": 4, "PLACED": 8}

    @property
    def flags(self) -> dict[str, int]:
        """Those of this arm."""
        return {name: bit for name, bit in self.ALL.items() if name.lower() in self.results}

    @property
    def factor(self) -> int:
        """What the branch's number is multiplied by."""
        return 2 * max(self.flags.values())

    @property
    def size(self) -> int:
        """Joint positions in all."""
        return self.branches * self.joints


def listing_of(signature: Signature) -> Listing | None:
    """The list of the solutions of ``signature``; None where it has not all branches."""
    function = FUNCTIONS.get(signature.function)
    if function is None or function.answers is None or function.answers.branch:
        return None
    sizes = dict(signature.outputs)  # a stage of it has others, and given sines are no pose
    if "T" not in dict(signature.inputs) or function.answers.exists not in sizes:
        return None
    branches = sizes[function.answers.exists]
    joints = sizes[function.answers.solutions] // branches
    near = joints > _POSED or branches == 1
    name = f"{signature.robot}_{function.name}"
    return Listing(name, function.name, signature, branches, joints, near, tuple(sizes))


_DEVIATIONS = {
    "2.5": "macros of the header say sizes and bits of flags to callers; the kernel itself does not need all",
    "8.7": "a function that another one of the file calls is for callers as well",
    "19.2": "a union reads the bits of a floating number, to choose and to sign sine and cosine without a "
    "branch; its members have one size, C99 defines what is read (6.5.2.3), and the number is IEEE 754",
}


def misra_deviations(unit: Unit) -> dict[str, str]:
    """Rules that a kernel written for MISRA C:2012 does not keep, and why."""
    signatures = [signature for signature, _ in unit.functions]
    listed = any(listing_of(signature) is not None for signature in signatures)
    columns = any(signature.columns for signature in signatures)
    broken = {"2.5": listed or columns, "8.7": listed, "19.2": unit.builtin}
    return {rule: why for rule, why in _DEVIATIONS.items() if broken[rule]}


def misra_notes(unit: Unit) -> tuple[str, ...]:
    """What the head of such a kernel says."""
    lines = misra_deviations(unit)
    if not lines:
        return ("MISRA C:2012: cppcheck finds no rule that is not kept (robodyn prove).",)
    return (
        f"MISRA C:2012: every rule that cppcheck checks is kept but {', '.join(lines)} (robodyn prove):",
        *(f"{rule}: {why}" for rule, why in lines.items()),
    )
