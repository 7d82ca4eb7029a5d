"""Random effects at the joints of a robot: valid by the catalogue, the same for the same seed.

Every number is a short decimal, as if read from a file, of a size that an arm of some kilograms may have.
Nothing is drawn that reading would put into the numbers of the rigid arm.
"""

from __future__ import annotations

import random
from collections.abc import Collection
from dataclasses import replace
from fractions import Fraction
from typing import Any, Final

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect, Parameter
from robodyn.robot.effects import default_of
from robodyn.robot.model import EffectEntry, Inertia, Robot
from robodyn.robot.values import Value, parameter

__all__ = ["FOLDED", "with_random_effects"]

#: Effects that reading puts into the numbers of the rigid arm.
FOLDED: Final = frozenset(
    {"viscous_friction", "coulomb_friction", "rotor_inertia", "inertial_error", "base_tilt"}
)
_SIZES: Final = {"N m/rad": 400, "N/m": 4000, "N m": 5, "N": 20, "rad": 0.5, "m": 0.05, "s": 0.01}


def with_random_effects(
    robot: Robot,
    seed: int,
    *,
    ids: Collection[str] = tuple(CATALOGUE),
    share: float = 0.2,
    names: float = 0.0,
) -> Robot:
    """``robot`` with random effects of the ``ids``, each at a joint with the probability ``share``.

    ``names`` is the probability that a number which may be a run-time parameter is one.
    """
    rng, effects = random.Random(seed), list[EffectEntry]()
    for joint in (*range(1, robot.n + 1), None):
        for id, effect in CATALOGUE.items():
            fits = id in ids and id not in FOLDED and (effect.level == "robot") == (joint is None)
            if fits and rng.random() < share and (entry := _entry(rng, robot, effect, joint, names)):
                effects.append(entry)
    elastic = {entry.joint for entry in effects if entry.effect == "joint_elasticity"}
    both = [entry for entry in effects if entry.effect == "backlash" and entry.joint in elastic]
    return replace(robot, effects=tuple(entry for entry in effects if entry not in both))


def _entry(
    rng: random.Random, robot: Robot, effect: Effect, joint: int | None, names: float
) -> EffectEntry | None:
    """None where the effect is not possible there."""
    revolute = joint is None or robot.links[joint - 1].joint.kind == "revolute"
    others = [k for k in range(1, robot.n + 1) if k != joint]
    if not others and any(p.kind == "joint" for p in effect.parameters):
        return None
    for _ in range(500):
        values: dict[str, Any] = {}
        for p in effect.parameters:
            if p.optional and rng.random() < 0.5:
                continue
            keep = p.default is not None and rng.random() < 0.3
            values[p.name] = default_of(p) if keep else _value(rng, p, revolute, others, names)
        ordered = effect.id != "external_contact" or values["start"] < values["end"]
        if ordered and effect.check(values, revolute) is None:
            return EffectEntry(effect.id, joint, tuple(values.items()))
    if effect.id == "gas_spring" and not revolute:
        return None
    raise AssertionError(f"no valid values found for {effect.id}")


def _value(rng: random.Random, p: Parameter, revolute: bool, others: list[int], names: float) -> Any:
    if p.kind == "choice":
        return rng.choice(p.choices)
    if p.kind == "joint":
        return rng.choice(others)
    if p.kind == "text":
        return rng.choice(["null", "a: b, {c}", '"quoted" \\', "# 12ab"])
    if p.kind == "efficiency":
        if rng.random() < 0.4:
            return Fraction(rng.randint(30, 100), 100)
        loads = sorted(rng.sample(range(150), rng.randint(2, 5)))
        return tuple((Fraction(x, 100), Fraction(rng.randint(30, 100), 100)) for x in loads)
    if p.kind == "vector":
        return tuple(_number(rng, p, revolute, names) for _ in range(3))
    if p.kind == "inertia":
        a, b = Fraction(rng.randint(1, 9), 1000), Fraction(rng.randint(1, 9), 1000)
        return Inertia(a, b, a + b)
    return _number(rng, p, revolute, names)


def _number(rng: random.Random, p: Parameter, revolute: bool, names: float) -> Value:
    if p.names and rng.random() < names:
        return parameter(f"{p.name}_{rng.randint(1, 3)}")
    size = Fraction(str(_SIZES.get(p.unit_at(revolute=revolute), 1)))
    value = size * rng.randint(1, 1000) / 1000
    return -value if p.sign == "any" and rng.random() < 0.5 else value
