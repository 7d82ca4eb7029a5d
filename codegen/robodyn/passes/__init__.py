"""Passes from program to program, one file each; what a level of optimisation runs."""

from robodyn.passes.factor import factor
from robodyn.passes.negate import negate
from robodyn.passes.order import dce, order
from robodyn.passes.pipeline import Pass, PassError, run, unchecked
from robodyn.passes.replay import cse, fold
from robodyn.passes.units import units

#: Always run: they change signs and order, no operation.
SPELLING: tuple[Pass, ...] = (negate, order)
#: Those before them, which save operations of any program.
SAVING: tuple[Pass, ...] = (fold, cse, dce, factor, units)
#: The same for a program fresh from a graph, which has merged, folded and dropped already.
FRESH_SAVING: tuple[Pass, ...] = (factor, units)
#: The passes of ``--optimize fast`` for any program, and for one fresh from a graph.
FAST: tuple[Pass, ...] = (*SAVING, *SPELLING)
FRESH: tuple[Pass, ...] = (*FRESH_SAVING, *SPELLING)

__all__ = [
    "FAST", "FRESH", "FRESH_SAVING", "SAVING", "SPELLING", "Pass", "PassError", "cse", "dce", "factor",
    "fold", "negate", "order", "run", "unchecked", "units",
]  # fmt: skip
