"""Trajectories that tell effects apart: of many periodic motions inside the limits the one that tells most.

Two effects are as far apart on a motion as their torques are, whatever their parameters: the angle between
the spaces of their columns, in the metric of what a fit sees. There a torque counts less, the better the
rigid arm's own numbers, within the description's confidence, can stand for it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations
from os import PathLike
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.limits import (
    CORRELATION_RIDGE,
    EXCITE_NOISE,
    EXCITE_QUIET,
    EXCITE_SAMPLES,
    EXCITE_SHARE,
    NO_TORQUE,
    RIPPLE_WAVES,
    SAME_SPACE,
)
from robodyn.diagnose.select.library import Candidate, Hints, candidates, context_of
from robodyn.effects.catalogue import CATALOGUE, effect
from robodyn.errors import InputError
from robodyn.formats.loading import robot_of
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.signals import Signals
from robodyn.robot.model import Robot
from robodyn.simulate.limits import with_limits
from robodyn.simulate.trajectories.fourier import fourier
from robodyn.simulate.trajectories.trajectory import Trajectory

#: An effect at a joint (from 1; None: all joints where it can be, or the whole robot).
EffectAt = tuple[str, int | None]


@dataclass(frozen=True, slots=True, eq=False)
class Design:
    """The ``trajectory`` that tells most. ``separation``: of the worst pair of effects, 0 to 1, the sine of
    the angle between them (without a ``tell``, how independent the whole library is, 0 to 1); ``typical``:
    the median of those tried; ``pair``: which one is worst; ``experiments``: of each effect what the
    catalogue says to record."""

    trajectory: Trajectory
    separation: float
    typical: float
    pair: str | None
    tell: tuple[EffectAt, ...]
    experiments: dict[str, str]
    tries: int


def design(
    robot: Robot,
    tell: Sequence[EffectAt] = (),
    *,
    duration: float = 10.0,
    harmonics: int = 5,
    seed: int = 0,
    tries: int = 30,
    period: float = 1e-3,
    progress: Callable[[int], object] | None = None,
) -> Design:
    """A motion of ``duration`` [s], sampled each ``period`` [s], that tells the effects ``tell`` apart, two
    or more; without them, all effects of the catalogue. Where joints state no limits, usual ones are taken.

    Raises
    ------
    InputError: an effect is not known, or has no place on this robot or no torque of its own; the robot has
    run-time parameters.
    """
    if robot.parameters:
        raise InputError(
            f"{robot.name} has run-time parameters, and a design needs numbers",
            found=", ".join(robot.parameters),
            remedy="write numbers in their place",
        )
    if tries < 1:
        raise InputError("a design needs a try", found=str(tries), expected="1 or more")
    pairs = _checked(robot, tell)
    limited, _ = with_limits(robot)
    motions: list[tuple[float, str | None, Trajectory]] = []
    for k in range(tries):
        # Slow motions and quick ones, by turns.
        periods = 1 + k % max(1, min(4, round(duration / 2.5)))
        one = int(np.random.SeedSequence(seed, spawn_key=(k,)).generate_state(1)[0])
        motion = fourier(
            limited, periods / duration, harmonics, one, periods=periods, share=EXCITE_SHARE, period=period
        )
        value, pair = separation(robot, motion, pairs) if pairs else (independence(robot, motion), None)
        motions.append((value, pair, motion))
        if progress is not None:
            progress(k + 1)
    value, pair, motion = max(motions, key=lambda each: each[0])
    if pairs and pair is None:
        raise InputError(
            f"no motion of {robot.name} shows two of these effects",
            found=", ".join(_name(*one) for one in pairs),
            remedy="other effects, or joints at which they act",
        )
    typical = float(np.median([each[0] for each in motions]))
    texts = {id: CATALOGUE[id].separates for id, _ in pairs}
    return Design(motion, value, typical, pair, pairs, texts, tries)


def _checked(robot: Robot, tell: Sequence[EffectAt]) -> tuple[EffectAt, ...]:
    for id, joint in tell:
        known = effect(id)
        if joint is not None and not 1 <= joint <= robot.n:
            raise InputError(f"{id}: no such joint", found=str(joint), expected=f"1 to {robot.n}")
        if joint is not None and known.level == "robot":
            raise InputError(f"{id} is an effect of the whole robot", found=f"joint {joint}")
    if len(tell) == 1:
        raise InputError(
            "one effect alone cannot be told apart",
            found=_name(*tell[0]),
            expected="two or more, such as " + ",".join([tell[0][0], *effect(tell[0][0]).rivals[:1]]),
        )
    return tuple(tell)


def _name(id: str, joint: int | None) -> str:
    return id if joint is None else f"{id} at joint {joint}"


# --- how far apart ----------------------------------------------------------------------------------------


def excite(robot: Robot | str | PathLike[str], tell: Sequence[EffectAt] = (), **options: Any) -> Design:
    """A motion that tells effects of ``robot`` (or of that path or name) apart: :func:`design` with its
    ``options``. The motion's ``q``, ``qd``, ``qdd`` are [S, n], in rad or m, per s and s^2.

    Raises
    ------
    InputError: as :func:`design`, and if there is no such robot.
    """
    return design(robot_of(robot), tell, **options)


class _Columns:
    """All candidates along a motion, in standard deviations of the noise, and the metric of a fit."""

    def __init__(self, robot: Robot, motion: Trajectory) -> None:
        step = max(1, len(motion) // EXCITE_SAMPLES)
        t, q, qd, qdd = (x[::step] for x in (motion.t, motion.q, motion.qd, motion.qdd))
        model = Model(robot)
        tau = model.torque(q, qd, qdd)
        top = np.abs(qd).max(axis=0)
        # Exact rates: a cutoff above the band is no filter.
        signals = Signals(t, q, qd, qdd, tau, 0.5 / float(t[1] - t[0]), 1, 0)
        self.context = context_of(model, signals, Hints(top, ((RIPPLE_WAVES,),) * robot.n))
        size = np.sqrt(np.mean(tau**2, axis=0))
        self.sigma = EXCITE_NOISE * np.maximum(size, EXCITE_QUIET * max(float(size.max()), 1e-9))
        scale = np.stack([np.abs(row) for row in model.standard_parameters()])
        confidence = np.array([float(link.inertial_share) for link in robot.links])
        Y = model.regressor(q, qd, qdd) * (scale * confidence[:, None])
        self.nuisance = (Y.reshape(len(t), robot.n, -1) / self.sigma[:, None]).reshape(len(t) * robot.n, -1)
        self.inner = np.linalg.cholesky(np.eye(self.nuisance.shape[1]) + self.nuisance.T @ self.nuisance)
        # Of a motion that is designed the rates are known, and no friction is in it yet.
        self.every = list(candidates(self.context))

    def seen(self, candidate: Candidate) -> Floats:
        """The candidate's columns [N, c] as a fit beside the nuisance sees them, each of length 1 before."""
        K, n = self.context.signals.q.shape
        wide = np.zeros((K, n, candidate.columns.shape[2]))
        rows = list(candidate.rows)
        wide[:, rows] = candidate.columns / self.sigma[rows][:, None]
        flat = wide.reshape(K * n, -1)
        size = np.linalg.norm(flat, axis=0)
        there = size > NO_TORQUE
        return np.asarray(flat[:, there] / size[there])

    def metric(self, A: Floats, B: Floats) -> Floats:
        """``A' (1 + Y Y')^-1 B``: the noise and what the arm's own numbers may do."""
        a, b = (np.linalg.solve(self.inner, self.nuisance.T @ X) for X in (A, B))
        return np.asarray(A.T @ B - a.T @ b)


