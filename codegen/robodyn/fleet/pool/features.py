"""What is watched of a type's arms: effects of the catalogue at joints, and what each log shows of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects.friction import COULOMB, VISCOUS
from robodyn.effects.rigid import PAYLOAD
from robodyn.effects.sensors import BIAS, GAIN
from robodyn.effects.springs import BACKLASH
from robodyn.fleet.limits import SEEN
from robodyn.fleet.pool.numbers import DRIVES, LogNumbers
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
    places, moves, worth = numbers.places, numbers.worth > 0, np.maximum(numbers.worth, 1)
    joints = range(places.n)
    at = {name: [places.of(name, j) for j in joints] for name in DRIVES}
    errors = np.sqrt(np.maximum(np.diagonal(numbers.covariance, axis1=1, axis2=2), 0))
    # Friction [K, n] at the usual speed of each joint, and its standard error as a share of it.
    level = numbers.y[:, at["viscous"]] * numbers.speed + numbers.y[:, at["coulomb"]]
    across = numbers.covariance[:, at["viscous"], at["coulomb"]]
    variance = (errors[:, at["viscous"]] * numbers.speed) ** 2 + errors[:, at["coulomb"]] ** 2
    variance += 2 * numbers.speed * across
    share = np.where(level > 0, np.sqrt(np.maximum(variance, 0)) / np.maximum(level, 1e-300), np.inf)
    usual = np.nan_to_num(known_median(np.where(share < SEEN["friction"], level, np.nan)), nan=0.0)
    # Of each kind what logs show [K, n], its standard error, and what that is at most of what counts.
    measures: dict[Kind, tuple[Floats, Floats, Any]] = {
        "friction": (np.log(np.maximum(level, 1e-300)), share, SEEN["friction"]),
        "offset": (numbers.y[:, at["offset"]], errors[:, at["offset"]], SEEN["offset"] * usual),
        "gain": (numbers.y[:, at["gain"]], errors[:, at["gain"]], SEEN["gain"]),
        "play": (bursts, np.sqrt(0.5 / worth + 1 / np.maximum(struck, 1)), SEEN["play"]),
        "unexplained": (np.log(np.maximum(numbers.left, 1e-12)), np.sqrt(0.5 / worth), 1.0),
    }
    body, body_error = numbers.y[:, [places.mass]], errors[:, [places.mass]]
    values, stderr = np.full((2, len(level), len(features)), np.nan)
    for c, one in enumerate(features):
        j = (one.joint or 1) - 1
        value, error, most = measures.get(one.kind, (body, body_error, SEEN["body"] * numbers.mass))
        is_known = (error < most)[:, j] & np.isfinite(value[:, j]) & (moves[:, j] | (one.joint is None))
        values[is_known, c], stderr[is_known, c] = value[is_known, j], error[is_known, j]
    return Readings(values, stderr, np.where(moves, share, np.inf))
