"""Inverse kinematics by iteration: of arms of no class from a reference, of arms that are nearly of a class
from its branches."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.inverse.descent import Descent, State
from robodyn.dynamics.inverse.inverse import Inverse, inverse_of, size_of
from robodyn.dynamics.inverse.limits import ASIDE, BEGUN, EDGE, ITERATIONS, REFINEMENTS
from robodyn.dynamics.inverse.nearly import idealised
from robodyn.dynamics.inverse.rank import has_full_rank, moves_all_ways
from robodyn.dynamics.inverse.screws import as_floats, chain_of
from robodyn.dynamics.inverse.solution import Joint, Nearest, Solved, joints_of, nearest, places_only
from robodyn.dynamics.state import Dynamics, Iterative, NoSuchFunction

_WEAK = (
    "there is a direction in which its joints move the tool only because axes do not meet, or are not "
    "parallel: few poses are within reach, and those only from a reference very near them"
)


@dataclass(frozen=True, slots=True)
class Numerical:
    """Inverse kinematics of an arm by damped least squares, see :mod:`~robodyn.dynamics.inverse.descent`.

    ``size``: about the arm's reach [m]. ``conditions``: why it is solved so. ``begins``: the inverse
    kinematics of a similar arm, at whose branches it begins; None: it has one solution, near the reference
    that it begins at, within the joints' limits. ``most``: iterations at most, from each beginning.
    ``weak``: whether the joints move the tool in some direction only because axes miss where they have to
    meet or be parallel: then steps lead to a pose from a reference only that is very near.
    """

    joints: tuple[Joint, ...]
    size: Fraction
    conditions: tuple[str, ...]
    begins: Inverse | None = None
    most: int = ITERATIONS
    weak: bool = False

    @property
    def branch_names(self) -> tuple[str, ...]:
        """Names of the solutions."""
        return ("numerical",) if self.begins is None else self.begins.branch_names

    @property
    def branches(self) -> int:
        """How many solutions there are at most."""
        return len(self.branch_names)

    @property
    def redundant(self) -> int | None:
        """The joint (from 0) that takes its position from the reference."""
        return None if self.begins is None else self.begins.redundant

    @property
    def place_only(self) -> bool:
        """Whether only the place of the tool is solved for."""
        return places_only(self.joints)

    @property
    def alone(self) -> bool:
        """Whether there is but one solution, from the reference."""
        return self.begins is None

    def approach(self, finish: Callable[[Dynamics, Solved], Sequence[Any]]) -> Iterative:
        """How a function of what was reached is approached."""

        def start(at: Dynamics) -> Sequence[Any]:
            q_near, descent = at.inputs["q_near"], self._descent(at)
            if self.begins is None:
                return descent.start(q_near).flat()
            starts = self._starts(self.begins, at.inputs["T"], q_near, at.rounding)
            return [x for q in starts for x in descent.start(q, within=BEGUN).flat()]

        def step(at: Dynamics) -> Sequence[Any]:
            return self._descent(at).step(at, at.inputs["T"], State.of(at.inputs["x"])).flat()

        def results(at: Dynamics) -> Sequence[Any]:
            x = at.inputs["x"]
            size = len(x) // self.branches
            states = [State.of(x[k : k + size]) for k in range(0, len(x), size)]
            return finish(at, self._descent(at).finish(states, self.joints))

        return Iterative(start, step, results, self.most, self.branches)

    def nearest(self, solved: Solved, q_near: Sequence[Any], unit: Fraction) -> Nearest:
        """Of what was reached the nearest to ``q_near`` [n]."""
        return nearest(solved, self.joints, q_near, EDGE * unit)

    def _starts(
        self, begins: Inverse, T: Sequence[Any], q_near: Sequence[Any], unit: Fraction
    ) -> Iterator[list[Any]]:
        """Where each branch begins; a little aside where it meets another: no step leads away from there."""
        begun = begins.solve(T, q_near, unit)
        for q, singular, signs in zip(begun.solutions, begun.singular, begins.signs, strict=True):
            aside = list(q)
            for k, sign in signs:
                length = 1 if self.joints[k].revolute else self.size
                aside[k] = q[k] + sign * ASIDE * length * singular
            yield aside

    def _descent(self, at: Dynamics) -> Descent:
        if self.begins is None:
            return Descent(self.joints, self.size, at.rounding)
        # Branches are those of the arm without limits, which only say whether each is within them.
        free = tuple(replace(joint, limits=None) for joint in self.joints)
        locked = frozenset(() if self.redundant is None else (self.redundant,))
        return Descent(free, self.size, at.rounding, locked)


def solver_of(arm: Arm) -> Inverse | Numerical:
    """The inverse kinematics of ``arm``, its numbers exact: in closed form where it is of a class that has
    one, else by iteration, from the branches of such an arm where it is nearly one.

    Raises
    ------
    NoSuchFunction: a length is a run-time parameter.
    """
    limits = [body.limits for body in arm.bodies]
    try:
        return inverse_of(arm, limits)
    except NoSuchFunction as none:
        if not all(isinstance(x, (int, Fraction)) for body in arm.bodies for x in (body.a, body.b, body.d)):
            raise
        reason = none.found or none.what
    chain, joints = chain_of(arm), joints_of(arm, limits)
    whole = size_of(chain)
    # The sum of all offsets is about twice the reach: they are along three axes, and those at base and tool
    # are levers of nothing.
    size = whole / 2
    similar, neglected = idealised(chain, whole)
    try:
        begins = inverse_of(arm, limits, similar)
    except NoSuchFunction:
        if has_full_rank(as_floats(chain, whole)) and not moves_all_ways(as_floats(similar, whole)):
            return Numerical(joints, size, (reason, _WEAK, *neglected), weak=True)
        return Numerical(joints, size, (reason,))
    return Numerical(joints, size, (*begins.conditions, *neglected), begins, REFINEMENTS)
