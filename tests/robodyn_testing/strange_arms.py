"""Arms that a division may trip over: without gravity, of one joint, of slides alone, without mass, long."""

from __future__ import annotations

import random
from collections.abc import Iterator
from functools import partial

import yaml

Link = dict[str, object]
_BODY: Link = {"mass": 2, "com": [0.1, 0.02, 0.05], "inertia": {"xx": 0.02, "yy": 0.03, "zz": 0.04}}


def _turn(joint: object = "revolute", **numbers: object) -> Link:
    return {"joint": joint, **_BODY, **numbers}


_slide = partial(_turn, "prismatic")


def _without_mass(*links: Link) -> list[Link]:
    return [{k: v for k, v in link.items() if k not in ("mass", "com", "inertia")} for link in links]


_PLANAR = [_turn(), _turn(a=0.4), _turn(a=0.3)]
_GANTRY = [_slide(alpha="pi/2"), _slide(alpha="pi/2", theta="pi/2"), _slide(alpha="pi/2", theta="pi/2")]
_SCARA = [_turn(), _turn(a=0.4), _slide(a=0.3, alpha="pi"), _turn()]
_POINT: Link = {"mass": 1, "com": [0.2, 0, 0], "inertia": {}}
_ON_AXIS: Link = {"mass": 1, "com": [0, 0, 0.2], "inertia": {}}
_PENDULUM = _turn(alpha="pi/2")
_CHAIN = [_turn(a=0.1 * (k % 3), d=0.1, alpha=("pi/2", 0, "-pi/2")[k % 3]) for k in range(13)]

#: What is strange about an arm, and its links.
ARMS: dict[str, list[Link]] = {
    "vertical_axis": [_turn()],
    "pendulum": [_PENDULUM],
    "level_slide": [_slide(alpha="pi/2")],
    "lift": [_slide()],
    "gantry": _GANTRY,
    "table": _GANTRY[:2],
    "planar": _PLANAR,
    "two_planar": _PLANAR[:2],
    "scara": _SCARA,
    "massless": _without_mass(*_PLANAR[:2]),
    "rotors_alone": [{**link, "motor_inertia": 0.3} for link in _without_mass(*_PLANAR[:2])],
    "massless_tip": [_PENDULUM, *_without_mass(_turn(a=0.3))],
    "massless_first": [*_without_mass(_turn()), _turn(a=0.3, alpha="pi/2")],
    "point": [_turn(**{**_POINT, "alpha": "pi/2"})],
    "on_its_axis": [_turn(**_ON_AXIS)],
    "points_on_axes": [_turn(**_ON_AXIS), _turn(**_ON_AXIS, a=0.2, alpha="pi/2")],
    "turn_then_slide": [_PENDULUM, _slide(alpha="pi/2")],
    "slide_then_turn": [_slide(alpha="pi/2"), _turn(a=0.2)],
    "coaxial": [_turn(), _turn()],
    "coaxial_slides": [_slide(), _slide()],
    "long_chain": _CHAIN,
}


def arm_text(name: str, seed: int = 0) -> str:
    """The description of the arm ``name``; with a ``seed`` other than 0 varied by chance: friction, rotors,
    limits, gravity off, masses very small or large, an effect."""
    links = [dict(link) for link in ARMS[name]]
    robot: dict[str, object] = {"name": name, "links": links}
    if seed:
        _decorate(robot, links, random.Random(f"{name} {seed}"))
    return yaml.safe_dump(robot, sort_keys=False)


def strange_arms(seed: int = 0) -> Iterator[tuple[str, str]]:
    """Names and descriptions of all arms."""
    for name in ARMS:
        yield name, arm_text(name, seed)


def _decorate(robot: dict[str, object], links: list[Link], chance: random.Random) -> None:
    if chance.random() < 0.15:
        robot["gravity"] = chance.choice(([0, 0, 0], [9.81, 0, 0], [0, 0, -1e-9]))
    if chance.random() < 0.2:
        robot["torque_side"] = "link"
    if chance.random() < 0.3:
        robot["tool"] = {"xyz": [0.1, 0, 0.2]}
    if chance.random() < 0.2:
        robot["effects"] = [{"effect": "payload", "mass": chance.choice((0, 1, 1e-9)), "com": [0, 0, 0.1]}]
    size = chance.choice((1, 1, 1, 1e-6, 1e6))
    for link in links:
        if "mass" in link:
            link["mass"] = float(str(link["mass"])) * size
            link["inertia"] = {k: v * size for k, v in dict(link["inertia"]).items()}  # type: ignore[call-overload]
        if chance.random() < 0.4:
            link["motor_inertia"] = chance.choice((0.1, 1e-9, 50))
        if chance.random() < 0.4:
            link["friction"] = {"viscous": chance.choice((0, 0.3)), "coulomb": chance.choice((0, 0.5))}
        if chance.random() < 0.5:
            link["limits"] = {
                "position": chance.choice(([-1, 1], [-3, 3], [0.5, 0.5], [0, 1e-9], [-1e6, 1e6])),
                "velocity": chance.choice((2, 1e-9, 1e9)),
                "acceleration": 10,
                "torque": chance.choice((50, 1e-9)),
            }
        if chance.random() < 0.2:
            link["effects"] = [chance.choice(_EFFECTS)]


_EFFECTS: tuple[dict[str, object], ...] = (
    {"effect": "spring", "stiffness": 20, "rest": 0},
    {"effect": "stribeck_friction", "level": 1, "static": 2, "velocity": 0.1},
    {"effect": "torque_bias", "bias": 0.3},
    {"effect": "torque_gain", "gain": -1},
    {"effect": "encoder_offset", "offset": 0.1},
    {"effect": "torque_saturation", "limit": 3},
    {"effect": "backlash", "gap": 0.01, "encoder": "motor"},
    {"effect": "joint_elasticity", "stiffness": 1e4, "damping": 2, "encoder": "motor"},
    {"effect": "time_delay", "delay": 0.004},
    {"effect": "torque_ripple", "amplitude": 0.4, "cycles_per_rev": 6, "phase": 0},
)
