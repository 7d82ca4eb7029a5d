"""A robot moved through time: what drives it, the run, and what a log shows of it.

>>> motion = fourier(robot, 10.0)                                      # doctest: +SKIP
>>> run = simulate(robot, Follow(motion, "pd", kp=400.0, kd=40.0))
>>> run.log(Sensors(position_resolution=resolution_of(17))).csv()
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.formats.loading import robot_of
from robodyn.logs.log import Log
from robodyn.robot.filling import parameter_values
from robodyn.robot.model import Robot
from robodyn.simulate.balance import Balance, stored_energy
from robodyn.simulate.control import Control
from robodyn.simulate.engine import ATOL, RTOL, Method, Record
from robodyn.simulate.plant import Plant, build_plant, drive_limits
from robodyn.simulate.sensors import Sensors, measure
from robodyn.simulate.start import start_state
from robodyn.simulate.trajectories.trajectory import Trajectory

Law = Literal["feedforward", "pd", "computed_torque"]
LAWS = ("feedforward", "pd", "computed_torque")
PERIOD = 1e-3
#: Steps that a run may take, and so many more a second: an arm that needs more has run away, or is too stiff.
_STEPS = 1_000_000


@dataclass(frozen=True, slots=True, eq=False)
class Torques:
    """Torques given in time: ``table`` [K, n] (N m or N), a row each ``period`` [s], held between or joined
    by straight lines (``linear``)."""

    table: ArrayLike
    period: float = PERIOD
    linear: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Follow:
    """A controller that follows ``trajectory``, once every ``period`` [s].

    ``feedforward``: the torques of the model along the trajectory, open loop. ``pd``: those and ``kp (q_ref -
    q) + kd (qd_ref - qd)``. ``computed_torque``: the model's torques for ``qdd_ref + kd (qd_ref - qd) + kp
    (q_ref - q)`` where the arm is. ``kp`` and ``kd`` [n], or one number: N m/rad and N m s/rad for ``pd``,
    1/s^2 and 1/s for ``computed_torque``. ``model`` is what the controller takes the robot for (by
    default what it is); ``without_model`` leaves the feed-forward out. Encoders read the true position.
    """

    trajectory: Trajectory
    law: Law = "pd"
    kp: ArrayLike = 0.0
    kd: ArrayLike = 0.0
    period: float = PERIOD
    model: Robot | None = None
    without_model: bool = False


Drive = Torques | Follow


@dataclass(frozen=True, slots=True, eq=False)
class Simulation:
    """A finished run: signals at the samples, SI units.

    ``q, qd, qdd`` [S, n] are the links', ``motor_q`` and so on the motors' (the same where nothing is
    elastic); ``command`` and ``applied`` [S, n] the torques as commanded and as the drives gave them.
    """

    plant: Plant
    record: Record
    parameters: Mapping[str, float]
    provenance: Mapping[str, Any] = field(default_factory=dict)

    @property
    def t(self) -> Floats:
        """Times of the samples [S] in s."""
        return self.record.t

    @property
    def q(self) -> Floats:
        """Positions of the links [S, n]."""
        return self.record.y[:, : self.plant.robot.n]

    @property
    def qd(self) -> Floats:
        """Velocities of the links [S, n]."""
        return self.record.v[:, : self.plant.robot.n]

    @property
    def qdd(self) -> Floats:
        """Accelerations of the links [S, n]."""
        return self.record.a[:, : self.plant.robot.n]

    @property
    def command(self) -> Floats:
        """Torques as commanded [S, n]."""
        return self.record.command

    @property
    def applied(self) -> Floats:
        """Torques as the drives gave them [S, n]."""
        return self.record.applied

    def balance(self) -> Balance:
        """The energies of the run."""
        kinetic, potential = stored_energy(self.plant.system, self.record.y, self.record.v, self.parameters)
        return Balance(kinetic, potential, self.record.work, self.record.loss)

    def true_log(self) -> Log:
        """What perfect sensors show: each joint on the side of its encoder, torques as commanded where only
        the drive clips them."""
        seen = list(self.plant.system.encoders)
        record = self.record
        return Log(
            record.t, record.y[:, seen], record.v[:, seen], record.a[:, seen], record.command, self.provenance
        )

    def log(self, sensors: Sensors | None = None, *, seed: int = 0) -> Log:
        """What the robot's sensors show: its own sensor effects, and ``sensors`` (default: else perfect)."""
        effects = self.plant.robot.effects
        return measure(self.true_log(), sensors or Sensors(), effects, seed=seed, parameters=self.parameters)


