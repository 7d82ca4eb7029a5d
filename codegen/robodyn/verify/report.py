"""What a verification found, for people and for programs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from robodyn.draw.tables import aligned


@dataclass(frozen=True, slots=True)
class Comparison:
    """One function against one reference.

    Attributes
    ----------
    function, against: name of the function; ``reference``, ``exact`` or ``lagrangian``.
    states, left_out: how many states were compared, and how many could not be.
    error: the largest difference divided by the yardstick (see :mod:`robodyn.verify.check`).
    tolerance: what the error may be at most.
    joint, column: the joint (from 1) with that difference; of a matrix its row, and the column (from 1). None
        where the result has none.
    state, inputs: number of the state (from 0) and what the kernel was given there.
    ulps: against ``exact``: the largest difference in units in the last place (of the kernel's type) of the
        largest torque that the joint needs at the states compared, for a matrix of the yardstick; else None.
    """

    function: str
    against: str
    states: int
    left_out: int
    error: float
    tolerance: float
    joint: int | None
    column: int | None
    state: int
    inputs: Mapping[str, tuple[float, ...]]
    ulps: float | None

    @property
    def passed(self) -> bool:
        """Whether the error is within the tolerance; never if it is not a number."""
        return self.error <= self.tolerance

    def to_dict(self) -> dict[str, Any]:
        """For JSON; an infinite error is null."""
        names = (
            "function", "against", "passed", "error", "tolerance", "states", "left_out", "joint", "column",
            "state", "inputs", "ulps",
        )  # fmt: skip
        return {name: _for_json(getattr(self, name)) for name in names}


@dataclass(frozen=True, slots=True)
class VerifyReport:
    """All comparisons of one kernel.

    ``largest_torque`` [N m or N] is the yardstick of torques, ``parameters`` the values of the run-time
    parameters, ``functions`` all that the kernel has, ``skipped`` what was not compared and why.
    """

    robot: str
    scalar: str
    language: str
    seed: int
    states: int
    largest_torque: float
    parameters: Mapping[str, float]
    functions: tuple[str, ...]
    comparisons: tuple[Comparison, ...]
    skipped: Mapping[str, str]

    @property
    def passed(self) -> bool:
        """Whether every function was compared with something, and all is within its tolerance."""
        return bool(self.comparisons) and not self.uncompared and all(c.passed for c in self.comparisons)

    @property
    def uncompared(self) -> tuple[str, ...]:
        """Functions that were compared with nothing."""
        compared = {c.function for c in self.comparisons}
        return tuple(function for function in self.functions if function not in compared)

    @property
    def worst(self) -> Comparison | None:
        """The comparison that is nearest to its tolerance, or farthest beyond."""
        return max(self.comparisons, key=lambda c: c.error / c.tolerance, default=None)

    def to_dict(self) -> dict[str, Any]:
        """For JSON."""
        names = (
            "robot", "scalar", "language", "passed", "states", "seed", "largest_torque", "parameters",
            "comparisons", "uncompared", "skipped",
        )  # fmt: skip
        return {name: _for_json(getattr(self, name)) for name in names}

    def to_text(self) -> str:
        """A table, and the state of the worst comparison if it failed."""
        title = f"{self.robot} ({self.scalar}, {self.language}): {self.states} states, seed {self.seed}"
        lines = [f"{title}, largest torque {self.largest_torque:.4g}"]
        head = ("function", "against", "states", "error", "allowed", "joint", "state", "ulp", "")
        lines += aligned([head, *map(_row, self.comparisons)], left=(0, 1))
        lines += [f"not compared: {what}: {why}" for what, why in self.skipped.items()]
        if self.passed:
            lines.append("all within tolerance")
        if self.uncompared:
            lines.append(f"COMPARED WITH NOTHING: {', '.join(self.uncompared)}")
        failed = sum(not c.passed for c in self.comparisons)
        if failed:
            lines.append(f"FAILED: {failed} of {len(self.comparisons)}")
            worst = self.worst
            assert worst is not None
            where = "" if worst.joint is None else f", joint {worst.joint}"
            lines.append(f"worst: {worst.function} against {worst.against}{where}, at")
            lines += [f"  {name} = [{', '.join(repr(x) for x in xs)}]" for name, xs in worst.inputs.items()]
        return "\n".join(lines)


def _row(c: Comparison) -> tuple[str, ...]:
    joint = ",".join(str(x) for x in (c.joint, c.column) if x is not None) or "-"
    states = str(c.states) if not c.left_out else f"{c.states} (-{c.left_out})"
    ulps = "" if c.ulps is None else f"{c.ulps:{'.1f' if c.ulps < 1e6 else '.1e'}}"
    sizes = f"{c.error:.1e}", f"{c.tolerance:.0e}"
    return (c.function, c.against, states, *sizes, joint, str(c.state), ulps, "" if c.passed else "FAILED")


def _for_json(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Comparison):
        return value.to_dict()
    if isinstance(value, Mapping):
        return {name: _for_json(x) for name, x in value.items()}
    return [_for_json(x) for x in value] if isinstance(value, tuple) else value
