"""Every effect of the catalogue, with its options, put on an arm."""

from __future__ import annotations

import copy
import random
from collections.abc import Callable, Mapping
from typing import Any, Final

from independent.arms import Arm

Put = Callable[[Arm, random.Random], Arm | None]

KNOTS: Final = [[0.02, 0.31], [0.1, 0.55], [0.3, 0.7], [0.55, 0.78], [0.8, 0.9]]


def _on_links(kinds: str, make: Callable[[random.Random], dict[str, Any]]) -> Put:
    """An entry with numbers of its own on every joint of ``kinds``."""

    def put(arm: Arm, rng: random.Random) -> Arm | None:
        fitting = [link for link in arm["links"] if link["joint"][0].upper() in kinds]
        for link in fitting:
            link.setdefault("effects", []).append(make(rng))
        return arm if fitting else None

    return put


def _entry(effect: str, kinds: str = "RP", **ranges: Any) -> Put:
    """Numbers drawn from ``(low, high)``, and what else the entry says."""

    def make(rng: random.Random) -> dict[str, Any]:
        entry: dict[str, Any] = {"effect": effect}
        for key, value in ranges.items():
            entry[key] = round(rng.uniform(*value), 4) if isinstance(value, tuple) else value
        return entry

    return _on_links(kinds, make)


def _bearing(bearing: str, kinds: str, **more: Any) -> Put:
    return _entry("load_dependent_friction", kinds, bearing=bearing, **more)


def _loss(**more: Any) -> Put:
    return _entry("transmission_loss", **more)


def _of_robot(**entry: Any) -> Put:
    def put(arm: Arm, _: random.Random) -> Arm:
        arm.setdefault("effects", []).append(dict(entry))
        return arm

    return put


def _coupling(arm: Arm, rng: random.Random) -> Arm | None:
    if len(arm["links"]) < 2:
        return None
    last = len(arm["links"])
    for first, second in {(1, 2), (last - 1, last)}:
        entry = {"effect": "motor_coupling", "with": second, "ratio": round(rng.uniform(-2, 2), 3)}
        entry |= {x: round(rng.uniform(0.1, 1), 3) for x in ("inertia", "viscous", "coulomb")}
        arm["links"][first - 1].setdefault("effects", []).append(entry)
    return arm


def _friction(arm: Arm, rng: random.Random) -> Arm:
    for link in arm["links"]:
        link["friction"] = {x: round(rng.uniform(0.3, 3), 3) for x in ("viscous", "coulomb")}
    return arm


def _named(keys: Mapping[str, tuple[str, ...]]) -> Put:
    """Names in the place of numbers of the last link, and of effects; ``values`` has the numbers. The length
    of the last row of standard DH places the tool, which has no names: there it is that of the row before."""

    def name_numbers(link: Any, key: str, inner: tuple[str, ...], values: dict[str, Any]) -> None:
        table = link[key] if inner else link
        for name in inner or (key,):
            values[f"p_{key}_{name}".replace(f"_{key}_{key}", f"_{key}")] = table[name]
            table[name] = f"p_{key}_{name}".replace(f"_{key}_{key}", f"_{key}")

    def put(arm: Arm, _: random.Random) -> Arm:
        values = arm.setdefault("values", {})
        for key, inner in keys.items():
            before = key == "a" and arm["convention"] == "sdh"
            for link in arm["links"][:-1][-1:] if before else arm["links"][-1:]:
                name_numbers(link, key, inner, values)
        for number, entry in enumerate([*arm["links"][-1].get("effects", ()), *arm.get("effects", ())]):
            for name, value in entry.items():
                if isinstance(value, float) and (entry["effect"], name) not in _NUMBERS:
                    values[f"p{number}_{name}"] = value
                    entry[name] = f"p{number}_{name}"
        return arm

    return put


def _together(*puts: Put, **keys: Any) -> Put:
    """Several effects at once, and keys of the description."""

    def put(arm: Arm, rng: random.Random) -> Arm | None:
        found = [p(arm, rng) is not None for p in puts]
        arm.update(keys)
        return arm if any(found) or not puts else None

    return put


