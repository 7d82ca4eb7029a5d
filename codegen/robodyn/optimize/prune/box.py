"""The box of states that a pruned kernel is good for: the limits of the joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from robodyn.errors import InputError
from robodyn.ir.program import Input
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True)
class Box:
    """What the joints may do.

    ``angles`` are the variables of revolute joints: they enter by sine and cosine only, and every point of
    the circle is taken to be possible. ``ranges`` hold all others [m, and per s, per s^2; rad/s, rad/s^2].
    """

    angles: tuple[Input, ...]
    ranges: dict[Input, tuple[Fraction, Fraction]]
    #: Position limits of revolute joints [rad]: where torques are sampled.
    sampled: dict[Input, tuple[Fraction, Fraction]]

    @property
    def inputs(self) -> tuple[Input, ...]:
        """All variables, in a fixed order."""
        return (*self.angles, *self.ranges)

    def interval(self, x: Input) -> tuple[Fraction, Fraction]:
        """Where ``x`` is sampled."""
        return self.ranges[x] if x in self.ranges else self.sampled[x]


def box_of(robot: Robot, arrays: Sequence[str] = ("q", "qd", "qdd")) -> Box:
    """The limits of ``robot``, for the variables of ``arrays``.

    Raises
    ------
    InputError: a joint lacks a limit, or the robot has run-time parameters.
    """
    if robot.parameters:
        raise InputError(
            f"{robot.name} cannot be pruned",
            found=f"run-time parameters ({', '.join(robot.parameters)}), whose values no bound can know",
            expected="numbers",
            remedy="write numbers in their place, or leave out --prune",
        )
    missing = _missing(robot)
    if missing:
        raise InputError(
            f"{robot.name} cannot be pruned without limits of its joints",
            found=missing,
            expected="limits of position, velocity and acceleration at every joint",
            remedy="add for example `limits: {position: [-pi, pi], velocity: 3, acceleration: 10}` to each "
            "of these links",
        )
    angles: list[Input] = []
    ranges: dict[Input, tuple[Fraction, Fraction]] = {}
    sampled: dict[Input, tuple[Fraction, Fraction]] = {}
    for i, link in enumerate(robot.links):
        position, x = link.joint.limits.position, Input("q", i)
        assert position is not None
        if link.joint.kind == "revolute":
            angles.append(x)
            sampled[x] = position
        else:
            ranges[x] = position
    for array, limits in (
        ("qd", [link.joint.limits.velocity for link in robot.links]),
        ("qdd", [link.joint.limits.acceleration for link in robot.links]),
    ):
        if array in arrays:
            ranges.update(
                {Input(array, i): (-(b or Fraction(0)), b or Fraction(0)) for i, b in enumerate(limits)}
            )
    return Box(tuple(angles), ranges, sampled)


def _missing(robot: Robot) -> str:
    """Which limits which joints lack, in words; empty if none."""
    lacking: dict[str, list[str]] = {}
    for i, link in enumerate(robot.links, 1):
        limits = link.joint.limits
        stated = {
            "position": limits.position,
            "velocity": limits.velocity,
            "acceleration": limits.acceleration,
        }
        keys = ", ".join(key for key, value in stated.items() if value is None)
        if keys:
            lacking.setdefault(keys, []).append(str(i))
    return "; ".join(
        f"no {keys} of joint{'s' if len(joints) > 1 else ''} {', '.join(joints)}"
        for keys, joints in lacking.items()
    )
