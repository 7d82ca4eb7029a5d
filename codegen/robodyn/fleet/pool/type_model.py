"""A type of arm as its logs show it: readings of features, programs, clocks, and the population of each."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats, Indices
from robodyn.fleet.digest import Digest
from robodyn.fleet.limits import CLOCK_OFF
from robodyn.fleet.pool.features import Readings, Watched, readings_of, watched
from robodyn.fleet.pool.numbers import LogNumbers, numbers_of
from robodyn.fleet.pool.population import Population, known_median, population_of
from robodyn.fleet.pool.programs import programs_of
from robodyn.fleet.sources.fleet import ArmType, LogFile
from robodyn.robot.model import Robot
from robodyn.robot.reader import read_text


@dataclass(frozen=True, slots=True, eq=False)
class TypeModel:
    """A type's ``robot`` and ``features`` [F]; its ``logs`` [K] in order, the unit of each (``unit`` [K],
    from 0, of ``units``), ``program`` [K] (from 0) and ``clock`` [K]: its period between samples beside the
    usual one; ``numbers`` and ``readings`` of the logs; names of ``conditions`` and the ``population`` [F]
    of each feature."""

    name: str
    robot: Robot
    features: tuple[Watched, ...]
    logs: tuple[LogFile, ...]
    units: tuple[str, ...]
    unit: Indices
    program: Indices
    clock: Floats
    numbers: LogNumbers
    readings: Readings
    conditions: tuple[str, ...]
    population: tuple[Population, ...]

    @property
    def group(self) -> Indices:
        """Which unit and program each log is of [K]."""
        return self.unit * (int(self.program.max()) + 1) + self.program

    @property
    def dates(self) -> Floats:
        """When the logs were recorded [K] (s since 1970)."""
        return np.array([log.date for log in self.logs])

    def logs_of(self, unit: int) -> Indices:
        """The logs of a unit (from 0), by date."""
        return np.flatnonzero(self.unit == unit)


def type_model(arm: ArmType, logs: Sequence[LogFile], digest_of: Callable[[str], Digest]) -> TypeModel:
    """The model of a type from the digests of its ``logs``, which are sorted by unit and date."""
    robot = read_text(arm.text, arm.spec, warn=lambda _: None)
    features = watched(robot)
    units = tuple(dict.fromkeys(log.unit for log in logs))
    _, unit = np.unique([log.unit for log in logs], return_inverse=True)  # they are sorted

    def digest(k: int) -> Digest:
        return digest_of(logs[k].source)

    bursts, struck, speed, period, own = zip(
        *(
            (one.bursts, one.struck, one.speed, one.period, one.conditions)
            for one in map(digest, range(len(logs)))
        ),
        strict=True,
    )
    clock = np.array(period) / float(np.median(period))
    wrong = is_clock_wrong(clock)
    program = programs_of(unit, digest)
    numbers = numbers_of(robot, unit, ~wrong, digest)
    readings = readings_of(features, numbers, np.array(bursts), np.array(struck))
    readings.value[wrong] = np.nan
    names, conditions = _conditions([{**log.conditions, **one} for log, one in zip(logs, own, strict=True)])
    pace = np.where(numbers.worth > 0, np.log(np.maximum(np.array(speed), 1e-9)), np.nan)
    pace = np.nan_to_num(pace - known_median(pace), nan=0.0)
    pace = np.column_stack([pace.mean(axis=1), pace])  # of the whole arm, then of each joint
    group = unit * (int(program.max()) + 1) + program
    population = tuple(
        population_of(value, stderr, unit, group, np.column_stack([conditions, pace[:, one.joint or 0]]))
        for one, value, stderr in zip(features, readings.value.T, readings.stderr.T, strict=True)
    )
    return TypeModel(
        arm.name, robot, features, tuple(logs), units, unit, program, clock, numbers, readings, names,
        population,
    )  # fmt: skip


def is_clock_wrong(clock: Floats) -> NDArray[np.bool_]:
    """Which logs [K] have a period between samples that is off from the usual one as of a wrong clock: other
    rates are farther off."""
    off = np.abs(clock - 1)
    return np.asarray((off > CLOCK_OFF[0]) & (off < CLOCK_OFF[1]))


def _conditions(stated: Sequence[Mapping[str, float]]) -> tuple[tuple[str, ...], Floats]:
    """Names of the conditions that most logs state, and by how much they are beyond usual [K, c] (0: not
    known)."""
    names = sorted({name for one in stated for name in one})
    columns, used = [np.zeros((len(stated), 0))], []
    for name in names:
        column = np.array([one.get(name, np.nan) for one in stated])
        known = np.isfinite(column)
        if known.mean() > 0.5:
            used.append(name)
            columns.append(np.where(known, column - float(np.median(column[known])), 0.0)[:, None])
    return tuple(used), np.hstack(columns)
