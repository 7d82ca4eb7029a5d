"""An arm whose numbers are run-time parameters: compiled once, moved with those of any unit on any day."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from fractions import Fraction
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from benchmarks.fleet.limits import CONTROL_PERIOD
from numpy.typing import NDArray

from robodyn.errors import InputError
from robodyn.logs.log import Log
from robodyn.robot.model import EffectEntry, Robot
from robodyn.robot.parts import AXES, Inertia, Link
from robodyn.robot.values import Value, parameter
from robodyn.simulate.control import Control
from robodyn.simulate.plant import Plant, build_plant
from robodyn.simulate.start import start_state
from robodyn.simulate.trajectories.trajectory import Trajectory

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Numbers:
    """The numbers of an arm's links: ``mass`` [n] (kg), ``com`` [n, 3] (m), ``inertia`` [n, 6] (kg m^2, in
    the order of :data:`AXES`), ``motor_inertia`` [n], ``viscous`` and ``coulomb`` friction [n]."""

    mass: Floats
    com: Floats
    inertia: Floats
    motor_inertia: Floats
    viscous: Floats
    coulomb: Floats

    def by_name(self) -> dict[str, float]:
        """Values of the parameters of :func:`with_parameters`."""
        values = {}
        for each in fields(self):
            array = np.asarray(getattr(self, each.name))
            names = _NAMES[each.name]
            for j, row in enumerate(array.reshape(len(array), -1), 1):
                values.update({f"{name}_{j}": float(x) for name, x in zip(names, row, strict=True)})
        return values


_NAMES = {
    "mass": ("mass",),
    "com": ("com_x", "com_y", "com_z"),
    "inertia": AXES,
    "motor_inertia": ("motor_inertia",),
    "viscous": ("viscous",),
    "coulomb": ("coulomb",),
}


def numbers_of(robot: Robot) -> Numbers:
    """The numbers of ``robot``.

    Raises
    ------
    InputError: it has run-time parameters.
    """
    if robot.parameters:
        raise InputError(
            f"{robot.name} has run-time parameters, of which a log knows no values",
            found=", ".join(robot.parameters),
            remedy="write numbers in their place",
        )
    rows = [_values(link) for link in robot.links]
    return Numbers(*(np.array([row[k] for row in rows], float) for k in range(len(_NAMES))))


def _values(link: Link) -> tuple[Any, ...]:
    joint, inertia = link.joint, [getattr(link.inertia, axis) for axis in AXES]
    return link.mass, link.com, inertia, joint.motor_inertia, joint.viscous, joint.coulomb


def with_numbers(robot: Robot, numbers: Numbers, digits: int = 17) -> Robot:
    """``robot`` with ``numbers``, rounded to so many digits."""

    def value(name: str, j: int) -> Value:
        return Fraction(f"{values[f'{name}_{j}']:.{digits}g}")

    values = numbers.by_name()
    return _renumbered(robot, value)


def with_parameters(robot: Robot) -> Robot:
    """``robot`` with a run-time parameter in the place of each of its :class:`Numbers`."""
    return _renumbered(robot, lambda name, j: parameter(f"{name}_{j}"))


def _renumbered(robot: Robot, value: Any) -> Robot:
    links = []
    for j, link in enumerate(robot.links, 1):
        x, y, z = (value(name, j) for name in _NAMES["com"])
        joint = replace(
            link.joint,
            motor_inertia=value("motor_inertia", j),
            viscous=value("viscous", j),
            coulomb=value("coulomb", j),
        )
        inertia = Inertia(*(value(axis, j) for axis in AXES))
        links.append(replace(link, mass=value("mass", j), com=(x, y, z), inertia=inertia, joint=joint))
    return replace(robot, links=tuple(links))


def loaded(numbers: Numbers, mass: float, com: Floats) -> Numbers:
    """``numbers`` with a point of ``mass`` [kg] at ``com`` [3] (m) in the last link's frame."""
    m = numbers.mass[-1]
    total = m + mass
    centre = (m * numbers.com[-1] + mass * com) / total
    tensor = _shifted(m, numbers.com[-1] - centre) + _shifted(mass, com - centre)
    masses, coms, inertia = numbers.mass.copy(), numbers.com.copy(), numbers.inertia.copy()
    masses[-1], coms[-1] = total, centre
    inertia[-1] += tensor
    return replace(numbers, mass=masses, com=coms, inertia=inertia)


