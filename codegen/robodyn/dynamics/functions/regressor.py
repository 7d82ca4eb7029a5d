"""The regressor, which torques are times the base parameters; and torques by those parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.arm import Arm, Body, Symmetric
from robodyn.dynamics.functions.record import PI, QD, QDD, TAU, Array, Function, Pair, Q
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.regroup import lumps_of, shifted
from robodyn.dynamics.state import Dynamics, Posture, Vector
from robodyn.dynamics.vectors import flat, products
from robodyn.effects.scalars import quotient

if TYPE_CHECKING:
    from robodyn.dynamics.base_set import Standard

Y = Array("Y", "torques by base parameters, a column each", "SI units", shape=("n", "p"))


def _columns(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.regressor import unit_torques

    qd, qdd = at.inputs["qd"], at.inputs["qdd"]
    columns = [parameter.own for parameter in at.base_set()]
    posture = Posture(at.arm, at.motion(qd, qdd), at.turns(qd, qdd))
    return flat(unit_torques(posture, columns, at.mark))


def _of_any_masses(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """The regressor times the base parameters of an arm that moves like this one and has any masses, rotors
    and friction, beside the torques of that arm."""
    arm = _with_masses(at.arm, x)
    numbers = _numbers_of(arm)
    parameters = [parameter.value(numbers) for parameter in at.base_set()]
    motion = at.motion(at.inputs["qd"], at.inputs["qdd"])
    return products(result, parameters), at.folded(newton_euler(arm, motion))


def _with_masses(arm: Arm, x: Vector) -> Arm:
    """``arm`` with other masses, rotors and friction, which nothing connects but ``x``: sums of it whose
    factors are the digits of one number after another; small, as arms are."""
    state = 1

    def drawn() -> Any:
        nonlocal state
        state = state * 75 % 65537  # Lehmer's generator, as in the ZX Spectrum
        return sum(((state >> 3 * (k % 5)) % 8 + 1) * value for k, value in enumerate(x)) / 512

    bodies: list[Body] = []
    for body in arm.bodies:
        mass, com = 1 + len(bodies), (drawn(), drawn(), drawn())
        body = replace(body, mass=mass, com=com, inertia=Symmetric(*(drawn() for _ in range(6))))
        if arm.motors:
            body = replace(body, motor_inertia=drawn(), viscous=drawn(), coulomb=drawn())
        bodies.append(body)
    return replace(arm, bodies=tuple(bodies))


def _numbers_of(arm: Arm) -> dict[Standard, Any]:
    """The numbers of the links of ``arm`` by name."""
    from robodyn.dynamics.base_set import numbers_of

    return numbers_of(arm, lumps_of(arm))


def _from_parameters(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.regressor import torques_from

    qd, qdd = at.inputs["qd"], at.inputs["qdd"]
    owns: list[tuple[str, int]] = [parameter.own for parameter in at.base_set()]
    numbers = dict(zip(owns, at.inputs["pi"], strict=True))
    return torques_from(Posture(at.arm, at.motion(qd, qdd), at.turns(qd, qdd)), numbers, at.mark)


def _of_an_arm_with_them(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """The torques of an arm that has these base parameters, and of all else that its links have anything."""
    numbers = _numbers_of(_with_masses(at.arm, x))
    parameters = at.base_set()
    for parameter in parameters:
        numbers[parameter.own] = 0
    rest = [parameter.value(numbers) for parameter in parameters]  # owns are in no other's terms
    for parameter, value, share in zip(parameters, at.inputs["pi"], rest, strict=True):
        numbers[parameter.own] = value - share
    bodies = tuple(_with_numbers(body, numbers, i) for i, body in enumerate(at.arm.bodies, 1))
    motion = at.motion(at.inputs["qd"], at.inputs["qdd"])
    return list(result), at.folded(newton_euler(replace(at.arm, bodies=bodies), motion))


def _with_numbers(body: Body, numbers: Mapping[Standard, Any], link: int) -> Body:
    """``body`` with these moments of mass about its frame's origin, rotor and friction."""
    from robodyn.dynamics.base_set import DRIVE, MOMENTS, Standard

    m, x, y, z, *second = (numbers[Standard(quantity, link)] for quantity in MOMENTS)
    com = cx, cy, cz = quotient(x, m), quotient(y, m), quotient(z, m)
    moved = shifted(Lump(m, (x, y, z), Symmetric(*second)), (-cx, -cy, -cz))
    rotor, viscous, coulomb = (numbers[Standard(quantity, link)] for quantity in DRIVE)
    return replace(
        body,
        mass=m,
        com=com,
        inertia=moved.inertia(),
        motor_inertia=rotor,
        viscous=viscous,
        coulomb=coulomb,
    )


FUNCTIONS = (
    Function(
        "regressor",
        "torques by base parameters: inverse dynamics is Y times them",
        (Q, QD, QDD),
        (Y,),
        _columns,
        condition=_of_any_masses,
    ),
    Function(
        "inverse_dynamics_from_parameters",
        "torques by base parameters that are an input",
        (Q, QD, QDD, PI),
        (TAU,),
        _from_parameters,
        condition=_of_an_arm_with_them,
    ),
)
