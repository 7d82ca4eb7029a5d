"""The findings refitted together: all their parameters at once, in the full equations.

Candidates are fitted where the model stood when they were tried, and some along a tangent. Left so, what they
miss would look like something else.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.diagnose.select.fit import Problem
from robodyn.diagnose.select.library import Context
from robodyn.diagnose.select.library.sensors import leave_little
from robodyn.diagnose.select.limits import (
    HUBER,
    HUBER_ROUNDS,
    LEAST_SHAPE,
    REFINE_FARTHEST,
    REFINE_ROUNDS,
    REFINE_STEP,
    REFINE_WORTH,
    STICKING_SPEEDS,
    TOWARDS_ZERO,
)
from robodyn.diagnose.select.own_numbers import own_numbers_of
from robodyn.diagnose.select.remainder import remainder
from robodyn.effects.catalogue import effect
from robodyn.effects.effect import Effect
from robodyn.errors import InputError
from robodyn.kernels.array_dynamics import Reuse
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Freed:
    """The numbers of ``amendments`` to ``robot`` that logs say, at ``places`` (index, name), and the speeds
    below which joints (from 0) are ``sticking``: their values ``x`` [P], speeds last, are what is changed;
    ``contexts`` and ``start`` are of ``robot`` as it was given; ``by_drives`` as in
    :func:`own_numbers_of`. The model is that of ``about``, which is ``robot`` with numbers of its own that
    are by ``changes`` [count] larger, and ``put_back`` [N n] what these explain
    (:mod:`robodyn.diagnose.select.about`)."""

    robot: Robot
    amendments: tuple[Amendment, ...]
    contexts: tuple[Context, ...]
    start: Problem
    places: tuple[tuple[int, str], ...]
    by_drives: bool = False
    sticking: Mapping[int, float] = field(default_factory=dict)
    about: Robot | None = None
    changes: Floats | None = None
    put_back: Floats | float = 0.0

    @classmethod
    def of(
        cls,
        robot: Robot,
        amendments: Sequence[Amendment],
        contexts: Sequence[Context],
        start: Problem,
        *,
        by_drives: bool = False,
    ) -> Freed:
        """All numbers that are sizes, and not 0; with ``by_drives``, in the last fit, what shapes curves."""
        if by_drives:
            amendments = [_with_shape(one) for one in amendments]
        places = tuple(
            (k, name)
            for k, one in enumerate(amendments)
            for name, value in one.parameters.items()
            if isinstance(value, float) and value and _is_refined(effect(one.effect), name, shape=by_drives)
        )
        return cls(robot, tuple(amendments), tuple(contexts), start, places, by_drives)

    @property
    def x(self) -> Floats:
        """The values [P] of the amendments as they are."""
        values = [float(self.amendments[k].parameters[name]) for k, name in self.places]
        return np.array([*values, *self.sticking.values()])

    @property
    def sizes(self) -> NDArray[np.bool_]:
        """Which of the values [P] keep their sign, and are varied by factors."""
        kinds = [
            next(p.sign for p in effect(self.amendments[k].effect).parameters if p.name == name)
            for k, name in self.places
        ]
        return np.array([kind != "any" for kind in kinds] + [True] * len(self.sticking), dtype=bool)

    def with_signs(self, x: Floats, tried: Floats) -> Floats:
        """Values ``tried`` [P] beside ``x`` [P]: a size that would change its sign goes a part of the way to
        zero instead. Else a number that hardly shows, such as a speed below which a joint sticks, would keep
        all others where they are."""
        lost = self.sizes & (tried * x <= 0)
        return np.asarray(np.where(lost, TOWARDS_ZERO * x, tried))

    def changed(self, x: Floats) -> list[Amendment]:
        """The amendments with values ``x`` [P]."""
        values = [dict(one.parameters) for one in self.amendments]
        for (k, name), each in zip(self.places, x, strict=False):
            values[k][name] = float(each)
        return [Amendment(one.effect, one.joint, v) for one, v in zip(self.amendments, values, strict=True)]

    def at(self, x: Floats) -> Freed:
        """The same with values ``x`` [P]."""
        speeds = dict(zip(self.sticking, x[len(self.places) :].tolist(), strict=True))
        return replace(self, amendments=tuple(self.changed(x)), sticking=speeds)

    def with_sticking(self) -> Freed:
        """With the speeds below which joints of new friction stick: of a few, those that fit best."""
        tops = [np.abs(c.signals.qd).max(axis=0) for c in self.contexts]
        top = np.max(tops, axis=0, initial=0.0)
        arm, freed = amended(self.robot, self.amendments), self
        rubbing = {one.joint - 1 for one in self.amendments if one.joint and effect(one.effect).dissipative}
        for j in sorted(rubbing) if tops else ():
            if is_dry(arm, j) and top[j] > 0:
                speeds = [share * float(top[j]) for share in STICKING_SPEEDS]
                tried = [replace(freed, sticking={**freed.sticking, j: speed}) for speed in speeds]
                freed = min(tried, key=Freed.misfit)
        return freed

    def misfit(self) -> float:
        """The sum of squares that its values leave, the arm's own numbers refitted."""
        x = self.x
        left = self.missed(x)
        if left is None:
            return np.inf
        nuisance, prior = self.own_numbers(x)
        weight, _ = weights(left.reshape(-1, self.start.n), nuisance, prior)
        return least_squares(weight * left, weight[:, None] * nuisance, prior)[0]

    def speeds(self, x: Floats) -> Floats | None:
        """Of values ``x`` [P] the speeds [n] below which joints stick; None where no friction is new."""
        if not self.sticking:
            return None
        speeds = np.zeros(self.start.n)
        speeds[list(self.sticking)] = x[len(self.places) :]
        return speeds

    def missed(self, x: Floats) -> Floats | None:
        """What is left [N n] of the logs with values ``x`` [P], in units of the noise; None where no robot
        has such values, its springs diverge, or its limits leave next to nothing to be explained."""
        try:
            model = amended(self.about or self.robot, self.changed(x))
        except InputError:
            return None
        if leave_little([c.signals.tau for c in self.contexts], model):
            return None
        speeds = self.speeds(x)
        rows = np.concatenate([remainder(model, c, sticking=speeds) for c in self.contexts])
        rows /= self.start.sigma
        left = (rows * self.start.weight).reshape(-1) + self.put_back
        return left if np.isfinite(left).all() else None

    def smoother(self) -> Freed:
        """The same along motions that went through their filter once more."""
        contexts = [replace(c, signals=c.signals.smoother(), reuse=Reuse()) for c in self.contexts]
        return replace(self, contexts=tuple(contexts))

    def noisier(self, draw: int) -> Freed:
        """The same along motions with as much noise of the encoders once more, of which each ``draw`` is
        another."""
        contexts = [
            replace(c, signals=c.signals.noisier(np.random.default_rng((draw, part))), reuse=Reuse())
            for part, c in enumerate(self.contexts)
        ]
        return replace(self, contexts=tuple(contexts))

    def own_numbers(self, x: Floats) -> tuple[Floats, Floats]:
        """Columns [N n, p] of the arm's own numbers beside values ``x`` [P], and how they are held [p, p]."""
        arm = amended(self.about or self.robot, self.changed(x))
        return own_numbers_of(
            arm, self.robot, self.contexts, self.start, by_drives=self.by_drives, sticking=self.speeds(x)
        )

    def slopes(self, x: Floats, left: Floats) -> Floats:
        """Of what is ``left`` [N n] the derivatives [N n, P] by ``x`` [P]; 0 where there is no robot."""
        columns = []
        for i in range(len(x)):
            moved = x.copy()
            moved[i] *= 1 + REFINE_STEP
            other = self.missed(moved)
            columns.append(np.zeros_like(left) if other is None else (other - left) / (REFINE_STEP * x[i]))
        return np.stack(columns, axis=1)


