"""Dynamics of an arm just as it is described, nothing chosen to save operations: references."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import Any

from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.dual import moving_along, slopes
from robodyn.dynamics.free_bodies import reactions
from robodyn.dynamics.limits import ROUNDING
from robodyn.dynamics.lump import NO_LUMP, MomentForm
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.parallel import Turns, single_turns
from robodyn.dynamics.regroup import lumps_of
from robodyn.dynamics.state import First, Moving, RigidDrives
from robodyn.dynamics.vectors import Vector, unmarked


class AsDescribed(RigidDrives, ABC):
    """Turns and masses of ``arm``; see :class:`robodyn.dynamics.functions.Dynamics`."""

    mark = staticmethod(unmarked)
    cheapest = First()
    rounding = ROUNDING["double"]
    arm: Arm
    inputs: Mapping[str, Sequence[Any]]

    @abstractmethod
    def motion(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Motion:
        """The arm at ``q``, with these rates and accelerations."""

    def turns(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Turns:
        """How its joints turn, each for itself."""
        return single_turns(self.motion(qd, qdd))

    def links(self, qd: Sequence[Any], qdd: Sequence[Any], form: MomentForm = "second_moment") -> Moving:
        """The same, as described."""
        motion = self.motion(qd, qdd)
        return Moving(self.arm, motion, single_turns(motion), lumps_of(self.arm), NO_LUMP)

    def reactions(
        self, qd: Sequence[Any], qdd: Sequence[Any], w: Sequence[Any]
    ) -> Sequence[tuple[Vector, Vector]]:
        """Force and moment in each joint, of free bodies."""
        return reactions(self.arm, self.motion(qd, qdd), w)

    def torque_derivatives(self, qdd: Sequence[Any]) -> None:
        """None: the rigid arm's derivatives are written out."""
        return

    def torque_slopes(self, qdd: Sequence[Any], dq: Sequence[Any], dqd: Sequence[Any]) -> list[Any]:
        """The plain recursion of the rigid arm, differentiated along ``dq, dqd`` by dual numbers."""
        motion = self.motion(self.inputs["qd"], qdd)
        return slopes(newton_euler(self.arm, moving_along(self.arm, motion, dq, dqd, [0] * len(dq))))