def _shifted(mass: float, x: Floats) -> Floats:
    """What a point of ``mass`` at ``x`` adds to a tensor [6]."""
    full = mass * (x @ x * np.eye(3) - np.outer(x, x))
    return np.array([full[0, 0], full[1, 1], full[2, 2], full[0, 1], full[0, 2], full[1, 2]])


# --- motion -----------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class Day:
    """An arm on a day: its ``numbers``, the ``coupler`` that it has beside its effects with the ``values`` of
    that one's run-time parameters, and what its sensors do (``sensors``)."""

    numbers: Numbers
    coupler: EffectEntry | None = None
    values: Mapping[str, float] = field(default_factory=dict)
    sensors: tuple[EffectEntry, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Arm:
    """A compiled arm and the controller's gains ``kp`` and ``kd`` [n]; ``model`` are the numbers that the
    controller takes it to have."""

    plant: Plant
    model: Numbers
    kp: Floats
    kd: Floats

    def torque(
        self, log: Log, numbers: Numbers, values: Mapping[str, float] = MappingProxyType({})
    ) -> Floats:
        """The torques [K, n] of a rigid arm of ``numbers`` on the motion of a ``log`` that has its rates."""
        return self._torque(log.q, log.qd, log.qdd, numbers.by_name() | dict(values))

    def reference(
        self, motion: Trajectory, values: Mapping[str, float] = MappingProxyType({})
    ) -> tuple[Trajectory, Floats]:
        """The motion at every instant of the controller, and the torques [K, n] that it expects there."""
        follow = motion.sampled(CONTROL_PERIOD)
        return follow, self._torque(follow.q, follow.qd, follow.qdd, self.model.by_name() | dict(values))

    def _torque(self, q: Any, qd: Any, qdd: Any, values: Mapping[str, float]) -> Floats:
        return self.plant.engine.model_torques(
            q, qd, qdd, [values[name] for name in self.plant.robot.parameters]
        )

    def log(
        self,
        motion: Trajectory,
        numbers: Numbers,
        rate: float,
        values: Mapping[str, float] = MappingProxyType({}),
    ) -> Log:
        """What perfect sensors show, at ``rate`` [Hz], of an arm of ``numbers`` that follows ``motion``;
        ``values`` are those of further parameters.

        Raises
        ------
        InputError: the arm runs away.
        """
        own = numbers.by_name() | dict(values)
        plant = self.plant
        follow, ahead = self.reference(motion, values)
        control = Control.pd(
            follow.q, follow.qd, CONTROL_PERIOD, self.kp, self.kd,
            torque=ahead, place=plant.system.motors, seen=plant.system.encoders,
        )  # fmt: skip
        y, v, z = start_state(plant.system, follow.q[0], follow.qd[0], own)
        record = plant.engine.run(
            y, v, z,
            duration=follow.duration, sample_period=1 / rate, control=control, method="rk4",
            step=CONTROL_PERIOD, parameters=[own[name] for name in plant.robot.parameters],
        )  # fmt: skip
        if record.status != "done":
            raise InputError(
                f"{plant.robot.name}: the simulation ended at t = {record.time:.6g} s",
                found=record.status,
                expected="a state that stays finite",
            )
        encoders = list(plant.system.encoders)
        return Log(
            record.t, record.y[:, encoders], record.v[:, encoders], record.a[:, encoders], record.command
        )


@lru_cache(maxsize=64)
def compiled(robot: Robot, coupler: EffectEntry | None, cache: Path | None) -> Plant:
    """``robot`` compiled with :func:`with_parameters`, and with a ``coupler`` beside its effects."""
    arm = with_parameters(robot)
    if coupler is not None:
        arm = replace(arm, effects=(*arm.effects, coupler))
    return build_plant(arm, energy=False, cache=cache)
