"""Units: the same thing measured in other units gives the same torque in other units."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

import pytest

from effects.cases import CASES, Case, draw, floats, mapped, site
from robodyn.effects.effect import Effect, Site

_UNITS = {"N": {"kg": 1, "m": 1, "s": -2}, "kg": {"kg": 1}, "m": {"m": 1}, "s": {"s": 1}, "rad": {"rad": 1}}
_SCALES = {"kg": 4.0, "m": 16.0, "s": 0.25, "rad": 64.0}
#: Where the angle is in a sine, or an inertia makes a torque of its acceleration, rad is 1.
_ANGLE_IS_A_NUMBER = {"torque_ripple", "rotor_inertia", "gas_spring"}


def factor(unit: str, scales: dict[str, float]) -> float:
    """What the number before ``unit`` becomes in units that are smaller by ``scales``."""
    total = 1.0
    for part, sense in zip(unit.split("/"), (1, -1), strict=False):
        for token in part.split():
            base, _, power = token.partition("^")
            for name, exponent in {} if base == "1" else _UNITS[base].items():
                total *= scales[name] ** (exponent * int(power or 1) * sense)
    return total


def in_smaller_units(
    found: Effect, values: dict[str, Any], at: Site
) -> tuple[dict[str, Any], Site, dict[str, float]]:
    number = found.id in _ANGLE_IS_A_NUMBER or values.get("inertia", 0) != 0
    scales = _SCALES | ({"rad": 1.0} if number else {})
    units = {p.name: p.unit_at(revolute=at.revolute) for p in found.parameters if p.kind == "number"}
    scaled = {k: v * factor(units[k], scales) if k in units else v for k, v in values.items()}
    way, force = ("rad", "N m") if at.revolute else ("m", "N")
    position, moment = factor(way, scales), factor("N m", scales)
    moved = replace(
        at,
        q=at.q * position,
        qd=at.qd * position / scales["s"],
        qdd=at.qdd * position / scales["s"] ** 2,
        tau=at.tau * factor(force, scales),
        f=tuple(x * factor("N", scales) for x in at.f),
        n=tuple(x * moment for x in at.n),
    )
    return scaled, moved, scales


def units_fit(case: Case, found: Effect, revolute: bool, rng: random.Random) -> bool:
    """Whether the numbers of the same thing in other units give the number of the same torque."""
    assert found.equation is not None
    values, at = floats(draw(case, rng)), mapped(site(rng, revolute=revolute), float)
    if case.id == "motor_coupling" and rng.random() < 0.5:
        values["inertia"] = 0.0
    scaled, moved, scales = in_smaller_units(found, values, at)
    expected = found.equation(values, at) * factor("N m" if revolute else "N", scales)
    return bool(found.equation(scaled, moved) == pytest.approx(expected, rel=1e-12))


@pytest.mark.parametrize("name", CASES)
def test_units(name: str) -> None:
    case, rng = CASES[name], random.Random(name)
    for revolute in (True, False):
        if case.revolute if revolute else case.prismatic:
            assert all(units_fit(case, case.effect, revolute, rng) for _ in range(5))
