"""What stands in for a reference that nobody has written: an equation as it is printed, or an error."""

from __future__ import annotations

import random
from dataclasses import replace

import numpy as np
import pytest

from effects.cases import CASES, draw, floats, sites, stacked
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.verify import declared
from robodyn.verify.declared import NoReferenceError, declared_torque
from robodyn.verify.effects import _symbols, added_torque, place_of
from robodyn.verify.stateful import twist

#: What is printed as ``tau = ...``.
PRINTED = ("viscous", "coulomb", "asymmetric", "stribeck", "power law, thinning", "spring", "ripple")


@pytest.mark.parametrize("name", PRINTED)
def test_what_is_printed_is_the_reference_written_by_hand(name: str) -> None:
    case, rng = CASES[name], random.Random(name)
    for _ in range(5):
        p = floats(draw(case, rng))
        _, at = stacked(sites(rng, 40))
        at = replace(at, **{x: np.asarray(getattr(at, x), float) for x in ("q", "qd", "qdd", "way", "tau")})
        expected = added_torque(case.id, p, at)
        assert np.abs(expected).max() > 0
        assert declared_torque(case.id, p, _symbols(at)) == pytest.approx(expected, rel=1e-12, abs=1e-12)


def test_places_are_those_of_the_definitions() -> None:
    assert {id: place_of(id) for id in CATALOGUE} == {id: each.place for id, each in CATALOGUE.items()}


def unknown(monkeypatch: pytest.MonkeyPatch, known: Effect) -> str:
    """The id of the effect, which only :mod:`.declared` has heard of."""
    monkeypatch.setattr(declared, "effect", {known.id: known}.__getitem__)
    return known.id


def test_an_unknown_effect_is_never_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    _, at = stacked(sites(random.Random(1), 9))
    viscous = CATALOGUE["viscous_friction"]
    drag = replace(viscous, id="drag", latex=r"\tau = F_v \dot q |\dot q|")
    id = unknown(monkeypatch, drag)
    assert place_of(id) == "motor"
    found = added_torque(id, {"coefficient": 3.0}, at)
    assert found == pytest.approx(np.asarray(3.0 * at.qd * np.abs(at.qd), float))
    for latex in (r"\tau \text{ is small}", r"\tau = F_v \dot w", r"T = F_v \dot q"):
        id = unknown(monkeypatch, replace(drag, latex=latex))
        with pytest.raises(NoReferenceError, match="no reference for drag"):
            added_torque(id, {"coefficient": 3.0}, at)


@pytest.mark.parametrize("id", ["presliding_hysteresis", "backlash", "motor_coupling", "payload"])
def test_more_than_an_equation_needs_a_reference(monkeypatch: pytest.MonkeyPatch, id: str) -> None:
    id = unknown(monkeypatch, replace(CATALOGUE[id], id=f"another_{id}"))
    with pytest.raises(NoReferenceError, match=f"no reference for {id}"):
        place_of(id)


def test_another_twist_needs_a_reference() -> None:
    with pytest.raises(NoReferenceError):
        twist("another", {"stiffness": 1.0}, np.ones(1))


def test_cases_over_arrays() -> None:
    from robodyn.verify.declared import ARRAYS, value

    latex = r"\begin{cases} 2 a & a > 1 \\ -a & a \le 1 \end{cases}"
    assert value(latex, {"a": np.array([0.5, 1.0, 3.0])}, ARRAYS).tolist() == [-0.5, -1.0, 6.0]
    with pytest.raises(SyntaxError, match="no case"):
        value(r"\begin{cases} a & a > 1 \end{cases}", {"a": np.array([0.5, 3.0])}, ARRAYS)
