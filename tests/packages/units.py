"""FMI units on disk: arms of every kind, and instances of their units."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from packages.consumers import MAINTAINER
from robodyn.kernels.generate import Options, generate
from robodyn.packages import package
from robodyn.robot import Robot, load, read_text
from robodyn.simulate.simulation import Simulation, Torques, simulate

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
STUCK = ", friction: {coulomb: 80}"
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
    "a joint that sticks": (ELBOW.format(STUCK, 2, "", ""), {}),
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

    @contextmanager
    def model(self, more: Mapping[str, float]) -> Iterator[Any]:
        """An instance for model exchange in continuous time, with ``more`` start values."""
        from fmpy.fmi3 import FMU3Model

        model = FMU3Model(
            guid=self.description.guid,
            unzipDirectory=str(self.folder),
            modelIdentifier=self.description.modelExchange.modelIdentifier,
            instanceName=self.robot.name,
        )
        model.instantiate()
        model.setFloat64(self.references(list(more)), list(more.values()))
        self.begin(model)
        model.updateDiscreteStates()
        model.enterContinuousTimeMode()
        yield model
        model.terminate()
        model.freeInstance()

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


def unit_of(name: str, folder: Path) -> Unit:
    """The unit of an arm of :data:`ARMS`, written to ``folder`` and extracted there."""
    import fmpy

    text, values = ARMS[name]
    robot = read_text(text) if "\n" in text else load(text)
    functions = ("forward_kinematics", "kinetic_energy")
    generated = generate(robot, Options(functions=functions))
    packed = package(generated, "fmu", version="1.2.3", license="MIT", maintainer=MAINTAINER)
    path = folder / f"{packed.name}.fmu"
    content = packed.files()[path.name]
    assert isinstance(content, bytes)
    path.write_bytes(content)
    extracted = Path(fmpy.extract(str(path), unzipdir=str(folder / "extracted")))
    places = np.random.default_rng(1).uniform(-0.5, 0.5, robot.n)
    start = {f"q[{i + 1}]": float(q) for i, q in enumerate(places)}
    start |= {f"parameters.{parameter}": value for parameter, value in values.items()}
    return Unit(robot, values, path, extracted, fmpy.read_model_description(str(path)), start)
