"""Which effects are worth adding: one after another, each judged on parts of the log that it was not fitted
to.

A step takes, of all candidates that pass, the one that explains most; those that explain as much are its
rivals, and of them the simplest is named. It passes where (i) the gain is there in nearly all parts of the
log (paired over parts), (ii) it is more than chance would give over the whole library, (iii) what it
explains at some joint matters beside the noise of the torque channel and the torque itself.

The rigid arm's own numbers compete: what they explain within their confidence costs little, beyond it as
much as its prior says."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.beside import Library
from robodyn.diagnose.select.ceiling import unexplained
from robodyn.diagnose.select.choice import nearest
from robodyn.diagnose.select.fit import (
    Fit,
    Problem,
    by_prior,
    coarser,
    covariance,
    fitted,
    problem,
    share_taken,
    tighter,
    wider,
)
from robodyn.diagnose.select.forward import Chosen, Key, Named, forward
from robodyn.diagnose.select.library import Context, context_of, regressor_seen
from robodyn.diagnose.select.library.several import usual_sizes
from robodyn.diagnose.select.limits import (
    DIVERGED,
    LEAST_MOVING,
    OF_ENCODER_NOISE,
    OF_NOISE,
    OF_TORQUE,
    POSES,
    REST_WEIGHT,
    RIGID_EVIDENCE,
    SHORTEST_PIECE,
    STANDS_OUT,
    TIGHT,
    TIGHT_EVIDENCE,
    UNSTATED,
)
from robodyn.diagnose.select.prior_share import prior_share
from robodyn.diagnose.select.scope import EVERYTHING, Scope
from robodyn.diagnose.select.trial import Trial, evidence_threshold, numbers_of, trials
from robodyn.effects.catalogue import CATALOGUE
from robodyn.identify.limits import LEAST_NOISE
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.limits import MOTION_WIDER
from robodyn.logs.log import Log
from robodyn.logs.signals import Signals, signals_of
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Selection:
    """The effects selected in the parts of a log; ``first`` and ``last`` fits; all trials of the first step,
    best first; ``residue`` [n]: the median of what is left, in units of the noise (a median, so that short
    bursts of joints that stick at reversals do not count); ``unstated``: by which share the inertial numbers
    were taken to be wrong of which nothing is stated, None: by that of the description;
    ``rough``: the log has more in it than the catalogue; ``share``: as what share of what is said
    of them or taken the numbers are wrong, as the log has it."""

    contexts: tuple[Context, ...]
    start: Problem
    findings: tuple[Named, ...]
    first: Fit
    last: Fit
    trials: tuple[Trial, ...]
    residue: Floats
    unstated: float | None = None
    rough: bool = False
    share: float = 1.0

    @property
    def context(self) -> Context:
        """That of the longest part."""
        return self.contexts[0]


def prior_scales(model: Model, unstated: float | None = None) -> Floats:
    """Standard deviations [n, 10] of the links' standard parameters about the description: by the share that
    is stated of each, or ``unstated``."""
    phi = model.standard_parameters()
    scales, usual = np.zeros_like(phi), usual_sizes(model)
    for k, link in enumerate(model.robot.links):
        share = float(link.inertial_share)
        is_free = link.confidence == "unknown"
        if link.confidence is None and unstated is not None:
            share, is_free = unstated, True
        size = np.abs(phi[k])
        floor = np.concatenate([[0.0], np.full(3, 0.02 * size[0]), np.full(6, 0.1 * size[4:7].max())])
        scales[k] = share * np.maximum(size, usual[k] if is_free else floor)
    return scales


def start_of(contexts: Sequence[Context], scale: Floats, weight: Floats | None = None) -> Problem:
    """The filtered residual of the model, and the nuisance of its rigid numbers, which are right to
    ``scale`` [n, 10]; ``weight`` [N, n]: what the rows count (1)."""
    s = contexts[0].signals
    rests, nuisances = [], []
    for c in contexts:
        rests.append(c.signals.thinned(c.signals.filtered(c.signals.tau - c.at.total)))
        nuisances.append(regressor_seen(c) * scale.reshape(-1))
    Y = np.concatenate(nuisances)
    thin = max(1.0, 1 / (2 * s.cutoff * s.period * s.every))
    by_encoders = encoder_torque_noise(contexts[0])
    sigma = np.hypot(passed_noise(s), by_encoders)
    return problem(np.concatenate(rests), Y, sigma, thin, by_encoders, weight, scale.reshape(-1))


def weight_of(resting: Mask) -> Floats:
    """What rows [N, n] count: less where joints rest, for stiction holds them there with any torque. A joint
    that hardly moves has nothing better."""
    is_weighed = resting & (np.mean(~resting, axis=0) > LEAST_MOVING)
    return np.where(is_weighed, REST_WEIGHT, 1.0)


def raw_noise(s: Signals) -> Floats:
    """Standard deviations [n] of the torque channel's noise."""
    return np.zeros(s.n) if s.torque_noise is None else s.torque_noise


