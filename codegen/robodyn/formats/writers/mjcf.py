"""MJCF out of a robot, as MuJoCo's XML reference has it."""

from __future__ import annotations

from collections.abc import Sequence

from robodyn.formats.tree import Mimic
from robodyn.formats.writers import Tag, decimal, decimals, tag
from robodyn.formats.writers.parts import Cylinder, Frame, PartJoint, Parts, cylinders


def root(parts: Parts) -> Tag:
    """The element ``<mujoco>``."""
    pictures = cylinders(parts)
    inner: list[Tag] = []
    if parts.tool is not None:
        inner = [tag("site", name="tool", pos=decimals(parts.tool.xyz), euler=_unless_zero(parts.tool.rpy))]
    for joint, picture in zip(reversed(parts.joints), reversed(pictures[1:]), strict=True):
        inner = [_body(joint, picture, inner)]
    world = tag("body", *map(_geom, pictures[0]), *inner, name="base", **_placed(parts.base or Frame()))
    compiler = tag("compiler", angle="radian", eulerseq="XYZ", autolimits="true", inertiafromgeom="false")
    geom = tag("geom", contype="0", conaffinity="0", group="1", mass="0", rgba="0.7 0.7 0.7 1")
    motors = [_motor(joint) for joint in parts.joints if joint.mimic is None]
    followers = [_equality(joint.name, joint.mimic) for joint in parts.joints if joint.mimic]
    gravity = tag("option", gravity=decimals(parts.gravity))
    elements = [compiler, gravity, tag("default", geom), tag("worldbody", world), tag("actuator", *motors)]
    elements += [tag("equality", *followers)] * bool(followers)
    return tag("mujoco", *elements, model=parts.name)


def _body(joint: PartJoint, picture: tuple[Cylinder, ...], inner: list[Tag]) -> Tag:
    body, limits = joint.body, joint.limits
    diagonal = not any(body.inertia[3:])
    inertial = tag(
        "inertial",
        pos=decimals(body.com),
        mass=decimal(body.mass),
        diaginertia=decimals(body.inertia[:3]) if diagonal else None,
        fullinertia=None if diagonal else decimals(body.inertia),
    )
    position, torque, spring = limits.position, limits.torque, joint.spring
    moving = tag(
        "joint",
        name=joint.name,
        type="hinge" if joint.kind == "revolute" else "slide",
        axis="0 0 1",
        range_=None if position is None else decimals([*map(float, position)]),
        actuatorfrcrange=None if torque is None else decimals((-float(torque), float(torque))),
        damping=_unless_zero([joint.viscous]),
        frictionloss=_unless_zero([joint.coulomb]),
        stiffness=_unless_zero([spring.stiffness]) if spring else None,
        springref=_unless_zero([spring.rest]) if spring else None,
        armature=_unless_zero([joint.motor_inertia]),
    )
    return tag(
        "body", inertial, moving, *map(_geom, picture), *inner, name=joint.link, **_placed(joint.frame)
    )


def _motor(joint: PartJoint) -> Tag:
    """A motor, whose control is the torque in front of its gear."""
    ratio = None if joint.gear is None else decimal(float(joint.gear.ratio))
    return tag("motor", name=f"{joint.name}_motor", joint=joint.name, gear=ratio)


def _equality(joint: str, mimic: Mimic) -> Tag:
    """What holds a joint where it follows another; both are at 0 in the model's own position."""
    powers = decimals((mimic.offset, mimic.multiplier, 0, 0, 0))
    return tag("joint", joint1=joint, joint2=mimic.leader, polycoef=powers)


def _geom(cylinder: Cylinder) -> Tag:
    size = decimals((cylinder.radius, cylinder.length / 2))
    return tag("geom", type="cylinder", size=size, **_placed(cylinder.frame))


def _placed(frame: Frame) -> dict[str, str | None]:
    return {"pos": _unless_zero(frame.xyz), "euler": _unless_zero(frame.rpy)}


def _unless_zero(numbers: Sequence[float]) -> str | None:
    return decimals(numbers) if any(numbers) else None
