"""What motors and bearings bear of the torques: in front of the gears, as current, and as force and moment.

The torques of :mod:`.standard` are those of the motors, reflected to the joints: rotors, friction and losses
of the gears are in them. Force and moment in a joint are what its bearings and housings bear, and what
friction under load depends on.

Source: Dhanaraj 1990, equations 3.8 to 3.10; Table 2.4, steps 7 and 8 (f_i, n_i), which its Eqs 3.1 to 3.5
start from.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.functions.record import QD, QDD, WITH_WRENCH, WRENCH, Array, Function, Q
from robodyn.dynamics.state import Dynamics, NoSuchFunction, Vector
from robodyn.dynamics.vectors import flat
from robodyn.effects.scalars import quotient

TAU_MOTOR = Array("tau_motor", "motor torques in front of the gears", "N m")
CURRENT = Array("current", "motor currents", "A")
R = Array(
    "R",
    "force and moment of the link before on each link, about the origin and along the axes of its frame",
    "N, N m",
    shape=("l", 6),
)


def _in_front_of_the_gears(at: Dynamics) -> Sequence[Any]:
    """``tau / ratio``."""
    return _divided(at, [body.ratio for body in at.driven()], "gear", "gear: {ratio: ...}")


def _currents(at: Dynamics) -> Sequence[Any]:
    """``tau / (ratio torque_constant)``."""
    per_ampere = [
        None if body.torque_constant is None else body.ratio * body.torque_constant for body in at.driven()
    ]
    return _divided(at, per_ampere, "torque constant", "gear: {ratio: ..., torque_constant: ...}")


def _divided(at: Dynamics, divisors: Vector, what: str, key: str) -> Sequence[Any]:
    missing = [str(i) for i, divisor in enumerate(divisors, 1) if divisor is None]
    if missing:
        raise NoSuchFunction(
            "nothing is known of the motors",
            found=f"no {what} at joint {', '.join(missing)}",
            expected=f"{key} at every joint, and torque_side: motor",
            remedy="state them in the description, or leave the function out",
        )
    torques = at.torques(at.inputs["qd"], at.inputs["qdd"])
    return [quotient(tau, divisor) for tau, divisor in zip(torques, divisors, strict=True)]


def _reactions(at: Dynamics, w: Vector = (0, 0, 0, 0, 0, 0)) -> Sequence[Any]:
    return flat(flat(at.reactions(at.inputs["qd"], at.inputs["qdd"], w)))


def _reactions_under_wrench(at: Dynamics) -> Sequence[Any]:
    return _reactions(at, at.inputs["w"])


_PURPOSE = "force and moment that each joint passes on to its link"

FUNCTIONS = (
    Function(
        "motor_torque",
        "torques of the motors in front of their gears",
        (Q, QD, QDD),
        (TAU_MOTOR,),
        _in_front_of_the_gears,
        in_coordinates=_in_front_of_the_gears,
        expected=_in_front_of_the_gears,
    ),
    Function(
        "motor_current",
        "currents of the motors",
        (Q, QD, QDD),
        (CURRENT,),
        _currents,
        in_coordinates=_currents,
        expected=_currents,
    ),
    Function(
        "joint_reactions",
        _PURPOSE,
        (Q, QD, QDD),
        (R,),
        _reactions,
        expected=_reactions,
        drives=False,
    ),
    Function(
        "joint_reactions" + WITH_WRENCH,
        f"{_PURPOSE}, while a wrench pushes the tool",
        (Q, QD, QDD, WRENCH),
        (R,),
        _reactions_under_wrench,
        expected=_reactions_under_wrench,
        drives=False,
    ),
)
