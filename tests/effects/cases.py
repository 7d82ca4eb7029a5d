"""Random numbers for the effects of the catalogue, and entries of robots with them."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import dataclass, fields
from fractions import Fraction
from typing import Any, Final

import numpy as np

from robodyn.effects.catalogue import effect
from robodyn.effects.effect import Effect, Parameter, Site
from robodyn.robot.model import EffectEntry
from robodyn.robot.values import ZERO
from robodyn.verify.effects import State

RANDOM: Final = object()
"""Stands for a random number of an optional parameter."""

KNOTS: Final = tuple(
    (Fraction(x, 64), Fraction(y, 64)) for x, y in ((1, 20), (8, 44), (20, 52), (33, 50), (40, 50), (60, 62))
)


@dataclass(frozen=True, slots=True)
class Case:
    """An effect with what is not drawn at random, and the joints that it fits."""

    id: str
    fixed: Mapping[str, Any]
    revolute: bool = True
    prismatic: bool = True
    rational: bool = True

    @property
    def effect(self) -> Effect:
        return effect(self.id)


def _case(
    id: str, rational: bool = True, revolute: bool = True, prismatic: bool = True, **fixed: Any
) -> Case:
    return Case(id, fixed, revolute, prismatic, rational)


def _bearing(kind: str, rational: bool = True, **more: Any) -> Case:
    joints = {"revolute": kind != "linear", "prismatic": kind in ("linear", "torque")}
    names = () if "mu_r" in more else ("mu",) if kind in ("linear", "torque") else ("mu", "radius")
    given = dict.fromkeys(names, RANDOM)
    return _case("load_dependent_friction", rational, **joints, bearing=kind, **given, **more)


def _table(interpolation: str, knots: Any = KNOTS) -> Case:
    return _case("transmission_loss", efficiency=knots, interpolation=interpolation, rated_torque=RANDOM)


#: Everything that has an equation of the torque of a drive.
CASES: Final = {
    "viscous": _case("viscous_friction"),
    "coulomb": _case("coulomb_friction"),
    "asymmetric": _case("asymmetric_friction"),
    "stribeck": _case("stribeck_friction", rational=False, exponent=Fraction(2)),
    "stribeck, sharp": _case("stribeck_friction", rational=False, exponent=Fraction(7, 5)),
    "power law, thinning": _case("power_law_friction", rational=False, exponent=Fraction(1, 2)),
    "power law, thickening": _case("power_law_friction", rational=False, exponent=Fraction(7, 4)),
    "presliding": _case("presliding_hysteresis"),
    "journal": _bearing("journal", rational=False, span=RANDOM),
    "journal, printed": _bearing("journal", rational=False, span=RANDOM, variant="printed"),
    "journal, product": _bearing("journal", rational=False, span=RANDOM, mu_r=RANDOM),
    "journal, short": _bearing("journal", rational=False),
    "radial": _bearing("radial", rational=False),
    "radial, product": _bearing("radial", rational=False, mu_r=RANDOM),
    "thrust": _bearing("thrust"),
    "linear": _bearing("linear", span=RANDOM),
    "torque": _bearing("torque"),
    "efficiency": _case("transmission_loss", efficiency=Fraction(45, 64)),
    "breakaway": _case("transmission_loss", efficiency=Fraction(1)),
    "efficiencies, one": _table("linear", KNOTS[:1]),
    "efficiencies, two": _table("cubic", (KNOTS[0], KNOTS[-1])),
    "efficiencies, linear": _table("linear"),
    "efficiencies, cubic": _table("cubic"),
    "spring": _case("spring"),
    "gas spring": _case("gas_spring", rational=False, prismatic=False, ratio=Fraction(1, 4)),
    "gas spring that pushes": _case("gas_spring", rational=False, prismatic=False, ratio=Fraction(-5, 8)),
    "spring balancer": _case("gas_spring", rational=False, prismatic=False, ratio=ZERO),
    "ripple": _case("torque_ripple", rational=False),
    "coupling": _case("motor_coupling", **{"with": 2}),
    "rotor": _case("rotor_inertia"),
}

COUPLERS: Final = {"joint_elasticity": _case("joint_elasticity"), "backlash": _case("backlash")}


def draw(case: Case, rng: random.Random) -> dict[str, Any]:
    """Parameters of ``case``: exact numbers that are doubles too."""
    found: dict[str, Any] = {}
    for parameter in case.effect.parameters:
        given = case.fixed.get(parameter.name)
        if given is None and parameter.optional:
            continue
        if given is not None and given is not RANDOM:
            found[parameter.name] = given
        elif parameter.kind == "choice":
            found[parameter.name] = parameter.default
        else:
            found[parameter.name] = _number(parameter, rng)
    if case.id == "stribeck_friction":
        found["static"] += found["level"]
    if "rated_torque" in found:
        found["rated_torque"] += 3  # so that a site's torque is often between the knots
    return found


def _number(parameter: Parameter, rng: random.Random) -> Fraction:
    size = Fraction(rng.randint(1, 150), 64)
    return size if parameter.sign != "any" or rng.random() < 0.5 else -size


def site(rng: random.Random, *, revolute: bool = True, smooth: bool = False) -> Site:
    """A random site; ``smooth``: a direction between -1 and 1."""

    def number(far: int) -> Fraction:
        return Fraction(rng.randint(-64 * far, 64 * far), 64)

    qd = number(3)
    way = (qd > 0) - (qd < 0)
    direction = Fraction(way * rng.randint(0, 64), 64) if smooth else Fraction(way)
    f, n = ((number(50), number(50), number(50)) for _ in range(2))
    return Site(revolute, number(3), qd, number(9), direction, number(5), f, n)


def sites(rng: random.Random, count: int, *, revolute: bool = True) -> list[Site]:
    """Random sites: in motion, some with a smoothed direction, the last two at rest and without a load."""
    found = [site(rng, revolute=revolute, smooth=i % 3 == 0) for i in range(count - 2)]
    still = Site(revolute, Fraction(1), ZERO, Fraction(1), ZERO, Fraction(2), found[0].f, found[0].n)
    return [*found, still, Site(revolute, direction=Fraction(1), qd=Fraction(1))]


def mapped(at: Site, number: Any) -> Site:
    """``at`` with ``number`` applied to every scalar."""

    def scalar(value: Any) -> Any:
        if isinstance(value, tuple):
            return tuple(number(x) for x in value)
        return value if isinstance(value, bool) else number(value)

    return Site(*(scalar(getattr(at, field.name)) for field in fields(Site)))


def floats(values: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters with doubles for exact numbers."""

    def plain(value: Any) -> Any:
        if isinstance(value, tuple):
            return tuple(plain(x) for x in value)
        return float(value) if isinstance(value, Fraction) else value

    return {name: plain(value) for name, value in values.items()}


def stacked(at: list[Site]) -> tuple[Site, State]:
    """Sites as one of arrays: for the catalogue, and for the reference."""

    def array(name: str) -> Any:
        return np.array([getattr(each, name) for each in at], dtype=np.float64)

    q, qd, qdd, way, tau, f, n = (array(x) for x in ("q", "qd", "qdd", "direction", "tau", "f", "n"))
    together = Site(at[0].revolute, q, qd, qdd, way, tau, tuple(f.T), tuple(n.T))  # type: ignore[arg-type]
    return together, State(q, qd, qdd, way, tau, f, n)


def entry(id: str, joint: int | None, **given: Any) -> EffectEntry:
    """An entry of a robot, defaults filled in as the reader of descriptions does."""
    settings = []
    for parameter in effect(id).parameters:
        value = given.pop(parameter.name, parameter.default)
        if parameter.kind == "vector" and value == ZERO:
            value = (ZERO, ZERO, ZERO)
        if value is not None:
            settings.append((parameter.name, value))
    assert not given, f"{id} has no {', '.join(given)}"
    return EffectEntry(id, joint, tuple(settings))
