"""The regressor, which torques are times the base parameters; and torques by those parameters."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.arm import Arm, Body, Symmetric
from robodyn.dynamics.functions.arguments import PI, QD, QDD, TAU, Array, Q
from robodyn.dynamics.functions.record import Function, Pair
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.regressor import torques_from, unit_torques
from robodyn.dynamics.regroup import lumps_of
from robodyn.dynamics.state import Dynamics, Vector
from robodyn.effects.scalars import quotient

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
    numbers = _standard(arm)
    parameters = [parameter.value(numbers) for parameter in at.base_set()]
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


def _from_parameters(at: Dynamics) -> Sequence[Any]:
    qd, qdd = at.inputs["qd"], at.inputs["qdd"]
    owns: list[tuple[str, int]] = [parameter.own for parameter in at.base_set()]
    numbers = dict(zip(owns, at.inputs["pi"], strict=True))
    return torques_from(at.arm, at.motion(qd, qdd), at.turns(qd, qdd), numbers, at.mark)


def _of_an_arm_with_them(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """The torques of an arm that has these base parameters, and of all else that its links have anything."""
    numbers = _standard(_with_masses(at.arm, x))
    parameters = at.base_set()
    for parameter in parameters:
        numbers[parameter.own] = 0
    rest = [parameter.value(numbers) for parameter in parameters]  # owns are in no other's terms
    for parameter, value, share in zip(parameters, at.inputs["pi"], rest, strict=True):
        numbers[parameter.own] = value - share
    bodies = tuple(_with_numbers(body, numbers, i) for i, body in enumerate(at.arm.bodies, 1))
    motion = at.motion(at.inputs["qd"], at.inputs["qdd"])
    return list(result), newton_euler(replace(at.arm, bodies=bodies), motion)


def _with_numbers(body: Body, numbers: Mapping[Standard, Any], link: int) -> Body:
    """``body`` with these moments of mass about its frame's origin, rotor and friction."""
    from robodyn.dynamics.base_parameter import DRIVE, MOMENTS, Standard

    m, x, y, z, *second = (numbers[Standard(quantity, link)] for quantity in MOMENTS)
    com = tuple(quotient(h, m) for h in (x, y, z))
    i = Lump(m, (x, y, z), Symmetric(*second)).inertia()
    cx, cy, cz = com
    central = Symmetric(
        i.xx - (y * cy + z * cz),
        i.yy - (x * cx + z * cz),
        i.zz - (x * cx + y * cy),
        i.xy + x * cy,
        i.xz + x * cz,
        i.yz + y * cz,
    )
    rotor, viscous, coulomb = (numbers[Standard(quantity, link)] for quantity in DRIVE)
    return replace(
        body, mass=m, com=com, inertia=central, motor_inertia=rotor, viscous=viscous, coulomb=coulomb
    )


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
