"""A robot's limits and a motion: where it leaves them, and limits for joints that state none."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from robodyn.robot.model import Limits, Robot
from robodyn.robot.rotations import ONE_TURN
from robodyn.simulate.trajectories.trajectory import Trajectory

_SLACK = 1e-9
_HALF_TURN = Fraction("3.141592653589793")

#: For joints that state no limits: of a revolute joint (rad), and of a prismatic one (m).
ASSUMED = {
    "revolute": Limits((-_HALF_TURN, _HALF_TURN), Fraction(2), Fraction(10)),
    "prismatic": Limits((Fraction(-1, 2), Fraction(1, 2)), Fraction(1), Fraction(5)),
}


def with_limits(robot: Robot) -> tuple[Robot, tuple[int, ...]]:
    """``robot``, with those of :data:`ASSUMED` where none are stated; the joints (from 1) that got some."""
    links, filled = [], []
    for i, link in enumerate(robot.links, 1):
        own, other = link.joint.limits, ASSUMED[link.joint.kind]
        full = Limits(
            own.position or other.position,
            other.velocity if own.velocity is None else own.velocity,
            other.acceleration if own.acceleration is None else own.acceleration,
            own.torque,
        )
        if full != own:
            filled.append(i)
        links.append(replace(link, joint=replace(link.joint, limits=full)))
    return replace(robot, links=tuple(links)), tuple(filled)


def beyond_a_turn(robot: Robot, q: Sequence[float]) -> tuple[int, ...]:
    """The revolute joints (from 1) whose positions ``q`` [n] (rad) are more than a turn, outside their limits
    too where they state any: degrees, probably."""
    joints = []
    for i, (link, x) in enumerate(zip(robot.links, q, strict=True), 1):
        stated = link.joint.limits.position
        within = stated is not None and float(stated[0]) <= x <= float(stated[1])
        if link.joint.kind == "revolute" and abs(x) > ONE_TURN and not within:
            joints.append(i)
    return tuple(joints)


def outside(robot: Robot, motion: Trajectory) -> list[str]:
    """What of ``motion`` is outside the stated limits of ``robot``, a line each."""
    violations = []
    for i, link in enumerate(robot.links):
        limits, unit = link.joint.limits, "m" if link.joint.kind == "prismatic" else "rad"
        ranges = [("is at", motion.q, limits.position, unit)]
        for what, values, size, per in (
            ("moves at", motion.qd, limits.velocity, "s"),
            ("accelerates by", motion.qdd, limits.acceleration, "s^2"),
        ):
            ranges.append((what, values, None if size is None else (-size, size), f"{unit}/{per}"))
        for what, values, bounds, measure in ranges:
            if bounds is None:
                continue
            low, high = float(bounds[0]), float(bounds[1])
            beyond = np.maximum(values[:, i] - high, low - values[:, i])
            k = int(np.argmax(beyond))
            if beyond[k] > _SLACK * max(1.0, abs(low), abs(high)):
                violations.append(
                    f"joint {i + 1} {what} {values[k, i]:.4g} {measure} at {motion.t[k]:.4g} s, outside its "
                    f"limits {low:.4g} to {high:.4g}"
                )
    return violations
