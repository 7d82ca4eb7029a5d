"""The input of a simulation, from the options of ``simulate``."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from robodyn.errors import InputError
from robodyn_cli.output import talk
from robodyn_cli.robot_files import load_robot
from robodyn_cli.simulate_options import SimulationOptions, exactly, spread

if TYPE_CHECKING:
    from robodyn.robot import Robot
    from robodyn.simulate.plant import Plant
    from robodyn.simulate.simulation import Drive, Follow
    from robodyn.simulate.trajectories import Trajectory

#: Default duration [s]: of --to and --line, and of everything else.
MOVE, RUN = 2.0, 10.0
_CONTROL_RATE = 1000.0
_HARMONICS = 5


@dataclass(frozen=True, slots=True)
class Driven:
    """A compiled robot with its input and duration [s]; ``description`` describes the input for the
    provenance."""

    plant: Plant
    drive: Drive | None
    duration: float
    description: dict[str, Any] = field(default_factory=dict)

    @property
    def reference(self) -> Trajectory | None:
        """The reference motion."""
        return getattr(self.drive, "trajectory", None)


def driven(robot: Robot, settings: SimulationOptions, values: Mapping[str, float]) -> Driven:
    """The input of ``robot`` that ``settings`` selects; ``values`` are its run-time parameters.

    Raises
    ------
    InputError: an option or a file does not fit the robot.
    ToolError: no C compiler.
    """
    from robodyn.simulate.limits import outside
    from robodyn.simulate.plant import build_plant

    if settings.drive is None:
        return Driven(build_plant(robot), None, settings.duration or RUN, {"kind": "free"})
    if settings.drive == "torque":
        return _torques(robot, settings)
    motion = _motion(robot, settings, values)
    duration = settings.duration if settings.duration is not None else motion.duration
    if settings.drive == "trajectory" and duration > motion.duration * (1 + 1e-9):
        talk(f"robodyn: note: the motion ends at {motion.duration:g} s; its last row is held")
    for text in outside(robot, motion):
        talk(f"robodyn: warning: {text}")
    model = None if settings.model is None else _model(robot, settings.model)
    law = (settings.controller or "pd").replace("-", "_")
    plant = build_plant(robot, model=model)
    follow = _controller(plant, settings, motion, law, model, values)
    description = {
        "kind": "follow", "trajectory": motion.describe(), "controller": law,
        "control_rate": 1 / follow.period, "model": None if model is None else model.name,
    }  # fmt: skip
    if settings.trajectory is not None:
        description["sha256"] = _hash(settings.trajectory)
    if law != "feedforward":
        description.update(kp=follow.kp, kd=follow.kd)
    return Driven(plant, follow, duration, description)


def _torques(robot: Robot, settings: SimulationOptions) -> Driven:
    from robodyn.simulate.plant import build_plant
    from robodyn.simulate.simulation import Torques
    from robodyn.simulate.trajectories.file import read_torques

    file = settings.torque
    table, period = read_torques(file, robot.n)
    end = (len(table) - 1) * period if len(table) > 1 else 0.0
    if settings.duration is None and len(table) == 1:
        raise InputError("one row of torques has no duration", remedy="add --duration S")
    duration = settings.duration if settings.duration is not None else end
    if len(table) > 1 and duration > end * (1 + 1e-9):
        talk(f"robodyn: note: the torques end at {end:g} s; the last row is held")
    drive = Torques(table, period if math.isfinite(period) else duration, settings.linear)
    description = {
        "kind": "torque",
        "file": Path(file).name,
        "sha256": _hash(file),
        "linear": settings.linear,
    }
    return Driven(build_plant(robot), drive, duration, description)


def _controller(
    plant: Plant,
    settings: SimulationOptions,
    motion: Trajectory,
    law: Any,
    model: Robot | None,
    values: Mapping[str, float],
) -> Follow:
    from robodyn.simulate.gains import default_gains
    from robodyn.simulate.simulation import Follow

    period = _control_period(settings)
    gains: dict[str, Any] = {"kp": 0.0, "kd": 0.0}
    if law != "feedforward":
        default = default_gains(plant.system, motion, law, period, values)
        for (name, chosen), gain in zip((("kp", settings.kp), ("kd", settings.kd)), default, strict=True):
            gains[name] = gain.tolist() if chosen is None else spread(f"--{name}", chosen, plant.robot)
    return Follow(motion, law, period=period, model=model, **gains)


def _model(robot: Robot, spec: str) -> Robot:
    """The controller's model of ``robot``."""
    model = load_robot(spec)
    if model.n != robot.n or not set(model.parameters) <= set(robot.parameters):
        raise InputError(
            f"--controller-model does not fit {robot.name}",
            found=f"{model.n} joints, run-time parameters {', '.join(model.parameters) or 'none'}",
            expected=f"{robot.n} joints, run-time parameters among {', '.join(robot.parameters) or 'none'}",
        )
    return model


