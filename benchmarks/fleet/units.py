"""A unit of a simulated fleet: its own numbers, programs and days, and its logs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from benchmarks.fleet.arm import Day, Numbers
from benchmarks.fleet.changes import (
    CLOCK_RUNS,
    DATE_LOST,
    FRICTION,
    PROGRAM,
    Change,
    changed,
    draw_effect,
    draw_friction,
    when,
    window,
)
from benchmarks.fleet.limits import (
    DAY,
    FIRST_DAY,
    LOST_DATE,
    REFERENCE,
    SHIFTS,
    SLOW,
    SPEEDS,
    UNEVEN,
    WARMEST_DAY,
    YEAR,
)
from benchmarks.fleet.programs import Program, draw_program
from benchmarks.fleet.recipe import Recipe
from benchmarks.fleet.types import TrueType, scattered
from numpy.typing import NDArray

from robodyn.effects.rigid import PAYLOAD
from robodyn.effects.springs import BACKLASH
from robodyn.fleet.result import CLOCK, PROGRAM_CHANGE
from robodyn.logs.log import Log
from robodyn.simulate.sensors import measure
from robodyn.simulate.trajectories.trajectory import Trajectory

Floats = NDArray[np.float64]

PLAY, LOAD = "play", PAYLOAD.id


@dataclass(frozen=True, slots=True, eq=False)
class Unit:
    """A unit of a type: true ``numbers`` at the temperature for which friction is stated, ``gains`` [n] of
    the torques in its logs, ``programs``, and those that it runs ``later``; ``dates`` [K] (s since 1970)
    and ``temperature`` [K] (deg C) of its logs; the ``seed`` of everything in them; what is
    planted (None: nothing)."""

    numbers: Numbers
    gains: Floats
    programs: tuple[Program, ...]
    dates: Floats
    temperature: Floats
    seed: int
    change: Change | None = None
    later: tuple[Program, ...] = ()

    def stated_date(self, k: int) -> float:
        """What the clock says of the log ``k`` [s since 1970]."""
        date = float(self.dates[k])
        lost = self.change is not None and self.change.kind == DATE_LOST and self.change.level(date)
        return date - LOST_DATE if lost else date


def draw_unit(kind: str | None, true: TrueType, recipe: Recipe, seed: int, cache: Path | None = None) -> Unit:
    """A unit of the type ``true`` in which a change of a ``kind`` is planted (None: nothing): friction, play,
    payload, or the id of an effect.

    Raises
    ------
    InputError: the effect cannot be planted, or shows nowhere.
    """
    rng = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(0,)))
    numbers = scattered(true.numbers, float(rng.uniform(*recipe.scatter_inertial)), true.scatter, rng)
    gains = 1 + rng.uniform(*recipe.scatter_gain) * rng.standard_normal(true.robot.n)
    programs = _programs(true, recipe, rng)
    dates = _dates(recipe, rng)
    while window(dates, recipe.growth[0] * DAY) is None:
        dates = _dates(recipe, rng)
    unit = Unit(numbers, gains, programs, dates, _temperature(dates, recipe, rng), seed)
    if kind is None:
        return unit
    later = _programs(true, recipe, rng) if kind == PROGRAM else ()
    return replace(unit, later=later, change=_planted(kind, unit, true, recipe, rng, cache))


def _programs(true: TrueType, recipe: Recipe, rng: np.random.Generator) -> tuple[Program, ...]:
    count = int(rng.integers(recipe.programs[0], recipe.programs[1] + 1))
    return tuple(draw_program(true.robot, rng) for _ in range(count))


def _dates(recipe: Recipe, rng: np.random.Generator) -> Floats:
    """Days of the year, unevenly, at hours of the day."""
    count = int(rng.integers(recipe.logs[0], recipe.logs[1] + 1))
    gaps = rng.gamma(UNEVEN, size=count + 1)
    days = np.floor(np.cumsum(gaps)[:-1] / gaps.sum() * recipe.days)
    seconds = FIRST_DAY + days * DAY + rng.uniform(*SHIFTS, count) * 3600
    return np.asarray(np.sort(np.round(seconds)))


def _temperature(dates: Floats, recipe: Recipe, rng: np.random.Generator) -> Floats:
    """Of the gears: the workshop's, by the season and the day, and what they have warmed up by."""
    day = (dates - FIRST_DAY) / DAY
    summer = np.cos(2 * np.pi * (day - WARMEST_DAY) / YEAR)
    room = rng.uniform(*recipe.workshop) + rng.uniform(*recipe.season) * summer
    room = room + recipe.daily * rng.standard_normal(len(day))
    return np.asarray(room + rng.uniform(*recipe.warm_up, len(day)))


