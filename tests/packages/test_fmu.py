"""The FMI unit: valid, and the same motion as our simulator, in co-simulation and in model exchange."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from packages.consumers import MAINTAINER, run
from packages.units import ARMS, PERIOD, SAMPLES, Floats, Unit, torques, unit_of
from robodyn.errors import InputError
from robodyn.kernels.generate import Options, generate
from robodyn.packages import package
from robodyn.packages.fmi import base_units, describe, results_of
from robodyn.robot import load
from robodyn.simulate.simulation import Torques
from robodyn.simulate.system import system_of
from robodyn_testing import representative, require_module, require_tool

pytestmark = pytest.mark.thorough
Units = Callable[[str], Unit]
KINDS = representative(ARMS, "dry friction, run-time parameter", "elastic", rest="slow")


@pytest.fixture(scope="module")
def fmpy() -> Any:
    require_tool("cc")
    return require_module("fmpy")


@pytest.fixture(scope="module")
def units(fmpy: Any, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Unit]:
    """Units by the name of the arm, each written once."""
    return cache(lambda name: unit_of(name, tmp_path_factory.mktemp("unit")))


@pytest.mark.parametrize(
    "name", representative(ARMS, "dry friction, run-time parameter", "elastic", "bristles", rest="slow")
)
def test_fmpy_has_no_complaint(name: str, units: Units) -> None:
    from fmpy.model_description import read_build_description
    from fmpy.validation import validate_fmu

    unit = units(name)
    assert validate_fmu(str(unit.path)) == []
    (build,) = read_build_description(str(unit.path))
    assert build.modelIdentifier == f"{unit.robot.name}_dynamics"
    assert unit.description.author == MAINTAINER
    coordinates = unit.robot.n + (name == "elastic")
    assert unit.description.numberOfContinuousStates == 2 * coordinates + (name == "bristles")


def test_the_readme_names_every_output() -> None:
    """As the description does, also those that the arm has itself; nothing of functions that are left out."""
    require_tool("cc")
    robot = load("stanford_3dof")
    functions = ("inverse_dynamics", "kinetic_energy", "mass_matrix", "momentum")
    for options in (Options(functions), Options(("all",))):
        packed = package(generate(robot, options), "fmu")
        readme = packed.files()["README.md"]
        assert isinstance(readme, str)
        rows = re.findall(r"(?m)^\| (`.*`) \| .* \| outputs", readme)
        listed = re.findall(r"`(\w+)(?:\[[i.]+\])?`", " ".join(rows))
        system = system_of(robot, packed.generated.options)
        outputs = describe(packed, system, results_of(packed)).outputs
        assert listed == list(dict.fromkeys(variable.name.partition("[")[0] for variable in outputs))


@pytest.mark.parametrize("name", KINDS)
def test_co_simulation_is_our_simulator(name: str, units: Units) -> None:
    unit = units(name)
    tau = torques(unit.robot.n)
    expected = unit.expected(Torques(tau, PERIOD))
    with unit.instance() as slave:
        states = unit.go(slave, tau)
        known = [f"T[{i},{j}]" for i in (1, 2, 3) for j in (1, 2, 3, 4)] + ["E_kin", *unit.names("qdd")]
        outputs = slave.getFloat64(unit.references(known))
    assert np.ptp(states) > 0.5
    assert states == pytest.approx(np.hstack([expected.q, expected.qd])[1:], abs=1e-9)
    q, qd = expected.q[-1], expected.qd[-1]
    generated = kernel(unit, "forward_kinematics", "kinetic_energy")
    assert outputs[:12] == pytest.approx(generated.forward_kinematics(q).ravel(), abs=1e-8)
    assert outputs[12] == pytest.approx(float(generated.kinetic_energy(q, qd)), abs=1e-8)


def kernel(unit: Unit, *functions: str) -> Any:
    import robodyn

    return robodyn.compile(unit.robot.at(unit.values), functions=functions)


@pytest.mark.parametrize("name", KINDS)
def test_model_exchange_is_our_simulator(name: str, fmpy: Any, units: Units) -> None:
    """By the integrator of fmpy (CVode), which finds the events by the indicators."""
    unit = units(name)
    expected = unit.expected(None)
    names = unit.names("q", "qd")
    record = fmpy.simulate_fmu(
        str(unit.folder), fmi_type="ModelExchange", stop_time=SAMPLES * PERIOD, output_interval=PERIOD,
        start_values=unit.start, output=names, relative_tolerance=1e-10,
    )  # fmt: skip
    last = [np.flatnonzero(np.abs(record["time"] - t) < 1e-9)[-1] for t in expected.t]
    states = np.column_stack([record[name] for name in names])[last]
    assert np.ptp(states) > 0.3
    assert states == pytest.approx(np.hstack([expected.q, expected.qd]), abs=1e-6)
    without_events = {"puma560", "stanford", "a joint that sticks", "bristles"}
    assert (len(record["time"]) > len(last)) == (name not in without_events)


@pytest.mark.parametrize("name", ["bristles"])
def test_states_are_saved_and_instances_are_apart(name: str, units: Units) -> None:
    unit = units(name)
    tau = torques(unit.robot.n)
    half = SAMPLES // 2
    with unit.instance() as one:
        unit.go(one, tau[:half])
        state = one.getFMUState()
        stored = one.serializeFMUState(state)
        rest = unit.go(one, tau[half:], half)
        one.setFMUState(state)
        assert np.array_equal(unit.go(one, tau[half:], half), rest)
        with unit.instance() as other:
            start = unit.go(other, tau[:3])
            assert not np.array_equal(start[-1], rest[-1])
            other.setFMUState(other.deserializeFMUState(stored))
            assert np.array_equal(unit.go(other, tau[half:], half), rest)
            other.reset()
            unit.begin(other)
            assert np.array_equal(unit.go(other, tau[:3]), start)
        one.freeFMUState(state)


@pytest.mark.parametrize(
    ("name", "speed"),
    representative(
        [(name, speed) for name in ARMS if name != "contact" for speed in (0.0, 0.7)],
        ("elastic", 0.7), ("bristles", 0.7), rest="slow",
    ),
)  # fmt: skip
def test_directional_derivatives_are_those_of_differences(name: str, speed: float, units: Units) -> None:
    """Of slopes and outputs by all states and torques; at rest dry friction holds joints."""
    unit = units(name)
    described = ElementTree.parse(unit.folder / "modelDescription.xml").getroot()
    assert [kind.attrib["providesDirectionalDerivatives"] for kind in described[:2]] == ["true"] * 2
    with unit.model(dict.fromkeys(unit.names("qd"), speed)) as model:
        random = np.random.default_rng(2)
        states = [v.variable.derivative.valueReference for v in unit.description.derivatives]
        x = np.array(model.getFloat64(states))
        x[: unit.robot.n] += random.uniform(-1e-3, 1e-3, unit.robot.n)  # drives that are no longer at rest
        tau, dx = random.uniform(-1, 1, unit.robot.n), random.uniform(-1, 1, len(x))
        dtau = random.uniform(-1, 1, len(tau))
        inputs = unit.references(unit.names("tau"))
        unknowns = [v.variable.valueReference for v in unit.description.derivatives]
        unknowns += [v.variable.valueReference for v in unit.description.outputs]

        def at(step: float) -> Floats:
            model.setFloat64(inputs, list(tau + step * dtau))
            model.setContinuousStates((ctypes.c_double * len(x))(*(x + step * dx)), len(x))
            return np.array(model.getFloat64(unknowns))

        differences = (at(1e-6) - at(-1e-6)) / 2e-6
        at(0.0)
        slopes = model.getDirectionalDerivative(unknowns, [*states, *inputs], [*dx, *dtau])
    assert np.abs(differences).max() > 0.5
    assert slopes == pytest.approx(differences, rel=1e-5, abs=1e-5 * np.abs(differences).max())


def test_a_parameter_changes_between_steps(units: Units) -> None:
    unit = units("dry friction, run-time parameter")
    (parameter,) = unit.references(["parameters.m_tool"])
    with unit.instance() as slave:
        unit.go(slave, np.full((20, 2), 8.0))
        q, qd = np.split(np.array(slave.getFloat64(unit.references(unit.names("q", "qd")))), 2)
        assert np.abs(qd).min() > 1e-3
        slave.setFloat64([parameter], [4.0])
        qdd = slave.getFloat64(unit.references(unit.names("qdd")))
    import robodyn

    heavier = robodyn.compile(unit.robot.at({"m_tool": 4.0}), functions=("forward_dynamics",))
    assert qdd == pytest.approx(heavier.forward_dynamics(q, qd, [8.0, 8.0]), rel=1e-9)


def test_what_is_refused_is_said(units: Units, capsys: pytest.CaptureFixture[str]) -> None:
    from fmpy.fmi1 import FMICallException

    unit = units("elastic")

    def refused(what: str, call: Any, *arguments: Any) -> None:
        with pytest.raises(FMICallException):
            call(*arguments)
        assert what in capsys.readouterr().out

    with unit.instance() as slave:
        references = unit.references(["q[1]", "motor_q[2]", "tau[1]"])
        refused("cannot be set", slave.setFloat64, references[:1], [0.1])
        refused("there is no variable 9999", slave.getFloat64, [9999])
        refused("no step from 1", slave.doStep, 1.0, PERIOD)
        slave.setFloat64(references[2:], [float("nan")])
        refused("t = 0: a number is not finite", slave.doStep, 0.0, PERIOD)
        slave.setFloat64(references[2:], [0.0])
        slave.doStep(0.0, PERIOD)


@pytest.mark.parametrize("name", ["elastic", pytest.param("contact", marks=pytest.mark.slow)])
def test_its_sources_compile_without_a_warning(name: str, units: Units, tmp_path: Path) -> None:
    """Every one by itself, with the functions' prefix that static linking needs."""
    unit = units(name)
    (build,) = ElementTree.parse(unit.folder / "sources" / "buildDescription.xml").getroot()
    (sources,) = build.findall("SourceFileSet")
    options = [*sources.attrib["compilerOptions"].split(), "-Wall", "-Wextra", "-pedantic", "-Werror"]
    prefix = f"-DFMI3_FUNCTION_PREFIX={build.attrib['modelIdentifier']}_"
    for k, source in enumerate(sources):
        path = unit.folder / "sources" / source.attrib["name"]
        run(require_tool("cc"), *options, prefix, "-c", path, "-o", f"{k}.o", cwd=tmp_path)
        assert (tmp_path / f"{k}.o").stat().st_size > 0


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        (Options(functions=("gravity",), scalar="float"), "numbers of an FMI unit are doubles"),
        (Options(functions=("gravity_with_wrench",)), "no place for the function gravity; found it needs w"),
    ],
)
def test_what_has_no_place(options: Options, complaint: str) -> None:
    with pytest.raises(InputError, match=complaint):
        package(generate(load("stanford_3dof"), options), "fmu").files()


@pytest.mark.parametrize(
    ("unit", "exponents"),
    [
        ("N m s^2/rad^2", {"kg": 1, "m": 2, "rad": -2}),
        ("rad/(rad s^2)", {"s": -2}),
        ("1", {}),
        ("kg m^2, kg m, kg", None),
        ("1 and m", None),
        ("", None),
    ],
)
def test_units_in_base_units(unit: str, exponents: dict[str, int] | None) -> None:
    assert base_units(unit) == exponents
