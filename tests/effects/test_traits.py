"""Traits name effects and parameters that there are, and say what the equations say; what holds a joint at
rest is known from the equation, not from the name."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction

import numpy as np
import pytest

from effects.cases import CASES, draw, sites, stacked
from robodyn.drives.drive import Acting, JointDrive, Layer
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.effects.traits import Dahl, Form, Law, Twist, Usual
from robodyn.robot.model import Joint
from robodyn.simulate.shape import without_losses

JOINTS = (
    Usual(2, 3, True, 4.0, 10.0, 20.0, 45.0, 1.0, 3.0, 0.1, 0.8, 0.2),
    Usual(2, 3, False, 4.0, 10.0, 90.0, 200.0, 0.3, 1.0, 0.02, 6.0, 0.5),
)


def others(effect: Effect) -> Iterator[str]:
    """Ids that the traits of ``effect`` name."""
    traits = effect.traits
    yield from (*traits.contains, *traits.absorbs, *traits.one_law_with)
    if traits.steady is not None:
        yield traits.steady[0]
    if traits.limit is not None:
        yield traits.limit.id


def parameters(effect: Effect) -> Iterator[str]:
    """Parameters that the traits of ``effect`` name."""
    traits = effect.traits
    yield from (*traits.levels, *traits.adds, *traits.chosen, *traits.nothing)
    if traits.twist:
        yield traits.twist
    if traits.cycles:
        yield traits.cycles
    if traits.steady is not None:
        yield from traits.steady[1]
    if traits.fold is not None and traits.fold.parameter:
        yield traits.fold.parameter
    if traits.channel is not None:
        yield traits.channel.parameter
        yield from (traits.channel.who,) if traits.channel.who else ()
    for way in traits.candidates:
        if isinstance(way, Dahl):
            yield from (way.level, way.stiffness)
        if isinstance(way, Twist):
            yield from (*way.reach, *way.fixed, *(name for values in way.ahead for name in values))


@pytest.mark.parametrize("id", CATALOGUE)
def test_names_are_those_of_the_catalogue(id: str) -> None:
    effect = CATALOGUE[id]
    assert set(others(effect)) <= set(CATALOGUE) - {id}
    assert set(parameters(effect)) <= set(effect.names)
    assert set(effect.rivals) <= set(CATALOGUE) - {id}
    fold = effect.traits.fold
    if fold is not None and fold.into == "joint":
        assert fold.key in Joint.__slots__
    assert (effect.place == "sensor") == (effect.traits.channel is not None)
    # A contact is looked for by itself: where in time the residual bursts.
    assert bool(effect.traits.candidates) == (effect.place != "outside")


@pytest.mark.parametrize("joint", JOINTS, ids=["revolute", "prismatic"])
@pytest.mark.parametrize("id", CATALOGUE)
def test_what_is_hidden_is_a_size_of_the_effect(id: str, joint: Usual) -> None:
    hidden = CATALOGUE[id].traits.hidden
    assert hidden is not None
    form: Form = hidden.form(joint, -1.0, np.random.default_rng(3))
    assert 0 < form.least <= form.start <= form.most
    one, other = form.build(form.start), form.build(1.1 * form.start)
    known = {*CATALOGUE[id].names, "com_x", "com_y", "com_z"}
    assert set(one) == set(other) <= known
    assert one != other


LAWS = [
    (name, way)
    for name, case in CASES.items()
    for way in case.effect.traits.candidates
    if isinstance(way, Law) and not CASES[name].effect.needs_load
]


@pytest.mark.parametrize(("name", "law"), LAWS, ids=[name for name, _ in LAWS])
def test_columns_are_the_equation(name: str, law: Law) -> None:
    """Columns times numbers are the torque with the parameters that are read from those numbers."""
    effect = CASES[name].effect
    at, _ = stacked(sites(random.Random(name), 30))
    assert effect.equation is not None
    for given in law.grid:
        x = np.array([2.0, *(0.5 for _ in law.signs[1:])])
        columns = law.columns(given, at)
        assert len(columns) == len(law.signs)
        defaults = {p.name: p.default for p in effect.parameters if p.default is not None}
        torque = effect.equation({**defaults, **law.read(x, given)}, at)
        expected = sum(k * np.asarray(column, float) for k, column in zip(x, columns, strict=True))
        np.testing.assert_allclose(np.asarray(torque, float), expected, rtol=1e-12, atol=1e-12)


# --- what holds a joint at rest ---------------------------------------------------------------------------

_NOT_DRY = (
    "viscous_friction", "power_law_friction", "presliding_hysteresis", "spring", "torque_ripple",
    "gas_spring",
)  # fmt: skip


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
