"""A type of arms: its true numbers, the sensors of its controller, and the data sheet that is known of it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np
from benchmarks.fleet.arm import Arm, Day, Numbers, compiled, numbers_of, with_numbers
from benchmarks.fleet.limits import (
    CARRIED_SHARE,
    COARSE,
    CONTROL_PERIOD,
    COULOMB,
    DIGITS,
    ROTOR,
    TORQUE_STEP,
    TYPICAL,
    VISCOUS,
)
from benchmarks.fleet.programs import draw_program
from benchmarks.fleet.recipe import Recipe
from numpy.typing import NDArray

from robodyn.diagnose.blind.drawn import Usual, usual
from robodyn.diagnose.blind.limits import QUIET_SHARE
from robodyn.robot.model import EffectEntry, Robot
from robodyn.robot.writer import to_yaml
from robodyn.simulate.gains import default_gains, masses
from robodyn.simulate.sensors import Sensors, resolution_of
from robodyn.simulate.trajectories.trajectory import Trajectory

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class TrueType:
    """A type: the ``robot`` that it is modelled on, its ``numbers``; ``sensors`` of its controller with the
    RMS [n] of the torques' ``noise``, and the ``rate`` [Hz] of its logs; the standard deviation [n] of the
    logarithm of friction from unit to unit (``scatter``), and the shares [n] by which it falls a kelvin; what
    is ``usual`` of its ``motion``; ``sheet``, the description that is known of it."""

    robot: Robot
    numbers: Numbers
    sensors: Sensors
    noise: Floats
    rate: float
    scatter: Floats
    viscous_slope: Floats
    coulomb_slope: Floats
    motion: Trajectory
    usual: Usual
    sheet: str

    def arm(self, day: Day, cache: Path | None = None) -> Arm:
        """The arm of a ``day`` compiled, under a controller that takes every unit for the type's mean."""
        return _arm(self, day.coupler, tuple(day.values.items()), cache)


@lru_cache(maxsize=64)
def _arm(
    true: TrueType, coupler: EffectEntry | None, values: tuple[tuple[str, float], ...], cache: Path | None
) -> Arm:
    plant = compiled(true.robot, coupler, cache)
    known = {**true.numbers.by_name(), **dict(values)}
    return Arm(plant, true.numbers, *default_gains(plant.system, true.motion, "pd", CONTROL_PERIOD, known))


def draw_type(robot: Robot, recipe: Recipe, rng: np.random.Generator, cache: Path | None = None) -> TrueType:
    """A type modelled on ``robot``: what that does not state is drawn.

    Raises
    ------
    InputError: ``robot`` has run-time parameters, or cannot be simulated.
    """
    n = robot.n
    numbers = numbers_of(robot)
    motions = [draw_program(robot, rng).motion(TYPICAL[1], 1.0, rng) for _ in range(TYPICAL[0])]
    rotor, coulomb, viscous = (rng.uniform(*span, n) for span in (ROTOR, COULOMB, VISCOUS))
    carried = _carried(robot, numbers, motions, cache)
    numbers = replace(numbers, motor_inertia=_where_none(numbers.motor_inertia, rotor * carried))
    of_motions = [usual(with_numbers(robot, numbers), motion) for motion in motions]
    load, speed = (
        np.sqrt(np.mean([x**2 for x in each], axis=0))
        for each in zip(*((one.tau, one.speed) for one in of_motions), strict=True)
    )
    level = _where_none(numbers.coulomb, coulomb * np.maximum(load, QUIET_SHARE * load.max()))
    viscous = _where_none(numbers.viscous, viscous * level / speed)
    numbers = replace(numbers, coulomb=level, viscous=viscous)
    of_type = usual(with_numbers(robot, numbers), motions[0])
    noise = recipe.noise * np.maximum(of_type.tau, QUIET_SHARE * of_type.tau.max())
    return TrueType(
        robot,
        numbers,
        _sensors(robot, noise, recipe.encoder_bits),
        noise,
        float(rng.choice(recipe.rates)),
        rng.uniform(*recipe.scatter_friction, n),
        rng.uniform(*recipe.viscous_slope, n),
        rng.uniform(*recipe.coulomb_slope, n),
        motions[0].sampled(COARSE),
        of_type,
        _sheet(robot, numbers, recipe, rng),
    )


def _where_none(stated: Floats, drawn: Floats) -> Floats:
    return np.where(stated > 0, stated, drawn)


def _carried(robot: Robot, numbers: Numbers, motions: list[Trajectory], cache: Path | None) -> Floats:
    """The inertia [n] of the links at each joint, without rotors."""
    few = np.concatenate([motion.q[:: max(1, len(motion) // 16)] for motion in motions])
    bare = replace(numbers, motor_inertia=np.zeros(robot.n)).by_name()
    plant = compiled(robot, None, cache)
    carried = np.diagonal(masses(plant.system, few, bare), axis1=1, axis2=2).mean(axis=0)
    return np.asarray(np.maximum(carried, CARRIED_SHARE * carried.max()))


def _sensors(robot: Robot, noise: Floats, bits: int) -> Sensors:
    turn = resolution_of(bits)
    steps = [turn / (2 * np.pi) if link.joint.kind == "prismatic" else turn for link in robot.links]
    return Sensors(
        position_resolution=tuple(steps),
        velocity="none",
        acceleration="none",
        torque_noise=tuple(noise.tolist()),
        torque_resolution=TORQUE_STEP,
    )


def scattered(numbers: Numbers, share: float, friction: Floats | float, rng: np.random.Generator) -> Numbers:
    """``numbers`` off by ``share`` (inertial ones) and ``friction`` (the standard deviation [n] of its
    logarithm); a link's tensor is off as a whole, so that it stays one of a body."""
    n = len(numbers.mass)
    mass, inertia, rotor = (np.exp(share * rng.standard_normal(n)) for _ in range(3))
    viscous, coulomb = (np.exp(friction * rng.standard_normal(n)) for _ in range(2))
    return Numbers(
        numbers.mass * mass,
        numbers.com * (1 + share * rng.standard_normal((n, 3))),
        numbers.inertia * (mass * inertia)[:, None],
        numbers.motor_inertia * rotor,
        numbers.viscous * viscous,
        numbers.coulomb * coulomb,
    )


def _sheet(robot: Robot, numbers: Numbers, recipe: Recipe, rng: np.random.Generator) -> str:
    """The description that is known of the type: wrong as data sheets are, in some without friction."""
    wrong = scattered(numbers, recipe.sheet_inertial, recipe.sheet_friction, rng)
    if rng.random() < recipe.sheet_silent:
        none = np.zeros(robot.n)
        wrong = replace(wrong, viscous=none, coulomb=none)
    known = with_numbers(robot, wrong, DIGITS)
    source = "a data sheet: numbers of its units differ from it"
    return to_yaml(replace(known, title="", source=source, compare=None))
