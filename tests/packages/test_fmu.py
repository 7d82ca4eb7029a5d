"""The FMI unit: valid, and the same motion as our simulator, in co-simulation and in model exchange."""

from __future__ import annotations

import csv
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from numpy.typing import NDArray

from packages.consumers import run
from robodyn.errors import InputError
from robodyn.kernels.generate import Options, generate
from robodyn.packages import package
from robodyn.packages.fmi import base_units
from robodyn.robot import Robot, load, read_text
from robodyn.simulate.simulation import Simulation, Torques, simulate
from robodyn_testing import require_module, require_tool

Floats = NDArray[np.float64]

PERIOD, SAMPLES = 0.01, 150
#: Tolerances of the engine: a unit's steps end elsewhere, so that results differ by as much as these allow.
RELATIVE, ABSOLUTE = 1e-10, 1e-12
ELBOW = """name: elbow
links:
- {{joint: revolute, alpha: 1, mass: 3, com: [1, 0, 0.5], motor_inertia: 1{0}}}
- {{joint: revolute, a: 1, mass: {1}, com: [0.3, 0, 0], motor_inertia: 1{2}}}
{3}"""
DRY = ", friction: {viscous: 0.5, coulomb: 6}"
BRISTLES = ", effects: [{effect: presliding_hysteresis, stiffness: 1000, level: 5, damping: 10}]"
ELASTIC = ", effects: [{effect: joint_elasticity, stiffness: 2000, damping: 3}], friction: {coulomb: 2}"
LOADED = ", effects: [{effect: load_dependent_friction, bearing: torque, mu: 0.1}]"
LIMITED = ", effects: [{effect: torque_saturation, limit: 4, clips: drive}]"
PUSHED = (
    "effects: [{effect: external_contact, start: 0.31, end: 0.52, link: 2, "
    "force_x: 5, force_y: 3, force_z: 20}]\n"
)
ARMS: Mapping[str, tuple[str, Mapping[str, float]]] = {
    "puma560": ("puma560", {}),
    "stanford": ("stanford", {}),
    "dry friction, run-time parameter": (ELBOW.format(DRY, "m_tool", "", ""), {"m_tool": 1.7}),
    "bristles": (ELBOW.format(BRISTLES, 2, "", ""), {}),
    "elastic": (ELBOW.format("", 2, ELASTIC, ""), {}),
    "friction by load, limited drive": (ELBOW.format(LOADED, 2, LIMITED, ""), {}),
    "contact": (ELBOW.format("", 2, "", PUSHED), {}),
}


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit on disk and what it is of."""

    robot: Robot
    values: Mapping[str, float]
    path: Path
    folder: Path
    description: Any
    start: Mapping[str, float]

    def names(self, *blocks: str) -> list[str]:
        """The variables of blocks such as ``q``."""
        return [f"{block}[{i + 1}]" for block in blocks for i in range(self.robot.n)]

    def references(self, names: Sequence[str]) -> list[int]:
        """What the standard's functions know the variables by."""
        known = {v.name: v.valueReference for v in self.description.modelVariables}
        return [known[name] for name in names]

    @contextmanager
    def instance(self, tolerance: float = RELATIVE) -> Iterator[Any]:
        """An instance for co-simulation that stands at the start."""
        from fmpy.fmi3 import FMU3Slave

        slave = FMU3Slave(
            guid=self.description.guid,
            unzipDirectory=str(self.folder),
            modelIdentifier=self.description.coSimulation.modelIdentifier,
            instanceName=self.robot.name,
        )
        slave.instantiate()
        self.begin(slave, tolerance)
        yield slave
        slave.terminate()
        slave.freeInstance()

    def begin(self, slave: Any, tolerance: float = RELATIVE) -> None:
        """Initialise with the start values."""
        slave.setFloat64(self.references(list(self.start)), list(self.start.values()))
        slave.enterInitializationMode(tolerance=tolerance)
        slave.exitInitializationMode()

    def go(self, slave: Any, torques: Floats, begin: int = 0) -> Floats:
        """Positions and velocities after each period, from sample ``begin`` on, under ``torques``."""
        inputs, outputs = self.references(self.names("tau")), self.references(self.names("q", "qd"))
        rows = []
        for k, tau in enumerate(torques, begin):
            slave.setFloat64(inputs, list(tau))
            slave.doStep(k * PERIOD, PERIOD)
            rows.append(slave.getFloat64(outputs))
        return np.array(rows)

    def expected(self, drive: Torques | None) -> Simulation:
        """The same by our simulator."""
        q = [self.start[name] for name in self.names("q")]
        return simulate(
            self.robot, drive, start=q, duration=SAMPLES * PERIOD, sample_period=PERIOD, method="adaptive",
            parameters=self.values, rtol=RELATIVE, atol=ABSOLUTE,
        )  # fmt: skip


