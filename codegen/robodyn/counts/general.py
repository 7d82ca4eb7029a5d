"""What a formulation costs for an arm of n joints of which nothing is special: the general count.

The recursion runs on tallies, scalars without a value that count each ``*``, ``/``, ``+`` and ``-``. The
convention, that of Luh, Walker and Paul 1980 and Hollerbach 1980 as far as their texts tell:

* every length, angle, mass, centre of mass and entry of an inertia tensor is some number, none is zero;
* what depends on the model alone is formed beforehand and free, ``m r`` for instance or a pseudo-inertia
  about the frame's origin; so are sines and cosines, and changes of sign;
* operations with the 0s and 1s that the formulation itself writes (a base at rest, a unit vector) are free,
  any other number is a constant of the model: ``2 * x`` is a multiplication;
* ``dense=True`` forgets of whatever the formulation marks that it is 0, 1 or constant, the last row
  ``0 0 0 1`` of a 4x4 transform for instance: then a product of two of them is 64 multiplications and 48
  additions, as the tables of 1980 count it;
* no rotor, no friction.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from fractions import Fraction
from typing import Any

from robodyn.counts.count import Count
from robodyn.dynamics.arm import Arm, Body, Motion, Symmetric
from robodyn.dynamics.vectors import Mark, unmarked
from robodyn.ir.program import Label
from robodyn.robot.values import quarter_turns

#: Inverse dynamics over any scalar: an arm, its motion and a mark to the joint torques.
Formulation = Callable[[Arm, Motion, Mark], list[Any]]
Plain = int | Fraction


class Tally:
    """A number that is not known, and a note of every operation on it in ``ledger``.

    ``fixed``: it depends on the model alone; operations among such are free.
    """

    __slots__ = ("fixed", "ledger")

    def __init__(self, ledger: dict[str, int], fixed: bool = False) -> None:
        self.ledger, self.fixed = ledger, fixed

    def _with(self, other: Tally | Plain, kind: str) -> Tally:
        fixed = self.fixed and (other.fixed if isinstance(other, Tally) else True)
        if not fixed:
            self.ledger[kind] = self.ledger.get(kind, 0) + 1
        return Tally(self.ledger, fixed)

    def __neg__(self) -> Tally:
        return self

    __abs__ = __neg__

    def __add__(self, other: Tally | Plain) -> Tally:
        return self if _is(other, 0) else self._with(other, "add")

    __radd__ = __sub__ = __rsub__ = __add__

    def __mul__(self, other: Tally | Plain) -> Tally | int:
        if _is(other, 0):
            return 0
        return self if _is(other, 1) or _is(other, -1) else self._with(other, "mul")

    __rmul__ = __mul__

    def __truediv__(self, other: Tally | Plain) -> Tally:
        return self._with(other, "div" if isinstance(other, Tally) else "mul")

    def __rtruediv__(self, other: Plain) -> Tally | int:
        return 0 if _is(other, 0) else self._with(other, "div")

    def sqrt(self) -> Tally:
        """Its square root."""
        return self._with(1, "sqrt")


def _is(x: Tally | Plain, value: int) -> bool:
    return not isinstance(x, Tally) and x == value


def general_count(
    formulation: Formulation, n: int, prismatic: Collection[int] = (), *, dense: bool = False
) -> Count:
    """Operations of ``formulation`` for any arm of ``n`` joints, those numbered (from 1) in ``prismatic``
    prismatic and the rest revolute; ``dense`` as the module says."""
    ledger: dict[str, int] = {}
    arm, motion = general_arm(n, prismatic, lambda fixed: Tally(ledger, fixed))

    def filled(value: Any, label: Label) -> Any:
        return Tally(ledger)

    formulation(arm, motion, filled if dense else unmarked)
    return Count(**ledger)


def general_arm(n: int, prismatic: Collection[int], constant: Callable[[bool], Any]) -> tuple[Arm, Motion]:
    """An arm of which nothing is special and its motion: ``number(True)`` makes a number of the model,
    ``number(False)`` one of the state."""

    def some(count: int, fixed: bool = True) -> tuple[Any, ...]:
        return tuple(constant(fixed) for _ in range(count))

    def triple() -> tuple[Any, Any, Any]:
        return constant(True), constant(True), constant(True)

    def body(revolute: bool) -> Body:
        cos_alpha, sin_alpha, a, d, mass = some(5)
        return Body(
            revolute, cos_alpha, sin_alpha, a, d, quarter_turns(0),
            mass, triple(), Symmetric(*some(6)), motor_inertia=0, viscous=0, coulomb=0,
        )  # fmt: skip

    bodies = tuple(body(i + 1 not in prismatic) for i in range(n))
    motion = Motion(
        c=tuple(constant(not body.revolute) for body in bodies),
        s=tuple(constant(not body.revolute) for body in bodies),
        d=tuple(constant(body.revolute) for body in bodies),
        qd=some(n, fixed=False),
        qdd=some(n, fixed=False),
    )
    return Arm(bodies, triple(), rest_velocity=None), motion
