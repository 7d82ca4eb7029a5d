"""Proofs of emitted kernels: rounding errors, run-time errors, stack, MISRA C:2012.

robodyn writes the questions and reads the answers; Gappa, Frama-C, gcc and cppcheck prove.
"""

from robodyn.certify.plan import PROOFS, Finding, ProofOptions, with_ranges
from robodyn.certify.run import Proof, prove

__all__ = ["PROOFS", "Finding", "Proof", "ProofOptions", "prove", "with_ranges"]
