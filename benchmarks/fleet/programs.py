"""What an arm does all day: a program goes from point to point, again and again, never quite the same."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np
from benchmarks.fleet.limits import (
    CONTROL_PERIOD,
    LONGEST_DWELL,
    POINTS,
    REACH,
    SHIFT,
    SHORTEST_MOVE,
    STOPS,
    TOP_RATE,
    TOP_SPEED,
    WIDEST,
)
from numpy.typing import NDArray

from robodyn.robot.model import Robot
from robodyn.simulate.limits import with_limits
from robodyn.simulate.trajectories.trajectory import Trajectory, hermite, sample_times

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Program:
    """Points [m, n] (rad or m) that are passed in turn; at those that are ``stops`` [m] the arm rests, for
    ``dwell`` [m] (s). ``velocity`` and ``acceleration`` [n] are what it moves by at full speed."""

    points: Floats
    stops: NDArray[np.bool_]
    dwell: Floats
    velocity: Floats
    acceleration: Floats

    def motion(self, duration: float, speed: float, rng: np.random.Generator) -> Trajectory:
        """The program from one of its stops on for ``duration`` [s], at a share ``speed`` of its full speed;
        every point a little elsewhere, as things lie."""
        m = len(self.points)
        place = int(rng.choice(np.flatnonzero(self.stops)))
        knots, x, moving = [0.0], [self._near(place, rng)], [False]
        while knots[-1] < duration:
            if self.stops[place] and self.dwell[place] > 0:
                knots.append(knots[-1] + float(self.dwell[place]))
                x.append(x[-1])
                moving.append(False)
            place = (place + 1) % m
            following = self._near(place, rng)
            knots.append(knots[-1] + self._time(following - x[-1], speed))
            x.append(following)
            moving.append(not self.stops[place])
        t, points = np.array(knots), np.array(x)
        v = np.zeros_like(points)
        for k in np.flatnonzero(moving[:-1]):
            v[k] = (points[k + 1] - points[k - 1]) / (t[k + 1] - t[k - 1])
        law = partial(hermite, t, points, v, np.zeros_like(points))
        times = sample_times(duration, CONTROL_PERIOD, beyond=False)
        return Trajectory(times, *law(times), {"kind": "program"}, law)

    def _near(self, place: int, rng: np.random.Generator) -> Floats:
        return np.asarray(self.points[place] + SHIFT * rng.standard_normal(self.points.shape[1]))

    def _time(self, way: Floats, speed: float) -> float:
        size = np.abs(way)
        by_speed = (TOP_SPEED * size / self.velocity).max()
        by_rate = np.sqrt((TOP_RATE * size / self.acceleration).max())
        return float(max(by_speed, by_rate, SHORTEST_MOVE) / speed)


def draw_program(robot: Robot, rng: np.random.Generator) -> Program:
    """A program for ``robot``, inside its limits."""
    limited, _ = with_limits(robot)
    own = [link.joint.limits for link in limited.links]
    position = np.array([limits.position for limits in own], float)
    velocity, acceleration = (np.array([getattr(limits, name) for limits in own], float)
                              for name in ("velocity", "acceleration"))  # fmt: skip
    middle, half = position.mean(axis=1), np.ptp(position, axis=1) / 2
    reach = np.minimum(rng.uniform(*REACH, robot.n) * half, WIDEST)
    centre = middle + rng.uniform(-1, 1, robot.n) * (0.9 * half - reach)
    count = int(rng.integers(POINTS[0], POINTS[1] + 1))
    points = centre + reach * rng.uniform(-1, 1, (count, robot.n))
    stops = rng.random(count) < STOPS
    stops[0] = True
    return Program(points, stops, rng.uniform(0, LONGEST_DWELL, count), velocity, acceleration)
