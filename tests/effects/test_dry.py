"""What holds a joint at rest is known from the equation, not from the name."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction

import pytest

from effects.cases import CASES, draw
from robodyn.drives.drive import Acting, JointDrive, Layer
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.simulate.shape import elements_of, without_losses

_NOT_DRY = {
    "viscous_friction",
    "power_law_friction",
    "presliding_hysteresis",
    "spring",
    "torque_ripple",
    "gas_spring",
}


@pytest.mark.parametrize("name", [name for name in CASES if CASES[name].id != "rotor_inertia"])
def test_dry_or_not(name: str) -> None:
    case = CASES[name]
    values = draw(case, random.Random(name))
    expected = case.id not in _NOT_DRY
    assert case.effect.is_dry(values, revolute=case.revolute) is expected


def test_a_motor_of_two_joints_is_dry_by_its_level() -> None:
    effect = CATALOGUE["motor_coupling"]
    values = {"inertia": Fraction(1), "viscous": Fraction(1), "coulomb": Fraction(0)}
    assert not effect.is_dry(values, revolute=True)
    assert effect.is_dry({**values, "coulomb": Fraction(1, 100)}, revolute=True)


@pytest.mark.parametrize("id", ["coulomb_friction", "asymmetric_friction", "stribeck_friction"])
def test_a_copy_under_another_name_sticks(id: str) -> None:
    copy: Effect = replace(CATALOGUE[id], id="another")
    values = {p.name: Fraction(2) for p in copy.parameters}
    for place in ("link", "bearing", "gear", "motor"):
        side = (Acting(copy, values),)
        drive = JointDrive(True, **{place: side})
        assert [element.what for element in elements_of(Layer((drive,)), (), 1)] == ["joint 1"]
        end = "link 1" if place in ("link", "bearing") else "motor 1"
        assert [element.what for element in elements_of(Layer((drive,)), (0,), 2)] == [end]


def test_what_is_kept_without_losses_has_a_potential() -> None:
    acting = {id: Acting(CATALOGUE[id], {}) for id in ("spring", "viscous_friction", "torque_ripple")}
    drive = JointDrive(
        True,
        link=(acting["spring"], acting["viscous_friction"]),
        motor=(acting["viscous_friction"], acting["torque_ripple"]),
        viscous=1,
    )
    (kept,) = without_losses(Layer((drive,))).joints
    assert [one.effect.id for one in kept.link + kept.motor] == ["spring", "torque_ripple"]
    assert kept.viscous == 0
