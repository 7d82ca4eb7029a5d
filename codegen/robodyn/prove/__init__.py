"""Proofs of emitted kernels: rounding errors, run-time errors, stack, MISRA C:2012.

robodyn writes the questions and reads the answers; Gappa, Frama-C, gcc and cppcheck prove.
"""

from robodyn.prove.finding import Finding
from robodyn.prove.plan import PROOFS, Asked
from robodyn.prove.ranges import with_ranges
from robodyn.prove.run import Proof, prove

__all__ = ["PROOFS", "Asked", "Finding", "Proof", "prove", "with_ranges"]