_NUMBERS: Final = {
    ("torque_ripple", "phase"),
    ("torque_ripple", "cycles_per_rev"),
    ("stribeck_friction", "exponent"),
    ("motor_coupling", "ratio"),
    ("gas_spring", "ratio"),
}
"""What may be no name."""
_INERTIAL: Final[dict[str, tuple[str, ...]]] = {
    "mass": (),
    "motor_inertia": (),
    "inertia": ("xx", "yz"),
    "friction": ("viscous", "coulomb"),
}
_WEIGHT: Final = {"xx": 0.02, "yy": 0.03, "zz": 0.025, "xy": 0.004, "xz": -0.003, "yz": 0.005}
_PAYLOAD: Final = {"mass": 1.7, "com": [0.06, -0.04, 0.13], "inertia": _WEIGHT}
_ALL_DRIVES: Final = (
    _friction,
    _entry("spring", stiffness=(5, 30), rest=(-1, 1), cubic=(1, 5)),
    _entry("torque_ripple", amplitude=(0.5, 2), cycles_per_rev=(3, 12), phase=(-1, 1)),
    _coupling,
    _of_robot(effect="payload", **_PAYLOAD),
)
_STRIBECK: Final[dict[str, Any]] = {"level": (1, 2), "static": (3, 5), "velocity": (0.4, 1)}
_JOURNAL: Final[dict[str, Any]] = {"mu": (0.05, 0.2), "radius": (0.03, 0.1), "span": (0.1, 0.4)}
_ELASTIC: Final[dict[str, Any]] = {"stiffness": (300, 600), "damping": (10, 15)}
_TEETH: Final[dict[str, Any]] = {**_ELASTIC, "gap": (0.002, 0.01), "transition": (1, 3)}
_ERRORS: Final[dict[str, Any]] = {
    "delta_mass": (0.1, 0.5),
    **{f"delta_com_{axis}": (-0.05, 0.05) for axis in "xyz"},
    **{f"delta_{axes}": (0.01, 0.02) for axes in ("xx", "yy", "zz")},
    **{f"delta_{axes}": (-0.002, 0.002) for axes in ("xy", "xz", "yz")},
}
_SMOOTH: Final = {"smooth": {"velocity": 0.4}}
_DEAD: Final = {"dead_band": {"velocity": 0.05}}

