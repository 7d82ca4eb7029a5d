"""Torques of one joint: laws by its motion and load, and friction by the way since it turned."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.library.candidate import Candidate, Context, rubs, single, site, unit_column
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect, Site
from robodyn.effects.traits import Bristles, Law

Floats = NDArray[np.float64]
Given = Mapping[str, float]


def laws(c: Context, effect: Effect, law: Law, j: int) -> Iterator[Candidate]:
    """A torque that is linear in some numbers, for each value of its grid."""
    kind = c.model.robot.links[j].joint.kind
    if law.kind not in ("any", kind) or (law.rubbing and not rubs(c, j)):
        return
    top = max(float(c.hints.top[j]), 1e-9)
    for values in law.grid:
        if law.suits(values, top):
            yield _fitted(c, effect, law, j, values)


def _fitted(c: Context, effect: Effect, law: Law, j: int, settings: Given) -> Candidate:
    at = site(c, j)
    if effect.place == "gear":  # behind the bearings
        at = Site(at.revolute, at.q, at.qd, at.qdd, at.direction, c.at.passed[:, j])
    columns = [np.asarray(x + np.zeros_like(at.qd)) for x in law.columns(settings, at)]
    columns += [unit_column(CATALOGUE[id], at) for id in law.beside]
    return single(
        effect.id, j, columns, (*law.signs, *(0 for _ in law.beside)), lambda x: law.read(x, settings),
        law.order, values=settings, beside=law.beside, spread=law.spread, rough=law.rough,
        feasible=law.feasible,
        again=lambda c, values: _fitted(c, effect, law, j, values),
    )  # fmt: skip


def bristles(c: Context, effect: Effect, law: Bristles, j: int) -> Iterator[Candidate]:
    """Bristles of several lengths.

    Between two samples the joint goes so far: bristles that bend less than that are sliding friction, of
    which the direction is that of the way."""
    q = c.signals.q[:, j]
    travel = float(np.sqrt(np.mean(np.diff(q) ** 2)))
    (sliding, *_) = (one for one in CATALOGUE[law.sliding].traits.candidates if isinstance(one, Law))
    for bend in law.bends:
        if bend < travel:
            yield single(
                law.sliding, j, [bent(q, bend)], sliding.signs, lambda x: sliding.read(x, {}),
                sliding.order, stand_in=True,
            )  # fmt: skip
        else:
            yield _bristles(c, effect, law, j, {"bend": bend})


def _bristles(c: Context, effect: Effect, law: Bristles, j: int, settings: Given) -> Candidate:
    column = bent(c.signals.q[:, j], settings["bend"])
    return single(
        effect.id, j, [column], (1,), lambda x: law.read(x, settings), law.order, values=settings,
        again=lambda c, values: _bristles(c, effect, law, j, values),
    )  # fmt: skip


def bent(q: Floats, bend: float) -> Floats:
    """Bristles over the bend of sliding [K], along positions ``q``: exact between samples."""
    way = np.diff(q, prepend=q[0]) / bend
    left = np.exp(-np.abs(way)).tolist()
    gone = (np.sign(way) * -np.expm1(-np.abs(way))).tolist()
    columns = []
    z = 0.0
    for kept, new in zip(left, gone, strict=True):
        z = z * kept + new
        columns.append(z)
    return np.array(columns)