def refined(
    robot: Robot, amendments: Sequence[Amendment], contexts: Sequence[Context], start: Problem
) -> list[Amendment]:
    """``amendments`` with numbers that explain more of the logs together; ``contexts`` and ``start`` are of
    ``robot`` as it was given."""
    freed = Freed.of(robot, amendments, contexts, start)
    return freed.changed(fitted(freed))


def fitted(freed: Freed) -> Floats:
    """Values [P] that explain more of the logs together, by Gauss and Newton, differences taken one by
    one."""
    start, x, sizes = freed.start, freed.x, freed.sizes
    begun, now = x, freed.missed(x) if len(x) else None
    if now is None:
        return x
    for _ in range(REFINE_ROUNDS):
        nuisance, prior = freed.own_numbers(x)
        weight, _ = weights(now.reshape(-1, start.n), nuisance, prior)
        best = least_squares(weight * now, weight[:, None] * nuisance, prior)[0]
        J = freed.slopes(x, now)
        all_of_it = weight[:, None] * np.concatenate([J, nuisance], axis=1)
        _, step = least_squares(weight * now, all_of_it, prior, free=len(x))
        for share in (1.0, 0.3, 0.1):
            tried = freed.with_signs(x, x - share * step[: len(x)])
            within = np.all((np.abs(tried) < REFINE_FARTHEST * np.abs(begun))[sizes])
            other = freed.missed(tried) if within else None
            if other is None:
                continue
            sum_of_squares = least_squares(weight * other, weight[:, None] * nuisance, prior)[0]
            if sum_of_squares < best:
                break
        else:
            break
        assert other is not None
        worth = best - sum_of_squares > REFINE_WORTH * best
        x, now = tried, other
        if not worth:
            break
    return x