CASES: Final[dict[str, Put]] = {
    "rigid": lambda arm, _: arm,
    "viscous_friction": _entry("viscous_friction", coefficient=(0.3, 3)),
    "coulomb_friction": _entry("coulomb_friction", level=(0.3, 3)),
    "friction (shorthand)": _friction,
    "asymmetric_friction": _entry("asymmetric_friction", positive=(1, 3), negative=(0.3, 2)),
    "stribeck_friction": _entry("stribeck_friction", **_STRIBECK),
    "stribeck_friction, exponent": _entry("stribeck_friction", exponent=1.3, **_STRIBECK),
    "power_law_friction": _entry("power_law_friction", level=(1, 3)),
    "power_law_friction, exponent": _entry(
        "power_law_friction", level=(1, 3), exponent=(1.2, 1.9), velocity=(0.5, 2)
    ),
    "presliding_hysteresis": _entry(
        "presliding_hysteresis", stiffness=(200, 400), level=(1, 3), damping=(0.1, 1)
    ),
    "load_dependent_friction, journal": _bearing("journal", "R", **_JOURNAL),
    "load_dependent_friction, printed": _bearing("journal", "R", variant="printed", **_JOURNAL),
    "load_dependent_friction, short": _bearing("journal", "R", mu=(0.05, 0.2), radius=(0.03, 0.1)),
    "load_dependent_friction, linear": _bearing("linear", "P", mu=(0.05, 0.2), span=(0.1, 0.4)),
    "load_dependent_friction, thrust": _bearing("thrust", "R", mu=(0.05, 0.2), radius=(0.03, 0.1)),
    "load_dependent_friction, radial": _bearing("radial", "R", mu_r=(0.003, 0.02)),
    "load_dependent_friction, torque": _bearing("torque", "RP", mu=(0.05, 0.2)),
    "transmission_loss, breakaway": _loss(breakaway=(0.5, 3)),
    "transmission_loss, number": _loss(breakaway=(0.5, 3), efficiency=(0.5, 0.9)),
    "transmission_loss, linear": _loss(breakaway=(0.5, 3), efficiency=KNOTS, rated_torque=(40, 90)),
    "transmission_loss, cubic": _loss(efficiency=KNOTS, rated_torque=(40, 90), interpolation="cubic"),
    "spring": _entry("spring", stiffness=(-5, 30), rest=(-1, 1)),
    "spring, cubic": _entry("spring", stiffness=(5, 30), rest=(-1, 1), cubic=(1, 5)),
    "joint_elasticity": _entry("joint_elasticity", **_ELASTIC),
    "joint_elasticity, link": _entry("joint_elasticity", encoder="link", **_ELASTIC),
    "backlash": _entry("backlash", **_TEETH),
    "backlash, link": _entry("backlash", encoder="link", **_TEETH),
    "gas_spring": _entry("gas_spring", "R", torque=(20, 60), dead_center=(-1, 1), rise=(0.1, 0.5)),
    "gas_spring, pushing": _entry("gas_spring", "R", torque=(20, 60), rise=(0.1, 0.5), ratio=(-0.6, -0.2)),
    "rotor_inertia": _entry("rotor_inertia", inertia=(0.2, 1)),
    "torque_ripple": _entry("torque_ripple", amplitude=(0.5, 2), cycles_per_rev=(3, 12), phase=(-1, 1)),
    "motor_coupling": _coupling,
    "payload": _of_robot(effect="payload", **_PAYLOAD),
    "inertial_error": _entry("inertial_error", **_ERRORS),
    "base_tilt": _of_robot(effect="base_tilt", tilt_x=0.21, tilt_y=-0.34),
    "external_contact": _of_robot(effect="external_contact", start=0, end=1, link=1, force_x=30),
    "torque_bias": _entry("torque_bias", bias=(1, 3)),
    "torque_gain": _entry("torque_gain", gain=(0.1, 0.3)),
    "time_delay": _entry("time_delay", delay=(0.001, 0.01)),
    "encoder_offset": _entry("encoder_offset", offset=(0.01, 0.1)),
    "torque_saturation": _entry("torque_saturation", limit=(10, 30)),
    # several at once, and options of the description
    "drives together": _together(*_ALL_DRIVES),
    "drives together, smooth": _together(*_ALL_DRIVES, friction_at_rest=_SMOOTH),
    "drives together, link side": _together(*_ALL_DRIVES, torque_side="link"),
    "friction, smooth": _together(_friction, friction_at_rest=_SMOOTH),
    "friction, dead band": _together(_friction, friction_at_rest=_DEAD),
    "asymmetric_friction, smooth": _together(
        _entry("asymmetric_friction", positive=(1, 3), negative=(0.3, 2)), friction_at_rest=_SMOOTH
    ),
    "stribeck_friction, smooth": _together(
        _entry("stribeck_friction", **_STRIBECK), friction_at_rest=_SMOOTH
    ),
    "bearing and loss": _together(
        _entry("spring", stiffness=(5, 30), rest=(-1, 1)),
        _bearing("torque", "RP", mu=(0.05, 0.2)),
        _loss(efficiency=(0.5, 0.9)),
        _friction,
    ),
    "loss, smooth": _together(_loss(breakaway=(0.5, 3), efficiency=(0.5, 0.9)), friction_at_rest=_SMOOTH),
    "rigid, link side": _together(torque_side="link"),
    "names": _together(_friction, _named(_INERTIAL)),
    "names, lengths": _together(_friction, _named({**_INERTIAL, "a": (), "d": ()})),
    "names, drives together": _together(
        _entry("stribeck_friction", **_STRIBECK),
        *_ALL_DRIVES,
        _named(_INERTIAL),
    ),
    "names, load": _together(_bearing("torque", "RP", mu=(0.05, 0.2)), _loss(breakaway=(0.5, 3)), _named({})),
    "payload and tilt": _together(
        _of_robot(effect="payload", **_PAYLOAD), _of_robot(effect="base_tilt", tilt_x=0.21, tilt_y=-0.34)
    ),
}


def with_case(arm: Arm, name: str) -> Arm | None:
    """A copy of ``arm`` with the effect; None where none of its joints takes it."""
    return CASES[name](copy.deepcopy(arm), random.Random(f"{name} {arm['name']}"))
