"""References that share nothing with the code that makes the kernels, and the comparison with them."""

from robodyn.verify.check import EXACT_STATES, TOLERANCE, verify
from robodyn.verify.exact import exact_mass_matrix, exact_torque
from robodyn.verify.lagrangian import LIMIT, lagrangian
from robodyn.verify.reference import Reference
from robodyn.verify.report import Comparison, VerifyReport

__all__ = [
    "EXACT_STATES",
    "LIMIT",
    "TOLERANCE",
    "Comparison",
    "Reference",
    "VerifyReport",
    "exact_mass_matrix",
    "exact_torque",
    "lagrangian",
    "verify",
]
