"""The effects of an arm on its page: equation, numbers, and the torque that each adds, by joint."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, Final

import numpy as np

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect, Site
from robodyn.report.arm_parts import number
from robodyn.robot.model import AXES, Inertia, Robot
from robodyn.robot.values import Affine

#: Points of a curve; an odd number, so that the middle of a range is one of them.
POINTS: Final = 81


@dataclass(frozen=True, slots=True)
class _At:
    """An effect at a joint (from 1; None: of the whole robot), with its numbers."""

    effect: Effect
    joint: int | None
    values: Mapping[str, Any]


def effects(robot: Robot, joints: list[dict[str, Any]], motion: Mapping[str, Any]) -> list[dict[str, Any]]:
    """A record for each kind of effect that ``robot`` has, entries and plain numbers of joints alike;
    ``joints`` and ``motion`` are those of the page."""
    by_kind: dict[str, list[_At]] = {}
    for one in _all(robot):
        by_kind.setdefault(one.effect.id, []).append(one)
    return [_record(group, robot, joints, motion) for group in by_kind.values()]


def _all(robot: Robot) -> Iterator[_At]:
    folded = [effect for effect in CATALOGUE.values() if effect.traits.fold is not None]
    for effect in folded:
        fold = effect.traits.fold
        assert fold is not None
        for index, link in enumerate(robot.links, 1):
            value = getattr(link.joint, fold.key, 0) if fold.into == "joint" else 0
            if value:
                yield _At(effect, index, {fold.parameter: float(value)})
    for entry in robot.effects:
        yield _At(entry.definition, entry.joint, {name: _plain(x) for name, x in entry.settings})


def _plain(value: Any) -> Any:
    """A setting in floats."""
    assert not isinstance(value, Affine)
    if isinstance(value, Fraction):
        return float(value)
    if isinstance(value, tuple):
        return tuple(map(_plain, value))
    return value


def _record(
    group: list[_At], robot: Robot, joints: list[dict[str, Any]], motion: Mapping[str, Any]
) -> dict[str, Any]:
    effect = group[0].effect
    return {
        "effect": effect.id,
        "title": effect.title,
        "latex": effect.latex,
        "doc": effect.doc,
        "signature": effect.signature,
        "source": effect.source,
        "entries": [
            {"joint": one.joint, "values": [_value(one, robot, name) for name in one.values]} for one in group
        ],
        "curves": [
            curve
            for one in group
            if one.joint is not None
            for curve in _curves(one, joints[one.joint - 1], motion)
        ],
    }


def _value(one: _At, robot: Robot, name: str) -> dict[str, Any]:
    revolute = one.joint is None or robot.links[one.joint - 1].joint.kind == "revolute"
    units = {p.name: p.unit_at(revolute=revolute) for p in one.effect.parameters}
    unit = units.get(name, "")
    return {"name": name, "value": _json(one.values[name]), "unit": "" if unit == "1" else unit}


def _json(value: Any) -> Any:
    if isinstance(value, Inertia):
        return [number(getattr(value, axes)) for axes in AXES]
    return [_json(x) for x in value] if isinstance(value, tuple) else value


def _curves(one: _At, joint: Mapping[str, Any], motion: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """The torque of an effect over what it is drawn over, where one number at the joint decides it."""
    equation, over = one.effect.equation, one.effect.traits.over
    if equation is None or one.effect.needs_load:
        return
    low, high = joint["range"]
    index = joint["joint"] - 1
    top = joint["limits"]["velocity"] or 1.0
    load = max(map(abs, motion["torque"][index]), default=0.0) or 1.0
    fastest = joint["limits"]["acceleration"] or 1.0
    ranges = {
        "position": ("q", low, high, "position"),
        "velocity": ("qd", -top, top, "velocity"),
        "acceleration": ("qdd", -fastest, fastest, ""),
        "load": ("tau", -load, load, "torque"),
        "load, each way": ("tau", -load, load, "torque"),
    }
    if over not in ranges:
        return
    name, start, end, quantity = ranges[over]
    units = joint["units"]
    unit = units[quantity] if quantity else units["velocity"] + "²"
    ways = (1.0, -1.0) if over == "load, each way" else (1.0,)
    x = np.linspace(start, end, POINTS)
    revolute = joint["kind"] == "revolute"
    curves = [[float(equation(one.values, _site(revolute, name, float(v), way))) for v in x] for way in ways]
    if all(_is_straight(curve) for curve in curves):
        return  # its number says all of it
    yield {
        "joint": one.joint,
        "over": over.partition(",")[0],
        "unit": unit,
        "torque_unit": units["torque"],
        "x": [float(f"{v:.5g}") for v in x],
        "torque": [[float(f"{v:.5g}") for v in curve] for curve in curves],
    }


def _is_straight(curve: list[float]) -> bool:
    """Whether a curve over evenly spaced points is a line."""
    size = max(map(abs, curve), default=0.0)
    return bool(np.abs(np.diff(curve, 2)).max() <= 1e-9 * size)


def _site(revolute: bool, name: str, value: float, way: float) -> Site:
    """What an equation reads where one quantity has this ``value``: it moves as that says, else ``way``."""
    direction = float(np.sign(value)) if name == "qd" else way
    at_rest = Site(revolute, 0.0, 0.0, 0.0, direction, 0.0)
    return replace(at_rest, **{name: value})  # type: ignore[arg-type]
