"""Effects that are in, fitted together in the model's full equations, beside the arm's own numbers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.diagnose.select.families import Family, Key
from robodyn.diagnose.select.library.sensors import leave_little
from robodyn.diagnose.select.limits import (
    FIT_ROUNDS,
    FIT_WORTH,
    STEP,
    TOWARDS_ZERO,
)
from robodyn.diagnose.select.noise import rest_of
from robodyn.diagnose.select.rows import Rows
from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError


@dataclass(frozen=True, slots=True, eq=False)
class Member:
    """An effect that is in: its ``parameters``; or, where it has a prior and so is a part of the arm's own
    numbers, ``columns`` [N, n, c] of its standard parameters, in units of the prior; ``is_shaped``: numbers
    that shape its curve are fitted too."""

    key: Key
    family: Family
    k: int
    parameters: dict[str, float | str]
    columns: Floats | None = None
    is_shaped: bool = False

    @property
    def is_linear(self) -> bool:
        """Whether it is fitted by its columns."""
        return self.columns is not None

    @property
    def amendment(self) -> Amendment:
        """What is added to the model."""
        return Amendment(self.key[0], self.key[1], self.parameters)

    @property
    def free(self) -> list[str]:
        """The numbers that logs say."""
        traits = CATALOGUE[self.key[0]].traits
        fixed = traits.chosen if self.is_shaped else (*traits.chosen, *traits.shape)
        return [
            name for name, x in self.parameters.items() if isinstance(x, float) and x and name not in fixed
        ]

    def of_slope(self, name: str) -> tuple[Any, ...]:
        """What the slope by a number depends on: where the torque is linear in it, on the others that it is
        not linear in; else on all."""
        linear = CATALOGUE[self.key[0]].linear
        alike = linear if name in linear else ()
        others = tuple((each, x) for each, x in sorted(self.parameters.items()) if each not in alike)
        return (*self.key, name, others)

    @property
    def is_delay(self) -> bool:
        """Whether it says how late a torque is."""
        channel = CATALOGUE[self.key[0]].traits.channel
        return channel is not None and channel.acts == "delay"

    def is_size(self, name: str) -> bool:
        """Whether a number keeps its sign."""
        return any(p.name == name and p.sign != "any" for p in CATALOGUE[self.key[0]].parameters)

    def at(self, name: str, value: float) -> Member:
        """The same with another value."""
        return replace(self, parameters={**self.parameters, name: value})


@dataclass(frozen=True, slots=True, eq=False)
class Model:
    """``members`` of a model beside the arm's ``own`` numbers [N, n, p], wrong by a ``share`` at most where
    nothing is stated of them; ``is_timed``: and beside when torques were read."""

    rows: Rows
    own: Floats
    members: tuple[Member, ...] = ()
    share: float | None = None
    is_timed: bool = False
    _known: dict[tuple[Any, ...], Floats] = field(default_factory=dict)

    @property
    def exact(self) -> list[Member]:
        """Members in the model's equations."""
        return [one for one in self.members if not one.is_linear]

    @property
    def places(self) -> list[tuple[int, str]]:
        """The numbers that are fitted: of which exact member, and which."""
        return [(k, name) for k, one in enumerate(self.exact) for name in one.free]

    @property
    def delays(self) -> list[int | None]:
        """The joints (from 1; None: all alike) of which a delay of the torque is among the members."""
        return [one.key[1] for one in self.members if one.is_delay]

    @property
    def tilts(self) -> list[Amendment]:
        """What the members do to the direction of gravity."""
        folds = [(CATALOGUE[one.key[0]].traits.fold, one.amendment) for one in self.exact]
        return [amendment for fold, amendment in folds if fold is not None and fold.into == "gravity"]

    def with_members(self, members: Iterable[Member]) -> Model:
        """The same with other members."""
        return replace(self, members=tuple(members))

    def left(self) -> Floats | None:
        """What the exact members leave of the logs [N, n]; None where no such robot can be."""
        return _left(self.rows, [one.amendment for one in self.exact])

    def slopes(self, left: Floats) -> Floats:
        """What the model's torques [N, n, P] change by each number."""
        exact, parts = self.exact, []
        is_same = not any(CATALOGUE[one.key[0]].traits.reevaluate for one in exact)
        for k, name in self.places:
            value = float(exact[k].parameters[name])
            slope_of = exact[k].of_slope(name) if is_same and not _is_behind(exact[k], exact) else None
            if slope_of in self._known:
                parts.append(self._known[slope_of])
                continue
            moved = [one.amendment if i != k else one.at(name, value * (1 + STEP)).amendment
                     for i, one in enumerate(exact)]  # fmt: skip
            other = _left(self.rows, moved)
            slope = np.zeros_like(left) if other is None else (left - other) / (STEP * value)
            if slope_of is not None:
                self._known[slope_of] = slope
            parts.append(slope)
        return np.stack(parts, axis=2) if parts else np.zeros((*left.shape, 0))

    def design(self, slopes: Floats) -> tuple[Floats, Floats]:
        """All columns [N, n, p]: own numbers, members with priors, numbers of the others; and the precision
        [p] that holds them about 0."""
        linear = [one.columns for one in self.members if one.columns is not None]
        columns = np.concatenate([self.own, *linear, slopes], axis=2)
        held = np.zeros(columns.shape[2])
        held[: columns.shape[2] - slopes.shape[2]] = 1.0
        return columns, held


