"""What candidates foretell is what least squares over the other blocks foretell, block by block."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from diagnose.synthetic import fit_of, rows_of_numbers
from robodyn.diagnose.select.families import Family
from robodyn.diagnose.select.library.candidate import Candidate
from robodyn.diagnose.select.members import Fit
from robodyn.diagnose.select.score import held_out, trials

Floats = NDArray[np.float64]
N, JOINTS = 400, 3


def family(columns: Floats, rows: tuple[int, ...], scale: Floats | None = None, sign: int = 0) -> Family:
    """Candidates of ``columns`` [G, N, rows, c] at joints ``rows``, with numbers of that ``sign``."""
    ones = tuple(
        Candidate(
            "viscous_friction", rows[0] + 1, rows, np.zeros((0, len(rows), columns.shape[3])),
            (sign,) * columns.shape[3], lambda x: {"coefficient": float(x[0])}, 1, scale=scale,
        )
        for _ in columns
    )  # fmt: skip
    return Family(ones, columns.astype(np.float32))


def posed(seed: int) -> tuple[Fit, np.random.Generator]:
    """A model with two numbers that are held and one that is free, along rows some of which are at rest."""
    rng = np.random.default_rng(seed)
    rows = rows_of_numbers(N, np.array([1.0, 0.5, 2.0]), rng.uniform(0, 1, (N, JOINTS)) ** 4)
    own, slopes = rng.standard_normal((N, JOINTS, 2)), rng.standard_normal((N, JOINTS, 1))
    y = own @ [1.0, -0.5] + 3 * slopes[:, :, 0] + rows.sigma * rng.standard_normal((N, JOINTS))
    return fit_of(rows, y, own, slopes), rng


def by_loops(fit: Fit, more: Floats, held: float) -> tuple[Floats, Floats, Floats]:
    """Weighted squares [B, n] that are left of blocks by the best of ``more`` [G, N, n, c], each fitted to
    the other blocks by least squares over all rows at once; the same of the model alone; and what the priors
    have against the numbers of either, a part of it for each block [2, B]."""
    rows = fit.model.rows
    N, n, _ = fit.columns.shape
    root = np.sqrt(1 / (rows.sigma**2 + rows.level**2 * rows.unresolved))
    left, against = np.zeros((2, len(rows.blocks), n)), np.zeros((2, len(rows.blocks)))
    for b, block in enumerate(rows.blocks):
        train = np.concatenate([other for k, other in enumerate(rows.blocks) if k != b])
        for which, tried in enumerate((more, np.zeros((1, N, n, 0)))):
            best = np.inf
            for columns in tried:
                A = np.concatenate([fit.columns, columns], axis=2)
                prior = np.sqrt(np.concatenate([fit.held, np.full(columns.shape[2], held)]))
                system = np.concatenate([
                    (A[train] * root[train][:, :, None]).reshape(-1, A.shape[2]), np.diag(prior)
                ])  # fmt: skip
                right = np.concatenate([(fit.leave * root)[train].ravel(), np.zeros(A.shape[2])])
                x = np.linalg.lstsq(system, right, rcond=None)[0]
                cost = np.sum((right - system @ x) ** 2)
                if cost < best:
                    best = cost
                    rest = (fit.leave[block] - A[block] @ x) * root[block]
                    left[which, b] = np.sum(rest**2, axis=0)
                    against[which, b] = np.sum((prior * x) ** 2) / len(rows.blocks)
    return left[0], left[1], against


@pytest.mark.parametrize(
    ("joints", "variants", "numbers", "scale"),
    [
        ((1,), 1, 1, None),
        ((0,), 3, 2, None),
        ((2, 0), 2, 2, None),
        ((0, 1, 2), 1, 3, np.array([0.2, 1.0, 3.0])),
    ],
    ids=["one column", "a grid", "two joints", "with a prior"],
)
def test_gains_are_those_of_least_squares_over_the_other_blocks(
    joints: tuple[int, ...], variants: int, numbers: int, scale: Floats | None
) -> None:
    fit, rng = posed(2)
    columns = rng.standard_normal((variants, N, len(joints), numbers)) + 0.05 * fit.leave[:, joints, None]
    one = family(columns, joints, scale)
    wide = np.zeros((variants, N, JOINTS, numbers))
    wide[:, :, joints] = one.columns.astype(np.float64) * (1 if scale is None else scale)
    after, before, against = by_loops(fit, wide, 0.0 if scale is None else 1.0)
    (trial,) = trials(fit, [one])
    np.testing.assert_allclose(held_out(fit), before + against[1][:, None] / JOINTS, rtol=1e-6)
    gains = ((before - after).sum(axis=1) - against[0] + against[1]) / 2
    np.testing.assert_allclose(trial.gains, gains, rtol=1e-3, atol=1e-4)
    np.testing.assert_allclose(trial.at, (before - after).sum(axis=0) / 2, rtol=1e-3, atol=1e-4)
    np.testing.assert_allclose(trial.after, after.sum(axis=0), rtol=1e-4)
    assert trial.drop == pytest.approx(1 - np.sqrt((after.sum(axis=0) / before.sum(axis=0)).min()), abs=1e-4)


def test_what_is_noise_foretells_nothing() -> None:
    fit, rng = posed(3)
    noise = family(rng.standard_normal((1, N, 1, 3)), (1,))
    (trial,) = trials(fit, [noise])
    assert trial.gain < 3
    assert trial.drop < 0.05


def test_of_a_law_whose_size_has_a_sign_another_value_is_tried() -> None:
    """The better of two columns would need a size below zero."""
    fit, rng = posed(4)
    shape = rng.standard_normal((N, 1, 1)) + fit.leave[:, :1, None]
    columns = np.stack([-shape, shape + 0.5 * rng.standard_normal(shape.shape)])
    (free,), (size,) = (trials(fit, [family(columns, (0,), sign=sign)]) for sign in (0, 1))
    assert (free.k, size.k) == (0, 1)
    assert free.gain > size.gain > 0
    assert size.is_possible


def test_of_two_numbers_of_a_law_one_may_be_none() -> None:
    """It comes out a little below zero, by less than can be told: it is zero."""
    fit, rng = posed(5)
    shape = rng.standard_normal((1, N, 1, 1)) + fit.leave[None, :, :1, None]
    noise = rng.standard_normal((1, N, 1, 1))
    for sign in (1, -1):  # of one of both the number is below zero
        (trial,) = trials(fit, [family(np.concatenate([shape, sign * noise], axis=3), (0,), sign=1)])
        assert trial.is_possible
        assert trial.x.min() >= 0
    (trial,) = trials(fit, [family(np.concatenate([-shape, noise], axis=3), (0,), sign=1)])
    assert not trial.is_possible
