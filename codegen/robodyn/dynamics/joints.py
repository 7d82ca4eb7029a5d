"""What a joint adds to the torque of its link: rotor inertia and friction."""

from __future__ import annotations

import math
from typing import Any

from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.vectors import Mark
from robodyn.ir.graph import Node
from robodyn.ir.program import Label


def smoothed_sign(velocity: Any, rest_velocity: Any | None) -> Any:
    """sgn(velocity) with sgn 0 = 0, or tanh(velocity / rest_velocity)."""
    if rest_velocity is None:
        if hasattr(velocity, "graph"):
            return velocity.graph.sign(velocity)
        if hasattr(velocity, "free_symbols"):
            import sympy

            return sympy.sign(velocity)
        return (velocity > 0) - (velocity < 0)
    ratio = velocity / rest_velocity
    if hasattr(ratio, "graph"):
        return ratio.graph.tanh(ratio)
    if hasattr(ratio, "free_symbols"):
        import sympy

        return sympy.tanh(ratio)
    return math.tanh(ratio)


def joint_torque(arm: Arm, i: int, motion: Motion, torque: Any, mark: Mark) -> Any:
    """Torque [N m or N] of joint ``i`` (from 0): ``torque`` of the links, rotor and friction added."""
    body = arm.bodies[i]
    qd, qdd = motion.qd[i], motion.qdd[i]
    total = torque
    if not is_zero(body.motor_inertia):
        # The reflected rotor turns with its own joint only: N^2 J on the diagonal, not in Izz.
        total = total + body.motor_inertia * qdd
    if not is_zero(qd):
        if not is_zero(body.viscous):
            total = total + body.viscous * qd
        if not is_zero(body.coulomb):
            total = total + body.coulomb * smoothed_sign(qd, arm.rest_velocity)
    return mark(total, Label(i + 1, "tau", ""))


def is_zero(value: Any) -> bool:
    """Whether ``value`` is the number zero (a node or an expression is not)."""
    return not isinstance(value, Node) and bool(value == 0)
