"""What of a robot's drives a system has: elements of dry friction, what conserves energy, what cannot be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from robodyn.drives.drive import Acting, Layer
from robodyn.effects.scalars import is_zero
from robodyn.errors import InputError
from robodyn.robot.model import Robot

#: Effects whose torque changes sign with the velocity and is there at the slowest motion.
_DRY = ("coulomb_friction", "asymmetric_friction", "stribeck_friction")


@dataclass(frozen=True, slots=True)
class Element:
    """Something with dry friction: its velocity is ``row`` [coordinates] times those of the coordinates."""

    what: str
    row: tuple[Fraction, ...]


def elements_of(layer: Layer, coupled: Sequence[int], size: int) -> tuple[Element, ...]:
    n = len(layer.joints)

    def unit(k: int) -> tuple[Fraction, ...]:
        return tuple(Fraction(int(j == k)) for j in range(size))

    found: list[Element] = []
    for i, drive in enumerate(layer.joints):
        dry = any(acting.effect.id in _DRY for acting in drive.motor) or not is_zero(drive.coulomb)
        at_motor, at_link = bool(drive.gear) or dry, bool(drive.bearing)
        if i in coupled:
            if at_link:
                found.append(Element(f"link {i + 1}", unit(i)))
            if at_motor:
                found.append(Element(f"motor {i + 1}", unit(n + list(coupled).index(i))))
        elif at_link or at_motor:
            found.append(Element(f"joint {i + 1}", unit(i)))
    for k, pair in enumerate(layer.pairs, 1):
        if not is_zero(pair.acting.values["coulomb"]):
            row = [Fraction(0)] * size
            for joint, x in ((pair.one, Fraction(1)), (pair.other, Fraction(pair.ratio))):
                row[n + list(coupled).index(joint) if joint in coupled else joint] = x
            found.append(Element(f"pair {k}", tuple(row)))
    return tuple(found)


def without_losses(layer: Layer) -> Layer:
    """What of the drives conserves energy: springs, ripple (a wave over position), couplers undamped."""
    joints = []
    for drive in layer.joints:
        coupler = drive.coupler
        if coupler is not None:
            coupler = Acting(coupler.effect, {**coupler.values, "damping": 0})
        kept = tuple(acting for acting in drive.motor if acting.effect.id == "torque_ripple")
        joints.append(replace(drive, bearing=(), gear=(), motor=kept, viscous=0, coulomb=0, coupler=coupler))
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
