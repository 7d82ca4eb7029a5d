"""The thesis's case study (chapter 3), repeated: how friction changes the torques along a straight line.

The thesis gives the line, its start, 201 samples in 2 s and the parameters of Table 3.4. It does not give the
velocity profile, the end of the line, the span of the bearings or the efficiency curve, so its curves cannot
be reproduced. :class:`Assumptions` fill these gaps: the result is a new study.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects.efficiency import efficiency_at
from robodyn.errors import InputError
from robodyn.kernels.robot_kernel import compile as compile_kernel
from robodyn.simulate.simulation import Follow, simulate
from robodyn.simulate.trajectories import ProfileName, Trajectory, line
from robodyn.thesis.case_arm import ARMS, D4_BRANCH, D4_START, Arm, Led, Robots, efficiency_curve, led, robots
from robodyn.thesis.printed import TABLE_3_4

LABEL: Final = "a new study on stated assumptions, not the thesis's Figures 3.6 to 3.13"

X: Final = 0.4
START: Final = 0.1
DURATION: Final = 2.0
SAMPLES: Final = 201
#: The sample that Table 3.5 shows: 0.6 s.
SHOWN: Final = 60
#: Profiles that begin and end at rest.
REST_TO_REST: Final[tuple[ProfileName, ...]] = ("quintic", "trapezoid")
#: Gains [N m/rad, N m s/rad] and period [s] of the controller in the forward simulation.
KP: Final = 200.0
KD: Final = 20.0
CONTROL_PERIOD: Final = 1e-3


@dataclass(frozen=True, slots=True)
class Assumptions:
    """Assumptions where the thesis is silent: velocity profile, y = z at the end of the line [m], span of the
    bearings [m], payload [kg], and how its arms are reconciled (:mod:`.case_arm`)."""

    profile: ProfileName = "quintic"
    end: float = 0.5
    span: float = 0.2
    payload: float = 0.0
    arm: Arm = "programs"


@dataclass(frozen=True, slots=True, eq=False)
class Torques:
    """Torques [S, 3] (N m) at the samples.

    ``rigid`` is the torque without friction, ``bearing`` the bearing friction (Eq 3.3), ``joint`` their sum.
    ``transmission`` is the friction of the transmission (Table 3.2), the sum of ``breakaway`` and ``loss``.
    ``input`` is the torque at the input, ``joint`` plus ``transmission``. ``load`` (a fraction) and
    ``efficiency`` [S, 3] are the operating points on the efficiency curve.
    """

    rigid: Floats
    bearing: Floats
    joint: Floats
    breakaway: Floats
    loss: Floats
    transmission: Floats
    input: Floats
    load: Floats
    efficiency: Floats


@dataclass(frozen=True, slots=True)
class Following:
    """Tracking of the motion in a forward simulation with the torques as feedforward: largest deviations of
    the joints [3] (rad) and of the point [m], and the energies of the run [J]."""

    joints: tuple[float, float, float]
    point: float
    energies: dict[str, float]


@dataclass(frozen=True, slots=True, eq=False)
class Study:
    """The study: ``motion``, ``point`` [S, 3] (m) and ``torques`` at the samples; forward simulations in open
    loop and with a PD controller. ``deviation`` is that of the point with the controller: times [s] and
    distances [m]."""

    assumptions: Assumptions
    led: Led
    robots: Robots
    motion: Trajectory
    point: Floats
    torques: Torques
    open_loop: Following
    closed_loop: Following
    deviation: tuple[Floats, Floats]

    @property
    def load_point(self) -> float:
        """Distance between the load of D.1.2 and the point that follows the line, at the start [m]."""
        from robodyn.thesis.case_arm import FOREARM, led_at

        loaded = led_at(self.robots.rigid, -FOREARM).kinematics.position(self.motion.q[0])
        return float(np.linalg.norm(loaded - self.point[0]))


def case_study(assumptions: Assumptions | None = None, *, cache: Path | None = None) -> Study:
    """Run the study.

    Raises
    ------
    InputError: a profile that is not at rest at both ends, an end out of reach, or an invalid
        payload or span.
    ToolError: no C compiler.
    """
    settings = assumptions or Assumptions()
    if settings.arm not in ARMS:
        raise InputError("there is no such arm", found=repr(settings.arm), expected=" or ".join(ARMS))
    if settings.profile not in REST_TO_REST:
        expected = " or ".join(REST_TO_REST)
        raise InputError(
            "the case study begins and ends at rest", found=repr(settings.profile), expected=expected
        )
    if settings.end == START:
        found = f"its end at y = z = {START}"
        raise InputError("the line has no length", found=found, remedy="choose another")
    arms = robots(settings.payload, settings.span)
    arm = led(settings.arm)
    fine = motion_of(settings, arm)
    motion = fine.sampled(DURATION / (SAMPLES - 1))
    place = arm.kinematics.position
    runs, deviation = [], (fine.t, fine.t)
    for law, kp, kd in (("feedforward", 0.0, 0.0), ("pd", KP, KD)):
        drive = Follow(fine, law, kp=kp, kd=kd, period=CONTROL_PERIOD)  # type: ignore[arg-type]  # of LAWS
        run = simulate(arms.complete, drive, sample_period=CONTROL_PERIOD, cache=cache)
        distances: Floats = np.linalg.norm(place(run.q) - place(fine.q), axis=1)
        one, two, three = np.abs(run.q - fine.q).max(axis=0).tolist()
        runs.append(Following((one, two, three), float(distances.max()), run.balance().to_dict()))
        deviation = run.t, distances
    torques = torques_along(arms, motion, cache)
    return Study(settings, arm, arms, motion, place(motion.q), torques, runs[0], runs[1], deviation)


def motion_of(assumptions: Assumptions, arm: Led) -> Trajectory:
    """The motion along the line, sampled as finely as it is simulated."""
    return line(
        arm.kinematics,
        (X, START, START),
        (X, assumptions.end, assumptions.end),
        DURATION,
        assumptions.profile,
        solver=lambda path: arm.inverse.continuous(path, D4_BRANCH, near=D4_START),
        period=CONTROL_PERIOD,
    )


def torques_along(arms: Robots, motion: Trajectory, cache: Path | None = None) -> Torques:
    """The torques along ``motion``, from kernels without friction, with bearings and with all friction."""
    kernels = [
        compile_kernel(robot, functions=["inverse_dynamics"], cache=cache)
        for robot in (arms.rigid, arms.with_bearings, arms.complete)
    ]
    rigid, joint, total = (
        np.asarray(kernel.inverse_dynamics(motion.q, motion.qd, motion.qdd)) for kernel in kernels
    )
    direction = np.sign(motion.qd)
    breakaway = direction * np.array([float(drive.breakaway) for drive in TABLE_3_4])
    load = np.abs(joint) / np.array([float(drive.largest) for drive in TABLE_3_4])
    knots = [(float(x), float(y)) for x, y in efficiency_curve()]
    efficiency = np.array([[efficiency_at(x, knots, "cubic") for x in row] for row in load.tolist()])
    bearing, transmission = joint - rigid, total - joint
    loss = transmission - breakaway
    return Torques(rigid, bearing, joint, breakaway, loss, transmission, total, load, efficiency)


def shares(torques: Torques) -> dict[str, Any]:
    """Peaks and root mean squares [3] of the torques [N m], the range of efficiencies [3], and the ratio [3]
    of the root mean squares of input torque and rigid torque."""
    result: dict[str, Any] = {}
    for name in ("rigid", "bearing", "joint", "transmission", "input"):
        values = getattr(torques, name)
        rms = np.sqrt((values**2).mean(axis=0))
        result[name] = {"peak": np.abs(values).max(axis=0).tolist(), "rms": rms.tolist()}
    moving = torques.efficiency[1:-1]  # at rest there is no loss
    result["efficiency"] = {"least": moving.min(axis=0).tolist(), "greatest": moving.max(axis=0).tolist()}
    pairs = zip(result["input"]["rms"], result["rigid"]["rms"], strict=True)
    result["factor"] = [input_rms / rigid_rms for input_rms, rigid_rms in pairs]
    return result
