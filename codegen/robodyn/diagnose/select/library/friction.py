"""Laws of friction: by direction, by velocity, by the way since a reversal, by load."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.library.candidate import Candidate, Context, column, single, site
from robodyn.effects.effect import Site

Floats = NDArray[np.float64]


#: Grids of what is not linear.
_STRIBECK = (0.01, 0.02, 0.04, 0.08, 0.15, 0.3)
_BENDS = (1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2)  # rad or m: level over stiffness
_DRY = frozenset({
    "asymmetric_friction", "stribeck_friction", "presliding_hysteresis", "load_dependent_friction",
    "transmission_loss",
})  # fmt: skip
_POWERS = (0.4, 0.6, 1.6, 2.0)
_SPANS = (0.03, 0.1, 0.3, 1.0)  # m
_EFFICIENCY = (0.3, 0.45, 0.6, 0.7, 0.8, 0.88, 0.94)


def friction(c: Context, j: int) -> Iterator[Candidate]:
    """What rubs by the velocity, its direction, and the way since it turned."""
    at = site(c, j)
    viscous = column("viscous_friction", {"coefficient": 1.0}, at)
    coulomb = column("coulomb_friction", {"level": 1.0}, at)
    yield single("viscous_friction", j, [viscous], (1,), lambda x: {"coefficient": float(x[0])}, 1)
    if _rubs(c, j):  # dry friction that was found without it has taken some of its place
        yield single(
            "viscous_friction", j, [viscous, coulomb], (1, 0), lambda x: {"coefficient": float(x[0])}, 2,
            rough=True, feasible=lambda x: bool(x[0] > 0),
        )  # fmt: skip
    yield single("coulomb_friction", j, [coulomb], (1,), lambda x: {"level": float(x[0])}, 1)
    moving = np.abs(at.direction)
    yield single(
        "asymmetric_friction", j, [coulomb, moving], (1, 0),
        lambda x: {"positive": float(x[0] + x[1]), "negative": float(x[0] - x[1])}, 3,
        feasible=lambda x: bool(abs(x[1]) <= x[0]),
    )  # fmt: skip
    top = max(float(c.hints.top[j]), 1e-9)
    for velocity in _STRIBECK:
        if velocity < 0.6 * top:
            yield stribeck(c, j, {"velocity": velocity})
    if _rubs(c, j):  # what viscous and dry friction leave is bent; before, it is a rival of everything
        for exponent in _POWERS:
            yield power_law(c, j, {"exponent": exponent})
    # Between two samples the joint goes so far: bristles that bend less than that are Coulomb friction, of
    # which the direction is that of the way.
    q = c.signals.q[:, j]
    travel = float(np.sqrt(np.mean(np.diff(q) ** 2)))
    for bend in _BENDS:
        if bend < travel:
            yield single(
                "coulomb_friction", j, [bent(q, bend)], (1,), lambda x: {"level": float(x[0])}, 1,
                stand_in=True,
            )  # fmt: skip
        else:
            yield bristles(c, j, {"bend": bend})


def _rubs(c: Context, j: int) -> bool:
    """Whether the model has friction at the joint."""
    robot = c.model.robot
    joint = robot.links[j].joint
    dry = any(entry.effect in _DRY for entry in robot.effects_at(j + 1))
    return bool(joint.viscous) or bool(joint.coulomb) or dry


def stribeck(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    """Dry friction that is higher at rest, up to the ``velocity`` given."""
    at, velocity = site(c, j), given["velocity"]
    fixed = {"velocity": velocity, "exponent": 2}
    rise = column("stribeck_friction", {"level": 0.0, "static": 1.0, **fixed}, at)
    level = column("stribeck_friction", {"level": 1.0, "static": 1.0, **fixed}, at)

    def read(x: Floats) -> dict[str, float | str]:
        return {"level": float(x[0]), "static": float(x[0] + x[1]), "velocity": velocity}

    return single(
        "stribeck_friction",
        j,
        [level, rise],
        (1, 1),
        read,
        4,
        given=given,
    )


def power_law(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    """A power of the speed, in place of some of the viscous and the dry friction."""
    at = site(c, j)
    added = column("power_law_friction", {"level": 1.0, "velocity": 1.0, **given}, at)
    columns = [added, at.qd, column("coulomb_friction", {"level": 1.0}, at)]

    def read(x: Floats) -> dict[str, float | str]:
        return {"level": float(x[0]), **given}

    return single(
        "power_law_friction",
        j,
        columns,
        (1, 0, 0),
        read,
        6,
        given=given,
        rough=True,
        feasible=lambda x: bool(x[0] > 0),
    )


def bristles(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    """Dahl's bristles: the way since reversals, over the bend at which they slide."""
    bend = given["bend"]
    bristle = bent(c.signals.q[:, j], bend)

    def read(x: Floats) -> dict[str, float | str]:
        return {"level": float(x[0]), "stiffness": float(x[0] / bend), "damping": 0.0}

    return single("presliding_hysteresis", j, [bristle], (1,), read, 4, given=given)


def bent(q: Floats, bend: float) -> Floats:
    """Bristles over the bend of sliding [K], along positions ``q``: exact between samples."""
    way = np.diff(q, prepend=q[0]) / bend
    left = np.exp(-np.abs(way)).tolist()
    gone = (np.sign(way) * -np.expm1(-np.abs(way))).tolist()
    found = []
    z = 0.0
    for kept, new in zip(left, gone, strict=True):
        z = z * kept + new
        found.append(z)
    return np.array(found)


def loads(c: Context, j: int) -> Iterator[Candidate]:
    """What rubs by the load: bearings, gears."""
    at = site(c, j)
    kinds = [("torque", "mu", {"mu": 1.0})]
    if at.revolute:
        kinds += [("radial", "mu_r", {"mu_r": 1.0}), ("thrust", "mu_r", {"mu_r": 1.0})]
    for span in _SPANS:
        yield bearing(c, j, {"span": span})
    for kind, key, values in kinds:
        added = column("load_dependent_friction", {"bearing": kind, **values}, at)

        def read(x: Floats, kind: str = kind, key: str = key) -> dict[str, float | str]:
            return {"bearing": kind, key: float(x[0])}

        yield single("load_dependent_friction", j, [added], (1,), read, 2)
    for efficiency in _EFFICIENCY:
        yield loss(c, j, {"efficiency": efficiency})


def bearing(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    """Two journals, or two sliding bearings, at a distance."""
    at = site(c, j)
    kind, key = ("journal", "mu_r") if at.revolute else ("linear", "mu")
    added = column("load_dependent_friction", {"bearing": kind, key: 1.0, **given}, at)

    def read(x: Floats) -> dict[str, float | str]:
        return {"bearing": kind, key: float(x[0]), **given}

    return single("load_dependent_friction", j, [added], (1,), read, 2, given=given)


def loss(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    """The loss at a fixed efficiency, with a factor of its own (1 where the efficiency is right), and
    breakaway."""
    at, efficiency = site(c, j), given["efficiency"]
    at = Site(at.revolute, at.q, at.qd, at.qdd, at.direction, c.at.passed[:, j])
    loss = column("transmission_loss", {"breakaway": 0.0, "efficiency": efficiency}, at)
    level = column("transmission_loss", {"breakaway": 1.0, "efficiency": 1}, at)

    def read(x: Floats) -> dict[str, float | str]:
        inverse = 1 + float(x[0]) * (1 / efficiency - 1)
        return {"efficiency": min(1.0, 1 / inverse), "breakaway": float(max(x[1], 0.0))}

    return single("transmission_loss", j, [loss, level], (1, 1), read, 4, given=given)