def _control_period(settings: SimulationOptions) -> float:
    return float(1 / (settings.control_rate if settings.control_rate is not None else _CONTROL_RATE))


# --- motions ----------------------------------------------------------------------------------------------


def _motion(robot: Robot, settings: SimulationOptions, values: Mapping[str, float]) -> Trajectory:
    """The motion to follow."""
    if settings.drive == "trajectory":
        from robodyn.simulate.trajectories import from_file

        return from_file(settings.trajectory, robot.n)
    if settings.drive == "excite":
        return _excitation(robot, settings)
    start = settings.start if settings.start is not None else (0.0,) * robot.n
    duration = settings.duration if settings.duration is not None else MOVE
    if settings.drive == "to":
        return _straight(robot, settings, start, duration)
    return _line(robot, settings, start, duration, values)


def _straight(
    robot: Robot, settings: SimulationOptions, start: tuple[float, ...], duration: float
) -> Trajectory:
    import numpy as np

    from robodyn.simulate.trajectories import quintic, trapezoid

    end, period = exactly("--to", settings.to, robot), _control_period(settings)
    assert end is not None
    way = np.abs(np.subtract(end, start))
    if settings.profile != "trapezoid" or not way.any():
        return quintic(start, end, duration, period=period)
    # A quarter of the time to accelerate, a quarter to decelerate; joints at rest get the largest limits.
    fastest = np.where(way > 0, way, way.max()) / (0.75 * duration)
    return trapezoid(start, end, fastest, fastest / (0.25 * duration), period=period)


def _line(
    robot: Robot,
    settings: SimulationOptions,
    start: tuple[float, ...],
    duration: float,
    values: Mapping[str, float],
) -> Trajectory:
    from robodyn.simulate.kinematics import Kinematics
    from robodyn.simulate.trajectories import line

    link = settings.link if settings.link is not None else min(robot.n, 6)
    tool = (0.0, 0.0, 0.0) if robot.tool is None or link != robot.n else tuple(map(float, robot.tool.xyz))
    point = settings.point if settings.point is not None else tool
    kinematics = Kinematics(robot, values, point, link)
    place, rotation = kinematics.pose(start)
    begin, end = settings.line if len(settings.line) == 2 else (place, settings.line[0])
    return line(
        kinematics, begin, end, duration, settings.profile or "quintic", start=start,
        rotation=rotation if link == 6 else None, period=_control_period(settings),
    )  # fmt: skip


def _excitation(robot: Robot, settings: SimulationOptions) -> Trajectory:
    from robodyn.simulate.limits import ASSUMED, with_limits
    from robodyn.simulate.trajectories import fourier

    limited, filled = with_limits(robot)
    if filled:
        words = []
        for kind in sorted({robot.links[i - 1].joint.kind for i in filled}, reverse=True):
            (low, high), unit = ASSUMED[kind].position or (0, 0), "m" if kind == "prismatic" else "rad"
            v, a = ASSUMED[kind].velocity, ASSUMED[kind].acceleration
            words.append(
                f"{float(low):.3g} to {float(high):.3g} {unit}, {v} {unit}/s, {a} {unit}/s^2 ({kind})"
            )
        joints = ", ".join(map(str, filled))
        talk(f"robodyn: note: {robot.name} has no limits for joint {joints}; assumed: {'; '.join(words)}")
    frequency = settings.base_frequency
    if frequency is None:
        frequency = 1 / (settings.duration if settings.duration is not None else RUN)
    duration = settings.duration if settings.duration is not None else 1 / frequency
    harmonics = settings.harmonics if settings.harmonics is not None else _HARMONICS
    periods = max(1, math.ceil(duration * frequency * (1 - 1e-12)))
    period = _control_period(settings)
    return fourier(limited, frequency, harmonics, settings.seed, periods=periods, period=period)


def _hash(path: str) -> str:
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()
