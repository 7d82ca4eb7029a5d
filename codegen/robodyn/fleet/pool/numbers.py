"""From digests to numbers: what the arms of a type have in common, what each unit is throughout, and what
each log shows.

First the inertial numbers of the type, from the logs of all its units. Then two sets of numbers: ``y`` of the
log itself (friction, offset and gain of each joint's torque, a body at the tip) and ``d`` of its unit (by how
much its links and rotors differ from the type's). ``d`` is the same in all logs of a unit, so that motions in
which it shows differently are no change of ``y``. All of it is arithmetic on triangles
(:class:`robodyn.fleet.digest.Digest`), in information form: what a log does not show has no information.
Each joint of each log counts by what is left of its torque and by how many of its samples say the same.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.fleet.digest import Digest
from robodyn.fleet.limits import ANY_NUMBER, BODY_SHARE, GAIN_SHARE, LINK_SHARE
from robodyn.fleet.pool.population import known_median
from robodyn.identify.normal import Layout
from robodyn.identify.prior import Prior, Usual, prior_of
from robodyn.robot.model import Robot

#: What a log tells of the drive of each joint: friction, offset and gain of its torque.
DRIVES: Final = ("viscous", "coulomb", "offset", "gain")
#: What a log tells of a body at the tip: its mass and first moments [kg, kg m].
BODY: Final = 4
#: Fits of the type, each with the noise that the last one left.
_ROUNDS: Final = 2


@dataclass(frozen=True, slots=True)
class Places:
    """Where the numbers y of a log of an arm of ``n`` joints stand: viscous and Coulomb friction, offset and
    gain of the torque, [n] each, then mass and first moments of a body at the tip."""

    n: int

    @property
    def size(self) -> int:
        """How many there are."""
        return len(DRIVES) * self.n + BODY

    @property
    def mass(self) -> int:
        """The place of the body's mass."""
        return len(DRIVES) * self.n

    def of(self, drive: str, j: int) -> int:
        """The place of one of :data:`DRIVES` of joint ``j`` (from 0)."""
        return DRIVES.index(drive) * self.n + j

    def columns(self, layout: Layout) -> NDArray[np.intp]:
        """Those columns of a layout, with a gain for each joint behind it, that the numbers multiply."""
        drives = [layout.joint(name) for name in DRIVES[:-1]]
        gains = layout.size + np.arange(self.n)
        return np.concatenate([*drives, gains, layout.link(self.n - 1)[:BODY]])


@dataclass(frozen=True, slots=True, eq=False)
class LogNumbers:
    """What the logs of a type show: their numbers ``y`` [K, s] with ``covariance`` [K, s, s]; RMS of what is
    left of each joint's torque (``left`` [K, n]), and how many samples say something of their own (``worth``
    [K, n]); the ``mass`` of all links [kg], ``speed`` [n] that is usual of the joints."""

    places: Places
    y: Floats
    covariance: Floats
    left: Floats
    worth: Floats
    mass: float
    speed: Floats


@dataclass(frozen=True, slots=True, eq=False)
class _Type:
    """The ``layout``; which columns are ``rigid`` [k], their ``numbers`` [k] and how these scatter from unit
    to unit (``scatter`` [k]); precisions of what a log does not show (``unseen`` [s])."""

    layout: Layout
    rigid: NDArray[np.intp]
    numbers: Floats
    scatter: Floats
    unseen: Floats

    def vector(self, numbers: Floats, y: Floats | None = None) -> Floats:
        """All numbers of the layout, and gains [p + n]: ``numbers`` of links and rotors, and ``y`` of a
        log."""
        x = np.zeros(self.layout.size + self.layout.n)
        x[self.rigid] = numbers
        if y is not None:
            x[Places(self.layout.n).columns(self.layout)] += y
        return x


