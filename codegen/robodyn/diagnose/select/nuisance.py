"""What is fitted beside all candidates and has no name: the arm's own numbers, and when torques were read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.diagnose.select.compare import ahead, foretells, is_of_link
from robodyn.diagnose.select.library import regressor_seen, rotors_seen
from robodyn.diagnose.select.limits import LEAST_SHOWN, PRACTICAL, SHARES
from robodyn.diagnose.select.members import Fit, Model, fitted
from robodyn.diagnose.select.prior import prior_scales
from robodyn.diagnose.select.rows import Rows
from robodyn.diagnose.select.score import Trial, held_out
from robodyn.effects.catalogue import CATALOGUE
from robodyn.identify.known import spread_of
from robodyn.kernels.array_dynamics import Model as ArrayModel
from robodyn.robot.parts import SHARE_NOT_STATED


def own_numbers(rows: Rows, share: float, tilts: Sequence[Amendment] = ()) -> Floats:
    """Torques [N, n, p] by combinations of the arm's own numbers, in units of what is known of them
    beforehand, those that show: by their covariance, or by what is stated of them and the ``share`` of those
    of which nothing is. On a base that ``tilts`` a first link has a weight that a level one does not
    show."""
    model, contexts = rows.contexts[0].model, rows.contexts
    if tilts:
        model = ArrayModel(amended(rows.robot, tilts), sticking=rows.speeds)
        contexts = tuple(replace(c, model=model, kept={}) for c in contexts)
    regressor = np.concatenate([regressor_seen(c) for c in contexts])
    spread = spread_of(model.robot, prior_scales(model, float(SHARE_NOT_STATED)))
    if spread is None:
        columns = regressor * prior_scales(model, share).reshape(-1)
    else:
        rotors = np.concatenate([rotors_seen(c) for c in rows.contexts])
        columns = np.concatenate([regressor, rotors], axis=2) @ spread.T
    flat = (columns * np.sqrt(rows.weight)[:, :, None]).reshape(-1, columns.shape[2])
    _, sizes, ways = np.linalg.svd(flat.T @ flat, hermitian=True)
    return np.asarray(columns @ ways[np.sqrt(sizes) > LEAST_SHOWN].T)


def _by_lateness(rows: Rows, delays: Sequence[int | None]) -> Floats:
    """Torques [N, n, n] by half a sample for which each joint's is read later than its position; of joints
    with ``delays`` (from 1; None: all) that is a part of the delay."""
    is_open = np.array([not {None, joint} & set(delays) for joint in range(1, rows.n + 1)])
    parts = []
    for c in rows.contexts:
        s = c.signals
        rate = np.gradient(s.filtered(s.tau), s.period, axis=0)
        parts.append(s.thinned(s.filtered(rate)) * s.period / 2)
    return np.asarray(np.concatenate(parts)[:, :, None] * np.diag(is_open))


def with_own_numbers(model: Model, share: float | None, *, is_timed: bool) -> Model:
    """The model beside its arm's own numbers, where nothing is stated of them wrong by the ``share``."""
    columns = own_numbers(model.rows, share or 0.0, model.tilts)
    if is_timed:
        columns = np.concatenate([columns, _by_lateness(model.rows, model.delays)], axis=2)
    return replace(model, own=columns, share=share, is_timed=is_timed)


def _wider(fit: Fit) -> Iterator[Fit]:
    """The fit with wider bounds of the arm's own numbers of which nothing is known, the members as they
    are."""
    robot = fit.model.rows.robot
    is_known = robot.covariance is not None or all(link.confidence is not None for link in robot.links)
    for share in () if is_known else SHARES:
        if fit.model.share is None or share > fit.model.share:
            wider = fitted(with_own_numbers(fit.model, share, is_timed=fit.model.is_timed), 0)
            if wider is not None:
                yield wider


def widened(fit: Fit, threshold: float, best: Trial | None = None) -> Fit | None:
    """The model with wider bounds of the arm's own numbers, where that foretells more by the
    ``threshold`` [nats], and clearly more than the ``best`` candidate: wrong numbers of one link."""
    before, choices = held_out(fit), []
    for wider in _wider(fit):
        after = held_out(wider)
        gains = (before - after).sum(axis=1) / 2
        drop = 1 - np.sqrt((after.sum(axis=0) / np.maximum(before.sum(axis=0), 1e-300)).min())
        lead = gains if best is None else np.minimum(gains, gains - best.gains)
        if lead.sum() > threshold and ahead(lead) > 1 and drop > PRACTICAL:
            choices.append((float(gains.sum()), wider))
    if not choices:
        return None
    most = max(gain for gain, _ in choices)
    near = [wider for gain, wider in choices if gain > most - threshold]
    return fitted(near[0].model)


def throughout(fit: Fit, one: Trial) -> Floats | None:
    """What the arm's own numbers foretell [B, nats] in the place of ``one``, a load or a wrong link, if all
    are wrong: a rival without a name, where nothing is stated of them. One link alone is all of them."""
    if fit.model.rows.n == 1 or not is_of_link(one.family.first):
        return None
    before = held_out(fit)
    gains = [(before - held_out(wider)).sum(axis=1) / 2 for wider in _wider(fit)]
    return max(gains, key=lambda each: float(each.sum()), default=None)


def timed(fit: Fit, threshold: float) -> Fit | None:
    """The fit beside when torques were read, to half a sample, where that foretells more by the ``threshold``
    [nats]: at reversals it makes a level of friction look another. What is later is a delay, to be named, and
    a search beside this from the start would miss it."""
    if fit.model.is_timed:
        return None
    other = fitted(with_own_numbers(fit.model, fit.model.share, is_timed=True))
    if other is None or foretells(other, fit) <= threshold:
        return None
    late = slice(other.model.own.shape[2] - fit.model.rows.n, other.model.own.shape[2])
    return other if np.abs(other.x[late]).max() <= 1 else None


def last_fit(fit: Fit) -> Fit:
    """The fit beside when torques were read, and with numbers that shape a curve free, in any case: without
    these intervals are too narrow."""
    is_shaped = any(CATALOGUE[one.key[0]].traits.shape for one in fit.model.members)
    if fit.model.is_timed and not is_shaped and not fit.model.delays:
        return fit
    members = [replace(one, is_shaped=True) for one in fit.model.members]
    return fitted(with_own_numbers(fit.model.with_members(members), fit.model.share, is_timed=True)) or fit
