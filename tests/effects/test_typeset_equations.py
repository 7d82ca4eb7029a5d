"""The equations as typeset are those that are computed, also where sgn is smoothed or has a dead band."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from effects.cases import CASES, draw, floats, stacked
from effects.typeset_effects import typeset
from robodyn.dynamics.joints import smoothed_sign
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Site
from robodyn.effects.efficiency import efficiency_at
from robodyn.verify.declared import value
from robodyn.verify.effects import added_torque, direction

REST = {"exact": (None, None), "smooth": (0.25, None), "dead band": (None, 0.25)}
FRICTION = [
    name for name, case in CASES.items()
    if case.effect.dissipative and not name.startswith(("journal, printed", "journal, short"))
]  # fmt: skip


def sense(speed: float, rest: str) -> float:
    """sgn as the page of effects says it: exact, tanh of velocity over v, or 0 below v and half at v."""
    smooth, band = REST[rest]
    plain = float((speed > 0) - (speed < 0))
    if smooth is not None:
        return math.tanh(speed / smooth)
    if band is not None and abs(speed) <= band:
        return plain / 2 if abs(speed) == band else 0.0
    return plain


def speeds(rng: random.Random) -> Iterator[float]:
    yield from (0.0, 0.25, -0.25, 0.2499, -0.2501, 1e-6, -1e-3, 3.0, -3.0)
    yield from (rng.uniform(-1, 1) * 10 ** rng.uniform(-3, 0.5) for _ in range(30))


def spelled(id: str, p: dict[str, Any], at: Site) -> dict[str, float]:
    """What the symbols of an equation stand for."""
    found = {"s": at.direction, r"\tau": at.tau, r"\tau_L": at.tau}
    found |= {r"\dot q": at.qd, r"\dot u": at.qd, r"\ddot u": at.qdd}
    found |= {rf"\operatorname{{sgn}}{name}": at.direction for name in (r"\dot q", r"\dot u")}
    found |= {f"f_{axis}": x for axis, x in zip("xyz", at.f, strict=True)}
    found |= {f"n_{axis}": x for axis, x in zip("xyz", at.n, strict=True)}
    for parameter in CATALOGUE[id].parameters:
        if isinstance(p.get(parameter.name), float) and parameter.symbol:
            found[parameter.symbol] = p[parameter.name]
    if "mu_r" in p:
        found |= {r"\mu": p["mu_r"], "r": 1.0}
    if id == "transmission_loss":
        eta = p["efficiency"]
        if isinstance(eta, tuple):
            eta = efficiency_at(abs(at.tau) / p["rated_torque"], eta, p["interpolation"])
        found[r"\eta"] = eta
    return found


@pytest.mark.parametrize("rest", REST)
@pytest.mark.parametrize("name", FRICTION)
def test_the_page_the_definition_and_the_reference(name: str, rest: str) -> None:
    case, rng = CASES[name], random.Random(f"{name} {rest}")
    for _ in range(3):
        p = floats(draw(case, rng))
        if case.id == "presliding_hysteresis":  # in steady motion; the page says it in words
            assert "tau is F_c sgn(qd)" in case.effect.doc
            latex = r"F_c \operatorname{sgn}\dot q"
        else:
            latex = typeset(case.id, p)
        for speed in speeds(rng):
            load = [tuple(rng.uniform(-50, 50) for _ in range(3)) for _ in range(2)]
            at = Site(case.revolute, rng.uniform(-3, 3), speed, rng.uniform(-9, 9), sense(speed, rest),
                      rng.uniform(-5, 5), *load)  # fmt: skip
            expected = value(latex, spelled(case.id, p, at)) - (
                at.tau if case.id == "transmission_loss" else 0
            )
            smooth, band = REST[rest]
            own = smoothed_sign(speed, smooth, band)
            assert float(own) == pytest.approx(at.direction, abs=1e-15)
            assert case.effect.equation is not None
            found = case.effect.equation(p, replace(at, direction=float(own)))
            assert found == pytest.approx(expected, rel=1e-12, abs=1e-12)
            _, many = stacked([at, at])
            way = direction(np.array([speed, speed]), smooth, band)
            again = added_torque(case.id, p, replace(many, way=way))
            assert again == pytest.approx([expected] * 2, rel=1e-12, abs=1e-12)


def test_presliding_moves_as_typeset() -> None:
    effect = CATALOGUE["presliding_hysteresis"]
    assert effect.memory is not None
    rate, _, torque = effect.latex.partition(r", \qquad ")
    rng = random.Random(3)
    for speed in speeds(rng):
        p = floats(draw(CASES["presliding"], rng))
        z = rng.uniform(-2, 2) * p["level"] / p["stiffness"]
        symbols = {**spelled(effect.id, p, Site(True, qd=speed)), "z": z}
        moves = value(rate.removeprefix(r"\dot z ="), symbols)
        at = Site(True, qd=speed)
        assert effect.memory.rates(p, at, (z,)) == (pytest.approx(moves, rel=1e-12, abs=1e-12),)
        expected = value(torque.removeprefix(r"\tau ="), {**symbols, r"\dot z": moves})
        assert effect.memory.torque(p, at, (z,)) == pytest.approx(expected, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"2 a^2 - \tfrac12 b", 2 * 9 - 2.0),
        (r"\frac{a}{b} \left|a - b\right|^{1/2}", 0.75),
        (r"|a - b| |b|\,e^{-|a/b|^2}", 4 * math.exp(-9 / 16)),
        (r"2\,\sin(a - b) a", 6 * math.sin(-1)),
        (r"\Bigl[\sqrt{(a + 1) b} + |{-1}|\Bigr] 3", 15.0),
        (r"\begin{cases} a & a - b > 0 \\ -b & a \le b \end{cases}", -4.0),
    ],
)
def test_latex_is_read_as_mathematics(latex: str, expected: float) -> None:
    assert value(latex.replace("{-1}", "(-1)"), {"a": 3.0, "b": 4.0}) == pytest.approx(expected)


@pytest.mark.parametrize("latex", ["a +", "(a", "a )", r"\tan a", "c", "|a", r"\frac{a}"])
def test_what_is_no_mathematics(latex: str) -> None:
    with pytest.raises(SyntaxError):
        value(latex, {"a": 3.0})
