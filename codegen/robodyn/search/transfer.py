"""Records of other arms as a start: of bundled arms that are built alike, with constants for this one."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

from robodyn.formats.chain import Chain, Pose
from robodyn.formats.frames import description_of
from robodyn.formats.writers.parts import parts_of
from robodyn.ir.program import Program
from robodyn.optimize.programs import Choice, build
from robodyn.optimize.records import best_record
from robodyn.optimize.records.validation import frictionless, joints_of, summed
from robodyn.passes import FAST, unchecked
from robodyn.robot.bundled import bundled_names, load
from robodyn.robot.model import Inertia, Link, Robot
from robodyn.robot.parts import AXES, Limits
from robodyn.robot.values import Value
from robodyn.search.refit import refitted

#: Torques and masses are of this degree in the numbers of a description: mass by length by length.
_DEGREE = 3
#: The numbers of a joint that may differ between arms that are built alike.
_NUMBERS = ("a", "b", "d", "motor_inertia")


def transferred(robot: Robot, function: str, end: float) -> Iterator[Program]:
    """Programs of ``function`` of ``robot`` with the operations of the records of bundled arms that have the
    same joints in the same directions, until ``end`` [s, of the monotonic clock].

    Friction is put on top. None is proven.
    """
    if robot.parameters or robot.effects:
        return
    bare = frictionless(robot)
    arm = _in_own_frames(bare)
    for name in bundled_names():
        if time.monotonic() > end:
            return
        other = load(name, warn=lambda _: None)
        if other.n != robot.n or other.parameters or other.effects:
            continue
        record, start = best_record(other, function), _in_own_frames(other)
        if record is None or _built(start) != _built(arm):
            continue
        arms = [_between(start, arm, t) for t in range(_DEGREE + 1)]
        path = [build(each, function, Choice()) for each in arms]
        program = refitted(record.program, path, end)
        if program is None:
            continue
        if bare != robot:
            program = summed(program, build(joints_of(robot), function, Choice()))
        yield unchecked(program, FAST)  # some of the constants may be 0 or 1 now


def _in_own_frames(robot: Robot) -> Robot:
    """``robot`` in the frames that an import of it has: they depend on its axes alone."""
    plain = replace(robot, gravity=robot.base_gravity, base=None, tool=None)
    parts = parts_of(plain)
    joints = [
        replace(joint, pose=Pose.from_rpy(joint.frame.xyz, joint.frame.rpy), limits=Limits(), gear=None)
        for joint in parts.joints
    ]
    chain = Chain(robot.name, tuple(joints), gravity=parts.gravity)
    framed = description_of(chain)
    return replace(framed, gravity=framed.base_gravity, base=None, tool=None, torque_side=robot.torque_side)


def _built(robot: Robot) -> object:
    """What arms that are built alike have in common."""
    joints = [link.joint for link in robot.links]
    return robot.torque_side, [
        (joint.kind, joint.alpha, joint.theta, bool(joint.viscous), bool(joint.coulomb)) for joint in joints
    ]


def _between(one: Robot, other: Robot, t: int) -> Robot:
    """The arm on the line from ``one`` (t = 0) to ``other`` (t = 1)."""

    def number(x: Value, y: Value) -> Fraction:
        assert isinstance(x, Fraction)
        assert isinstance(y, Fraction)
        return x + (y - x) * t

    def link(x: Link, y: Link) -> Link:
        numbers: dict[str, Any] = {}
        for name in _NUMBERS:
            numbers[name] = number(getattr(x.joint, name), getattr(y.joint, name))
        inertia = [number(getattr(x.inertia, axes), getattr(y.inertia, axes)) for axes in AXES]
        com = tuple(map(number, x.com, y.com))
        return replace(
            x,
            joint=replace(x.joint, **numbers),
            mass=number(x.mass, y.mass),
            com=com,  # type: ignore[arg-type]  # three of them
            inertia=Inertia(*inertia),
        )

    gx, gy, gz = map(number, one.gravity, other.gravity)
    links = tuple(map(link, one.links, other.links))
    return replace(one, links=links, gravity=(gx, gy, gz))