def torques(n: int) -> Floats:
    """A row for every period."""
    return 5 * np.sin(2 * np.pi * np.outer(np.arange(SAMPLES) * PERIOD, 0.7 + 0.3 * np.arange(n)))


@pytest.fixture(scope="module")
def fmpy() -> Any:
    require_tool("cc")
    return require_module("fmpy")


@pytest.fixture(scope="module")
def units(fmpy: Any, tmp_path_factory: pytest.TempPathFactory) -> Any:
    built: dict[str, Unit] = {}

    def unit(name: str) -> Unit:
        if name not in built:
            text, values = ARMS[name]
            robot = read_text(text) if "\n" in text else load(text)
            functions = ("forward_kinematics", "kinetic_energy")
            packed = package(
                generate(robot, Options(functions=functions)), "fmu", version="1.2.3", license="MIT"
            )
            path = tmp_path_factory.mktemp("unit") / f"{packed.name}.fmu"
            content = packed.files()[path.name]
            assert isinstance(content, bytes)
            path.write_bytes(content)
            folder = fmpy.extract(str(path), unzipdir=str(path.parent / "extracted"))
            places = np.random.default_rng(1).uniform(-0.5, 0.5, robot.n)
            start = {f"q[{i + 1}]": float(q) for i, q in enumerate(places)}
            start |= {f"parameters.{parameter}": value for parameter, value in values.items()}
            description = fmpy.read_model_description(str(path))
            built[name] = Unit(robot, values, path, Path(folder), description, start)
        return built[name]

    return unit


@pytest.mark.thorough
@pytest.mark.parametrize("name", ARMS)
def test_fmpy_has_no_complaint(name: str, units: Any) -> None:
    from fmpy.model_description import read_build_description
    from fmpy.validation import validate_fmu

    unit = units(name)
    assert validate_fmu(str(unit.path)) == []
    (build,) = read_build_description(str(unit.path))
    assert build.modelIdentifier == f"{unit.robot.name}_dynamics"
    coordinates = unit.robot.n + (name == "elastic")
    assert unit.description.numberOfContinuousStates == 2 * coordinates + (name == "bristles")


@pytest.mark.thorough
@pytest.mark.parametrize("name", ARMS)
def test_co_simulation_is_our_simulator(name: str, units: Any) -> None:
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


@pytest.mark.thorough
@pytest.mark.parametrize("name", ARMS)
def test_model_exchange_is_our_simulator(name: str, fmpy: Any, units: Any) -> None:
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
    smooth = {"puma560", "stanford", "bristles"}
    assert (len(record["time"]) > len(last)) == (name not in smooth), "events"


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["elastic", "bristles"])
def test_states_are_saved_and_instances_are_apart(name: str, units: Any) -> None:
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


@pytest.mark.thorough
def test_a_parameter_changes_between_steps(units: Any) -> None:
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


@pytest.mark.thorough
def test_what_is_refused_is_said(units: Any, capsys: pytest.CaptureFixture[str]) -> None:
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


@pytest.mark.thorough
def test_the_commands_of_fmpy(units: Any, tmp_path: Path) -> None:
    """Those of docs/packages.md."""
    unit = units("puma560")
    fmpy = (sys.executable, "-m", "fmpy")
    assert run(*fmpy, "validate", unit.path, cwd=tmp_path) == "No problems found.\n"
    fall = ("--start-values", "q[2]", "-0.5", "--stop-time", "1", "--output-file", "fall.csv")
    run(*fmpy, "simulate", unit.path, *fall, cwd=tmp_path)
    with (tmp_path / "fall.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert float(rows[0]["q[2]"]) == -0.5
    assert float(rows[-1]["time"]) == 1


@pytest.mark.thorough
def test_its_sources_compile_without_a_warning(units: Any, tmp_path: Path) -> None:
    """Every one by itself, with the functions' prefix that static linking needs."""
    unit = units("elastic")
    (build,) = ElementTree.parse(unit.folder / "sources" / "buildDescription.xml").getroot()
    (sources,) = build.findall("SourceFileSet")
    options = [*sources.attrib["compilerOptions"].split(), "-Wall", "-Wextra", "-pedantic", "-Werror"]
    prefix = f"-DFMI3_FUNCTION_PREFIX={build.attrib['modelIdentifier']}_"
    for k, source in enumerate(sources):
        path = unit.folder / "sources" / source.attrib["name"]
        run(require_tool("cc"), *options, prefix, "-c", path, "-o", f"{k}.o", cwd=tmp_path)


@pytest.mark.thorough
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
