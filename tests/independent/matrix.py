"""Arms x effects x functions: what robodyn's programs give beside what the reference gives."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np

import robodyn
from independent import memory, refusals
from independent.answers import ANSWERS
from independent.arms import Arm, placed, text
from independent.cases import with_case
from independent.checks import CHECKS
from independent.reference import Array, Reference
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.errors import InputError
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Program
from robodyn.kernels.generate import maker
from robodyn.kernels.options import Level, Options

TOLERANCE: Final = 1e-10
FUSED: Final = ("bias_and_mass_matrix", "forward_kinematics_and_jacobian_and_inverse_dynamics_derivatives")
EVERY: Final = (*FUNCTIONS, *FUSED)


@dataclass(frozen=True)
class Outcome:
    """Of one pair: the worst error as a share of the result's size, or why it was refused."""

    function: str
    case: str
    arm: str
    error: float = 0.0
    tolerance: float = TOLERANCE
    refused: str = ""
    allowed: bool = False

    @property
    def fails(self) -> bool:
        """Wrong, or refused without need or reason."""
        if self.refused:
            return not (self.allowed and refusals.gives_a_reason(self.refused))
        return not self.error <= self.tolerance

    @property
    def text(self) -> str:
        """For a person."""
        said = f"refused: {self.refused}" if self.refused else f"off by {self.error:.2g}"
        return f"{self.function} of {self.arm} with {self.case}: {said}"


def read(arm: Arm) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{arm['name']}.yaml"
        path.write_text(text(arm))
        return robodyn.load(path)


def states(arm: Arm, count: int, seed: int) -> list[dict[str, Array]]:
    """Away from rest, so that no sign is at its jump."""
    rng, n = np.random.default_rng(seed), len(arm["links"])
    found = []
    for _ in range(count):
        way = rng.choice((-1.0, 1.0), n)
        found.append(
            {
                "q": rng.uniform(-1.5, 1.5, n),
                "qd": way * rng.uniform(0.3, 2, n),
                "qdd": rng.uniform(-3, 3, n),
                "tau": rng.uniform(-40, 40, n),
                "w": rng.uniform(-15, 15, 6),
            }
        )
    return found


def run(program: Program, at: Mapping[str, Array], values: Mapping[str, float]) -> list[Array]:
    """The program's results, flat, in the order of the record."""
    inputs = {
        x: values[x.array] if x.index is None else float(at[x.array][x.index]) for x in program.inputs()
    }
    return [np.array(values) for values in evaluate(program, inputs).values()]


def compare(
    arm: Arm, case: str, functions: Sequence[str], count: int = 3, level: Level = "fast"
) -> Iterator[Outcome]:
    """What became of each of ``functions`` of the arm."""
    reference = Reference(arm)
    try:
        robot = read(arm)
    except InputError as refusal:
        yield from (Outcome(name, case, arm["name"], refused=str(refusal)) for name in functions)
        return
    builder = maker(robot, Options(optimize=level))
    for name in functions:
        try:
            program = builder.program(name)
            error, tolerance = _error(name, reference, robot, program, states(arm, count, len(case)))
            yield Outcome(name, case, arm["name"], error, tolerance)
        except InputError as refusal:
            may = refusals.allowed(name, arm)
            yield Outcome(name, case, arm["name"], refused=str(refusal), allowed=may)


def outcomes(
    case: str, joints: str, convention: str, functions: Sequence[str] = EVERY, level: Level = "none"
) -> list[Outcome]:
    """Of every function of an arm with an effect; nothing where the effect does not fit its joints."""
    arm = with_case(placed(joints, convention, len(joints)), case)
    return [] if arm is None else list(compare(arm, case, functions, level=level))


def _error(
    name: str, reference: Reference, robot: Any, program: Program, at: Sequence[Mapping[str, Array]]
) -> tuple[float, float]:
    """The worst error, and how large it may be."""
    known = reference.arm.get("values", {})
    if name in CHECKS:
        base = robodyn.base_parameters(robot, known) if "kinematics" not in name else None
        at = states(reference.arm, 30, 1) if name == "regressor" else at
        return CHECKS[name](reference, base, lambda x: run(program, x, known), at), TOLERANCE
    memory_size = sum(len(values) for array, values in program.outputs if array == "state")
    if memory_size:
        return memory.compared(reference, memory_size, lambda x: run(program, x, known))
    worst = 0.0
    for each in at:
        parts = (
            [name] if name in ANSWERS else name.split("_and_")
        )  # fused functions are named after their parts
        expected = [np.ravel(x) for part in parts for x in ANSWERS[part](reference, each)]
        worst = max(worst, *errors(run(program, each, known), expected))
    return worst, TOLERANCE


def errors(results: Sequence[Array], expected: Sequence[Array]) -> list[float]:
    """Of each result as a share of its size; of one that is smaller than 1/1000, of that."""
    found = []
    for result, right in zip(results, expected, strict=True):
        if result.shape != right.shape or not np.isfinite(result).all():
            found.append(np.inf)
        else:
            found.append(float(np.abs(result - right).max()) / max(float(np.abs(right).max()), 1e-3))
    return found
