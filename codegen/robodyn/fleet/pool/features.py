"""The numbers that every log of a type shows, and what they are called: effects of the catalogue at
joints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.identify.normal import Layout
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]
Kind = Literal["friction", "body", "play", "unexplained"]
#: What of a body at the tip a log tells: its mass and first moments [kg, kg m].
BODY: Final = 4


def _of_joint(key: str) -> Effect:
    """The effect that the joint's ``key`` of a description is."""
    folds = ((effect, effect.traits.fold) for effect in CATALOGUE.values())
    return next(effect for effect, fold in folds if fold and (fold.into, fold.key) == ("joint", key))


VISCOUS: Final = _of_joint("viscous")
COULOMB: Final = _of_joint("coulomb")
PAYLOAD: Final = next(effect for effect in CATALOGUE.values() if effect.traits.body)
PLAY: Final = next(effect for effect in CATALOGUE.values() if effect.traits.wears)


@dataclass(frozen=True, slots=True)
class Direction:
    """A way in which a feature may change: which ``effects`` change, and by how much of each number of its
    log (``places`` among :class:`Numbers`), in the ratio of what there is of them (``in_proportion``) or
    freely."""

    effects: tuple[str, ...]
    places: tuple[int, ...]
    in_proportion: bool = False


@dataclass(frozen=True, slots=True)
class Watched:
    """A feature: its ``name``, the ``joint`` (from 1) or None, its ``unit``, and its ``directions``, none
    where it is no number of the linear fit."""

    name: str
    kind: Kind
    joint: int | None
    unit: str
    effects: tuple[str, ...]
    directions: tuple[Direction, ...] = ()


@dataclass(frozen=True, slots=True)
class Numbers:
    """The numbers y that a log of an arm of ``n`` joints is reduced to: viscous and Coulomb friction and the
    torque's offset, [n] each, then mass and first moments of a body at the tip."""

    n: int

    @property
    def size(self) -> int:
        """How many they are."""
        return 3 * self.n + BODY

    def viscous(self, j: int) -> int:
        """That of joint ``j`` (from 0)."""
        return j

    def coulomb(self, j: int) -> int:
        """That of joint ``j`` (from 0)."""
        return self.n + j

    def offset(self, j: int) -> int:
        """That of joint ``j`` (from 0)."""
        return 2 * self.n + j

    @property
    def body(self) -> tuple[int, ...]:
        """Mass and first moments."""
        return tuple(range(3 * self.n, 3 * self.n + BODY))

    def drive_columns(self, layout: Layout) -> NDArray[np.intp]:
        """Where those of the drives stand in a layout [3 n]."""
        return np.concatenate([layout.joint(name) for name in ("viscous", "coulomb", "offset")])

    def body_columns(self, layout: Layout) -> NDArray[np.intp]:
        """Where those of the body do: it is a part of the last link [4]."""
        return layout.link(self.n - 1)[:BODY]


def watched(robot: Robot) -> tuple[Watched, ...]:
    """The features of a type. The offset of a torque is a number of each log and no feature: what is known of
    gravity not well enough looks like one, and it changes with every program of motion."""
    numbers, features = Numbers(robot.n), list[Watched]()
    for j, link in enumerate(robot.links):
        revolute = link.joint.kind == "revolute"
        v, c = numbers.viscous(j), numbers.coulomb(j)
        both = (COULOMB.id, VISCOUS.id)
        directions = (
            Direction(both, (v, c), in_proportion=True),
            Direction((VISCOUS.id,), (v,)),
            Direction((COULOMB.id,), (c,)),
        )
        torque = "N m" if revolute else "N"
        features.append(Watched(f"friction_{j + 1}", "friction", j + 1, torque, both, directions))
    body = Direction((PAYLOAD.id,), numbers.body)
    features.append(Watched(PAYLOAD.id, "body", None, "kg", body.effects, (body,)))
    features += [Watched(f"play_{j}", "play", j, "-", (PLAY.id,)) for j in range(1, robot.n + 1)]
    features += [Watched(f"unexplained_{j}", "unexplained", j, "-", ()) for j in range(1, robot.n + 1)]
    return tuple(features)