def passed_noise(s: Signals) -> Floats:
    """As far as the filter lets it pass."""
    floor = 1e-4 * np.sqrt(np.mean(s.tau**2, axis=0))
    passed = raw_noise(s) * np.sqrt(min(1.0, 2 * s.cutoff * s.period))
    return np.asarray(np.maximum(passed, np.maximum(floor, LEAST_NOISE)))


def encoder_torque_noise(c: Context) -> Floats:
    """Standard deviations [n] of the encoders' noise, carried into the model's torques by the
    accelerations."""
    s = c.signals
    if s.acceleration_noise is None:
        return np.zeros(c.n)
    q = s.q[:: max(1, len(s.q) // POSES)]
    zeros = np.zeros_like(q)
    still = c.model.torque(q, zeros, zeros)
    squares = np.zeros(c.n)
    for j in range(c.n):
        ahead = zeros.copy()
        ahead[:, j] = s.acceleration_noise[j]
        squares += np.mean((c.model.torque(q, zeros, ahead) - still) ** 2, axis=0)
    return np.sqrt(squares)


def what_matters(c: Context) -> Floats:
    """RMS [n] that an effect must explain at a joint to be worth a name."""
    s = c.signals
    large = np.maximum(OF_NOISE * raw_noise(s), OF_TORQUE * np.sqrt(np.mean(s.tau**2, axis=0)))
    large = np.maximum(large, LEAST_NOISE)
    # A link on its spring looks like a smoother motion, and so hides noise of the encoders.
    return np.asarray(np.maximum(large, OF_ENCODER_NOISE * encoder_torque_noise(c)))


def select(
    robot: Robot,
    logs: Log | Sequence[Log],
    *,
    known: frozenset[Key] = frozenset(),
    unstated: float | None = None,
    progress: Callable[[str], object] | None = None,
    cutoff: float | None = None,
    scope: Scope = EVERYTHING,
    resting: Sequence[Mask] = (),
) -> Selection:
    """What ``robot`` lacks to explain ``logs``, each evenly sampled, in ``scope``; parts too short to be
    filtered are left out. ``known``: what the model has of earlier passes; ``unstated``: by which share
    the inertial numbers may be wrong of which nothing is stated (None: the logs decide); ``resting`` of
    each log [K, n]: where joints stand still."""
    pieces = [logs] if isinstance(logs, Log) else list(logs)
    still = list(resting) or [np.zeros(log.q.shape, dtype=np.bool_) for log in pieces]
    order = sorted(range(len(pieces)), key=lambda k: -pieces[k].samples)
    longest = signals_of(pieces[order[0]], cutoff=cutoff, wider=MOTION_WIDER)
    context = context_of(Model(robot), longest)
    contexts, rests = [context], [still[order[0]][longest.used]]
    for k in order[1:]:
        if pieces[k].samples * longest.period > SHORTEST_PIECE / longest.cutoff:
            more = signals_of(pieces[k], cutoff=longest.cutoff, wider=MOTION_WIDER)
            contexts.append(context_of(context.model, more, context.hints))
            rests.append(still[k][more.used])
    weight = weight_of(np.concatenate(rests))
    narrow = prior_scales(context.model)
    start = start_of(contexts, narrow, weight)
    least = what_matters(context) / start.sigma
    library = Library.along(contexts, scope)
    factor = _factor(start, library, least, contexts)
    start = coarser(start, factor)
    least = least / factor
    rough = bool(np.any(factor > 1))

    def choose(start: Problem, *, links: bool = True) -> Chosen:
        return forward(
            start, library, least, contexts, known=known, rough=rough, links=links, most=scope.most,
            progress=progress,
        )  # fmt: skip

    def wide(share: float) -> Problem:
        return wider(start, start_of(contexts, prior_scales(context.model, share), weight))

    if unstated is not None:
        start = wide(unstated)
        chosen = choose(start, links=False)
    else:
        best = described = _View.of(start, choose(start))
        # Perhaps the arm's numbers are better than they are said to be, and something else shows; or, where
        # nothing is said of them, they are worse.
        is_stated = all(link.confidence is not None for link in robot.links)
        if not best.chosen.findings or (is_stated and not known and not rough):
            for tight in TIGHT:
                other = tighter(start, tight)
                view = _View.of(other, choose(other), tight=tight)
                margin = TIGHT_EVIDENCE if best is described else 0.0
                if view.chosen.findings and view.evidence > best.evidence + margin:
                    best = view
            if best is not described and not best.may_name(described, known):
                best = described
        elif not is_stated:
            for share in UNSTATED:
                other = wide(share)
                view = _View.of(other, choose(other, links=False), unstated=share)
                if view.evidence > best.evidence + TIGHT_EVIDENCE:
                    best = view
        start, chosen, unstated = best.start, best.chosen, best.unstated
    now, current, findings = chosen.now, chosen.current, chosen.findings
    first = fitted(start)
    share = prior_share(now, current)
    borne_out = tighter(now, share / share_taken(now))
    estimated = _estimated(borne_out, fitted(borne_out), findings)
    residue = factor * now.usual(now.rest - now.A @ current.known)
    for each in contexts:
        each.kept.clear()
    return Selection(
        tuple(contexts), start, estimated, first, current, tuple(chosen.trials), residue, unstated, rough,
        share,
    )  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class _View:
    """What was ``chosen`` beside one prior of the arm's numbers, that of the problem ``start``, and the
    ``evidence`` for both. ``tight``: as what share of what is said the numbers are taken to be wrong;
    ``unstated``: as what share of themselves those of which nothing is said."""

    start: Problem
    chosen: Chosen
    evidence: float
    tight: float
    unstated: float | None

    @classmethod
    def of(
        cls, start: Problem, chosen: Chosen, *, tight: float = 1.0, unstated: float | None = None
    ) -> _View:
        """With its evidence."""
        return cls(start, chosen, _evidence(start, chosen), tight, unstated)

    def may_name(self, described: _View, known: frozenset[Key]) -> bool:
        """Whether its names are none of what the view as ``described`` has it to be so. That the numbers of
        a link are wrong, or that there is a body more, is news where all other numbers are as exact as can
        be, whatever is said of them (those of an identified arm are better than its description says). A
        scatter of them all, of which one shows most, is what a description is expected to have, and on an
        arm of few joints one body may fit it; so may a second one beside what is ``known``."""
        named = [each.trial.candidate.effect for each in self.chosen.findings]
        if not any(map(_is_of_mass, named)):
            return True
        several = sum(map(_is_of_mass, [*named, *(effect for effect, _ in known)]))
        is_exact = self.tight == min(TIGHT) and self.evidence > described.evidence + RIGID_EVIDENCE
        return several == 1 and is_exact


def _is_of_mass(id: str) -> bool:
    """Whether an effect is of one link's numbers, or of a body more."""
    traits = CATALOGUE[id].traits
    return traits.body or (traits.fold is not None and traits.fold.into == "link")


def _evidence(start: Problem, chosen: Chosen) -> float:
    """How well a prior of the arm's numbers foresaw the logs, with what was chosen, in units of
    log-likelihood (MacKay 1992)."""
    p = chosen.now
    left = p.rest - p.A @ chosen.current.known
    floor = np.maximum(np.mean(left**2, axis=0), 1.0)
    known = chosen.current.known[: p.nuisance]
    misfit = float(np.sum(np.mean(left**2, axis=0) / floor)) * len(left) / p.thin / 2
    penalty = float(np.sum(p.prior[: p.nuisance] * known**2)) / p.thin / 2
    gram = start.grams.sum(axis=0)[: p.nuisance, : p.nuisance] / np.sqrt(
        np.outer(start.prior[: p.nuisance], start.prior[: p.nuisance])
    )
    width = float(np.linalg.slogdet(np.eye(len(gram)) + gram)[1]) / 2
    spread = float(np.sum(np.log(floor))) * len(left) / p.thin / 2
    choice = sum(evidence_threshold(start, numbers_of(f.trial)) for f in chosen.findings)
    return -misfit - spread - penalty - width - choice


def _factor(start: Problem, library: Library, least: Floats, contexts: Sequence[Context]) -> Floats:
    """How much larger [n] than the noise is what neither the library nor one of its candidates explains."""
    factor = unexplained(start, library)
    if np.all(factor == 1):
        return factor
    current = fitted(start)
    # A single burst may have biased all these fits.
    for left in (start.rest, start.rest - start.A @ current.known):
        factor = np.where(start.usual(left) < STANDS_OUT, 1.0, factor)
    tried = trials(start, current, library, least)
    for one in nearest(start, current, tried, least, contexts):
        left = np.sqrt(np.median(one.fit.held_out, axis=0))
        # A law in the place of others tells nothing of them, unless nothing is left beside it.
        if one.candidate.in_place and np.any(left >= STANDS_OUT):
            continue
        factor = np.minimum(factor, np.where(left < STANDS_OUT, 1.0, left))
    return factor


def _estimated(now: Problem, last: Fit, findings: Sequence[Named]) -> tuple[Named, ...]:
    """The effects with their coefficients in the fit of all together."""
    done = []
    at = now.nuisance
    spread = covariance(now, last)
    for one in findings:
        if one.trial.candidate.fixed:
            done.append(replace(one, x=np.ones(1), spread=np.zeros((1, 1))))
            continue
        wide = one.trial.columns.shape[2]
        x = last.known[at : at + wide]
        signs = np.array(one.trial.candidate.signs)
        if np.any((signs > 0) & (x < 0)) or np.abs(x).max() > DIVERGED * np.abs(one.trial.fit.x).max():
            x = one.trial.fit.x  # the fit of all together cannot separate them
        part = slice(at, at + wide)
        sizes, ways = np.linalg.eigh(spread[part, part])
        done.append(
            replace(one, x=x, spread=ways * np.sqrt(np.maximum(sizes, 0)), by_prior=by_prior(now, part))
        )
        at += wide
    return tuple(done)
