"""A log's digest: what it keeps, that it adds up, that it is the same bytes."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from fleet.small_fleet import motion
from robodyn.errors import InputError
from robodyn.fleet.digest import Digest, digest_of
from robodyn.fleet.sources.fleet import ArmType
from robodyn.formats.loading import load as load_robot
from robodyn.formats.loading import text_of
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log

ARM = ArmType("puma560", "puma560", text_of("puma560"))
VISCOUS, COULOMB = 3.0, 5.0


def log(seed: int, seconds: float = 12.0, rate: float = 250.0, noise: float = 0.02) -> Log:
    """What formulas say of the arm with friction at joint 3, along a motion that a seed draws."""
    rng = np.random.default_rng(seed)
    t = np.arange(int(seconds * rate)) / rate
    q, qd, qdd = motion(rng, t, 6, speeds=(0.7, 2.5), sizes=(0.1, 0.4))
    robot = load_robot("puma560")
    joint = replace(robot.links[2].joint, viscous=Fraction(VISCOUS), coulomb=Fraction(COULOMB))
    links = (*robot.links[:2], replace(robot.links[2], joint=joint), *robot.links[3:])
    tau = Model(replace(robot, links=links)).torque(q, qd, qdd)
    return Log(t, q, None, None, tau + noise * rng.standard_normal(tau.shape))


def _rates(one: Log) -> tuple[np.ndarray, np.ndarray]:
    """Velocities and accelerations [K, n] by differences."""
    period = float(one.t[1] - one.t[0])
    qd = np.gradient(one.q, period, axis=0)
    return qd, np.gradient(qd, period, axis=0)


def own_numbers(digest: Digest, joint: int) -> dict[str, float]:
    """Of a joint (from 0) what least squares over its triangle say of its drive."""
    R = digest.roots[joint]
    x = np.linalg.lstsq(R[:, :-1], R[:, -1], rcond=1e-6)[0]
    at = digest.layout.columns(joint)
    return {name: float(x[at == digest.layout.joint(name)[joint]][0]) for name in digest.layout.own}


def test_a_digest_keeps_what_least_squares_need() -> None:
    digest = digest_of(ARM, [log(1)])
    own = own_numbers(digest, 2)
    assert own["viscous"] == pytest.approx(VISCOUS, rel=0.03)
    assert own["coulomb"] == pytest.approx(COULOMB, rel=0.03)
    assert abs(own_numbers(digest, 1)["coulomb"]) < 0.1
    assert np.nanmax(np.abs(digest.bursts)) < 0.4
    assert digest.duration == pytest.approx(12.0, rel=0.01)


def test_triangles_of_pieces_add_up() -> None:
    """Normal equations of two logs are the sum of each, and those of one in pieces too."""
    pieces = log(1), log(2)
    apart = [digest_of(ARM, [one]) for one in pieces]
    both = digest_of(ARM, pieces)
    for j in range(6):
        total = np.sum([one.roots[j].T @ one.roots[j] for one in apart], axis=0)
        assert np.allclose(
            both.roots[j].T @ both.roots[j], total, rtol=1e-9, atol=1e-12 * np.abs(total).max()
        )


def test_a_digest_is_the_same_bytes() -> None:
    data = digest_of(ARM, [log(3)], {"temperature": 31.5, "load": 2.0}).to_bytes()
    assert data == digest_of(ARM, [log(3)], {"load": 2.0, "temperature": 31.5}).to_bytes()
    back = Digest.from_bytes(data)
    assert back.to_bytes() == data
    assert back.conditions == {"temperature": 31.5, "load": 2.0}
    assert len(data) < 40_000


def test_samples_at_rest_say_nothing() -> None:
    """Whatever holds a joint at rest, its numbers stay those of its motion; one that rests has none."""
    moving = log(4, seconds=20.0)
    rest = moving.q[-1:] + 1e-5 * np.random.default_rng(5).standard_normal((2000, 6))
    t = np.arange(len(moving.t) + 2000) / 250
    held = np.repeat(moving.tau[-1:] + 4.0, 2000, axis=0)
    stopped = Log(t, np.vstack([moving.q, rest]), None, None, np.vstack([moving.tau, held]))
    digest = digest_of(ARM, [stopped])
    assert own_numbers(digest, 2)["coulomb"] == pytest.approx(COULOMB, rel=0.05)
    assert (digest.rows <= digest_of(ARM, [moving]).rows * 1.1).all()
    still = moving.q.copy()
    still[:, 5] = 0.3 + 1e-5 * np.random.default_rng(6).standard_normal(len(still))
    assert digest_of(ARM, [Log(moving.t, still, None, None, moving.tau)]).rows[5] == 0


def test_what_comes_where_the_load_changes_sign_is_told_from_the_rest() -> None:
    quiet = log(6, seconds=20.0)
    load = Model(load_robot("puma560")).torque(quiet.q, *_rates(quiet))[:, 4]
    struck = np.flatnonzero(np.diff(np.signbit(load)))
    tau = quiet.tau.copy()
    for k in struck.tolist():  # one way and the other: no offset explains them
        tau[k : k + 8, 4] += 0.3
        tau[k + 8 : k + 16, 4] -= 0.3
    digest = digest_of(ARM, [Log(quiet.t, quiet.q, None, None, tau)])
    assert digest.bursts[4] > 0.5
    assert np.nanmax(np.abs(np.delete(digest.bursts, 4))) < 0.4


def test_logs_without_motion_are_refused() -> None:
    short = log(5, seconds=0.4)
    with pytest.raises(InputError):
        digest_of(ARM, [short])
