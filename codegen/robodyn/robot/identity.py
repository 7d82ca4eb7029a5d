"""What makes two robots the same to the dynamics: their numbers, exactly, and nothing else."""

from __future__ import annotations

import hashlib
from fractions import Fraction
from typing import Any

from robodyn.robot.model import EffectEntry, Inertia, Joint, Link, Robot, Setting
from robodyn.robot.values import Affine, Angle, Value


def identity(robot: Robot) -> str:
    """A hash of all that the kernels of ``robot`` depend on: not its name, its texts or its limits.

    Robots of one identity have the same programs; only the names of the emitted symbols differ.
    """
    lines = ["robodyn robot 1", "gravity " + " ".join(map(str, robot.base_gravity))]
    lines += [f"torque {robot.torque_side}", f"rest {robot.rest_velocity}", *map(_link, robot.links)]
    if robot.dead_band is not None:
        lines.append(f"dead band {robot.dead_band}")
    lines += [_effect(entry) for entry in robot.effects]
    lines += [f"coupling {x.joint} {x.of} {x.ratio} {x.offset}" for x in robot.couplings]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:32]


def _effect(entry: EffectEntry) -> str:
    settings = " ".join(f"{name}={_setting(setting)}" for name, setting in entry.settings)
    return f"effect {entry.effect} {entry.joint} {settings}"


def _setting(setting: Setting | tuple[Any, ...]) -> str:
    if isinstance(setting, (Fraction, Affine)):
        return _value(setting)
    if isinstance(setting, Inertia):
        return _setting(setting.entries)
    if isinstance(setting, tuple):
        return f"({','.join(map(_setting, setting))})"
    return str(setting)


def _link(link: Link) -> str:
    inertial = (link.mass, *link.com, *link.inertia.entries)
    return f"{_joint(link.joint)}; {' '.join(map(_value, inertial))}"


def _joint(joint: Joint) -> str:
    numbers = (joint.a, joint.d, joint.motor_inertia, joint.viscous, joint.coulomb)
    beside = f" {_value(joint.b)}" if joint.b else ""
    row = f"{joint.kind} {_angle(joint.alpha)} {_angle(joint.theta)}"
    return f"{row} {' '.join(map(_value, numbers))}{beside}"


def _angle(angle: Angle) -> str:
    quarter = f"{angle.quarter} quarters" if angle.quarter is not None else ""
    return f"({quarter or Fraction(angle.radians)})"


def _value(value: Value) -> str:
    if isinstance(value, Affine):
        return "+".join([str(value.constant), *(f"{factor}*{name}" for name, factor in value.terms)])
    return str(value)
