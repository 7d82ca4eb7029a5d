"""References of arms whose joints follow others: those of the joints, each moving by itself, at
``q = G u + o``, and their torques mapped by ``G^T``.

``G`` is worked out here, by putting what joints follow in their place again and again, and in arrays: nothing
of it is shared with what kernels are made by. With Fractions it is exact.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from robodyn.robot.coupling import as_turned
from robodyn.robot.model import Robot
from robodyn.verify.numbers import Parameters

Numbers = NDArray[Any]
#: An :class:`robodyn.verify.oracles.Oracle`.
Reference = TypeVar("Reference")


@dataclass(frozen=True, slots=True)
class Following:
    """``G`` [n, m] and ``o`` [n], floats or Fractions."""

    G: NDArray[Any]
    o: NDArray[Any]

    @classmethod
    def of(cls, robot: Robot, *, exact: bool = False) -> Following:
        """Those of ``robot``; without couplings every joint is a coordinate."""
        n, zero = robot.n, Fraction(0)
        along, start = np.full((n, n), zero, object), np.full(n, zero, object)
        own = np.full((n, len(robot.commanded)), zero, object)
        for k, joint in enumerate(robot.commanded):
            own[joint, k] = Fraction(1)
        for coupling in robot.couplings:
            along[coupling.joint - 1, coupling.of - 1] += coupling.ratio
            start[coupling.joint - 1] += coupling.offset
        G, o = own, start
        for _ in range(n):  # no chain of followers is longer
            G, o = own + along @ G, start + along @ o
        for i, link in enumerate(robot.links):
            if link.joint.kind == "revolute":
                o[i] = as_turned(o[i])
        return cls(G, o) if exact else cls(G.astype(np.float64), o.astype(np.float64))

    def joints(self, u: Numbers) -> Numbers:
        """Positions ``[N, n]`` of the joints at ``u`` ``[N, m]``."""
        return np.asarray(self.spread(u) + self.o)

    def spread(self, rates: Numbers) -> Numbers:
        """Rates ``[N, n]`` of the joints; or directions that positions are moved along."""
        if self.G.dtype == object:  # floats are Fractions, without rounding
            rates = np.array([Fraction(x) for x in rates.ravel().tolist()], object).reshape(rates.shape)
        return np.asarray(rates @ self.G.T)

    def folded(self, torques: Numbers) -> Numbers:
        """Torques ``[N, m]`` of torques ``[N, n]`` of the joints."""
        return np.asarray(torques @ self.G)


def in_coordinates(
    make: Callable[[Robot, Parameters], Reference], robot: Robot, parameters: Parameters
) -> Reference:
    """The reference that ``make`` makes of a robot whose joints move by themselves, of ``robot``."""
    beneath: Any = make(robot.free, parameters)
    at = Following.of(robot, exact=beneath.exact)
    matrix, pushed, slope, reactions = (
        getattr(beneath, name) for name in ("matrix", "under_wrench", "slope", "reactions")
    )

    def moved(q: Numbers, qd: Numbers, qdd: Numbers) -> tuple[Numbers, Numbers, Numbers]:
        return at.joints(q), at.spread(qd), at.spread(qdd)

    def slopes(q: Numbers, qd: Numbers, qdd: Numbers, dq: Numbers, dqd: Numbers) -> Numbers:
        return at.folded(slope(*moved(q, qd, qdd), at.spread(dq), at.spread(dqd)))

    reference: Reference = replace(
        beneath,
        robot=robot,
        torque=lambda q, qd, qdd: at.folded(beneath.torque(*moved(q, qd, qdd))),
        matrix=matrix and (lambda q: at.G.T @ matrix(at.joints(q)) @ at.G),
        under_wrench=pushed and (lambda q, qd, qdd, w: at.folded(pushed(*moved(q, qd, qdd), w))),
        slope=slope and slopes,
        reactions=reactions and (lambda q, qd, qdd, w: reactions(*moved(q, qd, qdd), w)),
        other=beneath.other and (lambda other, values: in_coordinates(make, other, values)),
    )
    return reference