def costs(
    robot: Robot, models: Sequence[Sequence[Amendment]], contexts: Sequence[Context], start: Problem
) -> list[float]:
    """What ``robot`` with all of each of the ``models`` leaves of the logs, in units of log-likelihood,
    infinite where there is no such robot or its springs diverge; bursts, by the measure of the first model,
    count by their size (Huber 1964)."""
    usual: Floats | None = None
    residuals = []
    for model in models:
        freed = Freed.of(robot, model, contexts, start)
        left = freed.missed(freed.x)
        if left is None:
            residuals.append(np.inf)
            continue
        nuisance, prior = freed.own_numbers(freed.x)
        weight, usual = weights(left.reshape(-1, start.n), nuisance, prior, usual)
        least = least_squares(weight * left, weight[:, None] * nuisance, prior)[0]
        residuals.append(least / 2 / start.thin)
    return residuals


def is_dry(robot: Robot, j: int) -> bool:
    """Whether joint ``j`` (from 0) has friction that may hold it at rest."""
    joint = robot.links[j].joint
    entries, revolute = robot.effects_at(j + 1), joint.kind == "revolute"
    return bool(joint.coulomb) or any(e.definition.is_dry(dict(e.settings), revolute) for e in entries)


def _with_shape(one: Amendment) -> Amendment:
    """With all that shapes its curve."""
    shapes = {name for name in effect(one.effect).traits.shape if not one.parameters.get(name)}
    return replace(one, parameters={**one.parameters, **dict.fromkeys(shapes, LEAST_SHAPE)})


def _is_refined(known: Effect, name: str, *, shape: bool) -> bool:
    """Whether the number is a size and not a choice, of an effect that is no window in time and whose numbers
    the arm's own do not make up for; a size that shapes its curve where ``shape``."""
    if name in known.traits.shape and not shape:
        return False
    fold = known.traits.fold
    is_body = known.traits.body or (fold is not None and fold.into == "link")
    return known.place != "outside" and not is_body and name not in known.traits.chosen


def _usual(left: Floats) -> Floats:
    """The median size [n] of what is left [N, n]."""
    return np.asarray(np.maximum(1.4826 * np.median(np.abs(left), axis=0), 1e-3))


def weights(
    left: Floats, nuisance: Floats, prior: Floats, usual: Floats | None = None
) -> tuple[Floats, Floats]:
    """Weights [N n] that keep a few bursts (joints that stick at reversals) from having their way (Huber
    1964), as factors of rows, and the median sizes [n]; by what the nuisance too leaves of ``left``
    [N, n]."""
    weight, size = np.ones(left.size), np.ones(left.shape[1])
    for _ in range(HUBER_ROUNDS):
        x = least_squares(weight * left.reshape(-1), weight[:, None] * nuisance, prior)[1]
        rest = left - (nuisance @ x).reshape(left.shape)
        size = _usual(rest) if usual is None else usual
        weight = np.sqrt(np.minimum(1.0, HUBER * size / np.maximum(np.abs(rest), 1e-300))).reshape(-1)
    return weight, size


def least_squares(b: Floats, A: Floats, prior: Floats, free: int = 0) -> tuple[float, Floats]:
    """Least squares of ``b - A x``, all but the first ``free`` of ``x`` held by the ``prior``: the sum, and
    x."""
    rows = np.concatenate([np.zeros((len(prior), free)), prior], axis=1)
    G, g = A.T @ A + rows.T @ rows, A.T @ b
    sizes = np.diag(G)
    scale = np.sqrt(np.where(sizes > 1e-200, sizes, np.inf))  # what does not show at all stays at 0
    x = np.linalg.lstsq(G / np.outer(scale, scale), g / scale, rcond=1e-12)[0] / scale
    left = b - A @ x
    return float(left @ left + np.sum((rows @ x) ** 2)), x
