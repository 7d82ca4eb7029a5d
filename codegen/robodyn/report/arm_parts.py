"""The joints, links and effects of an arm as a page shows them: numbers, units, what is doubtful about them,
and the torque that each effect adds, by joint."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any, Final

import numpy as np

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect, Site
from robodyn.report.figures import UNITS
from robodyn.robot.account import GROUPS
from robodyn.robot.masses import inertia_doubt, only_about_base_axis
from robodyn.robot.model import AXES, Inertia, Joint, Link, Robot
from robodyn.robot.rotations import ONE_TURN, limits_doubt
from robodyn.simulate.limits import ASSUMED


def plain(value: Any) -> Any:
    """A setting of a robot without run-time parameters, in floats."""
    if isinstance(value, Inertia):
        return [plain(getattr(value, axes)) for axes in AXES]
    if isinstance(value, tuple):
        return [plain(x) for x in value]
    return float(value) if isinstance(value, Fraction) else value


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
            **{name: plain(getattr(joint, name)) for name in ("a", "b", "d")},
            "theta": joint.theta.radians,
        },
        "range": [low, high],
        "home": min(max(0.0, low), high),
        "limits": {
            name: plain(getattr(joint.limits, name))
            for name in ("position", "velocity", "acceleration", "torque")
        },
        **{name: plain(getattr(joint, name)) for name in ("motor_inertia", "viscous", "coulomb")},
        "gear": None if joint.gear is None else float(joint.gear.ratio),
    }


def _range(joint: Joint) -> tuple[float, float]:
    """What the slider runs over [rad or m]: the limits, a turn each way at most; half a turn or half a metre
    each way where none are stated."""
    low, high = plain(joint.limits.position or ASSUMED[joint.kind].position)
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
            "mass": plain(link.mass),
            "com": plain(tuple(link.com)),
            "inertia": dict(zip(AXES, plain(link.inertia), strict=True)),
            "ellipsoid": ellipsoid(plain(link.mass), link.inertia),
            "confidence": {
                "share": float(link.inertial_share),
                "stated": link.confidence is not None,
                "unknown": link.confidence == "unknown",
            },
            "origins": {name: getattr(link.origins, name) for name in GROUPS["inertial"]},
            "doubts": list(_doubts(index, link)),
        }
        for index, link in enumerate(robot.links, 1)
    ]


def ellipsoid(mass: float, inertia: Inertia) -> dict[str, Any] | None:
    """The homogeneous ellipsoid of this ``mass`` [kg] and inertia: its semi-axes [m], and their directions by
    columns; None without mass or inertia. An axis that no body could have is 0."""
    xx, yy, zz, xy, xz, yz = plain(inertia)
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


def _doubts(index: int, link: Link) -> Iterator[dict[str, str]]:
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
    for joint in (link.joint for link in robot.links):
        a, b, d = map(plain, (joint.a, joint.b, joint.d))
        along = max(abs(d + x) for x in _range(joint)) if joint.kind == "prismatic" else d
        total += math.hypot(a, b, along)
    return total + (math.hypot(*map(plain, robot.tool.xyz)) if robot.tool is not None else 0.0)


# --- effects ----------------------------------------------------------------------------------------------

#: Points of a curve; an odd number, so that the middle of a range is one of them.
POINTS: Final = 81
#: What an effect is drawn over: the field of a site, and the quantity whose unit it has.
_AXES: Final = {
    "position": ("q", "position"), "velocity": ("qd", "velocity"), "acceleration": ("qdd", "acceleration"),
    "load": ("tau", "torque"), "load, each way": ("tau", "torque"),
}  # fmt: skip


def effects(robot: Robot, joints: list[dict[str, Any]], motion: Mapping[str, Any]) -> list[dict[str, Any]]:
    """A record for each kind of effect that ``robot`` has, entries and plain numbers of joints alike;
    ``joints`` and ``motion`` are those of the page."""
    records: dict[str, dict[str, Any]] = {}
    for effect, index, values in _all_effects(robot):
        fields = {key: getattr(effect, key) for key in ("title", "latex", "doc", "signature", "source")}
        record = records.setdefault(effect.id, {"effect": effect.id, **fields, "entries": [], "curves": []})
        revolute = index is None or robot.links[index - 1].joint.kind == "revolute"
        units = {p.name: p.unit_at(revolute=revolute) for p in effect.parameters}
        numbers = [
            {"name": name, "value": x, "unit": "" if units.get(name) == "1" else units.get(name, "")}
            for name, x in values.items()
        ]
        record["entries"].append({"joint": index, "values": numbers})
        if index is not None:
            record["curves"] += _curves(effect, values, joints[index - 1], motion)
    return list(records.values())


def _all_effects(robot: Robot) -> Iterator[tuple[Effect, int | None, Mapping[str, Any]]]:
    """Each effect, its joint (from 1; None: of the whole robot) and its numbers."""
    for effect in CATALOGUE.values():
        fold = effect.traits.fold
        if fold is None or fold.into != "joint":
            continue
        for index, link in enumerate(robot.links, 1):
            value = getattr(link.joint, fold.key, 0)
            if value:
                yield effect, index, {fold.parameter: float(value)}
    for entry in robot.effects:
        yield entry.definition, entry.joint, {name: plain(x) for name, x in entry.settings}


def _curves(
    effect: Effect, values: Mapping[str, Any], joint: Mapping[str, Any], motion: Mapping[str, Any]
) -> Iterator[dict[str, Any]]:
    """The torque of an effect over what it is drawn over, where one number at the joint decides it."""
    equation, over = effect.equation, effect.traits.over
    if equation is None or effect.needs_load or over not in _AXES:
        return
    name, quantity = _AXES[over]
    limits, load = joint["limits"], max(map(abs, motion["torque"][joint["joint"] - 1]), default=0.0)
    end = {"qd": limits["velocity"], "qdd": limits["acceleration"], "tau": load}.get(name) or 1.0
    low, high = joint["range"] if name == "q" else (-end, end)
    x = np.linspace(low, high, POINTS)
    revolute = joint["kind"] == "revolute"
    curves = [
        [float(equation(values, _site(revolute, name, float(v), way))) for v in x]
        for way in ((1.0, -1.0) if over == "load, each way" else (1.0,))
    ]
    if all(_is_straight(curve) for curve in curves):
        return  # its number says all of it
    yield {
        "joint": joint["joint"],
        "over": over.partition(",")[0],
        "unit": joint["units"].get(quantity) or joint["units"]["velocity"] + "²",
        "torque_unit": joint["units"]["torque"],
        "x": [float(f"{v:.5g}") for v in x],
        "torque": [[float(f"{v:.5g}") for v in curve] for curve in curves],
    }


def _is_straight(curve: list[float]) -> bool:
    """Whether a curve over evenly spaced points is a line."""
    return bool(np.abs(np.diff(curve, 2)).max() <= 1e-9 * max(map(abs, curve)))


def _site(revolute: bool, name: str, value: float, way: float) -> Site:
    """What an equation reads where one quantity has this ``value``: it moves as that says, else ``way``."""
    direction = float(np.sign(value)) if name == "qd" else way
    at_rest = Site(revolute, 0.0, 0.0, 0.0, direction, 0.0)
    return replace(at_rest, **{name: value})  # type: ignore[arg-type]
