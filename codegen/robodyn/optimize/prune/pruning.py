"""Pruning a function of a robot: the tolerance in torques, the smaller program, and what is known of it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

from robodyn.counts import count
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.errors import InputError
from robodyn.ir.program import Program
from robodyn.optimize.programs import Choice, build
from robodyn.optimize.prune.bounds import proven_errors
from robodyn.optimize.prune.box import Box, box_of, draw, largest, values
from robodyn.optimize.prune.editor import Editor
from robodyn.optimize.prune.greedy import pruned
from robodyn.passes import FAST, SPELLING, run
from robodyn.robot.model import Robot

#: Functions that are pruned, torques of the recursion. The others stay exact: an error of the mass matrix has
#: no bound in terms of the torques alone, and is magnified where the matrix is inverted.
PRUNED = tuple(name for name, function in FUNCTIONS.items() if function.gives_torques)

#: States at which the error is sampled.
STATES = 100_000
#: Digits of the figures that are told, and the part of a budget that their rounding may not use up.
_DIGITS = 4
_MARGIN = 0.998
#: Rounding of doubles in a torque, as a share of the peak: an error below it is none.
_ROUNDING = 1e-11

_REPORT = "; please report the robot file"

Progress = Callable[[str], None]


class PruneError(AssertionError):
    """A proven bound does not hold: a defect of robodyn, never of its input."""


@dataclass(frozen=True, slots=True)
class Pruning:
    """What pruning did to one function; figures of joint 1 first, in N m (N at prismatic joints).

    ``peaks`` are the largest torques found over the limits (of the inverse dynamics, whatever the function):
    the true ones are no smaller. ``proven`` bounds the error of each torque over all states within the
    limits;
    ``sampled`` is the largest error found at ``states`` states and by ascent from the worst of them.
    """

    function: str
    tolerance: Fraction
    limits: tuple[str, ...]
    peaks: tuple[float, ...]
    proven: tuple[float, ...]
    sampled: tuple[float, ...]
    states: int
    before: int
    after: int

    def to_dict(self) -> dict[str, Any]:
        """As ``--json`` prints it."""
        names = ("joint", "peak", "proven", "sampled", "share")
        joints = [
            dict(zip(names, (*row, _rounded(row[2] / row[1], 1) if row[1] else 0.0), strict=True))
            for row in self._rows()
        ]
        return {
            "tolerance": float(self.tolerance), "limits": list(self.limits), "before": self.before,
            "after": self.after, "states": self.states, "joints": joints,
        }  # fmt: skip

    def _rows(self) -> list[tuple[int, float, float, float]]:
        joints = range(1, len(self.peaks) + 1)
        return list(zip(joints, self.peaks, self.proven, self.sampled, strict=True))

    def notes(self) -> tuple[str, ...]:
        """Lines for the head of a file and for people."""
        lines = [f"  {self.function}: {self.before} operations without, {self.after} with"]
        for j, peak, proven, sampled in self._rows():
            share = _percent(proven / peak) if peak else "0 %"
            error = f"error proven below {proven:g} ({share}), sampled up to {sampled:g}"
            lines.append(f"    joint {j}: peak {peak:g}, {error if proven > _ROUNDING * peak else 'exact'}")
        return tuple(lines)


def notes_of(prunings: Sequence[Pruning]) -> tuple[str, ...]:
    """What the head of a file says of pruning; nothing if there was none."""
    if not prunings:
        return ()
    first = prunings[0]
    names = ", ".join(p.function for p in prunings)
    return (
        f"Pruned to {float(100 * first.tolerance):g} % of each joint's peak torque: terms of {names} that "
        "cannot matter within these limits are left out (mass_matrix and forward_dynamics never are):",
        *(f"  {text}" for text in first.limits),
        "The error is proven for all states within the limits (of revolute joints at any angle; rounding "
        f"comes on top), and sampled at {first.states} states besides [N m, prismatic N]:",
        *(line for pruning in prunings for line in pruning.notes()),
        "Beyond the limits it may be larger.",
    )


def parse_tolerance(text: str) -> Fraction:
    """``1%`` or ``0.01``: a share of each joint's peak torque.

    Raises
    ------
    InputError: it is no number, or not between 0 and 100 %.
    """
    plain = text.strip()
    try:
        value = Fraction(repr(float(plain.removesuffix("%")))) / (100 if plain.endswith("%") else 1)
    except (ValueError, OverflowError):
        value = Fraction(-1)
    _check_share(value, text)
    return value


def check_asked(tolerance: Fraction, functions: Sequence[str] | None) -> None:
    """:class:`InputError` for a tolerance that is no share, for functions that are never pruned."""
    _check_share(tolerance, str(float(tolerance)))
    if functions is not None and not set(functions) & set(PRUNED):
        raise InputError(
            f"{', '.join(functions)} cannot be pruned",
            expected=f"one of {', '.join(PRUNED)}",
            remedy="leave out --prune: what is asked for stays exact",
        )


def _check_share(value: Fraction, text: str) -> None:
    if not 0 < value < 1:
        raise InputError(
            "the tolerance is not a share of a torque",
            found=text,
            expected="a number above 0 and below 1, or a percentage",
            remedy="write 1% or 0.01",
        )


@lru_cache(maxsize=16)
def peaks_of(robot: Robot) -> tuple[float, ...]:
    """The largest torque [n] of each joint that sampling and ascent find within the limits: at most the true
    one, so that a share of it is the stricter tolerance."""
    box = box_of(robot)
    program = build(robot, "inverse_dynamics", Choice("newton_euler", regroup=False, chains=False))
    peaks = largest(lambda states: values(program, box, states), box, seed=1)
    return tuple(float(peak) * (1 - 1e-9) for peak in peaks)


def prune(
    robot: Robot,
    function: str,
    program: Program,
    tolerance: Fraction,
    *,
    beside: Sequence[Program] = (),
    progress: Progress | None = None,
) -> tuple[Program, Pruning]:
    """``program``, which computes ``function`` of ``robot``, without terms that cannot matter.

    Every torque stays within ``tolerance`` times the joint's peak torque of ``program``'s, for every state
    within the limits of ``robot``. Programs ``beside`` compute the same; what they come to is taken where
    that is smaller: the shortest program need not be the one that loses most. ``progress`` is told what goes
    on.

    Raises
    ------
    InputError: the robot lacks limits or has run-time parameters, or the program divides.
    """
    if function not in PRUNED:
        raise InputError(f"{function} cannot be pruned", expected=f"one of {', '.join(PRUNED)}")
    tell = progress or (lambda _: None)
    box = box_of(robot, FUNCTIONS[function].input_names)
    tell(f"peak torques of {robot.name}")
    peaks = peaks_of(robot)
    allowed = [float(tolerance) * peak for peak in peaks]
    budget = [_MARGIN * error for error in allowed]
    before = count(program).total
    candidates = [program]
    for start in dict.fromkeys((program, *beside)):
        editor = Editor(start, box, budget)
        state = pruned(editor, lambda left: tell(f"pruning {function}: {left} of {before} operations"))
        written = editor.written(state.edits)
        # Factoring again may undo what a search has found.
        candidates += [run(written, passes) for passes in (FAST, SPELLING)]
    smaller = min(candidates, key=lambda candidate: count(candidate).total)
    tell(f"proving the errors of {function}")
    proven = proven_errors(program, smaller, box, budget)
    sampled = sampled_errors(program, smaller, box)
    for bound, sample, most, peak in zip(proven, sampled, allowed, peaks, strict=True):
        if not bound <= most:
            raise PruneError(f"a proven error of {bound} is above the tolerance of {most}{_REPORT}")
        if not sample <= bound + _ROUNDING * peak:
            raise PruneError(f"an error of {sample} is above the proven {bound}{_REPORT}")
    shown = tuple(
        _rounded(min(sample, bound), 1) if sample > _ROUNDING * peak else 0.0
        for sample, bound, peak in zip(sampled, proven, peaks, strict=True)
    )
    rounded_peaks = tuple(_rounded(peak, -1) for peak in peaks)
    rounded_bounds = tuple(_rounded(bound, 1) for bound in proven)
    return smaller, Pruning(
        function, tolerance, limits_of(robot, box), rounded_peaks, rounded_bounds, shown, STATES, before,
        count(smaller).total,
    )  # fmt: skip


def sampled_errors(program: Program, smaller: Program, box: Box) -> list[float]:
    """The largest difference [m] of two programs found at random states, half of them corners, and by ascent
    from the worst."""
    import numpy as np

    def difference(at: Any) -> Any:
        return values(smaller, box, at) - values(program, box, at)

    seed, chunk = 2, 20_000
    worst = largest(difference, box, seed)
    for k in range(0, STATES, chunk):
        worst = np.maximum(worst, np.abs(difference(draw(box, chunk, seed + 1 + k))).max(axis=1))
    return [float(error) for error in worst]


def limits_of(robot: Robot, box: Box) -> tuple[str, ...]:
    """The limits in words, joints with the same ones together."""
    alike: dict[str, list[int]] = {}
    arrays = {x.array for x in box.inputs}
    for i, link in enumerate(robot.links, 1):
        limits, revolute = link.joint.limits, link.joint.kind == "revolute"
        unit = "rad" if revolute else "m"
        assert limits.position is not None
        low, high = (float(x) for x in limits.position)
        texts = [f"q {low:g} .. {high:g} {unit}"]
        if "qd" in arrays:
            texts.append(f"|qd| <= {float(limits.velocity or 0):g} {unit}/s")
        if "qdd" in arrays:
            texts.append(f"|qdd| <= {float(limits.acceleration or 0):g} {unit}/s^2")
        alike.setdefault(", ".join(texts), []).append(i)
    return tuple(
        f"joint{'s' if len(joints) > 1 else ''} {', '.join(map(str, joints))}: {text}"
        for text, joints in alike.items()
    )


def _rounded(value: float, way: int) -> float:
    """``value`` in a few digits, rounded up (``way`` 1) or down (-1)."""
    if not value or not math.isfinite(value):
        return value
    exponent = math.floor(math.log10(abs(value))) - _DIGITS + 1
    scaled = Fraction(value) / Fraction(10) ** exponent
    whole = math.ceil(scaled) if way > 0 else math.floor(scaled)
    return float(whole * Fraction(10) ** exponent)


def _percent(share: float) -> str:
    return f"{_rounded(100 * share, 1):.3g} %"
