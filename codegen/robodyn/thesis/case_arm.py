"""The arm of the thesis's case study (chapter 3): whose line, whose dynamics, whose friction.

Source: Dhanaraj 1990, section 3.5, Table 3.4, programs D.1.2, D.1.3 and D.4. Three things do not fit together
there, and :data:`Arm` chooses. The path is led by D.1.3, which measures the point along +y of frame 3 and
has an offset of 0.127 m; the torques are D.1.2's, whose masses and load lie along -y, and whose offset is
0.1501 m. ``programs`` does as the programs do: joint angles of the one are given to the other, and the start
is that of D.4. ``consistent`` leads the point that D.1.2 loads, along the same line, from another start.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Final, Literal

from robodyn.effects.bearings import LOAD, TRANSMISSION
from robodyn.effects.rigid import PAYLOAD
from robodyn.errors import InputError
from robodyn.robot.model import EffectEntry, Robot
from robodyn.thesis.printed import TABLE_3_4, TABLE_3_5, PrintedDrive, PrintedTorques, bundled

if TYPE_CHECKING:
    from robodyn.simulate.kinematics import Kinematics
    from robodyn.thesis.puma_inverse import PumaArm

Arm = Literal["programs", "consistent"]
ARMS: Final[tuple[Arm, ...]] = ("programs", "consistent")

ROBOT: Final = "puma560_3dof_d12"
#: The arm of D.1.3.
LED_ROBOT: Final = "puma560_3dof_d13"
#: Shoulder offset of D.1.3, and its forearm, which is also where D.1.2 has its load [m].
OFFSET: Final = Fraction(127, 1000)
FOREARM: Final = Fraction(4318, 10000)
#: Joint angles at which D.4 begins [rad], to more digits than it prints, and their branch.
D4_START: Final = (3.69968, 2.30828, 0.59505)
D4_BRANCH: Final = (-1, 1)

#: Efficiency at load fractions beyond those that Table 3.5 gives away: its last point, with the exponent that
#: its three points show, up to full load.
EXPONENT: Final = 0.2
EXTENDED: Final = (0.2, 0.4, 0.6, 0.8, 1.0)


@dataclass(frozen=True, slots=True)
class EfficiencyPoint:
    """What a row of Table 3.5 gives away of the efficiency curve: load fraction and efficiency; whether the
    motor drives, or the joint's torque goes against the motion."""

    load: Fraction
    efficiency: Fraction
    drives: bool


def efficiency_point(row: PrintedTorques, drive: PrintedDrive) -> EfficiencyPoint:
    """Table 3.2 solved for the efficiency; the motion goes where joint friction points."""
    passed = row.input - row.direction * drive.breakaway
    drives = row.joint_total * row.direction > 0
    efficiency = row.joint_total / passed if drives else passed / row.joint_total
    return EfficiencyPoint(abs(row.joint_total) / drive.largest, efficiency, drives)


def efficiency_points() -> tuple[EfficiencyPoint, ...]:
    """Those of the three links."""
    return tuple(efficiency_point(*rows) for rows in zip(TABLE_3_5, TABLE_3_4, strict=True))


def efficiency_curve() -> tuple[tuple[Fraction, Fraction], ...]:
    """Knots (load fraction, efficiency) to four decimals: the three points, and what is assumed beyond."""
    points = sorted((round(point.load, 4), round(point.efficiency, 4)) for point in efficiency_points())
    last_load, last = (float(x) for x in points[-1])
    beyond = ((load, round(last * (load / last_load) ** EXPONENT, 4)) for load in EXTENDED)
    return (*points, *((Fraction(str(x)), Fraction(str(y))) for x, y in beyond))


@dataclass(frozen=True, slots=True)
class Robots:
    """The same arm without friction, with journal bearings of Table 3.4 (Eq 3.3 with its sign corrected), and
    with its transmissions besides, a monotone cubic through the knots of :func:`efficiency_curve`."""

    rigid: Robot
    with_bearings: Robot
    complete: Robot


def robots(payload: float, span: float) -> Robots:
    """D.1.2's arm with a load of ``payload`` [kg] at the end of its forearm and bearings ``span`` [m] wide.

    Raises
    ------
    InputError: a negative payload, a span that is not positive.
    """
    if not (math.isfinite(payload) and payload >= 0):
        raise InputError("the payload is not a mass", found=f"{payload}", expected="0 kg or more")
    if not (math.isfinite(span) and span > 0):
        raise InputError("the span of the bearings is not a length", found=f"{span}", expected="above 0 m")
    carried: list[EffectEntry] = []
    if payload:
        com = (Fraction(0), -FOREARM, Fraction(0))
        carried = [EffectEntry(PAYLOAD.id, None, (("mass", Fraction(str(payload))), ("com", com)))]
    journals, all_friction = [], []
    for joint, drive in enumerate(TABLE_3_4, 1):
        journal = EffectEntry(
            LOAD.id,
            joint,
            (
                ("bearing", "journal"), ("mu", drive.mu), ("radius", drive.radius),
                ("span", Fraction(str(span))), ("variant", "corrected"),
            ),
        )  # fmt: skip
        gear = EffectEntry(
            TRANSMISSION.id,
            joint,
            (
                ("breakaway", drive.breakaway), ("efficiency", efficiency_curve()),
                ("rated_torque", drive.largest), ("interpolation", "cubic"),
            ),
        )  # fmt: skip
        journals.append(journal)
        all_friction += [journal, gear]
    rigid, with_bearings, complete = (
        replace(bundled(ROBOT), effects=(*entries, *carried)) for entries in ((), journals, all_friction)
    )
    return Robots(rigid, with_bearings, complete)


@dataclass(frozen=True, slots=True)
class Led:
    """The arm whose point follows the line, and its inverse kinematics."""

    kinematics: Kinematics
    inverse: PumaArm


def led(arm: Arm) -> Led:
    """The arm of D.1.3 (``programs``), or D.1.2's up to its load (``consistent``)."""
    if arm == "consistent":
        return led_at(bundled(ROBOT), -FOREARM)
    return led_at(bundled(LED_ROBOT), FOREARM)


def led_at(robot: Robot, along: Fraction) -> Led:
    """``robot`` led at ``along`` [m] on y of frame 3."""
    from robodyn.simulate.kinematics import Kinematics
    from robodyn.thesis.puma_inverse import PumaArm

    point = (0.0, float(along), 0.0)
    return Led(Kinematics(robot, point=point), PumaArm.of(robot, point=point))
