"""The numbers that every log of a type shows: effects of the catalogue at joints. A log is reduced to them,
and to what its unit has throughout.

First the inertial numbers of the type, from the logs of all its units, each log's friction being its own.
Then, log by log, the normal equations of two sets of numbers: ``y`` of the log itself (friction and offset
of each joint, a body at the tip) and ``d`` of its unit (by how much its links, rotors and torque constants
differ from the type's). ``d`` is the same in all logs of a unit, so that programs of motion in which it
shows differently are no change of ``y``. All of it is arithmetic on triangles
(:class:`robodyn.fleet.digest.Digest`), in information form: what a log does not show has no information.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.fleet.digest import Digest
from robodyn.fleet.limits import ALIKE, ANY_NUMBER, BODY_SIZE, GAIN_SCATTER, LEAST_ROTOR, LINK_SCATTER
from robodyn.identify.normal import Layout
from robodyn.identify.prior import Usual, prior_of
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


# --- the reduction of a digest ----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class Reduced:
    """What a log says of its numbers y [s] and its unit's d [r]: ``information`` [s + r, s + r] and its
    product with both (``weighted`` [s + r])."""

    information: Floats
    weighted: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Rigid:
    """The type's ``numbers`` [k] of links and rotors and their ``places`` in the layout; how links, rotors
    and torque constants scatter from unit to unit (``scatter`` [r], standard deviations); ``unseen`` [s]:
    precisions of what a log does not show of the numbers y."""

    layout: Layout
    numbers: Floats
    places: NDArray[np.intp]
    scatter: Floats
    unseen: Floats

    @property
    def mass(self) -> float:
        """Of all links [kg], as numbers that fit: some of them may have none of their own."""
        masses = self.layout.link(0)[0] + 10 * np.arange(self.layout.n)
        return max(float(np.abs(self.numbers[np.isin(self.places, masses)]).sum()), 1e-6)

    @property
    def whole(self) -> Floats:
        """All numbers of the layout [p], drives at rest."""
        x = np.zeros(self.layout.size)
        x[self.places] = self.numbers
        return x


def rigid_of(robot: Robot, usual: Usual, digests: Callable[[], Iterable[Digest]]) -> Rigid:
    """The inertial numbers of ``robot``'s type from the ``digests`` of logs of its units, one after the
    other."""
    layout = next(iter(digests())).layout
    numbers = Numbers(robot.n)
    prior = prior_of(robot, layout, usual)
    drive = numbers.drive_columns(layout)
    places = np.setdiff1d(np.arange(layout.size), drive)
    sizes = prior_of(robot, layout, usual, LINK_SCATTER).sd[places]
    if "rotor" in layout.own:
        rotors = np.isin(places, layout.joint("rotor"))
        usually = np.maximum(prior.mean[places][rotors], LEAST_ROTOR * prior.sd[places][rotors])
        sizes[rotors] = LINK_SCATTER * usually
    precision = np.diag(1 / sizes**2)
    own = 1 / (ANY_NUMBER * np.maximum(prior.sd[drive], 1e-12)) ** 2
    start = 1 / prior.sd[places] ** 2
    H, h = np.diag(start), start * prior.mean[places]
    for digest in digests():
        whole, right = _normal_equations(digest)
        D = whole[np.ix_(drive, drive)] + np.diag(own)
        C = whole[np.ix_(places, drive)]
        across = solved(D, np.column_stack([C.T, right[drive]]))
        info, weighted = whole[np.ix_(places, places)] - C @ across[:, :-1], right[places] - C @ across[:, -1]
        # A unit's links scatter about the type's: a log says no more than that of these.
        less = solved(info + precision, np.column_stack([info, weighted]))
        H += info - info @ less[:, :-1]
        h += weighted - info @ less[:, -1]
    pooled = solved((H + H.T) / 2, h)
    scatter = np.concatenate([sizes, np.full(robot.n, GAIN_SCATTER)])
    rigid = Rigid(layout, pooled, places, scatter, own)
    return replace(rigid, unseen=np.concatenate([own, np.full(BODY, (BODY_SIZE * rigid.mass) ** -2)]))


def reduced(rigid: Rigid, digest: Digest) -> Reduced:
    """What a log says of its own numbers and of its unit's."""
    layout, numbers = rigid.layout, Numbers(rigid.layout.n)
    size, x = layout.size, rigid.whole
    H, h = np.zeros((size + layout.n, size + layout.n)), np.zeros(size + layout.n)
    for j, R in enumerate(digest.roots):
        at, gram = layout.columns(j), R.T @ R
        columns, torque = gram[:-1, :-1], gram[:-1, -1]
        rigid_torque = columns @ x[at]  # what a larger torque constant would multiply
        H[np.ix_(at, at)] += columns
        H[at, size + j] = H[size + j, at] = rigid_torque
        H[size + j, size + j] = float(x[at] @ rigid_torque)
        left = torque - rigid_torque
        h[at] += left
        h[size + j] = float(x[at] @ left)
    own = np.concatenate([numbers.drive_columns(layout), numbers.body_columns(layout)])
    # A body at the tip is a part of the last link: its columns stand in both sets.
    which = np.concatenate([own, rigid.places, size + np.arange(layout.n)])
    return Reduced(H[np.ix_(which, which)], h[which])


def solved(H: Floats, b: Floats) -> Floats:
    """``x`` of ``H x = b``, of a symmetric matrix [p, p] in any units that is not negative: what rounding
    leaves of numbers that a log cannot tell apart is shared between them."""
    unit = 1 / np.sqrt(np.maximum(np.diag(H), 1e-300))
    scaled = H * np.outer(unit, unit) + ALIKE * np.eye(len(H))
    sides = b[:, None] if b.ndim == 1 else b
    x = unit[:, None] * np.linalg.solve(scaled, unit[:, None] * sides)
    return np.asarray(x[:, 0] if b.ndim == 1 else x)


def _normal_equations(digest: Digest) -> tuple[Floats, Floats]:
    """Curvature [p, p] and right-hand side [p] of all joints' weighted rows."""
    layout = digest.layout
    H, h = np.zeros((layout.size, layout.size)), np.zeros(layout.size)
    for j, R in enumerate(digest.roots):
        at, gram = layout.columns(j), R.T @ R
        H[np.ix_(at, at)] += gram[:-1, :-1]
        h[at] += gram[:-1, -1]
    return H, h


def with_scatter(one: Reduced, scatter: Floats) -> Reduced:
    """The same, where the numbers y of a log are those of its unit but for a ``scatter`` [s, s]
    (covariance)."""
    s = len(scatter)
    inner = one.information[:s, :s] + np.linalg.inv(scatter)
    across = one.information[:, :s]
    less = solved(inner, np.column_stack([across.T, one.weighted[:s]]))
    N = one.information - across @ less[:, :-1]
    return Reduced((N + N.T) / 2, one.weighted - across @ less[:, -1])


def beside_unit(one: Reduced, d: Floats) -> Reduced:
    """What a log says of its numbers y, where those of its unit are ``d`` [r]."""
    s = len(one.weighted) - len(d)
    return Reduced(one.information[:s, :s], one.weighted[:s] - one.information[:s, s:] @ d)
