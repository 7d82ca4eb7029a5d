"""Arms that rest, short pieces, and how a log was sampled."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gate.gated import GIVEN, WRONG, at, flag_of, put, rows_of
from robodyn.errors import InputError
from robodyn.gate.gate import inspect
from robodyn.logs.log import Log
from robodyn.verify.reference import Reference


def held(log: Log, row: int = 2000) -> Log:
    """The arm of ``log`` at rest, with the noise of sensors and a hand that pushes twice, over the gravity of
    another payload."""
    rng = np.random.default_rng(3)
    q = np.repeat(log.q[row][None], 4000, axis=0)
    hand = np.zeros((4000, 3))
    hand[1000:1600] = 40.0, -25.0, 12.0
    hand[2500:2900] = -15.0, 30.0, -9.0
    # Whoever pushes takes some time.
    soft = np.hanning(121) / np.hanning(121).sum()
    hand = np.stack([np.convolve(x, soft, mode="same") for x in hand.T], axis=1)
    q = q + 1e-4 * hand + 1e-5 * rng.standard_normal(q.shape)
    weight = Reference(GIVEN).inverse_dynamics(q, 0 * q, 0 * q)
    tau = 0.7 * weight - hand + 0.3 * rng.standard_normal(q.shape)
    return Log(np.asarray(1e-3 * np.arange(4000), np.float64), q, None, None, tau)


def test_an_arm_that_is_pushed_at_rest_passes(log: Log) -> None:
    gate = inspect(held(log), GIVEN)
    assert not {flag.kind for flag in gate.flags} & WRONG
    assert gate.resting.mean() > 0.7
    assert gate.stands
    assert not inspect(log, GIVEN).stands


def test_an_arm_that_only_stands_is_said_to(log: Log) -> None:
    still = replace(held(log), q=np.repeat(log.q[2000][None], 4000, axis=0))
    gate = inspect(still, GIVEN)
    assert gate.resting.all()
    assert gate.flags_of("at_rest")
    assert rows_of(gate, "constant") == [(1, 4000)]
    assert all(not one.moves for one in gate.joints)


def test_joints_rest_where_they_stand_and_not_where_they_turn_round(log: Log) -> None:
    gate = inspect(log, GIVEN)
    assert gate.resting.mean() < 0.02
    q = log.q.copy()
    q[3000:4000] = q[3000]
    q[4000:] += q[3000] - log.q[4000]
    q[:, 2] = q[0, 2]
    q += 2e-6 * np.random.default_rng(0).standard_normal(q.shape)
    gate = inspect(replace(log, q=q, qd=None), GIVEN)
    assert gate.resting[:, 2].all()
    assert gate.resting[3050:3950].all()
    assert gate.resting[4200:, :2].mean() < 0.05  # a standstill between two periods


@pytest.mark.parametrize(("rows", "stride"), [(700, 1), (50, 33), (21, 33)])
def test_a_log_in_short_pieces_passes(log: Log, rows: int, stride: int) -> None:
    """As when blocks of it are held out: ten pieces of 0.7 s, or of as many samples at 30 Hz."""
    thin = at(log, np.arange(0, log.samples, stride))
    starts = np.linspace(0, thin.samples - rows, max(5, min(10, thin.samples // (2 * rows)))).astype(int)
    pieces = np.concatenate([np.arange(start, start + rows) for start in starts])
    gate = inspect(at(thin, pieces), GIVEN)
    assert len(gate.segments) == len(starts)
    assert not {flag.kind for flag in gate.flags} & (WRONG - {"gap"})


def test_rows_that_were_sent_twice_are_left_out_and_the_others_spread(log: Log) -> None:
    """A source at 31 Hz, of which a publisher takes the latest row at 32 Hz."""
    source = at(log, np.arange(0, log.samples, 32))
    step = 0.97 * 32e-3
    rows = np.minimum((np.arange(int(source.samples / 0.97)) * 0.97).astype(int), source.samples - 1)
    sent = replace(at(source, rows), t=np.asarray(step * np.arange(len(rows)), np.float64))
    gate = inspect(sent, GIVEN)
    flag = flag_of(gate, "repeated_rows")
    repeated = np.flatnonzero(np.diff(rows) == 0) + 2
    # All but those from before the arm has set out, and where it stands.
    seen = [s.first for s in flag.spans]
    assert set(seen) <= set(repeated.tolist())
    assert len(seen) >= len(repeated) - 3
    assert gate.period == pytest.approx(32e-3, rel=5e-3)
    # Rows that are alike because nothing moves are none of these.
    assert not inspect(
        replace(held(log), q=held(log).q.round(2), tau=held(log).tau.round(0)), GIVEN
    ).flags_of("repeated_rows")


def test_rows_that_repeat_at_random_are_only_left_out(log: Log) -> None:
    rows = np.arange(log.samples)
    rows[[510, 530, 900, 4100]] -= 1
    moving = np.abs(np.gradient(log.q, axis=0)).max(axis=1)
    gate = inspect(replace(at(log, rows), t=log.t), GIVEN)
    seen = [s.first - 1 for s in flag_of(gate, "repeated_rows").spans]
    assert set(seen) <= {510, 530, 900, 4100}
    assert len(seen) >= 3, moving[[510, 530, 900, 4100]] / np.quantile(moving, 0.9)
    assert gate.log.samples == log.samples
    np.testing.assert_allclose(gate.log.t, log.t, atol=1e-9)


def test_an_angle_that_begins_anew_goes_on(log: Log) -> None:
    q = log.q.copy()
    q[:, 0] = (q[:, 0] - q[:, 0].mean() + 2 * np.pi) % (2 * np.pi)
    gate = inspect(replace(log, q=q, qd=None), GIVEN)
    assert flag_of(gate, "wrapped").joints == (1,)
    assert not gate.flags_of("jump")
    assert len(gate.segments) == 1
    turned = gate.log.q[:, 0] - log.q[:, 0]
    assert np.ptp(turned) < 1e-9


def test_noise_that_was_smoothed_away_is_not_believed(log: Log) -> None:
    from scipy.signal import butter, sosfiltfilt

    sections = butter(4, 60, fs=1000, output="sos")
    smooth = replace(
        log,
        tau=sosfiltfilt(
            sections, log.tau + 0.2 * np.random.default_rng(1).standard_normal(log.tau.shape), axis=0
        ),
    )
    gate = inspect(smooth, GIVEN)
    assert flag_of(gate, "smoothed").joints == (1, 2, 3)
    assert (gate.torque_noise > 3e-3 * log.tau.std(axis=0)).all()
    assert not inspect(log, GIVEN).flags_of("smoothed")


def test_velocities_that_are_late_by_a_sample(log: Log) -> None:
    slow = at(log, np.arange(0, log.samples, 4))
    rates = np.gradient(slow.q, slow.t, axis=0)
    late = np.vstack([rates[:1], rates[:-1]])
    gate = inspect(replace(slow, qd=late), GIVEN)
    assert flag_of(gate, "velocity_lag").joints == (1, 2, 3)
    assert not inspect(replace(slow, qd=rates), GIVEN).flags_of("velocity_lag")


def test_a_clock_that_changes_has_lost_no_rows(log: Log) -> None:
    steps = np.where(np.arange(log.samples) % 2000 < 600, 8, 5)
    places = np.cumsum(steps)
    places = places[places < log.samples]
    gate = inspect(at(log, places), GIVEN)
    assert not gate.flags_of("missing")
    np.testing.assert_allclose(np.diff(gate.log.t), gate.period, rtol=1e-6)


def test_pieces_that_show_nothing_are_refused(log: Log) -> None:
    pieces = np.concatenate([np.arange(start, start + 15) for start in range(0, 4000, 200)])
    with pytest.raises(InputError, match="too little of the log can be used"):
        inspect(at(log, pieces), GIVEN)


def test_a_dead_torque_is_refused_still(log: Log) -> None:
    with pytest.raises(InputError, match="tau2: the same throughout"):
        inspect(put(log, "tau", np.s_[:, 1], 3.0), GIVEN)
