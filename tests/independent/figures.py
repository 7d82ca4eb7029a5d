"""The widest matrix and its figures: ``PYTHONPATH=tests python -m independent``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Final

from independent.arms import placed
from independent.cases import CASES, with_case
from independent.matrix import Outcome, compare
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.kernels.options import Level

FUSED: Final = ("bias_and_mass_matrix", "forward_kinematics_and_jacobian_and_inverse_dynamics_derivatives")
EVERY: Final = (*FUNCTIONS, *FUSED)


def outcomes(
    case: str, joints: str, convention: str, functions: Sequence[str] = EVERY, level: Level = "none"
) -> list[Outcome]:
    """Of every function of an arm with an effect; nothing where the effect does not fit its joints."""
    arm = with_case(placed(joints, convention, len(joints)), case)
    return [] if arm is None else list(compare(arm, case, functions, level=level))


def figures(found: Iterable[Outcome]) -> str:
    """How many pairs, how many refused, the worst error, and which fail."""
    every = list(found)
    fails = [outcome for outcome in every if outcome.fails]
    compared = [outcome for outcome in every if not outcome.refused and not outcome.fails]
    memory = [x.error for x in compared if x.tolerance > 1e-10]
    worst = max((x.error for x in compared if x.tolerance <= 1e-10), default=0.0)
    lines = [
        f"{len(every)} pairs, of {len(CASES)} cases and {len({x.arm for x in every})} arms",
        f"{len(compared)} equal, worst error {worst:.2g}"
        + (f" (along motions, extrapolated: {max(memory):.2g})" if memory else ""),
        f"{len(every) - len(compared) - len(fails)} refused with a reason",
        f"{len(fails)} fail",
    ]
    for function, count in Counter(x.function for x in fails).most_common():
        cases = sorted({x.case for x in fails if x.function == function})
        lines.append(f"  {function}: {count}, of {'; '.join(cases)}")
    return "\n".join(lines)
