"""Solutions one after another: a function that hands back those that exist, and says how many they are.

The kernel has a place for every branch and a number for every flag. Callers in C and Rust mostly want a list:
a small function before the kernel puts the solutions that exist in front, in the order of the branches, the
others behind them, and writes what is true of each into one integer.

At the end stand the rules of MISRA C:2012 that emitted C does not keep, such a list among them, and why. The
rules' words are not ours to print.
"""

from __future__ import annotations

from dataclasses import dataclass

from robodyn.dynamics.functions import FUNCTIONS
from robodyn.emit.unit import Unit
from robodyn.ir.signature import Signature

#: What is true of a solution, by the bit that says so; the branch's number is above them.
FLAGS = {"EXISTS": 1, "WITHIN": 2, "SINGULAR": 4}
#: The branch's number is multiplied by this.
BRANCH = 8

#: Joints beyond which a pose leaves some free.
_POSED = 6


@dataclass(frozen=True, slots=True)
class Listing:
    """A list of solutions: ``symbol`` of the function in C and its ``name`` elsewhere, the kernel before it,
    ``branches`` and ``joints``; ``near``: whether it is given the reference too, because the arm is redundant
    or its one solution is searched for from there. Otherwise free joints are at 0."""

    symbol: str
    name: str
    kernel: Signature
    branches: int
    joints: int
    near: bool

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
    return Listing(f"{signature.robot}_{function.name}", function.name, signature, branches, joints, near)


_MACROS = "macros of the header say sizes and bits of flags to callers; the kernel itself does not need all"
_LISTED = "a function that another one of the file calls is for callers as well"
_BITS = (
    "a union reads the bits of a floating number, to choose and to sign sine and cosine without a branch; "
    "its members have one size, C99 defines what is read (6.5.2.3), and the number is IEEE 754"
)


def misra_deviations(unit: Unit) -> dict[str, str]:
    """Rules that a kernel written for MISRA C:2012 does not keep, and why."""
    signatures = [signature for signature, _ in unit.functions]
    listed = any(listing_of(signature) is not None for signature in signatures)
    rules = {}
    if listed or any(signature.columns for signature in signatures):
        rules["2.5"] = _MACROS
    if listed:
        rules["8.7"] = _LISTED
    if unit.builtin:
        rules["19.2"] = _BITS
    return rules


def misra_notes(unit: Unit) -> tuple[str, ...]:
    """What the head of such a kernel says."""
    lines = misra_deviations(unit)
    if not lines:
        return ("MISRA C:2012: cppcheck finds no rule that is not kept (robodyn prove).",)
    return (
        f"MISRA C:2012: every rule that cppcheck checks is kept but {', '.join(lines)} (robodyn prove):",
        *(f"{rule}: {why}" for rule, why in lines.items()),
    )
