"""Prints the figures of the matrix of these arms: ``python -m independent [JOINTS ...] [fast]``."""

from __future__ import annotations

import sys
from itertools import product

from independent.arms import CONVENTIONS
from independent.cases import CASES
from independent.figures import figures, outcomes
from independent.matrix import Outcome
from robodyn.kernels.options import Level

chosen = [x for x in sys.argv[1:] if x != "fast"] or ["R", "P", "RP", "PR"]
level: Level = "fast" if "fast" in sys.argv else "none"
found: list[Outcome] = []
for joints, convention, case in product(chosen, CONVENTIONS, CASES):
    found += outcomes(case, joints, convention, level=level)
print(figures(found))
