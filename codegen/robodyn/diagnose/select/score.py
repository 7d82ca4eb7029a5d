"""What candidates foretell: held-out log-likelihood, block by block, of a model with each beside it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats, Singles
from robodyn.diagnose.limits import HALF_WIDTH
from robodyn.diagnose.select.families import Family
from robodyn.diagnose.select.limits import ABOVE_FLOOR, NOISE_STEPS, RIDGE
from robodyn.diagnose.select.members import Fit
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.friction import COULOMB
from robodyn.identify.prior import number_of
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Trial:
    """A ``family`` beside a model: its best one ``k``, coefficients ``x`` [c] of all rows, the ``gains`` [B]
    of blocks that were held out, those of joints ``at`` [n], weighted squares ``after`` [n], ``drop``: the
    share of the RMS that it takes at the joint where that is most; ``is_possible``: whether physics allows
    its numbers."""

    family: Family
    k: int
    x: Floats
    gains: Floats
    at: Floats
    after: Floats
    drop: float
    is_possible: bool

    @property
    def gain(self) -> float:
        """Nats."""
        return float(self.gains.sum())

    @property
    def error(self) -> float:
        """Standard error of the gain."""
        return float(np.sqrt(len(self.gains)) * self.gains.std(ddof=1))


def trials(fit: Fit, found: Sequence[Family]) -> list[Trial]:
    """What each family foretells beside a fitted model; what is not linear is chosen in each fold."""
    rows = fit.model.rows
    I, n = rows.blocks, rows.n
    W, y, A = rows.weight[I], fit.leave[I], fit.columns[I]  # [B, m, n(, p)]
    B, m, _, p = A.shape
    flat = A.reshape(B, m * n, p)
    G, c, inverse, a, left = _folds(fit)
    before = (W * left**2).sum(1)  # [B, n]
    priors = (fit.held * a**2).sum(1)
    weighted = np.sqrt(np.mean(left.reshape(-1, n) ** 2, axis=0)) > ABOVE_FLOOR * rows.floor
    single = [x.astype(np.float32) for x in (W, y, A)]  # as columns are: most of the time goes into these
    at_joints: dict[tuple[int, ...], tuple[Singles, ...]] = {}
    done = []
    for one in found:
        J = one.rows
        Z = one.columns[:, I]  # [G, B, m, J, k]
        count, _, _, _, k = Z.shape
        if one.scale is not None:
            Z = Z * one.scale.astype(np.float32)
        if one.first.rows not in at_joints:
            at_joints[one.first.rows] = tuple(x[:, :, J].reshape(B, m * len(J), -1) for x in single)
        weights, right, beside = at_joints[one.first.rows]
        Zf = Z.reshape(count, B, m * len(J), k)
        WZ = (Zf * weights).swapaxes(2, 3)
        ZZ, ZA = (np.asarray(WZ @ x, dtype=np.float64) for x in (Zf, beside))
        cz = np.asarray(WZ @ right, dtype=np.float64)[..., 0]
        held = 0.0 if one.scale is None else 1.0
        tZZ, tZA, tc = (x.sum(1, keepdims=True) - x for x in (ZZ, ZA, cz))
        P = tZZ - tZA @ inverse @ tZA.swapaxes(2, 3)
        e = tc - (tZA @ a[None, ..., None])[..., 0]
        d = np.sqrt(np.maximum(tZZ.diagonal(0, 2, 3), 1e-300))
        P = P / (d[..., :, None] * d[..., None, :]) + np.eye(k) * (RIDGE + held / d**2)[..., None]
        b = np.linalg.solve(P, (e / d)[..., None])[..., 0] / d
        known, signs = _described(rows.robot, one), np.array(one.signs) > 0
        fits = np.all((b + known >= 0) | ~signs, axis=-1)  # of either sign another dead centre may do
        best = np.argmax(np.where(fits | ~fits.any(0), (e * b).sum(-1), -np.inf), 0)
        if one.first.fixed and one.first.local:  # nothing to learn: rare, and of a size that is known
            b = np.ones_like(b)
            size_of = P[..., 0, 0] * d[..., 0] ** 2
            best = np.full(B, int(np.argmax((2 * e[..., 0] - size_of).sum(1))))
        at = np.arange(B)
        b = b[best, at]
        a1 = a - np.einsum("bpq,bkq,bk->bp", inverse, tZA[best, at], b)
        rest = y - (flat @ a1[..., None]).reshape(B, m, n)
        rest[:, :, J] -= (Zf[best, at] @ b[..., None]).reshape(B, m, len(J))
        after = (W * rest**2).sum(1)
        share = 1 - np.sqrt(after.sum(0) / np.maximum(before.sum(0), 1e-300))
        # By what is thought of such numbers beforehand, and of those that it lets be as they are described.
        against = (held * (b**2).sum(-1) + (fit.held * a1**2).sum(1) - priors) / (2 * B)
        usual = int(np.bincount(best).argmax())
        if after.sum() < before.sum():
            sums = ZZ[usual].sum(0), ZA[usual].sum(0), cz[usual].sum(0)
            x, error = _all_rows(one, G.sum(0), c.sum(0), *sums, fit.held, held)
            x, possible = _possible(rows.robot, one, usual, b, x, error)
        else:
            x, possible = np.zeros(k), False
        done.append(
            Trial(one, usual, x, 0.5 * (before - after).sum(1) - against, 0.5 * (before - after).sum(0),
                  after.sum(0), float(np.where(weighted, share, 0.0).max()), possible)
        )  # fmt: skip
    return done


def held_out(fit: Fit) -> Floats:
    """Weighted squares [B, n] of blocks that a fit was not made to, with a part each of what is against its
    numbers beforehand."""
    squares = (fit.model.rows.weight[fit.model.rows.blocks] * _folds(fit)[-1] ** 2).sum(1)
    priors = (fit.held * _folds(fit)[3] ** 2).sum(1, keepdims=True)
    return np.asarray(squares + priors / squares.size)


def foretold_by(fit: Fit, one: Trial) -> float:
    """Held-out log-likelihood of a fit with ``one`` beside it, as of :func:`log_likelihood` [nats]."""
    return float(log_likelihood(fit).sum()) + one.gain


def log_likelihood(fit: Fit) -> Floats:
    """Held-out log-likelihood [B, n] of blocks, but for a constant."""
    weight = fit.model.rows.weight[fit.model.rows.blocks]
    return np.asarray((np.log(weight).sum(1) - held_out(fit)) / 2)


def likelihood_of_any_noise(fit: Fit) -> float:
    """Held-out log-likelihood, but for a constant, with as much more noise at each joint as makes that most:
    where a model leaves more than noise, what says less of its rows would win by that alone."""
    rows = fit.model.rows
    left = _folds(fit)[-1].reshape(-1, rows.n) ** 2
    noise = rows.correlation * rows.sigma**2
    resting = 1 / rows.weight[rows.blocks].reshape(-1, rows.n) - noise
    most = np.maximum(left.mean(axis=0) / noise, 1.0)
    total = [
        -(np.log(variance) + left / variance).sum(axis=0) / 2
        for share in np.linspace(0.0, 1.0, NOISE_STEPS)
        for variance in [noise * most**share + resting]
    ]
    priors = (fit.held * _folds(fit)[3] ** 2).sum() / len(rows.blocks)
    return float(np.max(total, axis=0).sum() - priors / 2)


def _folds(fit: Fit) -> tuple[Floats, ...]:
    """By block B: squares [B, p, p] and right-hand sides [B, p] of its rows; of all the others the inverse
    [B, p, p] and coefficients [B, p]; and what these leave of it [B, m, n]."""
    if fit.equations:
        return fit.equations[0]
    rows = fit.model.rows
    I, n = rows.blocks, rows.n
    W, y, A = rows.weight[I], fit.leave[I], fit.columns[I]
    B, m, _, p = A.shape
    flat = A.reshape(B, m * n, p)
    WA = (A * W[..., None]).reshape(B, m * n, p).swapaxes(1, 2)
    G, c = WA @ flat, (WA @ y.reshape(B, m * n, 1))[..., 0]
    T, t = G.sum(0) - G, c.sum(0) - c
    square = T.diagonal(0, 1, 2).max(0, initial=0.0) + fit.held
    size = np.sqrt(np.where(square > 1e-200, square, 1.0))  # what does not show at all stays at 0
    outer = np.outer(size, size)
    inverse = np.linalg.inv(T / outer + np.diag(fit.held / size**2 + 1e-9)) / outer
    a = np.einsum("bpq,bq->bp", inverse, t)
    fit.equations.append((G, c, inverse, a, y - (flat @ a[..., None]).reshape(B, m, n)))
    return fit.equations[0]


def _all_rows(
    one: Family, G: Floats, c: Floats, ZZ: Floats, ZA: Floats, cz: Floats, held: Floats, own: float
) -> tuple[Floats, Floats]:
    """Coefficients [c] by all rows together, and their standard errors [c]."""
    if one.first.fixed:
        return np.ones(1), np.zeros(1)
    whole = np.block([[G + np.diag(held), ZA.T], [ZA, ZZ + own * np.eye(len(ZZ))]])
    size = np.sqrt(np.maximum(np.diag(whole), 1e-300))
    right = np.concatenate([c, cz])
    inverse = np.linalg.pinv(whole / np.outer(size, size), rcond=1e-10, hermitian=True)
    x, error = inverse @ (right / size) / size, np.sqrt(np.maximum(np.diag(inverse), 0.0)) / size
    unit = np.ones(len(ZZ)) if one.scale is None else one.scale
    return np.asarray(x[len(G) :] * unit), np.asarray(error[len(G) :] * unit)


def _described(robot: Robot, one: Family) -> Floats:
    """What the description has of a family's numbers [c]."""
    known = np.zeros(len(one.signs))
    if one.first.joint is not None:
        joint = robot.links[one.first.joint - 1].joint
        traits = CATALOGUE[one.first.effect].traits
        fold = traits.fold
        if fold is not None and fold.into == "joint":
            known[0] = number_of(getattr(joint, fold.key))
        elif COULOMB.id in traits.contains or traits.steady:
            known[0] = number_of(joint.coulomb)
        if one.second:
            known[-1] = number_of(joint.viscous)
    return known


def _possible(robot: Robot, one: Family, k: int, b: Floats, x: Floats, error: Floats) -> tuple[Floats, bool]:
    """Coefficients ``x`` [c] of all rows, and whether they and those of folds ``b`` [B, c] can be: what must
    not be negative is not, with what is described there. Of several numbers of one law one may be 0: what
    cannot be told from that, by its standard ``error`` [c], is."""
    usual = np.median(b, axis=0) * (1 if one.scale is None else one.scale)
    if one.first.fixed and not one.first.local:
        return x, bool(0.5 < usual[0] < 2)
    known, signs = _described(robot, one), np.array(one.signs) > 0
    may_be_none = signs.sum() > 1 and not one.second
    least = -HALF_WIDTH * error if may_be_none else 0 * error
    if np.any((usual + known <= least)[signs]) or (signs.any() and not np.any((usual + known)[signs] > 0)):
        return x, False
    x = np.where(signs & may_be_none, np.maximum(x, -known), x)
    candidate = one.ones[k]
    shown = x[:-1] if one.second else one.whole(x)
    return x, bool(candidate.feasible(shown) and candidate.likely(shown))
