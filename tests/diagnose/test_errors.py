"""How sure numbers are: as a sandwich in plain loops has it, and as fresh noise shows."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from diagnose.synthetic import fit_of, rows_of_numbers
from robodyn.diagnose.select.errors import covariance, sureness
from robodyn.diagnose.select.families import Family
from robodyn.diagnose.select.library.candidate import Candidate
from robodyn.diagnose.select.limits import PART_CORRELATION
from robodyn.diagnose.select.members import Fit, Member

Floats = NDArray[np.float64]
N = 2000


def posed(seed: int, alike: int, columns: int = 3) -> tuple[Fit, Floats]:
    """A fit of one held and some free numbers, that are 1, to rows with noise of which so many neighbours are
    ``alike``, slower than which nothing moves; and the true numbers."""
    shape = np.random.default_rng(0)
    moves = shape.standard_normal((N + 8 * alike - 1, columns))
    A = np.stack([np.convolve(x, np.ones(8 * alike) / 4, mode="valid") for x in moves.T], axis=1)[:, None]
    rng = np.random.default_rng(seed)
    white = rng.standard_normal(N + alike - 1)
    noise = 0.5 * np.convolve(white, np.ones(alike) / np.sqrt(alike), mode="valid")
    truth = np.array([0.3 * rng.standard_normal(), *np.ones(columns - 1)])
    rows = rows_of_numbers(N, np.array([0.5]), np.zeros((N, 1)), float(alike))
    own, slopes = A[:, :, :1], A[:, :, 1:]
    return fit_of(rows, A @ truth + noise[:, None], own, slopes), truth


@pytest.mark.parametrize("alike", [1, 5])
def test_the_covariance_is_a_sandwich_over_parts(alike: int) -> None:
    fit, _ = posed(1, alike)
    weight = 1 / (alike * 0.5**2)
    A = fit.columns[:, 0]
    left = fit.leave[:, 0] - A @ fit.x
    outside = np.linalg.inv(weight * A.T @ A + np.diag(fit.held))
    length = int(PART_CORRELATION * alike)
    middle, parts = np.diag(fit.held), N // length
    for k in range(parts):
        part = slice(k * length, (k + 1) * length)
        pull = weight * A[part].T @ left[part]
        middle = middle + np.outer(pull, pull) * parts / (parts - 1)
    spread = outside @ middle @ outside
    errors = np.sqrt(np.maximum(np.diag(spread), np.diag(outside)))
    np.testing.assert_allclose(np.sqrt(np.diag(covariance(fit))), errors, rtol=1e-6)


@pytest.mark.parametrize("alike", [1, 5])
def test_intervals_hold_the_truth_as_often_as_they_say(alike: int) -> None:
    held = []
    for seed in range(200):
        fit, truth = posed(seed, alike)
        errors = np.sqrt(np.diag(covariance(fit)))
        held.append(np.abs(fit.x - truth)[1:] < 1.96 * errors[1:])
    assert 0.92 <= np.mean(held) <= 0.99


def bearing(mu: float, span: float) -> Member:
    """Friction of a linear bearing as a member that is in."""
    one = Candidate("load_dependent_friction", 3, (2,), np.zeros((0, 1, 1)), (1,), lambda x: {}, 2)
    family = Family((one,), np.zeros((1, 0, 1, 1), dtype=np.float32))
    parameters: dict[str, float | str] = {"bearing": "linear", "mu": mu, "span": span}
    return Member(family.key, family, 0, parameters)


@pytest.mark.parametrize("force", [0.0, 1e-4, 3.0], ids=["moments alone", "hardly a force", "both"])
def test_a_ratio_is_known_where_its_numbers_are_not(force: float) -> None:
    """A linear bearing rubs by mu times its force, and by mu / span times its moment."""
    rng, mu, span = np.random.default_rng(4), 0.01, 0.2
    push, twist = force * rng.standard_normal((N, 1)), 5 * rng.standard_normal((N, 1))
    rows = rows_of_numbers(N, np.array([0.05]), np.zeros((N, 1)))
    slopes = np.stack([push + twist / span, -mu * twist / span**2], axis=2)
    y = 0.05 * rng.standard_normal((N, 1))
    fit = fit_of(rows, y, np.zeros((N, 1, 0)), slopes, (bearing(mu, span),))
    (sure,) = sureness(fit)
    if force > 1:
        assert sure.errors["mu"] < 0.1 * mu
        assert sure.errors["span"] < 0.1 * span
        assert not sure.together
        return
    assert sure.errors["mu"] > mu
    assert sure.errors["span"] > span
    assert sure.bounds["mu"] == (None, None)
    value, error = sure.together["mu / span"]
    assert value == pytest.approx(mu / span)
    # By hand: the slope of what is measured over the moment.
    assert error == pytest.approx(0.05 / np.sqrt(np.sum(twist**2)), rel=0.2)