def numbers_of(
    robot: Robot, units: NDArray[np.intp], used: NDArray[np.bool_], digest: Callable[[int], Digest]
) -> LogNumbers:
    """The numbers of logs of a type: the ``digest`` of each (from 0) is asked for several times, one after
    the other; ``units`` [K]: the unit of each (from 0), ``used`` [K]: whether it counts."""
    # Of each log rows, how many say the same, squares left by a fit of its own, torque, speed, acceleration.
    heads = [
        (one.rows, one.alike, [R[-1, -1] ** 2 for R in one.roots], one.torque, one.speed, one.acceleration)
        for one in map(digest, range(len(units)))
    ]
    rows, alike, free, *motion = (np.array(each) for each in zip(*heads, strict=True))
    rows = np.where(used[:, None], rows, 0.0)
    moving = (known_median(np.where(rows > 0, each, np.nan)) for each in motion)
    usual = Usual(*(np.nan_to_num(each, nan=1e-9) for each in moving))
    layout, places = digest(0).layout, Places(robot.n)
    least = (1e-6 * usual.torque) ** 2
    variance = np.maximum(free / np.maximum(rows, 1), least)
    prior = prior_of(robot, layout, usual)
    whole = _type_of(prior, prior_of(robot, layout, usual, LINK_SHARE).sd, layout)
    y = np.zeros((len(rows), places.size))
    covariance = np.zeros((len(rows), places.size, places.size))
    for _ in range(_ROUNDS):
        weights = np.where(rows > 0, 1 / (variance * alike), 0.0)
        whole = _fit_type(whole, prior, digest, weights)
        for unit in range(int(units.max()) + 1):
            own = np.flatnonzero(units == unit)
            several = [digest(k) for k in own.tolist()]
            y[own], covariance[own], variance[own] = _fit_unit(whole, several, weights[own], rows[own])
        variance = np.maximum(variance, least)
    masses = layout.link(0)[0] + 10 * np.arange(robot.n)
    mass = max(float(np.abs(whole.numbers[np.isin(whole.rigid, masses)]).sum()), 1e-6)
    return LogNumbers(places, y, covariance, np.sqrt(variance), rows / alike, mass, usual.speed)


def _type_of(prior: Prior, scatter: Floats, layout: Layout) -> _Type:
    """The type as its description has it, with numbers of units that ``scatter`` [p]."""
    drives = np.concatenate([layout.joint(name) for name in DRIVES[:-1]])
    rigid = np.setdiff1d(np.arange(layout.size), drives)
    if "rotor" in layout.own:
        rotors = layout.joint("rotor")
        scatter[rotors] = LINK_SHARE * np.maximum(prior.mean[rotors], LINK_SHARE * prior.sd[rotors])
    masses = float(prior.mean[layout.link(0)[0] + 10 * np.arange(layout.n)].sum())
    body = np.full(BODY, max(BODY_SHARE * masses, 1e-6))
    drive = ANY_NUMBER * np.maximum(prior.sd[drives], 1e-12)
    unseen = np.concatenate([drive, np.full(layout.n, GAIN_SHARE), body])
    return _Type(layout, rigid, prior.mean[rigid], scatter[rigid], 1 / unseen**2)


def _fit_type(whole: _Type, prior: Prior, digest: Callable[[int], Digest], weights: Floats) -> _Type:
    """The type with the inertial numbers that the logs of all its units have in common; drives and a body at
    the tip are each log's own, gains 1."""
    start = 1 / prior.sd[whole.rigid] ** 2
    H, h = np.diag(start), start * prior.mean[whole.rigid]
    bare = replace(whole, numbers=np.zeros_like(whole.numbers))
    precision = np.diag(1 / whole.scatter**2)
    for k, weight in enumerate(weights):
        info, weighted = _marginal(*_equations(bare, digest(k), weight), bare)
        # A unit's links scatter about the type's: a log says no more than that of these.
        less = solve(info + precision, np.column_stack([info, weighted]))
        H += info - info @ less[:, :-1]
        h += weighted - info @ less[:, -1]
    return replace(whole, numbers=solve((H + H.T) / 2, h))


