"""The catalogue: complete, and each equation the same over every scalar and beside the reference's own."""

from __future__ import annotations

import random
from dataclasses import fields
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy

from effects.cases import CASES, COUPLERS, Case, draw, floats, mapped, site, sites, stacked
from robodyn.effects.catalogue import CATALOGUE, effect
from robodyn.effects.effect import Site
from robodyn.effects.efficiency import efficiency_at
from robodyn.errors import InputError
from robodyn.ir import Graph, Input
from robodyn.ir.evaluate import REAL_FUNCTIONS, evaluate
from robodyn.ir.lowering import lower
from robodyn.verify.effects import added_torque, efficiency


def torque(case: Case, values: Any, at: Site) -> Any:
    equation = case.effect.equation
    assert equation is not None
    return equation(values, at)


def close(found: Any, expected: Any, rel: float = 1e-12) -> None:
    size = float(np.abs(np.asarray(expected, dtype=float)).max())
    np.testing.assert_allclose(np.asarray(found, dtype=float), expected, rtol=rel, atol=rel * size)


# --- the list ---------------------------------------------------------------------------------------------


def test_an_effect_is_known_by_its_id() -> None:
    assert all(effect(id).id == id for id in CATALOGUE)
    with pytest.raises(InputError, match="did you mean 'spring'"):
        effect("sprng")


@pytest.mark.parametrize("id", CATALOGUE)
def test_every_effect_is_described(id: str) -> None:
    found = effect(id)
    for text in (found.title, found.latex, found.doc, found.signature, found.separates, found.source):
        assert text
    assert id not in found.rivals
    assert set(found.rivals) <= set(CATALOGUE)
    assert set(found.linear) <= set(found.names)
    assert len(set(found.names)) == len(found.names)
    for parameter in found.parameters:
        assert parameter.doc.endswith(".")
        dimensional = parameter.kind in ("number", "vector", "inertia", "efficiency")
        assert bool(parameter.unit) == dimensional, parameter.name
        assert (parameter.kind == "choice") == bool(parameter.choices)
        if parameter.kind == "choice" and not parameter.optional:
            assert parameter.default in (*parameter.choices, None)
    tested = {case.id for case in (*CASES.values(), *COUPLERS.values())}
    assert found.equation is None or id in tested or found.kind == "sensor"


# --- scalars ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", CASES)
def test_equations_are_the_references(name: str) -> None:
    """Over floats and over arrays."""
    case, rng = CASES[name], random.Random(name)
    for revolute in (joint for joint in (True, False) if (case.revolute if joint else case.prismatic)):
        for _ in range(3):
            values, places = floats(draw(case, rng)), sites(rng, 40, revolute=revolute)
            together, state = stacked(places)
            expected = state.qdd * values["inertia"] if case.id == "rotor_inertia" else None
            if expected is None:
                expected = added_torque(case.id, values, state)
            assert np.abs(expected).max() > 0
            close([torque(case, values, mapped(at, float)) for at in places], expected)
            over = torque(case, values, together)
            assert over.dtype == np.float64
            close(over, expected)


def symbolic(case: Case, values: Any, make: Any) -> tuple[dict[str, Any], Site, list[tuple[Any, Fraction]]]:
    """Parameters and a site of scalars that ``make`` names, where names may stand, and their numbers."""
    given: list[tuple[Any, Fraction]] = []
    at = site(random.Random(str(values)))

    def new(value: Any) -> Any:
        made = make(len(given))
        given.append((made, value))
        return made

    names = {p.name for p in case.effect.parameters if p.names}
    return {k: new(v) if k in names else v for k, v in values.items()}, mapped(at, new), given


@pytest.mark.parametrize("name", CASES)
def test_equations_over_programs_expressions_and_rationals(name: str) -> None:
    case, rng = CASES[name], random.Random(name)
    values = draw(case, rng)
    graph = Graph()
    p, at, nodes = symbolic(case, values, lambda i: graph.input("x", i))
    program = lower(graph, [("t", [torque(case, p, at)])])
    p, at, symbols = symbolic(case, values, lambda i: sympy.Symbol(f"x{i}", real=True))
    expression = sympy.lambdify([x for x, _ in symbols], torque(case, p, at), "math")
    for _ in range(4):
        fixed = {p.name: values[p.name] for p in case.effect.parameters if not p.names and p.name in values}
        values, exact = {**draw(case, rng), **fixed}, site(rng, smooth=True)
        numbers = [v for _, v in symbolic(case, values, lambda i: i)[2][: -len(flat(exact))]] + flat(exact)
        assert len(numbers) == len(nodes)
        inputs = {Input("x", i): float(v) for i, v in enumerate(numbers)}
        expected = torque(case, floats(values), mapped(exact, float))
        size = added_torque(case.id, floats(values), stacked([exact])[1])[0]
        near = pytest.approx(expected, rel=1e-12, abs=1e-12 * abs(size) + 1e-14)
        assert evaluate(program, inputs)["t"][0] == near
        assert expression(*(float(v) for v in numbers)) == near
        if case.rational:
            over = torque(case, values, exact)
            assert isinstance(over, Fraction | int)
            assert float(over) == near
            exactly: Any = {Input("x", i): v for i, v in enumerate(numbers)}
            functions = {"abs": abs, "sign": REAL_FUNCTIONS["sign"]}
            assert evaluate(program, exactly, constant=lambda x: x, functions=functions)["t"][0] == over


