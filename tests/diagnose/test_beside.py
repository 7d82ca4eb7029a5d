"""Candidates tried by block elimination are fitted and judged as by least squares over all samples."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.diagnose.select.beside import Library, fits
from robodyn.diagnose.select.fit import Fit, Problem, fitted, problem, without
from robodyn.diagnose.select.library import Candidate
from robodyn.diagnose.select.limits import BLOCKS

Floats = NDArray[np.float64]
N, JOINTS = 400, 3


def candidate(rows: tuple[int, ...], signs: tuple[int, ...], *, fixed: bool = False) -> Candidate:
    return Candidate(
        "viscous_friction", rows[0] + 1, rows, np.zeros((0, len(rows), len(signs))), signs,
        lambda x: {"coefficient": float(x[0])}, 1, fixed=fixed,
    )  # fmt: skip


def single(columns: Floats) -> NDArray[np.float32]:
    """Columns as a library keeps them."""
    return columns.astype(np.float32)


def posed(rng: np.random.Generator) -> Problem:
    """A problem with ten nuisance columns, two of which show nothing new, and a known one."""
    Y = rng.standard_normal((N, JOINTS, 10))
    Y[:, :, 8], Y[:, :, 9] = 0.0, Y[:, :, 0] - 2 * Y[:, :, 1]
    rest = rng.standard_normal((N, JOINTS)) + 3 * Y[:, :, 2]
    p = problem(rest, Y, np.array([1.0, 0.5, 2.0]), 2.0)
    return p.with_columns((1,), rng.standard_normal((N, 1, 1)))


def by_samples(p: Problem, rows: tuple[int, ...], columns: Floats, signs: tuple[int, ...]) -> Fit:
    """The same over all samples: every system solved whole, every residual worked out."""
    wide = np.zeros((N, JOINTS, columns.shape[2]))
    wide[:, list(rows)] = columns / p.sigma[list(rows)][:, None]
    A = np.concatenate([p.A, wide * p.rest.any(axis=1)[:, None, None]], axis=2)
    prior = np.sqrt(np.concatenate([p.prior, np.full(columns.shape[2], 1e-12)]))

    def solved(used: NDArray[np.bool_]) -> Floats:
        free = np.ones(A.shape[2], bool)
        x = np.zeros(A.shape[2])
        for _ in range(len(signs) + 1):
            flat = np.concatenate([A[used].reshape(-1, A.shape[2]), np.diag(prior)])[:, free]
            b = np.concatenate([p.rest[used].reshape(-1), np.zeros(A.shape[2])])
            x[:] = 0
            x[free] = np.linalg.lstsq(flat, b, rcond=None)[0]
            tail = x[p.A.shape[2] :]
            wrong = [i for i, sign in enumerate(signs) if sign > 0 and tail[i] < 0]
            if not wrong:
                break
            free[p.A.shape[2] + min(wrong, key=lambda i: tail[i] * np.sqrt(np.mean(wide[..., i] ** 2)))] = (
                False
            )
        return x

    held_out = []
    for part in p.parts:
        used = np.ones(N, bool)
        used[part] = False
        held_out.append(np.mean((p.rest[part] - A[part] @ solved(used)) ** 2, axis=0))
    x = solved(np.ones(N, bool))
    penalty = float(np.sum(p.prior[: p.nuisance] * x[: p.nuisance] ** 2)) / p.thin / 2
    known = x[: p.A.shape[2]]
    return Fit(x[p.A.shape[2] :], np.zeros((0, 0)), known, np.array(held_out), penalty)


def held_equal(one: Fit, other: Fit) -> None:
    for a, b in ((one.x, other.x), (one.known, other.known), (one.held_out, other.held_out)):
        np.testing.assert_allclose(a, b, rtol=1e-7, atol=1e-7)
    assert one.prior_penalty == pytest.approx(other.prior_penalty, rel=1e-7)


@pytest.mark.parametrize("masked", [False, True])
@pytest.mark.thorough
def test_candidates_are_fitted_as_by_all_samples(*, masked: bool) -> None:
    rng = np.random.default_rng(3)
    p = posed(rng)
    assert p.nuisance == 8
    if masked:
        p = without(p, (np.arange(N) > 90) & (np.arange(N) < 130))
    tried = [((0,), (1,)), ((0,), (1,)), ((2, 0), (1, 1)), ((0, 1, 2), (0, 0, 0)), ((1,), (1, 1, 1))]
    pairs = [
        (candidate(rows, signs), single(rng.standard_normal((N, len(rows), len(signs)))))
        for rows, signs in tried
    ]
    pairs[0] = (pairs[0][0], single(pairs[0][1] - p.rest[:, :1, None]))  # would come out negative
    pairs[4] = (pairs[4][0], single(pairs[4][1] - 0.3 * p.rest[:, 1:2, None]))  # all three would
    library = Library.of(pairs)
    current = fitted(p)
    held_equal(current, by_samples(p, (0,), np.zeros((N, 1, 0)), ()))
    outcome = fits(p, current, library, range(len(pairs)))
    assert sorted(outcome.which) == list(range(len(pairs)))
    for k, fit, explained in zip(outcome.which, outcome.fits, outcome.explained, strict=True):
        rows, signs = tried[k]
        held_equal(fit, by_samples(p, rows, pairs[k][1].astype(np.float64), signs))
        counted = pairs[k][1] * p.rest.any(axis=1)[:, None, None]
        rms = np.sqrt(np.mean((counted @ fit.x) ** 2, axis=0)) / p.sigma[list(rows)]
        np.testing.assert_allclose(explained, rms, rtol=1e-9)


def test_a_candidate_of_known_size_is_taken_off() -> None:
    rng = np.random.default_rng(4)
    p = posed(rng)
    column = single(rng.standard_normal((N, 2, 1)))
    outcome = fits(p, fitted(p), Library.of([(candidate((0, 2), (1,), fixed=True), column)]), [0])
    wide = np.zeros((N, JOINTS))
    wide[:, [0, 2]] = column[:, :, 0] / p.sigma[[0, 2]]
    rest = p.rest - wide
    A = p.A.reshape(N * JOINTS, -1)
    for k, part in enumerate(p.parts):
        used = np.ones(N, bool)
        used[part] = False
        rows = np.repeat(used, JOINTS)
        x = np.linalg.solve(A[rows].T @ A[rows] + np.diag(p.prior), A[rows].T @ rest.reshape(-1)[rows])
        left = np.mean((rest[part] - p.A[part] @ x) ** 2, axis=0)
        np.testing.assert_allclose(outcome.fits[0].held_out[k], left, rtol=1e-9)
    assert outcome.fits[0].x.tolist() == [1.0]
    assert outcome.fits[0].held_out.shape == (BLOCKS, JOINTS)


def test_what_is_known_already_gets_no_coefficient() -> None:
    rng = np.random.default_rng(5)
    p = posed(rng)
    again = single(p.A[:, 1, -1:, None] * 3.0)  # the column that is known already, larger
    fit = fits(p, fitted(p), Library.of([(candidate((1,), (0,)), again)]), [0]).fits[0]
    assert fit.x.tolist() == [0.0]
    np.testing.assert_allclose(fit.held_out, fitted(p).held_out, rtol=1e-9)
