"""What is watched of a type's arms: effects of the catalogue at joints, and what each log shows of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects.friction import COULOMB, VISCOUS
from robodyn.effects.rigid import PAYLOAD
from robodyn.effects.sensors import BIAS, GAIN
from robodyn.effects.springs import BACKLASH
from robodyn.fleet.limits import SEEN
from robodyn.fleet.pool.numbers import LogNumbers
from robodyn.fleet.pool.population import known_median
from robodyn.robot.model import Robot

Kind = Literal["friction", "offset", "gain", "play", "unexplained", "body"]


@dataclass(frozen=True, slots=True)
class Watched:
    """A feature: its ``name``, ``kind``, ``joint`` (from 1; None: the whole arm), ``unit`` of measurement,
    and the ``effects`` that change it. It is known as a logarithm where it ``is_logarithm``."""

    name: str
    kind: Kind
    joint: int | None
    unit: str
    effects: tuple[str, ...]

    @property
    def is_logarithm(self) -> bool:
        """Whether its readings are logarithms of what is said of it."""
        return self.kind == "friction"

    def stated(self, value: float) -> float:
        """What is said of a reading, in its unit."""
        return float(np.exp(value)) if self.is_logarithm else value


def watched(robot: Robot) -> tuple[Watched, ...]:
    """The features of a type."""
    features = []
    for j, link in enumerate(robot.links, 1):
        torque = "N m" if link.joint.kind == "revolute" else "N"
        features += [
            Watched(f"friction_{j}", "friction", j, torque, (COULOMB.id, VISCOUS.id)),
            Watched(f"{BIAS.id}_{j}", "offset", j, torque, (BIAS.id,)),
            Watched(f"{GAIN.id}_{j}", "gain", j, "-", (GAIN.id,)),
            Watched(f"play_{j}", "play", j, "-", (BACKLASH.id,)),
            Watched(f"unexplained_{j}", "unexplained", j, "-", ()),
        ]
    return (*features, Watched(PAYLOAD.id, "body", None, "kg", (PAYLOAD.id,)))


@dataclass(frozen=True, slots=True, eq=False)
class Readings:
    """What logs show of features: ``value`` [K, F] and standard errors ``stderr`` [K, F], nan where a log
    does not show it; ``error`` [K, n]: how well each log knows the friction of a joint, as a share of it
    (inf: the joint does not move)."""

    value: Floats
    stderr: Floats
    error: Floats


def readings_of(
    features: tuple[Watched, ...], numbers: LogNumbers, bursts: Floats, struck: Floats
) -> Readings:
    """The readings of a type's logs; ``bursts`` and ``struck`` [K, n] as of
    :class:`~robodyn.fleet.digest.Digest`."""
    K = len(numbers.left)
    level, level_error = _levels(numbers)
    share = np.divide(level_error, level, out=np.full_like(level, np.inf), where=level > 0)
    usual = known_median(np.where(share < SEEN["friction"], level, np.nan))
    usual = np.where(np.isfinite(usual), usual, 0.0)
    values, errors = np.full((K, len(features)), np.nan), np.full((K, len(features)), np.inf)
    for c, one in enumerate(features):
        j = (one.joint or 1) - 1
        moves, worth = numbers.worth[:, j] > 0, np.maximum(numbers.worth[:, j], 1)
        if one.kind == "friction":
            value, error, most = np.log(np.maximum(level[:, j], 1e-300)), share[:, j], SEEN["friction"]
        elif one.kind == "offset":
            value, error = _of_place(numbers, numbers.places.of("offset", j))
            most = SEEN["offset"] * float(usual[j])
        elif one.kind == "gain":
            value, error = _of_place(numbers, numbers.places.of("gain", j))
            most = SEEN["gain"]
        elif one.kind == "play":
            value, most = bursts[:, j], SEEN["play"]
            error = np.sqrt(numbers.worth[:, j].clip(1) ** -1 / 2 + 1 / np.maximum(struck[:, j], 1))
        elif one.kind == "unexplained":
            value, error, most = np.log(np.maximum(numbers.left[:, j], 1e-12)), np.sqrt(0.5 / worth), 1.0
        else:
            value, error = _of_place(numbers, numbers.places.mass)
            most, moves = SEEN["body"] * numbers.mass, np.ones(K, dtype=bool)
        seen = moves & (error < most) & np.isfinite(value)
        values[seen, c], errors[seen, c] = value[seen], error[seen]
    return Readings(
        values, np.where(np.isfinite(values), errors, np.nan), np.where(numbers.worth > 0, share, np.inf)
    )


def _levels(numbers: LogNumbers) -> tuple[Floats, Floats]:
    """Friction [K, n] at the usual speed of each joint, and its standard error."""
    n = numbers.places.n
    level, error = np.zeros((len(numbers.y), n)), np.zeros((len(numbers.y), n))
    for j in range(n):
        pair = [numbers.places.of(name, j) for name in ("viscous", "coulomb")]
        weight = np.array([numbers.speed[j], 1.0])
        level[:, j] = numbers.y[:, pair] @ weight
        variance = np.einsum("a,kab,b->k", weight, numbers.covariance[:, pair][:, :, pair], weight)
        error[:, j] = np.sqrt(np.maximum(variance, 0))
    return level, error


def _of_place(numbers: LogNumbers, place: int) -> tuple[Floats, Floats]:
    """A number of all logs [K], and its standard error."""
    return numbers.y[:, place], np.sqrt(np.maximum(numbers.covariance[:, place, place], 0))
