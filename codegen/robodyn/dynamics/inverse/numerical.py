"""Inverse kinematics by iteration: of arms of no class, from a reference."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.functions.record import Dynamics, NoSuchFunction
from robodyn.dynamics.inverse.descent import Descent, State
from robodyn.dynamics.inverse.inverse import Inverse, inverse_of, size_of
from robodyn.dynamics.inverse.limits import EDGE, ITERATIONS
from robodyn.dynamics.inverse.screws import chain_of
from robodyn.dynamics.inverse.solution import Joint, Nearest, Solved, joints_of, nearest, places_only
from robodyn.dynamics.iterative import Iterative


@dataclass(frozen=True, slots=True)
class Numerical:
    """Inverse kinematics of an arm by damped least squares, see :mod:`~robodyn.dynamics.inverse.descent`.

    ``size``: about the arm's reach [m]. ``conditions``: why it is solved so. Its one solution is near the
    reference that it begins at.
    """

    joints: tuple[Joint, ...]
    size: Fraction
    conditions: tuple[str, ...]
    most: int = ITERATIONS

    branches = 1
    branch_names = ("numerical",)
    redundant = None

    @property
    def place_only(self) -> bool:
        """Whether only the place of the tool is solved for."""
        return places_only(self.joints)

    def approach(self, finish: Callable[[Dynamics, Solved], Sequence[Any]]) -> Iterative:
        """How a function of what was reached is approached."""

        def start(at: Dynamics) -> Sequence[Any]:
            return self._descent(at).start(at.inputs["q_near"]).flat()

        def step(at: Dynamics) -> Sequence[Any]:
            return self._descent(at).step(at, at.inputs["T"], State.of(at.inputs["x"])).flat()

        def results(at: Dynamics) -> Sequence[Any]:
            return finish(at, self._descent(at).finish([State.of(at.inputs["x"])]))

        return Iterative(start, step, results, self.most)

    def nearest(self, solved: Solved, q_near: Sequence[Any], unit: Fraction) -> Nearest:
        """What was reached, in the turns nearest to ``q_near`` [n]."""
        return nearest(solved, self.joints, q_near, EDGE * unit)

    def _descent(self, at: Dynamics) -> Descent:
        return Descent(self.joints, self.size, at.rounding)


def solver_of(arm: Arm) -> Inverse | Numerical:
    """The inverse kinematics of ``arm``, its numbers exact: in closed form where it is of a class that has
    one, else by iteration.

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
        # The sum of all offsets is about twice the reach: they are along three axes, and those at base and
        # tool are levers of nothing.
        size = size_of(chain_of(arm)) / 2
        return Numerical(joints_of(arm, limits), size, (none.found or none.what,))