def _is_behind(one: Member, members: Iterable[Member]) -> bool:
    """Whether it acts in a gear, behind bearings that are among the ``members``: their friction passes it."""
    places = {CATALOGUE[id].place for id, joint in (each.key for each in members) if joint == one.key[1]}
    return CATALOGUE[one.key[0]].place == "gear" and "bearing" in places


def _left(rows: Rows, amendments: Sequence[Amendment]) -> Floats | None:
    try:
        robot = amended(rows.robot, amendments)
    except InputError:
        return None
    if leave_little([c.signals.tau for c in rows.contexts], robot):
        return None
    left = rest_of(robot, rows)
    return left if np.isfinite(left).all() else None


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """A fitted ``model``: what exact members ``leave`` [N, n]; all ``columns`` [N, n, p] there, held by
    ``held`` [p]; coefficients ``x`` [p], of the numbers of exact members about 0; ``cost`` in units of
    log-likelihood."""

    model: Model
    leave: Floats
    columns: Floats
    held: Floats
    x: Floats
    cost: float
    #: Those of the blocks, which trials of all families have in common, once they are worked out.
    equations: list[tuple[Floats, ...]] = field(default_factory=list)

    @property
    def rest(self) -> Floats:
        """What all leave of the logs [N, n]."""
        return np.asarray(self.leave - self.columns @ self.x)


def solve(columns: Floats, held: Floats, y: Floats, weight: Floats) -> tuple[Floats, float]:
    """Coefficients [p] of the weighted least squares, and what is left in units of log-likelihood."""
    A = (columns * np.sqrt(weight)[:, :, None]).reshape(y.size, columns.shape[2])
    b = (y * np.sqrt(weight)).reshape(-1)
    if not A.shape[1]:
        return np.zeros(0), float(b @ b) / 2
    gram, right = A.T @ A + np.diag(held), A.T @ b
    size = np.sqrt(np.maximum(np.diag(gram), 1e-300))
    x = np.linalg.lstsq(gram / np.outer(size, size), right / size, rcond=1e-11)[0] / size
    left = b - A @ x
    return x, float(left @ left + held @ x**2) / 2


def fitted(model: Model, rounds: int = FIT_ROUNDS) -> Fit | None:
    """The model with the numbers that explain most, by Gauss and Newton; None where no such robot can be."""
    left = model.left()
    if left is None:
        return None
    weight = model.rows.weight
    while True:
        columns, held = model.design(model.slopes(left))
        x, _ = solve(columns, held, left, weight)
        count = len(model.places)
        without = slice(0, columns.shape[2] - count)
        now = solve(columns[:, :, without], held[without], left, weight)[1]
        step = x[columns.shape[2] - count :]
        moved = None
        for share in (1.0, 0.3, 0.1) if count and rounds else ():
            tried = model.with_members(_stepped(model, share * step))
            other = tried.left()
            if other is None:
                continue
            cost = solve(columns[:, :, without], held[without], other, weight)[1]
            if cost < now:
                moved = tried, other, cost
                break
        rounds -= 1
        if moved is None:
            at = solve(columns[:, :, without], held[without], left, weight)[0]
            return Fit(model, left, columns, held, np.concatenate([at, np.zeros(count)]), now)
        model, left = moved[0], moved[1]
        if now - moved[2] < FIT_WORTH:
            rounds = 0


def _stepped(model: Model, step: Floats) -> list[Member]:
    exact = model.exact
    for (k, name), by in zip(model.places, step.tolist(), strict=True):
        value = float(exact[k].parameters[name])
        new = value + by
        if exact[k].is_size(name) and new * value <= 0:
            new = TOWARDS_ZERO * value
        exact[k] = exact[k].at(name, new)
    moved = iter(exact)
    return [one if one.is_linear else next(moved) for one in model.members]
