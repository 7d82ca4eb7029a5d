"""Torques of one joint: laws of its motion and load, and friction by the travel since its last reversal."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.select.library.candidate import Candidate, Context, single, site
from robodyn.diagnose.select.library.limits import GRAVITY_SHARE
from robodyn.effects.effect import Effect, Site
from robodyn.effects.traits import Dahl, Law
from robodyn.identify.oscillator import dahl_deflection

Values = Mapping[str, float]


def laws(c: Context, effect: Effect, law: Law, j: int) -> Iterator[Candidate]:
    """A torque that is linear in some numbers, for each value of its grid."""
    kind = c.model.robot.links[j].joint.kind
    if law.kind not in ("any", kind):
        return
    if law.balances and not _carries_gravity(c, j):
        return
    top = max(float(c.hints.top[j]), 1e-9)
    for values in law.grid:
        if law.suits(values, top):
            yield _fitted(c, effect, law, j, values)


def _fitted(c: Context, effect: Effect, law: Law, j: int, settings: Values) -> Candidate:
    at = site(c, j)
    if effect.place == "gear":  # behind the bearings
        at = Site(at.revolute, at.q, at.qd, at.qdd, at.direction, c.at.passed[:, j])
    columns = [np.asarray(x + np.zeros_like(at.qd)) for x in law.columns(settings, at)]
    return single(
        effect.id, j, columns, law.signs, lambda x: law.read(x, settings), law.order, values=settings,
        spread=law.spread, feasible=law.feasible, again=lambda c, values: _fitted(c, effect, law, j, values),
    )  # fmt: skip


def _carries_gravity(c: Context, j: int) -> bool:
    """Whether much of the torque of joint ``j`` (from 0) holds the arm against gravity."""
    size: Floats | None = c.kept.get(("gravity", 0))
    if size is None:
        q = c.signals.q
        gravity = c.model.evaluate(q, np.zeros_like(q), np.zeros_like(q)).rigid
        size = c.kept["gravity", 0] = np.sqrt(np.mean(gravity**2, axis=0))
    return bool(size[j] > GRAVITY_SHARE * size.max() > 0)


def dahl(c: Context, effect: Effect, law: Dahl, j: int) -> Iterator[Candidate]:
    """Dahl friction that slides at several deflections, longer than the travel between two samples: shorter
    ones are sliding friction in the direction of the travel."""
    travel = float(np.sqrt(np.mean(np.diff(c.signals.q[:, j]) ** 2)))
    for limit in law.deflections:
        if limit >= travel:
            yield _dahl(c, effect, law, j, {"bend": limit})


def _dahl(c: Context, effect: Effect, law: Dahl, j: int, settings: Values) -> Candidate:
    column = dahl_deflection(c.signals.q[:, j], settings["bend"])
    return single(
        effect.id, j, [column], (1,), lambda x: law.read(x, settings), law.order, values=settings,
        again=lambda c, values: _dahl(c, effect, law, j, values),
    )  # fmt: skip
