"""The arm at a step, as what acts on it sees it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from peers.numbers import Array


@dataclass(slots=True)
class Now:
    """The arm at a step: ``q``, ``v`` [n] of the links, ``theta``, ``w`` [n] of the motors, ``a``, ``alpha``
    [n] their accelerations a step ago; ``load`` [n]: torque that the rigid arm took a step ago; ``f``, ``m``
    [n, 3]: force and moment in the joints then, in the link's frame. ``link``, ``motor`` [n]: torques that
    the effects hold against the motion, summed up here."""

    n: int
    t: float = 0.0
    q: Array = field(default_factory=lambda: np.zeros(0))
    v: Array = field(default_factory=lambda: np.zeros(0))
    theta: Array = field(default_factory=lambda: np.zeros(0))
    w: Array = field(default_factory=lambda: np.zeros(0))
    a: Array = field(default_factory=lambda: np.zeros(0))
    alpha: Array = field(default_factory=lambda: np.zeros(0))
    load: Array = field(default_factory=lambda: np.zeros(0))
    f: Array = field(default_factory=lambda: np.zeros(0))
    m: Array = field(default_factory=lambda: np.zeros(0))
    link: Array = field(default_factory=lambda: np.zeros(0))
    gear: Array = field(default_factory=lambda: np.zeros(0))
    motor: Array = field(default_factory=lambda: np.zeros(0))


#: Adds its torque to ``now.link``, ``now.gear`` or ``now.motor``.
Force = Callable[[Now], None]


@dataclass(frozen=True, slots=True)
class Scale:
    """What steps must know beforehand: ``step`` and ``duration`` [s]; ``inertia`` [n], the least that a motor
    feels [kg m^2 or kg]; ``seed`` of what is random."""

    step: float
    inertia: Array
    duration: float
    seed: int


def width_of(scale: Scale, j: int, level: float) -> float:
    """Speed below which friction of ``level`` fades: a quarter of what one step could not hold."""
    return max(2 * level * scale.step / float(scale.inertia[j]), 1e-7)


def direction(speed: float, width: float) -> float:
    """The sign of a speed, fading below ``width``."""
    return speed / width if -width < speed < width else math.copysign(1.0, speed)
