"""Solutions one after another: a function that hands back those that exist, and says how many they are.

The kernel has a place for every branch and a number for every flag. Callers in C and Rust mostly want a list:
a small function before the kernel puts the solutions that exist in front, in the order of the branches, the
others behind them, and writes what is true of each into one integer.
"""

from __future__ import annotations

from dataclasses import dataclass

from robodyn.dynamics.functions import FUNCTIONS
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
