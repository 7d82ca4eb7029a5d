"""How sure the numbers of members are: one covariance for all of them, from what parts of the logs say.

Rows near each other are off alike, whatever made them so. So the covariance is a sandwich: the curvature of
the fit about the sum of squares of what each of many short parts pulls it by (White 1980; Newey and West 1987
for series in time), with what the priors leave open.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.limits import HALF_WIDTH
from robodyn.diagnose.result import Bounds
from robodyn.diagnose.select.compare import read_link
from robodyn.diagnose.select.limits import (
    NOT_SHOWN,
    PART_CORRELATION,
    STRIKE_ACCURACY,
    TOGETHER,
    VAGUE,
)
from robodyn.diagnose.select.members import Fit, Member
from robodyn.diagnose.select.rows import Rows
from robodyn.effects.catalogue import CATALOGUE


@dataclass(frozen=True, slots=True)
class Sure:
    """How sure the numbers of a member are: standard errors, and ends of 95 % intervals that are not that
    far to either side; ``together``: of numbers that are sure together and not alone, as ``a * b``, value
    and standard error."""

    errors: Mapping[str, float]
    bounds: Mapping[str, Bounds]
    together: Mapping[str, tuple[float, float]]


def covariance(fit: Fit) -> Floats:
    """Of all coefficients [p, p], those of numbers of exact members last."""
    rows = fit.model.rows
    root = np.sqrt(rows.weight)
    A = fit.columns * root[:, :, None]
    count, _, p = A.shape
    gram = np.einsum("tjp,tjq->pq", A, A, optimize=True) + np.diag(fit.held)
    square = np.diag(gram)
    size = np.sqrt(np.where(square > 1e-200, square, 1.0))  # what does not show at all stays open
    scaled, ways = np.linalg.eigh(gram / np.outer(size, size))
    is_open = scaled <= NOT_SHOWN * scaled.max(initial=0.0)
    ways = ways / size[:, None]
    inverse = (ways[:, ~is_open] / scaled[~is_open]) @ ways[:, ~is_open].T
    length = min(count, max(1, int(np.ceil(PART_CORRELATION * float(rows.correlation.max())))))
    parts = max(1, count // length)
    pulls = np.einsum("tjp,tj->tp", A, fit.rest * root, optimize=True)[: parts * length]
    pulls = pulls.reshape(parts, length, p).sum(axis=1)
    middle = pulls.T @ pulls * parts / max(parts - 1, 1) + np.diag(fit.held)
    white = inverse
    spread = inverse @ middle @ inverse
    # Of few parts a number may look surer than noise of that size ever allows.
    wider = np.sqrt(np.maximum(np.diag(white), 1e-300) / np.maximum(np.diag(spread), 1e-300))
    factor = np.maximum(wider, 1.0)
    # What no row shows is not known, however little pulls on it.
    unknown = ways[:, is_open] @ ways[:, is_open].T / NOT_SHOWN
    return np.asarray(spread * np.outer(factor, factor) + unknown)


def sureness(fit: Fit) -> list[Sure]:
    """Of each member of a fitted model."""
    spread = covariance(fit)
    model = fit.model
    first = len(spread) - len(model.places)
    at = model.own.shape[2]
    exact = model.exact
    done = []
    for member in model.members:
        if member.columns is not None:
            part = slice(at, at + member.columns.shape[2])
            at = part.stop
            done.append(_of_body(fit, member, spread[part, part]))
            continue
        k = next(i for i, one in enumerate(exact) if one is member)
        places = [(first + i, name) for i, (which, name) in enumerate(model.places) if which == k]
        done.append(_of_law(member, places, spread, model.rows))
    return done


def _of_law(member: Member, places: list[tuple[int, str]], spread: Floats, rows: Rows) -> Sure:
    """At what instant of a sample's period a torque is read the log does not say, so a delay is known to a
    uniform part of one at best."""
    errors, bounds = dict[str, float](), dict[str, Bounds]()
    for i, name in places:
        value = float(member.parameters[name])
        if member.is_delay:
            beside = rows.contexts[0].signals.period / np.sqrt(12)
        else:
            beside = STRIKE_ACCURACY * value * _strikes(member)
        error = float(np.hypot(np.sqrt(max(spread[i, i], 0.0)), beside))
        errors[name] = error
        if member.is_size(name) and error > 0:  # in logarithms: a size has no interval beyond zero
            if error < VAGUE * abs(value):
                ratio = float(np.exp(HALF_WIDTH * error / abs(value)))
                bounds[name] = tuple(sorted((value / ratio, value * ratio)))  # type: ignore[assignment]
            else:
                bounds[name] = (None, None)
    return Sure(errors, bounds, _together(member, places, spread, errors))


def _strikes(member: Member) -> bool:
    """Whether a link strikes what passes torque on to it: the twist between is not in proportion to that."""
    coupler, values = CATALOGUE[member.key[0]].coupler, member.parameters
    return coupler is not None and not np.isclose(coupler.twist(values, 2.0), 2 * coupler.twist(values, 1.0))


def _together(
    member: Member, places: list[tuple[int, str]], spread: Floats, errors: Mapping[str, float]
) -> dict[str, tuple[float, float]]:
    """Products and ratios of two numbers that are sure though neither is."""
    sure = dict[str, tuple[float, float]]()
    for a, (i, one) in enumerate(places):
        for k, other in places[a + 1 :]:
            x, y = (float(member.parameters[name]) for name in (one, other))
            if not all(errors[name] > VAGUE * abs(float(member.parameters[name])) for name in (one, other)):
                continue
            for sign, word in ((1, "*"), (-1, "/")):
                relative = spread[i, i] / x**2 + spread[k, k] / y**2 + 2 * sign * spread[i, k] / (x * y)
                error = float(np.sqrt(max(relative, 0.0)))
                if error < TOGETHER * errors[one] / abs(x):
                    value = x * y**sign
                    sure[f"{one} {word} {other}"] = (value, abs(value) * error)
    return sure


def _of_body(fit: Fit, member: Member, spread: Floats) -> Sure:
    """Of numbers of a body, by the spread of its standard parameters in units of their prior."""
    family = member.family
    candidate, scale = family.ones[member.k], family.scale
    assert scale is not None
    at = _coefficients(fit, member)
    values = read_link(candidate, at * scale, fit.model.rows)
    sizes, ways = np.linalg.eigh(spread)
    squares = dict.fromkeys(values, 0.0)
    for size, way in zip(np.sqrt(np.maximum(sizes, 0.0)), ways.T, strict=True):
        other = read_link(candidate, (at + size * way) * scale, fit.model.rows)
        for name, value in other.items():
            squares[name] += (float(value) - float(values[name])) ** 2
    return Sure({name: float(np.sqrt(x)) for name, x in squares.items()}, {}, {})


def _coefficients(fit: Fit, member: Member) -> Floats:
    at = fit.model.own.shape[2]
    for one in fit.model.members:
        if one.columns is not None:
            part = fit.x[at : at + one.columns.shape[2]]
            if one is member:
                return part
            at += one.columns.shape[2]
    raise ValueError(member.key)


def body_parameters(fit: Fit, member: Member) -> dict[str, float | str]:
    """The catalogue's parameters of a body in the last fit."""
    scale = member.family.scale
    assert scale is not None
    x = _coefficients(fit, member) * scale
    return read_link(member.family.ones[member.k], x, fit.model.rows)
