"""Dynamics that rest on others: all that they do not say themselves, those say."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.lump import MomentForm
from robodyn.dynamics.parallel import Turns
from robodyn.dynamics.state import Dynamics, Moving, RigidDrives, Rotor

if TYPE_CHECKING:
    from robodyn.dynamics.base_parameter import BaseParameter


class Upon(RigidDrives):
    """What the dynamics ``beneath`` say of places, motion and masses; see
    :class:`robodyn.dynamics.functions.Dynamics`."""

    def __init__(self, beneath: Dynamics) -> None:
        self._beneath, self.cheapest = beneath, beneath.cheapest

    @property
    def arm(self) -> Arm:
        """The links as they are described."""
        return self._beneath.arm

    @property
    def rounding(self) -> Fraction:
        """The rounding unit that programs are for."""
        return self._beneath.rounding

    def motion(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Motion:
        """The arm at ``q``, with these rates and accelerations."""
        return self._beneath.motion(qd, qdd)

    def turns(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Turns:
        """How its joints turn."""
        return self._beneath.turns(qd, qdd)

    def links(self, qd: Sequence[Any], qdd: Sequence[Any], form: MomentForm = "second_moment") -> Moving:
        """The same, with the links' masses."""
        return self._beneath.links(qd, qdd, form)

    def base_set(self) -> Sequence[BaseParameter]:
        """The base parameters."""
        return self._beneath.base_set()

    def rotors(self) -> Sequence[Rotor]:
        """The rotors."""
        return self._beneath.rotors()

    def reactions(
        self, qd: Sequence[Any], qdd: Sequence[Any], w: Sequence[Any]
    ) -> Sequence[tuple[Sequence[Any], Sequence[Any]]]:
        """Force and moment in each joint."""
        return self._beneath.reactions(qd, qdd, w)

    def inertial_torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Sequence[Any]:
        """Joint torques [n] without gravity and what drives do besides."""
        return self._beneath.inertial_torques(qd, qdd)
