"""What numbers of the links change of a motor's torque, where a drive answers to the loads on its joint.

Friction under load goes with the forces in the joint: they show numbers that the torque of the rigid arm does
not, such as the mass that a bearing carries. The rigid arm is linear in its standard parameters, so its loads
by each are those of the arm with that one alone; what the drives make of them is differentiated.

A link behind its motor swings on its spring with its own inertia, not with the sum of that and the rotor's,
which is all that a rigid joint shows. What it does under the load of a number is the answer of the spring's
tangent along its motion.
"""

from __future__ import annotations

import copy
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.arm import Symmetric
from robodyn.identify.limits import NUMBER_STEP, TANGENT_STEP
from robodyn.identify.oscillator import oscillation
from robodyn.identify.twist import Slopes, lags_of, links_of
from robodyn.kernels.array_dynamics import PARAMETERS, Model, Moved, Rigid, physical

Floats = NDArray[np.float64]


def motor_regressor(model: Model, q: Floats, qd: Floats, qdd: Floats, sizes: Floats) -> Floats:
    """Derivatives [K, n, n, 10] of the motors' torques along a motion [K, n] by the standard parameters of
    each link: joint, link, parameter. ``sizes`` [n, 10]: how much each may differ; 0 where it is known."""
    whole = model.rigid(q, qd, qdd)
    slopes = np.zeros((*q.shape, *sizes.shape))
    for k, i, unit in _units(model, q, qd, qdd):
        step = NUMBER_STEP * float(sizes[k, i])
        if not step > 0:
            continue
        ahead, behind = (model.driven(_sum(whole, unit, way), q, qd, qdd).total for way in (step, -step))
        slopes[:, :, k, i] = (ahead - behind) / (2 * step)
    return slopes


def lagging_regressor(
    model: Model, motion: Moved, period: float, every: int, tau: Floats | None = None
) -> tuple[Floats, Floats]:
    """The same at each of ``every`` samples, where links lag behind motors that move so (:func:`lags_of`) and
    other drives pass loads on as they are; and what torques [K, n, 2 joints] change by with how each of these
    links begins, as far as it swings."""
    lags, slopes = lags_of(model, model.evaluate(*motion), motion, period, tau)
    q, qd, qdd = (x[::every] for x in links_of(motion, lags))
    Y = model.regressor(q, qd, qdd)
    whole, begins = Y.copy(), []
    for j, lag in lags.items():
        response = _Response(model, slopes[j], lag[:, 0], period)
        for k, i in zip(*np.nonzero(Y[:, j].any(axis=0)), strict=True):
            load = np.interp(np.arange(len(lag)), np.arange(len(q)) * every, Y[:, j, k, i])
            whole[:, :, k, i] += response.torques(load)[::every]
        for begin in np.diag(np.sqrt(np.mean(lag[:, :2] ** 2, axis=0))):
            begins.append(response.torques(np.zeros(len(lag)), begin)[::every])
    return whole, np.stack(begins, axis=2)


class _Response:
    """A link about its motion behind the motor of joint ``j``, ``lag`` [K], on the tangent of its spring."""

    def __init__(self, model: Model, slopes: Slopes, lag: Floats, period: float) -> None:
        coupler = model.couplers[slopes.j]
        assert coupler.effect.coupler is not None
        self.slopes, self.period, self.damping = slopes, period, float(coupler.values["damping"])
        step = TANGENT_STEP * max(float(np.abs(lag).max()), 1e-12)
        ahead, behind = (
            np.asarray(coupler.effect.coupler.torque(coupler.values, lag + way, 0.0), dtype=np.float64)
            for way in (step, -step)
        )
        self.tangent = (ahead - behind) / (2 * step)

    def torques(self, load: Floats, begin: Floats | None = None) -> Floats:
        """What torques [K, n] change by as the link swings under a ``load`` [K] from a place and rate to
        ``begin`` with [2] (0); 0 where it would diverge."""
        of, j = self.slopes, self.slopes.j
        inputs = (load, of.inertia[:, j], of.rate[:, j], of.place[:, j] + self.tangent)
        place, rate = (0.0, 0.0) if begin is None else map(float, begin)
        motion = oscillation(inputs, self.period, (np.zeros(2), -1.0, 2.0), self.damping, (place, rate))
        torques = of.of(motion)
        return torques if np.isfinite(torques).all() else np.zeros_like(torques)


def _units(model: Model, q: Floats, qd: Floats, qdd: Floats) -> Iterator[tuple[int, int, Rigid]]:
    """Link, parameter, and the rigid arm of which that parameter is 1 and all others are 0."""
    for k in range(model.n):
        mass = None
        for i in range(len(PARAMETERS)):
            phi = np.eye(len(PARAMETERS))[i]
            if 1 <= i <= 3:
                phi[0] = 1.0  # a first moment has a mass, which is taken off again
            unit = _only(model, k, phi).rigid(q, qd, qdd)
            if i == 0:
                mass = unit
            elif i <= 3:
                assert mass is not None
                unit = _sum(unit, mass, -1.0)
            yield k, i, unit


def _only(model: Model, k: int, phi: Floats) -> Model:
    """The ``model`` with all numbers of links 0 but those of link ``k`` (from 0), ``phi`` [10]."""

    def numbers(values: Floats) -> dict[str, object]:
        mass, x, y, z, *inertia = (float(v) for v in values)
        return {"mass": mass, "com": (x, y, z), "inertia": Symmetric(*inertia)}

    none = np.zeros(len(PARAMETERS))
    bodies = tuple(
        replace(body, **numbers(physical(phi) if j == k else none))  # type: ignore[arg-type]
        for j, body in enumerate(model.arm.bodies)
    )
    other = copy.copy(model)
    other.arm = replace(model.arm, bodies=bodies)
    return other


def _sum(one: Rigid, other: Rigid, factor: float) -> Rigid:
    return Rigid(one.tau + factor * other.tau, one.f + factor * other.f, one.m + factor * other.m)