def flat(at: Site) -> list[Fraction]:
    found: list[Fraction] = []
    for field in fields(Site):
        value = getattr(at, field.name)
        found += [] if isinstance(value, bool) else value if isinstance(value, tuple) else [value]
    return found


def test_sensors() -> None:
    tau = np.linspace(-3, 3, 13)
    at = Site(True, tau=tau, q=tau)
    for id, values, expected in (
        ("torque_bias", {"bias": 0.5}, np.full(13, 0.5)),
        ("torque_gain", {"gain": 0.1}, 1.1 * tau - tau),
        ("encoder_offset", {"offset": -0.2}, np.full(13, -0.2)),
        ("torque_saturation", {"limit": 1.25}, np.clip(tau, -1.25, 1.25) - tau),
    ):
        equation = effect(id).equation
        assert equation is not None
        np.testing.assert_allclose(np.broadcast_to(equation(values, at), 13), expected, atol=1e-15)


# --- what the fields say ----------------------------------------------------------------------------------


def superposes(case: Case, names: tuple[str, ...], rng: random.Random) -> bool:
    """Whether the torque is affine in the parameters ``names`` together, exactly or to rounding."""
    values, at = draw(case, rng), site(rng, smooth=True)
    names = tuple(name for name in names if name in values)
    steps = [{n: Fraction(rng.randint(1, 99), 64) for n in names} for _ in range(2)]
    one, other = ({**values, **{n: values[n] + step[n] for n in names}} for step in steps)
    both = {**values, **{n: one[n] + steps[1][n] for n in names}}
    parts = [float(torque(case, p, at)) for p in (both, values, one, other)]
    return abs(parts[0] + parts[1] - parts[2] - parts[3]) <= 1e-12 * max(map(abs, parts))


@pytest.mark.parametrize("name", [name for name, case in CASES.items() if case.effect.linear])
def test_linear_parameters_superpose(name: str) -> None:
    case, rng = CASES[name], random.Random(name)
    assert all(superposes(case, case.effect.linear, rng) for _ in range(10))
    values, at = draw(case, rng), site(rng)
    nothing = torque(case, {**values, **{n: 0 for n in case.effect.linear if n in values}}, at)
    assert nothing == 0 or case.id == "transmission_loss"


@pytest.mark.parametrize("name", COUPLERS)
def test_couplers(name: str) -> None:
    """Twist and torque are inverse; energy is the integral of torque; the sides keep up after ``lag``."""
    case, rng = COUPLERS[name], random.Random(name)
    coupler = case.effect.coupler
    assert coupler is not None
    node, weight = np.polynomial.legendre.leggauss(60)
    for _ in range(10):
        p = floats(draw(case, rng))
        for tau in (-7.0, -0.3, -1e-3, 0.0, 1e-4, 0.02, 1.0, 30.0):
            x = coupler.twist(p, tau)
            assert coupler.torque(p, x, 0.0) == pytest.approx(tau, rel=1e-11, abs=1e-13)
            assert coupler.torque(p, x, 2.0) == pytest.approx(tau + 2 * p["damping"], rel=1e-11)
            work = sum(
                w * x / 2 * coupler.torque(p, x / 2 * (1 + t), 0.0) for t, w in zip(node, weight, strict=True)
            )
            assert coupler.energy(p, x) == pytest.approx(work, rel=1e-9, abs=1e-12)
            assert coupler.energy(p, -x) == pytest.approx(coupler.energy(p, x), abs=1e-14)
            slope = (coupler.twist(p, tau + 1e-6) - coupler.twist(p, tau - 1e-6)) / 2e-6
            assert coupler.lag(p, tau) == pytest.approx(p["damping"] * slope, rel=1e-4)


def test_efficiencies_are_scipys_cubic() -> None:
    from scipy.interpolate import PchipInterpolator

    rng = random.Random(3)
    for size in (3, 4, 7, 12):
        for _ in range(5):
            loads = sorted(rng.sample(range(1, 64), size))
            knots = tuple((x / 64, rng.randint(10, 64) / 64) for x in loads)
            x = np.linspace(0, 1.2, 97)
            curve = PchipInterpolator(*zip(*knots, strict=True))
            within = np.clip(x, knots[0][0], knots[-1][0])
            np.testing.assert_allclose(efficiency(x, knots, "cubic"), curve(within), rtol=1e-13)
            np.testing.assert_allclose(efficiency_at(x, knots, "cubic"), curve(within), rtol=1e-12)
            level = efficiency(x, knots, "linear")
            np.testing.assert_allclose(level, np.interp(x, *zip(*knots, strict=True)), rtol=1e-15)


@pytest.mark.parametrize("name", [name for name, case in CASES.items() if case.effect.potential])
def test_potentials_are_integrals_of_torques(name: str) -> None:
    case, rng = CASES[name], random.Random(name)
    potential = case.effect.potential
    assert potential is not None
    node, weight = np.polynomial.legendre.leggauss(40)
    for _ in range(5):
        p = floats(draw(case, rng))
        start, end = rng.uniform(-2, 0), rng.uniform(0, 2)
        q = (start + end) / 2 + (end - start) / 2 * node
        work = weight @ torque(case, p, Site(True, q=q)) * (end - start) / 2
        assert potential(p, end) - potential(p, start) == pytest.approx(work, rel=1e-11, abs=1e-12)
