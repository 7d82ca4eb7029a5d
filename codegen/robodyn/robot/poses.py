"""Links that state a pose in place of DH numbers: turned about z axes until rows describe them.

A pose places the frame of a joint in the one before, at q = 0; its z axis is the joint's. It is a turn about
the z axis before, a twist about x, and a turn about its own z axis. The first of the three is taken into the
frame before, which turns about its z axis with all that stands in it (of the first joint: into the base), so
that a row is left, with an offset ``b`` where the origin is not on the common normal. Origins stay.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from robodyn.robot.limits import QUARTER_TURN
from robodyn.robot.numbers import rounded
from robodyn.robot.parts import Inertia, Link, Placement, Vector
from robodyn.robot.rotations import (
    SAME,
    about_x,
    about_z,
    applied,
    placement,
    product,
    summed,
    tidy,
    twist_of,
)
from robodyn.robot.values import ZERO, Angle, Value, quarter_turns


def from_poses(
    links: Sequence[Link], poses: Sequence[Placement | None], base: Placement | None
) -> tuple[tuple[Link, ...], Placement | None]:
    """``links`` by their rows, those with a pose turned into one; and where the base frame then stands.

    Right angles keep every number exact; at other angles what is turned is rounded to double.

    Raises
    ------
    OverflowError: a number grows beyond double.
    """
    converted = list(links)
    for i, pose in enumerate(poses):
        if pose is None:
            continue
        phi, alpha, theta = _angles(pose)
        row = applied(about_x(-alpha), applied(about_z(-phi), pose.xyz))
        size = math.hypot(*pose.xyz)
        a, b, d = (
            row if alpha.quarter is not None and phi.quarter is not None else (tidy(x, size) for x in row)
        )
        joint = replace(converted[i].joint, alpha=alpha, a=a, b=b, d=d, theta=theta)
        converted[i] = replace(converted[i], joint=joint)
        if phi.quarter == 0:
            continue
        if i:
            converted[i - 1] = _turned(converted[i - 1], phi)
        else:
            rotation, origin = (SAME, (ZERO,) * 3) if base is None else (base.rotation, base.xyz)
            base = placement(product(rotation, about_z(phi)), origin, 0.0)
    return tuple(converted), base


def _angles(pose: Placement) -> tuple[Angle, Angle, Angle]:
    """Turn before, twist and turn behind; of both ways to say it that which turns the frame before less."""
    twist = twist_of(pose.rotation, QUARTER_TURN)
    half = quarter_turns(2)
    other = summed(twist.phi, half)
    if abs(other.radians) < abs(twist.phi.radians):
        return other, -twist.alpha, summed(twist.theta, half)
    return twist.phi, twist.alpha, twist.theta


def _turned(link: Link, phi: Angle) -> Link:
    """``link`` with its frame turned by ``phi`` about its z axis."""
    c, s = phi.cos, phi.sin
    x, y, z = link.com
    i = link.inertia

    def kept(value: Value) -> Value:
        return value if phi.quarter is not None or value == ZERO else rounded(value)

    com: Vector = (kept(x * c + y * s), kept(y * c - x * s), z)
    inertia = Inertia(
        xx=kept(i.xx * (c * c) + i.xy * (2 * c * s) + i.yy * (s * s)),
        yy=kept(i.xx * (s * s) - i.xy * (2 * c * s) + i.yy * (c * c)),
        zz=i.zz,
        xy=kept((i.yy - i.xx) * (c * s) + i.xy * (c * c - s * s)),
        xz=kept(i.xz * c + i.yz * s),
        yz=kept(i.yz * c - i.xz * s),
    )
    joint = replace(link.joint, theta=summed(link.joint.theta, phi))
    return replace(link, joint=joint, com=com, inertia=inertia)
