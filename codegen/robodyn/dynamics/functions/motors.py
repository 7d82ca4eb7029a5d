"""What the motors see of the torques: in front of the gears, and as current.

The torques of :mod:`.standard` are those of the motors, reflected to the joints: rotors, friction and losses
of the gears are in them. Source: Dhanaraj 1990, equations 3.8 to 3.10.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from robodyn.dynamics.functions.arguments import QD, QDD, Array, Q
from robodyn.dynamics.functions.record import Function
from robodyn.dynamics.state import Dynamics, NoSuchFunction

TAU_MOTOR = Array("tau_motor", "motor torques in front of the gears", "N m")
CURRENT = Array("current", "motor currents", "A")


def _in_front_of_the_gears(at: Dynamics) -> Sequence[Any]:
    """``tau / ratio``."""
    ratios = [body.ratio for body in at.arm.bodies]
    _check("gear", ratios, "gear: {ratio: ...}")
    return [tau * (Fraction(1) / ratio) for tau, ratio in zip(_torques(at), ratios, strict=True)]


def _currents(at: Dynamics) -> Sequence[Any]:
    """``tau / (ratio torque_constant)``."""
    constants = [body.torque_constant for body in at.arm.bodies]
    _check("torque constant", constants, "gear: {ratio: ..., torque_constant: ...}")
    per_ampere = [body.ratio * body.torque_constant for body in at.arm.bodies]
    return [tau * (Fraction(1) / torque) for tau, torque in zip(_torques(at), per_ampere, strict=True)]


def _torques(at: Dynamics) -> Sequence[Any]:
    return at.torques(at.inputs["qd"], at.inputs["qdd"])


def _check(what: str, numbers: Sequence[Any], key: str) -> None:
    missing = [str(i) for i, value in enumerate(numbers, 1) if value is None]
    if missing:
        raise NoSuchFunction(
            "nothing is known of the motors",
            found=f"no {what} at joint {', '.join(missing)}",
            expected=f"{key} at every joint, and torque_side: motor",
            remedy="state them in the description, or leave the function out",
        )


FUNCTIONS = (
    Function(
        "motor_torque",
        "torques of the motors in front of their gears",
        (Q, QD, QDD),
        (TAU_MOTOR,),
        _in_front_of_the_gears,
        expected=_in_front_of_the_gears,
    ),
    Function(
        "motor_current",
        "currents of the motors",
        (Q, QD, QDD),
        (CURRENT,),
        _currents,
        expected=_currents,
    ),
)
