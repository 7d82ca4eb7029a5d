"""Effects drawn at random, of shapes that occur and of a size that is wanted.

What is not drawn is how large they are: an effect has a scale ``x``, and who hides it turns that until it
shows as much as it should.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.amend.amending import LEVELS
from robodyn.diagnose.blind.limits import DRAWN_SAMPLES, LOADED_SHARE
from robodyn.diagnose.select.rigid import Model
from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError
from robodyn.robot.effects import belongs
from robodyn.robot.model import Robot
from robodyn.simulate.trajectories.trajectory import Trajectory

Floats = NDArray[np.float64]
Parameters = dict[str, float | str]

#: While a joint moves one way these are constant there: two of them look like a third.
_CONSTANT = frozenset({*LEVELS, "coulomb_friction", "torque_bias", "transmission_loss"})
_COUPLERS = frozenset({"joint_elasticity", "backlash"})
#: One body at the tip.
_BODIES = frozenset({"payload", "inertial_error"})
#: These need a joint that carries something.
_OF_LOAD = frozenset(
    {"load_dependent_friction", "transmission_loss", "torque_gain", "encoder_offset", "inertial_error",
     "torque_saturation", *_COUPLERS}
)  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Usual:
    """What is usual of a robot on a motion, [n] each: RMS torque ``tau`` and largest torque ``peak``, RMS
    ``speed`` and ``rate`` (of acceleration), the speed below which a tenth of the time is spent (``slow``),
    the inertia that a joint's spring carries (``weight``), RMS torque of gravity (``held``), the ``middle``
    of the motion."""

    robot: Robot
    duration: float
    tau: Floats
    peak: Floats
    speed: Floats
    rate: Floats
    slow: Floats
    weight: Floats
    held: Floats
    middle: Floats


def usual(robot: Robot, motion: Trajectory) -> Usual:
    """What is usual of ``robot`` on ``motion``."""
    step = max(1, len(motion) // DRAWN_SAMPLES)
    q, qd, qdd = (x[::step] for x in (motion.q, motion.qd, motion.qdd))
    model = Model(robot)
    tau = model.torque(q, qd, qdd)
    few = q[:: max(1, len(q) // 20)]
    still = np.zeros_like(few)
    resting = model.evaluate(few, still, still).rigid
    weight = np.empty(robot.n)
    for j in range(robot.n):
        unit = still.copy()
        unit[:, j] = 1.0
        weight[j] = np.mean((model.evaluate(few, still, unit).rigid - resting)[:, j])
    rms = [np.maximum(np.sqrt(np.mean(x**2, axis=0)), 1e-9) for x in (tau, qd, qdd)]
    slow = np.maximum(np.quantile(np.abs(qd), 0.1, axis=0), 1e-3 * np.abs(qd).max() + 1e-9)
    middle = (q.max(axis=0) + q.min(axis=0)) / 2
    held = np.sqrt(np.mean(resting**2, axis=0))
    peak = np.abs(tau).max(axis=0)
    return Usual(robot, motion.duration, rms[0], peak, rms[1], rms[2], slow, weight, held, middle)


@dataclass(frozen=True, slots=True)
class Form:
    """An effect of any size: its parameters by the scale x; a first guess ``start`` of x; what is physically
    likely, ``least`` and ``most``."""

    build: Callable[[float], Parameters]
    start: float
    least: float = 1e-9
    most: float = np.inf


def places(id: str, u: Usual) -> list[int | None]:
    """Joints (from 1; None: the whole robot) at which the effect ``id`` can be and would show."""
    if belongs(CATALOGUE[id], of_robot=True) and id != "torque_gain":
        return [None]
    found: list[int | None] = []
    for j, link in enumerate(u.robot.links):
        if id in _OF_LOAD and u.tau[j] < LOADED_SHARE * u.tau.max():
            continue
        if id == "encoder_offset" and u.held[j] <= LOADED_SHARE * u.held.max():
            continue
        if id in _COUPLERS and link.joint.motor_inertia == 0:
            continue
        if id == "motor_coupling" and (j == 0 or link.joint.kind != u.robot.links[j - 1].joint.kind):
            continue
        if id in LEVELS and _rubs(u.robot, j + 1):
            continue
        found.append(j + 1)
    return found


def _rubs(robot: Robot, joint: int) -> bool:
    """Whether the joint has a law of friction already."""
    laws = any(entry.effect in LEVELS for entry in robot.effects_at(joint))
    return laws or robot.links[joint - 1].joint.coulomb != 0


def draw(
    u: Usual, count: int, rng: np.random.Generator, taken: Sequence[Amendment] = ()
) -> tuple[Amendment, ...]:
    """``count`` effects and joints beside those that are ``taken``, without parameters; no two of a kind, nor
    two that together look like a third.

    Raises
    ------
    InputError: the robot has no room for so many.
    """
    found = list(taken)
    free = {id: places(id, u) for id in CATALOGUE}
    while len(found) < len(taken) + count:
        left = {
            id: [joint for joint in joints if all(_apart(id, joint, one) for one in found)]
            for id, joints in free.items()
        }
        ids = [id for id, joints in left.items() if joints]
        if not ids:
            raise InputError(
                f"{u.robot.name} has no room for so many effects", found=f"{count}", expected=f"{len(found)}"
            )
        id = ids[int(rng.integers(len(ids)))]
        found.append(Amendment(id, left[id][int(rng.integers(len(left[id])))], {}))
    return tuple(found[len(taken) :])


def _apart(id: str, joint: int | None, other: Amendment) -> bool:
    pair = {id, other.effect}
    if id == other.effect or pair == _BODIES:
        return False
    return joint != other.joint or joint is None or not (pair <= _CONSTANT or pair <= _COUPLERS)


def form(id: str, joint: int | None, u: Usual, rng: np.random.Generator) -> Form:
    """The effect ``id`` at ``joint``, its shape drawn by ``rng``, its size open."""
    j = (joint or 1) - 1
    near = float(0.05 * u.tau[j])
    tau, speed, rate = float(u.tau[j]), float(u.speed[j]), float(u.rate[j])
    kind = u.robot.links[j].joint.kind

    def drawn(low: float, high: float) -> float:
        return float(np.exp(rng.uniform(np.log(low), np.log(high))))

    way = float(rng.choice([-1.0, 1.0]))
    match id:
        case "viscous_friction":
            return Form(lambda x: {"coefficient": x}, near / speed)
        case "coulomb_friction":
            return Form(lambda x: {"level": x}, near)
        case "asymmetric_friction":
            lean = way * drawn(0.25, 0.5)
            return Form(lambda x: {"positive": x * (1 + lean), "negative": x * (1 - lean)}, near)
        case "stribeck_friction":
            rise, knee = drawn(1.6, 2.5), float(u.slow[j]) * drawn(0.7, 1.4)
            return Form(lambda x: {"level": x, "static": rise * x, "velocity": knee}, near)
        case "power_law_friction":
            a = float(rng.choice([0.5, 0.6, 0.7, 2.0]))
            return Form(lambda x: {"level": x, "exponent": a}, near / speed**a)
        case "presliding_hysteresis":
            bend = drawn(3e-3, 2e-2) * (1.0 if kind == "revolute" else 0.3)
            return Form(lambda x: {"level": x, "stiffness": x / bend, "damping": 0.01 * x / bend}, near)
        case "load_dependent_friction":
            return _bearing(kind == "revolute", rng)
        case "transmission_loss":
            rest = float(rng.choice([0.0, 0.3]))
            return Form(lambda x: {"efficiency": 1 / (1 + x), "breakaway": rest * x * tau}, 0.05, 0.003, 1.5)
        case "spring":
            rest = float(u.middle[j] + rng.uniform(-0.3, 0.3) * (1.0 if kind == "revolute" else 0.3))
            return Form(lambda x: {"stiffness": x, "rest": rest}, near)
        case "joint_elasticity":
            softest = float(u.weight[j]) * (2 * np.pi * 6.0) ** 2
            return Form(
                lambda x: {"stiffness": 1 / x, "damping": 2e-3 / x, "encoder": "motor"},
                0.3 / softest, 1e-9, 1 / softest,
            )  # fmt: skip
        case "backlash":
            teeth = float(u.weight[j]) * (2 * np.pi * 12.0) ** 2
            return Form(
                lambda x: {"gap": x, "stiffness": teeth, "damping": 2e-3 * teeth, "encoder": "motor"},
                0.005, 1e-4, 0.03,
            )  # fmt: skip
        case "rotor_inertia":
            return Form(lambda x: {"inertia": x}, near / rate)
        case "torque_ripple":
            waves, phase = float(round(drawn(20, 60))), float(rng.uniform(-3, 3))
            return Form(lambda x: {"amplitude": x, "cycles_per_rev": waves, "phase": phase}, near)
        case "motor_coupling":
            return Form(
                lambda x: {"with": float(j), "ratio": way, "inertia": 0.6 * x / rate,
                           "viscous": 0.5 * x / speed, "coulomb": 0.5 * x},
                near,
            )  # fmt: skip
        case "payload":
            x0, y0, z0 = (float(v) for v in rng.uniform([-0.05, -0.05, 0.03], [0.05, 0.05, 0.15]))
            return Form(lambda x: {"mass": x, "com_x": x0, "com_y": y0, "com_z": z0}, 0.3, 1e-3, 50.0)
        case "inertial_error":
            mass = float(u.robot.links[j].mass)  # type: ignore[arg-type]  # constants
            a, b = (float(v) for v in rng.standard_normal(2) * 0.05)
            return Form(
                lambda x: {"delta_mass": 0.5 * x * mass, "delta_com_x": a * x, "delta_com_y": b * x,
                           "delta_zz": 0.2 * x},
                0.3, 1e-3, 3.0,
            )  # fmt: skip
        case "base_tilt":
            c, s = (float(f(rng.uniform(0, 2 * np.pi))) for f in (np.cos, np.sin))
            return Form(lambda x: {"tilt_x": x * c, "tilt_y": x * s}, 0.05, 1e-4, 0.25)
        case "torque_bias":
            return Form(lambda x: {"bias": way * x}, near)
        case "torque_gain":
            return Form(lambda x: {"gain": way * x}, 0.05, 1e-3, 0.5)
        case "time_delay":
            return Form(lambda x: {"delay": x}, 0.005, 1e-4, 0.05)
        case "encoder_offset":
            return Form(lambda x: {"offset": way * x}, 0.03, 1e-4, 0.2)
        case "torque_saturation":
            who, peak = str(rng.choice(["drive", "sensor"])), float(u.peak[j])
            return Form(lambda x: {"limit": peak / (1 + x), "clips": who}, 0.15, 0.01, 0.8)
        case "external_contact":
            start = float(rng.uniform(0.2, 0.7)) * u.duration
            end = start + float(rng.uniform(0.03, 0.08)) * u.duration
            push = rng.standard_normal(3)
            push = push / np.linalg.norm(push)
            window = {"start": round(start, 3), "end": round(end, 3), "link": float(u.robot.n)}
            force = {f"force_{axis}": float(f) for axis, f in zip("xyz", push, strict=True)}
            return Form(lambda x: {**window, **{k: x * f for k, f in force.items()}}, 30.0, 0.01, 500.0)
    raise InputError(f"{id} cannot be drawn", remedy="give its parameters")


def _bearing(revolute: bool, rng: np.random.Generator) -> Form:
    if not revolute:
        return Form(lambda x: {"bearing": "linear", "mu": x, "span": 0.3}, 0.05, 1e-4, 0.5)
    if rng.random() < 0.5:
        return Form(lambda x: {"bearing": "torque", "mu": x}, 0.05, 1e-3, 0.5)
    return Form(lambda x: {"bearing": "radial", "mu_r": x}, 0.005, 1e-5, 0.1)


def settings(build: Parameters, given: Mapping[str, float | str]) -> Parameters:
    """Parameters with what is ``given`` in their place, six digits each, as a model is amended by them."""
    both: Parameters = {**build, **given}
    return {name: value if isinstance(value, str) else float(f"{value:.6g}") for name, value in both.items()}