def _fit_unit(
    whole: _Type, digests: Sequence[Digest], weights: Floats, rows: Floats
) -> tuple[Floats, Floats, Floats]:
    """Of the logs of a unit the numbers y [k, s], their covariances [k, s, s], and the variance [k, n] of
    what is left of torques."""
    s = len(whole.unseen)
    every = [_equations(whole, one, weight) for one, weight in zip(digests, weights, strict=True)]
    H, h = np.diag(1 / whole.scatter**2), np.zeros(len(whole.scatter))
    for equations in every:
        info, weighted = _marginal(*equations, whole)
        H, h = H + info, h + weighted
    d = solve((H + H.T) / 2, h)
    y, covariance, variance = np.zeros((len(every), s)), np.zeros((len(every), s, s)), np.zeros_like(weights)
    for k, ((info, weighted), digest) in enumerate(zip(every, digests, strict=True)):
        covariance[k] = solve(info[:s, :s] + np.diag(whole.unseen), np.eye(s))
        y[k] = covariance[k] @ (weighted[:s] - info[:s, s:] @ d)
        x = whole.vector(whole.numbers + d, y[k])
        gains = 1 + y[k, Places(whole.layout.n).of("gain", 0) :][: whole.layout.n]
        for j, R in enumerate(digest.roots):
            columns = whole.layout.columns(j)
            rigid = np.where(np.isin(columns, whole.rigid), gains[j], 1.0)
            left = R[:, -1] - R[:, :-1] @ (x[columns] * rigid)
            variance[k, j] = float(left @ left) / max(float(rows[k, j]), 1.0)
    return y, covariance, variance


def _equations(whole: _Type, digest: Digest, weights: Floats) -> tuple[Floats, Floats]:
    """What a log says of its own numbers y and its unit's d: information [s + k, s + k] and its product with
    both [s + k]."""
    layout = whole.layout
    size, x = layout.size, whole.vector(whole.numbers)[: layout.size]
    H, h = np.zeros((size + layout.n, size + layout.n)), np.zeros(size + layout.n)
    for j, R in enumerate(digest.roots):
        columns, gram = layout.columns(j), weights[j] * (R.T @ R)
        inner, torque = gram[:-1, :-1], gram[:-1, -1]
        rigid = inner @ x[columns]  # what a gain multiplies
        H[np.ix_(columns, columns)] += inner
        H[columns, size + j] = H[size + j, columns] = rigid
        H[size + j, size + j] = float(x[columns] @ rigid)
        left = torque - rigid
        h[columns] += left
        h[size + j] = float(x[columns] @ left)
    # A body at the tip is a part of the last link: its columns stand in both sets.
    which = np.concatenate([Places(layout.n).columns(layout), whole.rigid])
    return H[np.ix_(which, which)], h[which]


def _marginal(info: Floats, weighted: Floats, whole: _Type) -> tuple[Floats, Floats]:
    """The same of d [k] alone, where y may be anything."""
    s = len(whole.unseen)
    inner, across = info[:s, :s] + np.diag(whole.unseen), info[:s, s:]
    less = solve(inner, np.column_stack([across, weighted[:s]]))
    return info[s:, s:] - across.T @ less[:, :-1], weighted[s:] - across.T @ less[:, -1]


def solve(H: Floats, b: Floats) -> Floats:
    """``x`` of ``H x = b``, of a symmetric matrix [p, p] in any units that is not negative: what rounding
    leaves of numbers that a log cannot tell apart is shared between them."""
    unit = 1 / np.sqrt(np.maximum(np.diag(H), 1e-300))
    scaled = H * np.outer(unit, unit) + 1e-9 * np.eye(len(H))
    sides = b[:, None] if b.ndim == 1 else b
    x = unit[:, None] * np.linalg.solve(scaled, unit[:, None] * sides)
    return np.asarray(x[:, 0] if b.ndim == 1 else x)
