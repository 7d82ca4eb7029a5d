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
    [n, 3]: force and moment in the joints then, in the link's frame. ``link``, ``gear``, ``motor`` [n]:
    torques that the effects hold against the motion, summed up here; ``held_link``, ``held_motor`` [n]: most
    that dry friction holds on either side of a transmission, if it ``sticks``."""

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
    sticks: bool = False
    sums: Array = field(init=False)
    link: Array = field(init=False)
    gear: Array = field(init=False)
    motor: Array = field(init=False)
    held_link: Array = field(init=False)
    held_motor: Array = field(init=False)

    def __post_init__(self) -> None:
        self.sums = np.zeros((5, self.n))
        self.link, self.gear, self.motor, self.held_link, self.held_motor = self.sums

    def begin_step(self, t: float) -> None:
        """Nothing acts yet at the time ``t`` [s]."""
        self.t = t
        self.sums[:] = 0

    def rub(self, torques: Array, j: int, speed: float, levels: tuple[float, float], width: float) -> None:
        """Dry friction of joint ``j`` (from 0), ``levels`` [N m or N] against motion backward and forward.
        Where friction sticks it is a set, the middle of which is a torque; the rest is a constraint."""
        backward, forward = levels
        if self.sticks:
            held = self.held_link if torques is self.link else self.held_motor
            torques[j] += (forward - backward) / 2
            held[j] += (forward + backward) / 2
        else:
            torques[j] += (forward if speed > 0 else backward) * direction(speed, width)


#: Adds its torque to ``now.link``, ``now.gear`` or ``now.motor``.
Force = Callable[[Now], None]


@dataclass(frozen=True, slots=True)
class Scale:
    """What steps must know beforehand: ``step`` and ``duration`` [s]; ``inertia`` [n], the least that a motor
    feels [kg m^2 or kg]; ``seed`` of what is random; whether dry friction ``sticks``: else it creeps."""

    step: float
    inertia: Array
    duration: float
    seed: int
    sticks: bool = False


def width_of(scale: Scale, j: int, level: float) -> float:
    """Speed below which friction of ``level`` fades: a quarter of what one step could not hold."""
    return max(2 * level * scale.step / float(scale.inertia[j]), 1e-7)


def direction(speed: float, width: float) -> float:
    """The sign of a speed, fading below ``width``."""
    return speed / width if -width < speed < width else math.copysign(1.0, speed)