def _planted(
    kind: str, unit: Unit, true: TrueType, recipe: Recipe, rng: np.random.Generator, cache: Path | None
) -> Change:
    grows = (recipe.growth[0] * DAY, recipe.growth[1] * DAY)
    span: tuple[float | None, float] = when(unit.dates, grows, rng)
    if kind == FRICTION:
        return draw_friction(true, recipe.friction_size, recipe.one_law, span, rng)
    if kind in (PROGRAM, CLOCK_RUNS, DATE_LOST):
        at_once = when(unit.dates, (0.0, 0.0), rng)
        off = recipe.clock_share if kind == CLOCK_RUNS else 1.0
        return Change(kind, (PROGRAM_CHANGE if kind == PROGRAM else CLOCK,), None, *at_once, off, {})
    id, size = kind, recipe.effect_size
    if kind == PLAY:
        id, size = BACKLASH.id, recipe.play_size
    elif kind == LOAD:
        id, size = PAYLOAD.id, recipe.payload_size
        span = when(unit.dates, (0.0, 0.0), rng)
        if rng.random() < recipe.payload_always:
            span = (None, 0.0)
    return draw_effect(id, kind, true, unit.numbers, unit.programs[0], size, span, rng, cache)


# --- its logs ---------------------------------------------------------------------------------------------


#: What perfect sensors show of an arm of a type on a day that follows a motion.
Moved = Callable[[TrueType, Day, Trajectory, Path | None], Log]


def moved(true: TrueType, day: Day, motion: Trajectory, cache: Path | None = None) -> Log:
    """The arm in robodyn's own simulator.

    Raises
    ------
    InputError: the arm runs away.
    """
    return true.arm(day, cache).log(motion, day.numbers, true.rate, day.values)


def log_of_day(
    unit: Unit, k: int, true: TrueType, recipe: Recipe, cache: Path | None = None, by: Moved = moved
) -> Log:
    """The log ``k`` of ``unit`` as its controller records it, moved ``by`` a simulator.

    Raises
    ------
    InputError: the arm runs away.
    """
    rng = np.random.default_rng(np.random.SeedSequence(unit.seed, spawn_key=(1, k)))
    duration, speed = rng.uniform(*recipe.duration), rng.uniform(*SPEEDS)
    duration = duration * SLOW if rng.random() < recipe.short else duration
    speed = speed * SLOW if rng.random() < recipe.slow else speed
    level = unit.change.level(float(unit.dates[k])) if unit.change is not None else 0.0
    programs = unit.later if unit.later and level else unit.programs
    program = programs[int(rng.integers(len(programs)))]
    motion = program.motion(round(duration, 1), speed, rng)
    warm = float(unit.temperature[k]) - REFERENCE
    daily = np.exp(recipe.daily_friction * rng.standard_normal((2, true.robot.n)))
    numbers = replace(
        unit.numbers,
        viscous=unit.numbers.viscous * np.exp(-true.viscous_slope * warm) * daily[0],
        coulomb=unit.numbers.coulomb * np.exp(-true.coulomb_slope * warm) * daily[1],
    )
    day = changed(unit.change, level, true, numbers)
    exact = by(true, day, motion, cache)
    exact = replace(exact, tau=exact.tau * unit.gains)
    recorded = measure(exact, true.sensors, day.sensors, seed=int(rng.integers(1 << 31)))
    runs = unit.change is not None and unit.change.kind == CLOCK_RUNS and level
    return replace(recorded, t=recorded.t * (1 - unit.change.size)) if runs and unit.change else recorded


def shown_temperature(unit: Unit, k: int, recipe: Recipe) -> float:
    """What a thermometer shows at the log ``k`` [deg C]."""
    rng = np.random.default_rng(np.random.SeedSequence(unit.seed, spawn_key=(2, k)))
    return float(unit.temperature[k] + recipe.thermometer * rng.standard_normal())
