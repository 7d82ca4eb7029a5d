"""Motors that run ahead of their links: where the links are, from the motors' motion alone.

The arm's motion is taken to be the motors', and how far the link of a joint lags behind is the answer of an
oscillator to the torque of that: the inertia that the joint feels, on the spring or in the backlash between.
The arm is linear in a lag so small; the spring need not be.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects.catalogue import CATALOGUE
from robodyn.identify.limits import (
    LAG_BEGIN,
    LAG_EDGE,
    LAG_PIECE,
    LAG_SHARES,
    STEP_ANGLE,
)
from robodyn.identify.oscillator import Oscillator
from robodyn.kernels.array_dynamics import Evaluated, Model, Moved


@dataclass(frozen=True, slots=True, eq=False)
class Slopes:
    """What torques [K, n] of the arm change by as joint ``j`` (from 0) moves: by its position, velocity and
    acceleration."""

    j: int
    place: Floats
    rate: Floats
    inertia: Floats

    def of(self, lag: Floats) -> Floats:
        """Change [K, n] by a ``lag`` [K, 3] of that joint and its rates."""
        return -(self.place * lag[:, :1] + self.rate * lag[:, 1:2] + self.inertia * lag[:, 2:])


def slopes_of(model: Model, q: Floats, qd: Floats, qdd: Floats, rigid: Floats, j: int) -> Slopes:
    """Slopes along a motion [K, n] of which ``rigid`` [K, n] are the torques."""

    def by(which: int, step: float) -> Floats:
        moved = [q, qd, qdd]
        moved[which] = moved[which].copy()
        moved[which][:, j] += step
        return np.asarray((model.rigid_torque(moved[0], moved[1], moved[2]) - rigid) / step)

    return Slopes(j, by(0, 1e-6), by(1, 1e-6), by(2, 1.0))


def lag_of(
    effect: str,
    values: Mapping[str, Any],
    torque: Floats,
    felt: tuple[Floats, Floats, Floats],
    period: float,
    passed: Floats | None = None,
    kept: dict[int, list[Floats]] | None = None,
) -> Floats:
    """How far [K, 3] the link is behind its motor, with rates, under the ``torque`` [K] that the arm would
    take without; ``felt``: that torque's slopes [K] over acceleration, velocity and position of the joint.
    Samples are a ``period`` [s] apart. Not finite from where the link diverges.

    How it begins follows from the torque that was measured to pass, ``passed`` [K], over the first second but
    for the log's edge, where accelerations are not known; without that it begins at rest.

    Where samples are far apart for so quick a spring there are steps between them: by the trapezoidal rule it
    is softer by a sixth of the square of its angle in a step. Of the same arrays the values between samples
    are ``kept``, by the number of steps.
    """
    spring = _Spring.of(effect, values, float(np.abs(torque).max()))
    angle = period * float(np.sqrt(spring.stiffest / max(float(np.median(felt[0])), 1e-9)))
    steps = min(max(1, int(np.ceil(angle / STEP_ANGLE))), 8)
    if steps == 1:
        return _lag(spring, torque, felt, period, passed)
    kept = {} if kept is None else kept
    if steps not in kept:
        kept[steps] = [_between(x, steps) for x in (torque, *felt, *([] if passed is None else [passed]))]
    torque, mass, rub, stiff, *more = kept[steps]
    known = more[0] if more else None
    return _lag(spring, torque, (mass, rub, stiff), period / steps, known)[::steps]


def _between(x: Floats, steps: int) -> Floats:
    """Samples [K] with ``steps`` - 1 values of a cubic spline between each two."""
    from scipy.interpolate import CubicSpline

    places = np.arange((len(x) - 1) * steps + 1) / steps
    return np.asarray(CubicSpline(np.arange(len(x)), x)(places))


def _lag(
    spring: _Spring,
    torque: Floats,
    felt: tuple[Floats, Floats, Floats],
    period: float,
    passed: Floats | None,
) -> Floats:
    """The lag [K, 3] of a link on a ``spring``, with a step at each sample."""
    link = Oscillator((torque, *felt), period, (spring.force, spring.low, spring.width), spring.damping)
    begin = np.array([spring.at_rest(float(torque[0])), 0.0])
    if passed is not None and len(passed) * period > LAG_PIECE:  # two numbers more for each piece of a log
        first, last = round(LAG_EDGE / period), max(8, round(LAG_BEGIN / period))
        quick = np.sqrt(spring.stiffest / max(float(felt[0][0]), 1e-9))
        sizes = spring.width * np.array([1.0, quick])
        begin = _begun(link, spring, begin, sizes, passed[:last], first)
    lag = link.motion((float(begin[0]), float(begin[1])))
    far = np.abs(lag[:, 0]) > -1e3 * spring.low  # diverged
    if far.any():
        lag[int(np.argmax(far)) :] = np.nan
    return lag


def _begun(
    link: Oscillator, spring: _Spring, begin: Floats, sizes: Floats, passed: Floats, first: int
) -> Floats:
    """Place and rate at first with which the torque of the spring is nearest to ``passed`` [L], from the
    sample ``first`` on, by steps of ``sizes`` from ``begin``; and, as backlash has several sides, from where
    the link would rest under other torques."""
    loads = (float(passed[first]), 0.0, -float(passed[0]))
    starts = [begin, *(np.array([spring.at_rest(load), 0.0]) for load in loads)]
    ends = [first + max(8, round(share * (len(passed) - first))) for share in LAG_SHARES]

    def squares(place: Floats) -> float:
        left = link.misfit((float(place[0]), float(place[1])), passed[: ends[0]])[first:]
        return float(left @ left) if np.isfinite(left).all() else np.inf

    place = min(starts, key=squares)
    # Over a short time first: after a few blows of its teeth a link may be anywhere.
    for end in ends:
        place = _nearest(link, place, sizes, passed[:end], first)
    return place


def _nearest(link: Oscillator, begin: Floats, sizes: Floats, passed: Floats, first: int) -> Floats:
    """Place and rate near ``begin`` that leave least of ``passed`` [L] from ``first`` on."""

    def missed(at: Floats) -> Floats:
        return link.misfit((float(at[0]), float(at[1])), passed)[first:]

    left = missed(begin)
    if not np.isfinite(left).all():
        return begin
    for _ in range(5):
        slopes = np.stack([missed(begin + one) - left for one in np.diag(sizes)], axis=1)
        if not np.isfinite(slopes).all():
            break
        step = sizes * np.linalg.lstsq(slopes, left, rcond=1e-9)[0]
        for share in (1.0, 0.3, 0.1):
            now = missed(begin - share * step)
            if now @ now < left @ left:
                break
        else:
            break
        settled = now @ now > 0.999 * (left @ left)
        begin, left = begin - share * step, now
        if settled:
            break
    return begin


@dataclass(frozen=True, slots=True, eq=False)
class _Spring:
    """Torque over twist, piecewise linear: ``force`` at places a ``width`` apart, from ``low`` on."""

    low: float
    width: float
    force: Floats
    damping: float

    @classmethod
    def of(cls, effect: str, values: Mapping[str, Any], most: float) -> _Spring:
        coupler = CATALOGUE[effect].coupler
        assert coupler is not None
        reach = abs(float(coupler.twist(values, 4 * most + 1e-9)))
        places = np.linspace(-reach, reach, 4001)
        force = np.asarray(coupler.torque(values, places, 0.0), dtype=np.float64)
        return cls(-reach, float(places[1] - places[0]), force, float(values["damping"]))

    @property
    def stiffest(self) -> float:
        """Its largest slope."""
        return float(np.diff(self.force).max()) / self.width

    def at_rest(self, torque: float) -> float:
        """The twist that holds ``torque``."""
        places = self.low + self.width * np.arange(len(self.force))
        return float(np.interp(torque, self.force, places))


def _slopes(model: Model, motion: Moved, rigid: Floats, j: int) -> Slopes:
    if model.reuse is None:
        return slopes_of(model, *motion, rigid, j)
    slopes: Slopes = model.reuse.of(
        f"slopes{j}", model.arm, motion, lambda: slopes_of(model, *motion, rigid, j)
    )
    return slopes


def behind_motors(
    model: Model, q: Floats, qd: Floats, qdd: Floats, period: float, tau: Floats | None = None
) -> Evaluated:
    """``model`` along a motion [K, n] that its encoders saw, some of them on motors that run ahead; samples
    are a ``period`` [s] apart. The torque ``tau`` [K, n] that was measured gives its initial state."""
    seen = model.evaluate(q, qd, qdd)
    if not model.couplers:
        return seen
    lags = lags_of(model, seen, (q, qd, qdd), period, tau)
    return model.evaluate(*links_of((q, qd, qdd), lags), (q, qd, qdd))


def lags_of(
    model: Model, seen: Evaluated, motion: Moved, period: float, tau: Floats | None = None
) -> dict[int, Floats]:
    """By joint (from 0) with a coupler how far [K, 3] its link is behind its motor, with rates; ``seen``: the
    ``model`` along the ``motion``; the rest as in :func:`behind_motors`."""
    q, qd, qdd = motion
    couplers = model.couplers
    slopes = {j: _slopes(model, (q, qd, qdd), seen.rigid, j) for j in couplers}
    lags = {j: np.zeros((len(q), 3)) for j in couplers}
    for _ in range(2 if len(couplers) > 1 else 1):
        for j, coupler in couplers.items():
            others = sum((slopes[k].of(lags[k])[:, j] for k in couplers if k != j), np.zeros(len(q)))
            load = seen.passed[:, j] + others
            own = seen.total[:, j] - seen.passed[:, j]
            passed = None if tau is None else tau[:, j] - own
            felt = (slopes[j].inertia[:, j], slopes[j].rate[:, j], slopes[j].place[:, j])
            lags[j] = lag_of(coupler.effect.id, coupler.values, load, felt, period, passed)
    return lags


def links_of(motion: Moved, lags: Mapping[int, Floats]) -> Moved:
    """The links' motion, of the ``motion`` of their motors and how far they are behind."""
    q, qd, qdd = (x.copy() for x in motion)
    for j, lag in lags.items():
        for array, back in zip((q, qd, qdd), lag.T, strict=True):
            array[:, j] -= back
    return q, qd, qdd