def separation(robot: Robot, motion: Trajectory, tell: Sequence[EffectAt]) -> tuple[float, str | None]:
    """Sine of the angle between the effects of the worst pair, and which that is; 0 and None where no pair
    shows on the motion."""
    columns = _Columns(robot, motion)
    groups = [_groups(columns.every, *one) for one in tell]
    angles = []
    for one, other in combinations(groups, 2):
        for j, mine in one.items():
            for k, theirs in other.items():
                if j is not None and k is not None and j != k and _both_anywhere(one, other):
                    continue
                value = _apart(columns, mine, theirs)
                if value is not None:
                    angles.append((value, f"{mine[0].name} and {theirs[0].name}"))
    return min(angles) if angles else (0.0, None)


def _both_anywhere(one: dict[int | None, list[Candidate]], other: dict[int | None, list[Candidate]]) -> bool:
    """Whether both effects were asked for at any joint: then joint by joint."""
    return len(one) > 1 and len(other) > 1


def _groups(every: Sequence[Candidate], id: str, joint: int | None) -> dict[int | None, list[Candidate]]:
    """The candidates of an effect by joint, all values of what is not linear together."""
    groups: dict[int | None, list[Candidate]] = {}
    for each in every:
        if each.effect == id and (joint is None or each.joint == joint):
            groups.setdefault(each.joint, []).append(each)
    if not groups:
        raise InputError(
            f"{_name(id, joint)} has no columns that a motion could tell apart",
            remedy=CATALOGUE[id].separates,
        )
    if None in groups and len(groups) > 1:  # of the whole robot, and of a joint: as it was asked for
        groups = {None: groups[None]}
    return groups