def simulate(
    robot: Robot | str | PathLike[str],
    drive: Drive | None = None,
    *,
    start: ArrayLike | None = None,
    speed: ArrayLike | None = None,
    duration: float | None = None,
    sample_period: float = PERIOD,
    method: Method = "rk4",
    step: float | None = None,
    rtol: float = RTOL,
    atol: float = ATOL,
    parameters: Mapping[str, float] | None = None,
    plant: Plant | None = None,
    progress: Callable[[float], object] | None = None,
    cache: Path | None = None,
) -> Simulation:
    """Simulate ``robot`` (or that of a path or name) with all its effects.

    Parameters
    ----------
    drive: what the motors do; None: nothing.
    start, speed: positions and velocities [n] of the links at t = 0 (default: the trajectory's, else 0).
    duration: [s] (default: the trajectory's or the table's).
    sample_period: time between samples [s].
    method: ``rk4`` with the fixed ``step`` [s] (default: a sample), or ``adaptive`` to ``rtol``, ``atol``.
    parameters: values of the run-time parameters.
    plant: the robot compiled before, of :func:`build_plant`.
    progress: called now and then with the time reached [s].

    Raises
    ------
    InputError: an argument or the robot does not fit; the run did not come to its end.
    ToolError: no C compiler.
    """
    robot = robot_of(robot)
    values = parameter_values(robot, parameters)
    model = drive.model if isinstance(drive, Follow) else None
    plant = plant or build_plant(robot, model=model, cache=cache)
    total = _duration(drive, duration)
    if plant.robot != robot or plant.model != (model or robot):
        raise InputError(
            "the plant was built for another robot, or another model of the controller",
            found=f"{plant.robot.name}, modelled as {plant.model.name}",
            expected=f"{robot.name}, modelled as {(model or robot).name}",
        )
    q0, v0 = _start(robot, drive, start, speed)
    y, v, z = start_state(plant.system, q0, v0, values)
    control = _control(plant, drive, values)
    record = plant.engine.run(
        y, v, z, duration=total, sample_period=sample_period, control=control, method=method, step=step,
        rtol=rtol, atol=atol, breaks=plant.system.breaks,
        parameters=[values[name] for name in robot.parameters], progress=progress,
        max_steps=_STEPS + int(_STEPS * total),
    )  # fmt: skip
    if record.status == "interrupted":
        raise KeyboardInterrupt
    if record.status != "done":
        raise InputError(
            f"{robot.name}: the simulation ended at t = {record.time:.6g} s",
            found=record.status,
            expected="a state that stays finite",
            remedy=(
                "a gentler controller, or less stiff springs, contacts and dampers"
                if method == "adaptive"
                else "a shorter --step, --solver adaptive, or a gentler controller"
            ),
        )
    return Simulation(plant, record, values)


def _duration(drive: Drive | None, duration: float | None) -> float:
    if duration is not None:
        return duration
    if isinstance(drive, Follow):
        return drive.trajectory.duration
    if isinstance(drive, Torques):
        return (len(np.asarray(drive.table)) - 1) * drive.period
    raise InputError("the duration of the simulation is missing", expected="duration [s]")


def _start(
    robot: Robot, drive: Drive | None, start: ArrayLike | None, speed: ArrayLike | None
) -> tuple[Floats, Floats]:
    first = drive.trajectory if isinstance(drive, Follow) else None
    if first is not None and first.n != robot.n:
        raise InputError(
            "the trajectory is another robot's", found=f"{first.n} joints", expected=f"{robot.n}"
        )
    states = []
    for name, value, own in (
        ("start", start, first.q[0] if first is not None else None),
        ("speed", speed, first.qd[0] if first is not None else None),
    ):
        if value is None:
            value = own if own is not None else np.zeros(robot.n)
        array = np.asarray(value, np.float64)
        if array.shape != (robot.n,) or not np.isfinite(array).all():
            raise InputError(
                f"{name} does not fit {robot.name}",
                found=str(list(array.shape)),
                expected=f"{robot.n} numbers",
            )
        states.append(array)
    return states[0], states[1]


def _control(
    plant: Plant,
    drive: Drive | None,
    values: Mapping[str, float],
) -> Control | None:
    robot, system = plant.robot, plant.system
    places: dict[str, Any] = {
        "place": system.motors,
        "seen": system.encoders,
        "limit": drive_limits(robot, values),
    }
    if drive is None:
        zeros = np.zeros((1, robot.n))
        return Control.held(zeros, 1.0, **places)
    if isinstance(drive, Torques):
        make = Control.linear if drive.linear else Control.held
        table = np.asarray(drive.table, np.float64)
        if table.ndim != 2 or table.shape[1] != robot.n:
            raise InputError(
                "the torques are another robot's", found=str(list(table.shape)), expected=f"[K, {robot.n}]"
            )
        return make(table, drive.period, **places)
    if drive.law not in LAWS:
        raise InputError("there is no such controller", found=repr(drive.law), expected=" or ".join(LAWS))
    motion = drive.trajectory.sampled(drive.period)
    if drive.law == "computed_torque":
        return Control.computed(motion.q, motion.qd, motion.qdd, drive.period, drive.kp, drive.kd, **places)
    ahead = None
    if not drive.without_model:
        ahead = model_torques(plant, motion, values)
    if drive.law == "feedforward":
        zeros = np.zeros_like(motion.q)
        return Control.held(zeros if ahead is None else ahead, drive.period, **places)
    return Control.pd(motion.q, motion.qd, drive.period, drive.kp, drive.kd, torque=ahead, **places)


def model_torques(plant: Plant, motion: Trajectory, parameters: Mapping[str, float] | None = None) -> Floats:
    """The torques [K, n] of the plant's model along ``motion``; stateful effects, at their steady
    values."""
    values = parameter_values(plant.robot, parameters)
    numbers = [values[name] for name in plant.robot.parameters]
    return plant.engine.model_torques(motion.q, motion.qd, motion.qdd, numbers)
