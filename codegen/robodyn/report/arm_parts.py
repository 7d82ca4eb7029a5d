"""The joints and links of an arm as a page shows them: numbers, units, and what is doubtful about them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any, Final

import numpy as np

from robodyn.report.figures import UNITS
from robodyn.robot.model import AXES, Inertia, Joint, Link, Robot
from robodyn.robot.origins import GROUPS
from robodyn.robot.plausibility import inertia_doubt, limits_doubt, only_about_base_axis
from robodyn.robot.rotations import ONE_TURN
from robodyn.robot.values import Value
from robodyn.simulate.limits import ASSUMED


def joints(robot: Robot) -> list[dict[str, Any]]:
    """A record for each joint: kind, units, DH row [rad, m], the range of its slider, limits, drive."""
    return [_joint(index, link) for index, link in enumerate(robot.links, 1)]


def _joint(index: int, link: Link) -> dict[str, Any]:
    joint = link.joint
    low, high = _range(joint)
    return {
        "joint": index,
        "name": link.name,
        "kind": joint.kind,
        "units": {name: unit for name, unit in UNITS[joint.kind].items() if name != "acceleration"},
        "row": {
            "alpha": joint.alpha.radians,
            "a": number(joint.a),
            "b": number(joint.b),
            "d": number(joint.d),
            "theta": joint.theta.radians,
        },
        "range": [low, high],
        "home": min(max(0.0, low), high),
        "limits": {
            "position": None if joint.limits.position is None else [float(x) for x in joint.limits.position],
            "velocity": _optional(joint.limits.velocity),
            "acceleration": _optional(joint.limits.acceleration),
            "torque": _optional(joint.limits.torque),
        },
        "motor_inertia": number(joint.motor_inertia),
        "viscous": number(joint.viscous),
        "coulomb": number(joint.coulomb),
        "gear": None if joint.gear is None else float(joint.gear.ratio),
    }


def _range(joint: Joint) -> tuple[float, float]:
    """What the slider runs over [rad or m]: the limits, a turn each way at most; half a turn or half a metre
    each way where none are stated."""
    stated = joint.limits.position or ASSUMED[joint.kind].position
    assert stated is not None
    low, high = map(float, stated)
    if joint.kind == "revolute":
        low, high = max(low, -ONE_TURN), min(high, ONE_TURN)
    return low, high


def links(robot: Robot) -> list[dict[str, Any]]:
    """A record for each link: mass [kg], centre of mass [m], inertia about it [kg m^2], the ellipsoid of
    equal inertia, how far the numbers can be trusted, and the doubts about them."""
    return [
        {
            "link": index,
            "name": link.name,
            "mass": number(link.mass),
            "com": [number(x) for x in link.com],
            "inertia": {axes: number(getattr(link.inertia, axes)) for axes in AXES},
            "ellipsoid": ellipsoid(number(link.mass), link.inertia),
            "confidence": {
                "share": float(link.inertial_share),
                "stated": link.confidence is not None,
                "unknown": link.confidence == "unknown",
            },
            "origins": {name: getattr(link.origins, name) for name in GROUPS["inertial"]},
            "doubts": list(_plausibility(index, link)),
        }
        for index, link in enumerate(robot.links, 1)
    ]


def ellipsoid(mass: float, inertia: Inertia) -> dict[str, Any] | None:
    """The homogeneous ellipsoid of this ``mass`` [kg] and inertia: its semi-axes [m], and their directions by
    columns; None without mass or inertia. An axis that no body could have is 0."""
    xx, yy, zz, xy, xz, yz = (number(getattr(inertia, axes)) for axes in AXES)
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if mass <= 0 or not tensor.any():
        return None
    moments, directions = np.linalg.eigh(tensor)
    squares = 2.5 / mass * (moments.sum() - 2 * moments)
    return {"semi_axes": np.sqrt(np.maximum(squares, 0)).tolist(), "directions": directions.tolist()}


#: Origins of inertial numbers that torques should not rest on unsaid.
_ORIGINS: Final = {
    "assumed": "assumed",
    "synthetic": "synthetic: invented, not those of a real arm",
    "absent": "absent, taken as 0",
}


def _plausibility(index: int, link: Link) -> Iterator[dict[str, str]]:
    """What is doubtful of a link, and what the description says about it."""
    reason = inertia_doubt(link.inertia)
    if reason and not (index == 1 and only_about_base_axis(link.joint, link.inertia)):
        yield {"what": f"the inertia is not physical: {reason}", "acknowledged": link.acknowledged}
    reason = limits_doubt(link.joint.limits, link.joint.kind)
    if reason:
        yield {"what": f"limits of position: {reason}", "acknowledged": link.acknowledged}
    origins = {getattr(link.origins, name) for name in GROUPS["inertial"]} - {"stated", "measured"}
    if origins - {"absent"} or (len(origins) == 1 and link.origins.mass == link.origins.inertia == "absent"):
        words = " or ".join(_ORIGINS[origin] for origin in sorted(origins))
        yield {"what": f"mass, centre of mass and inertia are {words}", "acknowledged": ""}


def reach(robot: Robot) -> float:
    """How far the arm's frames can be apart from its base [m], at most: lengths in a row."""
    total = 0.0
    for link in robot.links:
        joint = link.joint
        along = number(joint.d)
        if joint.kind == "prismatic":
            low, high = _range(joint)
            along = max(abs(along + low), abs(along + high))
        total += math.hypot(number(joint.a), number(joint.b), along)
    return total + (math.hypot(*map(number, robot.tool.xyz)) if robot.tool is not None else 0.0)


def number(value: Value) -> float:
    """A number of a robot without run-time parameters."""
    assert isinstance(value, Fraction)
    return float(value)


def _optional(value: Fraction | None) -> float | None:
    return None if value is None else float(value)