def _apart(columns: _Columns, one: Sequence[Candidate], other: Sequence[Candidate]) -> float | None:
    """How far apart two effects are, at what is not linear in them as it may be: that of the one is unknown,
    and of the other what comes nearest is fitted."""
    mine, theirs = ([X for X in map(columns.seen, group) if X.shape[1]] for group in (one, other))
    if not mine or not theirs:
        return None
    pairs = [[_sine(columns, A, B) for B in theirs] for A in mine]
    sines = np.array([[sine for sine, _ in row] for row in pairs])
    inside = {way for row in pairs for _, way in row}
    forth, back = float(np.median(sines.min(axis=1))), float(np.median(sines.min(axis=0)))
    if inside == {-1}:  # the first is a special case of the second: what is unknown is the second's
        return back
    return forth if inside == {1} else min(forth, back)


def _sine(columns: _Columns, A: Floats, B: Floats) -> tuple[float, int]:
    """Sine of the smallest angle between the columns of A and B that is not 0 by nature; -1 or 1 where A or B
    lies in the other: then what the wider one has beyond, as a share of its columns."""
    a, b = _factor(columns.metric(A, A)), _factor(columns.metric(B, B))
    if not a.shape[1] or not b.shape[1]:
        return 0.0, 0
    _, cosines, _ = np.linalg.svd(a.T @ columns.metric(A, B) @ b)
    cosines = np.minimum(cosines, 1.0)
    shared = int(np.sum(cosines > 1 - SAME_SPACE))
    if shared < min(a.shape[1], b.shape[1]):
        return float(np.sqrt(1 - cosines[shared] ** 2)), 0
    if a.shape[1] == b.shape[1]:
        return 0.0, 0
    wide, narrow, base, way = (B, A, a, -1) if b.shape[1] > a.shape[1] else (A, B, b, 1)
    cross = base.T @ columns.metric(narrow, wide)
    left = 1 - np.sum(cross**2, axis=0) / np.maximum(np.diag(columns.metric(wide, wide)), 1e-300)
    beyond = left[left > SAME_SPACE]
    return (float(np.sqrt(min(beyond.min(), 1.0))), way) if len(beyond) else (0.0, way)


def _factor(gram: Floats) -> Floats:
    """Combinations [c, r] of columns with this Gram matrix that are orthonormal, of those that are not 0."""
    values, vectors = np.linalg.eigh(gram)
    kept = values > 1e-10 * max(float(values.max()), 1e-300)
    return np.asarray(vectors[:, kept] / np.sqrt(values[kept]))


def independence(robot: Robot, motion: Trajectory) -> float:
    """How independent the columns of the whole library are, 0 to 1: the geometric mean of the eigenvalues
    of their correlations (of what is not linear the middle of its grid), which a D-optimal motion has
    largest."""
    columns = _Columns(robot, motion)
    groups: dict[tuple[str, int | None, str], list[Candidate]] = {}
    for each in columns.every:
        groups.setdefault((each.effect, each.joint, ",".join(each.values)), []).append(each)
    middle = [group[len(group) // 2] for group in groups.values()]
    X = np.concatenate([columns.seen(each) for each in middle], axis=1)
    gram = columns.metric(X, X)
    size = np.sqrt(np.maximum(np.diag(gram), 1e-12))
    correlations = gram / np.outer(size, size) + CORRELATION_RIDGE * np.eye(len(gram))
    return float(math.exp(np.mean(np.log(np.maximum(np.linalg.eigvalsh(correlations), 1e-12)))))
