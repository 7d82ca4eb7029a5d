"""What of a robot's drives a system has: elements of dry friction, what conserves energy, what cannot be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.drives.drive import Acting, JointDrive, Layer
from robodyn.effects.scalars import is_zero
from robodyn.errors import InputError
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program
from robodyn.robot.model import Robot

#: Poses that no arm is singular in unless it is in all: angles whose sines are not alike [rad].
_POSES: Final = (0.3, 1.1, -0.7)
#: An eigenvalue of a mass matrix, as a share of its largest, that rounding makes of 0.
_SINGULAR: Final = 1e-14


@dataclass(frozen=True, slots=True)
class Element:
    """Something with dry friction: its velocity is ``row`` [coordinates] times those of the coordinates."""

    what: str
    row: tuple[Fraction, ...]


def elements_of(layer: Layer, coupled: Sequence[int], size: int) -> tuple[Element, ...]:
    n = len(layer.joints)

    def unit(k: int) -> tuple[Fraction, ...]:
        return tuple(Fraction(int(j == k)) for j in range(size))

    elements: list[Element] = []
    for i, drive in enumerate(layer.joints):
        at_link = _is_dry(drive, drive.link, drive.bearing)
        at_motor = _is_dry(drive, drive.gear, drive.motor) or not is_zero(drive.coulomb)
        if i in coupled:
            if at_link:
                elements.append(Element(f"link {i + 1}", unit(i)))
            if at_motor:
                elements.append(Element(f"motor {i + 1}", unit(n + list(coupled).index(i))))
        elif at_link or at_motor:
            elements.append(Element(f"joint {i + 1}", unit(i)))
    for k, pair in enumerate(layer.pairs, 1):
        if _is_dry(layer.joints[pair.one], (pair.acting,)):
            row = [Fraction(0)] * size
            for joint, x in ((pair.one, Fraction(1)), (pair.other, Fraction(pair.ratio))):
                row[n + list(coupled).index(joint) if joint in coupled else joint] = x
            elements.append(Element(f"pair {k}", tuple(row)))
    return tuple(elements)


def _is_dry(drive: JointDrive, *sides: Sequence[Acting]) -> bool:
    """Whether one of the effects of those sides holds what it acts on at rest."""
    return any(acting.effect.is_dry(acting.values, drive.revolute) for side in sides for acting in side)


def without_losses(layer: Layer) -> Layer:
    """What of the drives conserves energy: torques that have a potential, couplers undamped."""
    joints = []
    for drive in layer.joints:
        coupler = drive.coupler
        if coupler is not None:
            coupler = Acting(coupler.effect, {**coupler.values, "damping": 0})
        link, motor = (
            tuple(acting for acting in side if acting.effect.potential is not None)
            for side in (drive.link, drive.motor)
        )
        drive = replace(drive, link=link, bearing=(), gear=(), motor=motor, coupler=coupler)
        joints.append(replace(drive, viscous=0, coulomb=0))
    pairs = tuple(
        replace(pair, acting=Acting(pair.acting.effect, {**pair.acting.values, "viscous": 0, "coulomb": 0}))
        for pair in layer.pairs
    )
    return Layer(tuple(joints), pairs)


def check_shape(robot: Robot, layer: Layer) -> None:
    if robot.torque_side == "link":
        raise InputError(
            f"{robot.name} cannot be simulated: its torques act behind the gear",
            found="torque_side: link",
            remedy="describe the motors (torque_side: motor)",
        )
    for i, drive in enumerate(layer.joints, 1):
        if drive.coupler is not None and is_zero(drive.rotor):
            raise InputError(
                f"joint {i} of {robot.name} has {drive.coupler.effect.id} and a motor without inertia",
                expected="motor_inertia above 0 at that joint",
                remedy=f"give link {i} its motor_inertia",
            )


def check_inertia(robot: Robot, mass: Program, size: int) -> None:
    """Refuse an arm of which a coordinate moves without inertia in every pose.

    ``mass`` is the program of the mass matrix of ``size`` coordinates; run-time parameters are taken as 1.

    Raises
    ------
    InputError: there is such a coordinate; says at which joint.
    """
    largest = np.zeros(size)
    for pose in _POSES:
        values = {Input("y", i): pose * (i + 1) for i in range(size)}
        values |= {Input(name, None): 1.0 for name in robot.parameters}
        matrix = np.reshape(evaluate(mass, values)["M"], (size, size)).astype(float)
        sizes = abs(np.linalg.eigvalsh(matrix))
        if sizes.min() > _SINGULAR * sizes.max():
            return
        largest = np.maximum(largest, np.diagonal(matrix))
    raise without_inertia(robot.name, largest[: robot.n])


def without_inertia(robot: str, largest: NDArray[np.float64]) -> InputError:
    """The complaint about a mass matrix without inverse; ``largest`` [n] are its largest diagonal entries."""
    bare = [str(i) for i, m in enumerate(largest, 1) if not m > _SINGULAR * largest.max()]
    return InputError(
        f"{robot}: nothing resists the acceleration of "
        + (f"joint {', '.join(bare)}" if bare else "some joint together with others"),
        found="a mass matrix without an inverse",
        expected="links with mass and inertia, or motor_inertia, at every joint",
        remedy="complete the description: a motion cannot be simulated without",
    )
