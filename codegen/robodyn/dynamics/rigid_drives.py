"""Drives that do not feel what the arm asks of them."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from typing import Any


class RigidDrives:
    """Dynamics without friction that depends on loads; see :class:`robodyn.dynamics.functions.Dynamics`."""

    @abstractmethod
    def torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Sequence[Any]:
        """Joint torques [n]."""

    def torques_under_wrench(
        self, qd: Sequence[Any], qdd: Sequence[Any], wrench_torques: Sequence[Any]
    ) -> Sequence[Any]:
        """Joint torques [n] less those that the wrench gives."""
        return [tau - push for tau, push in zip(self.torques(qd, qdd), wrench_torques, strict=True)]
