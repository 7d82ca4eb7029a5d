"""Values of what is not linear in a law, between those of the catalogue's grid."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import product

import numpy as np

from robodyn.arrays import Floats, Singles
from robodyn.diagnose.select.families import Family, is_resolved
from robodyn.diagnose.select.library import without_regressor
from robodyn.diagnose.select.library.matched import light
from robodyn.diagnose.select.library.prepared import prepared
from robodyn.diagnose.select.limits import FINEST, FIT_WORTH
from robodyn.diagnose.select.members import Fit, Member, Model, solve
from robodyn.diagnose.select.rows import Rows
from robodyn.diagnose.select.score import Trial, trials


def tuned(model: Model, new: Member) -> Member:
    """A ``new`` member of a model with the values that explain most; its family has them too, so that later
    trials of it are of these."""
    candidate, rows, family = new.family.ones[new.k], model.rows, new.family
    if candidate.definition.traits.reevaluate and not candidate.fixed and len(new.free) == 1:
        return _with_secant(model, new)
    if candidate.again is None or not candidate.values or new.is_linear or family.second:
        return new
    left = model.left()
    if left is None:
        return new
    columns, held = model.design(model.slopes(left))

    ends = {} if candidate.reach else {name: _ends(family, name) for name in candidate.values}

    def cost(values: Mapping[str, float]) -> tuple[float, Floats]:
        beyond = any(not low <= values[name] <= high for name, (low, high) in ends.items())
        if beyond or not is_resolved(candidate, values, rows):
            return np.inf, np.zeros(0)
        z = np.zeros((*left.shape, family.columns.shape[3]))
        z[:, family.rows] = _columns_at(family, values, rows)
        if candidate.fixed:
            return solve(columns, held, left - z[:, :, 0], rows.weight)[1], np.ones(1)
        whole = np.concatenate([columns, z], axis=2), np.concatenate([held, np.zeros(z.shape[2])])
        x, misfit = solve(*whole, left, rows.weight)
        return misfit, x[columns.shape[2] :]

    values = {name: float(x) for name, x in candidate.values.items()}
    best, x = cost(values)
    step = {name: candidate.reach[name] for name in candidate.reach if name in values}
    step = step or {name: float(np.log(candidate.spread[0])) for name in values}
    finest = min(float(np.log(candidate.spread[1])), FINEST * max(step.values()))
    ways = [way for way in product((-1, 0, 1), repeat=len(step)) if any(way)]
    while max(step.values()) > finest:
        moved = False
        for way in ways:  # all of them at once: a valley seldom lies along one number
            factors = {name: np.exp(k * size) for (name, size), k in zip(step.items(), way, strict=True)}
            other = {name: float(x * factors.get(name, 1.0)) for name, x in values.items()}
            misfit, y = cost(other)
            if misfit < best - FIT_WORTH:
                best, x, values, moved = misfit, y, other, True
        if not moved:
            step = {name: size / 2 for name, size in step.items()}
    again = candidate.again(rows.contexts[0], values)
    more = _with_values(family, values, rows)
    return replace(new, family=more, k=len(more.ones) - 1, parameters=dict(again.read(family.whole(x))))


def _ends(family: Family, name: str) -> tuple[float, float]:
    """Between which a value stays: those of the catalogue and a step beyond. Beyond, a law is another."""
    values, step = [one.values[name] for one in family.ones if name in one.values], family.first.spread[0]
    return min(values) / step, max(values) * step


def _with_secant(model: Model, new: Member) -> Member:
    """A ``new`` member of one number, what the torques change by it at its size and not at zero."""
    size = float(new.parameters[new.free[0]])
    before, after = model.left(), model.with_members([*model.members, new]).left()
    if before is None or after is None or not size:
        return new
    column = ((before - after) / size)[None, :, new.family.rows, None].astype(np.float32)
    return replace(new, family=replace(new.family, columns=column), k=0)


def judge_shape(fit: Fit, one: Trial, threshold: float) -> Trial:
    """A trial beside a fit; a law that has friction come up by and by is impossible if it foretells no more,
    by the ``threshold`` [nats], than one that knows nothing but the side on which friction holds a joint at
    rest: the same law that comes up within what is not resolved of the joint's travel."""
    joint, rows = one.family.first.joint, fit.model.rows
    if joint is None or not one.family.first.definition.traits.steady or not one.is_possible:
        return one
    travel = float(rows.expected[joint - 1]) / (2 * np.pi * rows.contexts[0].signals.cutoff)
    values = one.family.ones[one.k].values
    with_plain = _with_values(one.family, dict.fromkeys(values, travel), rows)
    plain = replace(with_plain, ones=with_plain.ones[-1:], columns=with_plain.columns[-1:])
    is_longer = min(values.values()) > travel
    return replace(one, is_possible=is_longer and one.gain - trials(fit, [plain])[0].gain > threshold)


def with_tried(family: Family, old: Family, rows: Rows) -> Family:
    """The ``family`` in new ``rows`` with those values of the ``old`` one that it lacks."""
    known = [one.values for one in family.ones]
    for one in old.ones:
        if one.values not in known and one.again is not None and is_resolved(one, one.values, rows):
            family = _with_values(family, one.values, rows)
    return family


def _with_values(family: Family, values: Mapping[str, float], rows: Rows) -> Family:
    again = family.first.again
    assert again is not None
    one = light(again(rows.contexts[0], values))
    columns = np.concatenate([family.columns, _columns_at(family, values, rows)[None]])
    return replace(family, ones=(*family.ones, one), columns=columns)


def _columns_at(family: Family, values: Mapping[str, float], rows: Rows) -> Singles:
    """The family's columns [N, rows, c] at these values."""
    parts = []
    for c in rows.contexts:
        assert family.first.again is not None
        ((_, part),) = prepared(c, [family.first.again(c, values)])
        parts.append(part)
        without_regressor(c)
    kept = list(family.kept) or slice(None)
    return np.concatenate(parts)[:, :, kept]
