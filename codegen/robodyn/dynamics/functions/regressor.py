"""The regressor: torques are it times the base parameters."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.arm import Arm, Body, Symmetric
from robodyn.dynamics.functions.record import QD, QDD, Array, Dynamics, Function, Pair, Q, Vector
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.regressor import unit_torques
from robodyn.dynamics.regroup import lumps_of

if TYPE_CHECKING:
    from robodyn.dynamics.base_parameter import Standard

Y = Array("Y", "torques by base parameters, a column each", "SI units", shape=("n", "p"))


def _columns(at: Dynamics) -> Sequence[Any]:
    qd, qdd = at.inputs["qd"], at.inputs["qdd"]
    columns = [parameter.own for parameter in at.base_set()]
    rows = unit_torques(at.arm, at.motion(qd, qdd), at.turns(qd, qdd), columns, at.mark)
    return [x for row in rows for x in row]


def _of_any_masses(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """The regressor times the base parameters of an arm that moves like this one and has any masses, rotors
    and friction, beside the torques of that arm."""
    arm = _with_masses(at.arm, x)
    parameters = [parameter.value(_standard(arm)) for parameter in at.base_set()]
    p = len(parameters)
    rows = [result[k : k + p] for k in range(0, len(result), p)]
    torques = [sum(y * value for y, value in zip(row, parameters, strict=True)) for row in rows]
    return torques, newton_euler(arm, at.motion(at.inputs["qd"], at.inputs["qdd"]))


def _with_masses(arm: Arm, x: Vector) -> Arm:
    """``arm`` with other masses, rotors and friction, which nothing connects but ``x``."""
    drawn = _drawn(x)
    bodies: list[Body] = []
    for body in arm.bodies:
        mass, com = 1 + len(bodies), (drawn(), drawn(), drawn())
        body = replace(body, mass=mass, com=com, inertia=Symmetric(*(drawn() for _ in range(6))))
        if arm.motors:
            body = replace(body, motor_inertia=drawn(), viscous=drawn(), coulomb=drawn())
        bodies.append(body)
    return replace(arm, bodies=tuple(bodies))


def _drawn(x: Vector) -> Callable[[], Any]:
    """Sums of ``x`` whose factors are the digits of one number after another; small, as arms are."""
    state = [1]

    def drawn() -> Any:
        state[0] = state[0] * 75 % 65537  # Lehmer's generator, as in the ZX Spectrum
        return sum(((state[0] >> 3 * (k % 5)) % 8 + 1) * value for k, value in enumerate(x)) / 512

    return drawn


def _standard(arm: Arm) -> dict[Standard, Any]:
    """The numbers of the links of ``arm`` by name."""
    from robodyn.dynamics.base_parameter import numbers_of

    return numbers_of(arm, lumps_of(arm))


FUNCTIONS = (
    Function(
        "regressor",
        "torques by base parameters: inverse dynamics is Y times them",
        (Q, QD, QDD),
        (Y,),
        _columns,
        condition=_of_any_masses,
        rigid=True,
    ),
)
