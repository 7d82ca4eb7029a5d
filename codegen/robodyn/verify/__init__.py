"""References that share nothing with the code that makes the kernels, and the comparison with them.

- ``reference``: plain recursive Newton-Euler in double precision; ``exact``:
  torques by virtual work over exact rationals; ``lagrangian``: torques from
  energies, by sympy, for arms of few joints.
- ``effects``, ``declared`` and ``stateful``: effects by their printed
  equations.
- ``free_bodies``: reactions in the joints by d'Alembert's principle; ``poses``:
  solutions of inverse kinematics.
- ``oracles`` puts them behind one interface; ``check`` compares compiled
  kernels with them, ``report`` is the result.
- ``against``: the original file of an imported arm, as Pinocchio or MuJoCo
  reads it.
"""

from robodyn.verify.check import EXACT_STATES, TOLERANCE, verify
from robodyn.verify.exact import exact_torque
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
    "exact_torque",
    "lagrangian",
    "verify",
]
