"""MJCF out of a robot, as MuJoCo's XML reference has it."""

from __future__ import annotations

from robodyn.formats.writers.markup import Tag, decimal, decimals, tag
from robodyn.formats.writers.parts import Cylinder, Frame, PartJoint, Parts, cylinders


def root(parts: Parts) -> tuple[Tag, list[str]]:
    """The element ``<mujoco>``, and what it does not say of ``parts``."""
    pictures = cylinders(parts)
    missing = []
    inner: list[Tag] = []
    if parts.tool is not None:
        inner = [tag("site", name="tool", pos=decimals(parts.tool.xyz), euler=_euler(parts.tool))]
    for joint, picture in zip(reversed(parts.joints), reversed(pictures[1:]), strict=True):
        inner = [_body(joint, picture, inner)]
    base = parts.base or Frame()
    shapes = map(_geom, pictures[0])
    world = tag("body", *shapes, *inner, name="base", pos=_position(base), euler=_euler(base))
    compiler = tag("compiler", angle="radian", eulerseq="XYZ", autolimits="true", inertiafromgeom="false")
    geom = tag("geom", contype="0", conaffinity="0", group="1", mass="0", rgba="0.7 0.7 0.7 1")
    motors = [_motor(joint) for joint in parts.joints]
    gravity = tag("option", gravity=decimals(parts.gravity))
    elements = [compiler, gravity, tag("default", geom), tag("worldbody", world), tag("actuator", *motors)]
    if any(joint.limits.velocity is not None for joint in parts.joints):
        missing.append("limits of velocity")
    if any(joint.limits.acceleration is not None for joint in parts.joints):
        missing.append("limits of acceleration")
    return tag("mujoco", *elements, model=parts.name), missing


def _body(joint: PartJoint, picture: tuple[Cylinder, ...], inner: list[Tag]) -> Tag:
    body, limits = joint.body, joint.limits
    xx, yy, zz, xy, xz, yz = body.inertia
    diagonal = not any((xy, xz, yz))
    inertial = tag(
        "inertial",
        pos=decimals(body.com),
        mass=decimal(body.mass),
        diaginertia=decimals((xx, yy, zz)) if diagonal else None,
        fullinertia=None if diagonal else decimals(body.inertia),
    )
    position, torque = limits.position, limits.torque
    moving = tag(
        "joint",
        name=joint.name,
        type="hinge" if joint.kind == "revolute" else "slide",
        axis="0 0 1",
        range_=None if position is None else decimals([float(end) for end in position]),
        actuatorfrcrange=None if torque is None else decimals((-float(torque), float(torque))),
        damping=_unless_zero(joint.viscous),
        frictionloss=_unless_zero(joint.coulomb),
        stiffness=_unless_zero(joint.spring.stiffness) if joint.spring else None,
        springref=_unless_zero(joint.spring.rest) if joint.spring else None,
        armature=_unless_zero(joint.motor_inertia),
    )
    shapes = map(_geom, picture)
    pos, euler = _position(joint.frame), _euler(joint.frame)
    return tag("body", inertial, moving, *shapes, *inner, name=joint.link, pos=pos, euler=euler)


def _motor(joint: PartJoint) -> Tag:
    """A motor, whose control is the torque in front of its gear."""
    ratio = None if joint.gear is None else decimal(float(joint.gear.ratio))
    return tag("motor", name=f"{joint.name}_motor", joint=joint.name, gear=ratio)


def _geom(cylinder: Cylinder) -> Tag:
    size = decimals((cylinder.radius, cylinder.length / 2))
    return tag(
        "geom", type="cylinder", size=size, pos=_position(cylinder.frame), euler=_euler(cylinder.frame)
    )


def _position(frame: Frame) -> str | None:
    return decimals(frame.xyz) if any(frame.xyz) else None


def _euler(frame: Frame) -> str | None:
    return decimals(frame.rpy) if any(frame.rpy) else None


def _unless_zero(x: float) -> str | None:
    return decimal(x) if x else None
