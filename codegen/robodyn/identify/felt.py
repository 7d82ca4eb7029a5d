"""What numbers of the links change of a motor's torque, where a drive answers to the loads on its joint.

Friction under load goes with the forces in the joint: they show numbers that the torque of the rigid arm does
not, such as the mass that a bearing carries. The rigid arm is linear in its standard parameters, so its loads
by each are those of the arm with that one alone; what the drives make of them is differentiated.
"""

from __future__ import annotations

import copy
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.arm import Symmetric
from robodyn.identify.limits import FELT_STEP
from robodyn.identify.rigid import PARAMETERS, Model, Rigid, physical

Floats = NDArray[np.float64]


def felt(model: Model, q: Floats, qd: Floats, qdd: Floats, sizes: Floats) -> Floats:
    """Derivatives [K, n, n, 10] of the motors' torques along a motion [K, n] by the standard parameters of
    each link: joint, link, parameter. ``sizes`` [n, 10]: how much each may differ; 0 where it is known."""
    whole = model.rigid(q, qd, qdd)
    slopes = np.zeros((*q.shape, *sizes.shape))
    for k, i, unit in _units(model, q, qd, qdd):
        step = FELT_STEP * float(sizes[k, i])
        if not step > 0:
            continue
        ahead, behind = (model.driven(_sum(whole, unit, way), q, qd, qdd).total for way in (step, -step))
        slopes[:, :, k, i] = (ahead - behind) / (2 * step)
    return slopes


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
