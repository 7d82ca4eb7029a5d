"""The data gate: each fault of a log is found at its place, and sound logs of any arm pass."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from gate.gated import GIVEN, WRONG, at, flag_of, put, rows_of, swapped
from robodyn.errors import InputError
from robodyn.gate.gate import inspect
from robodyn.logs.log import Log

Floats = NDArray[np.float64]
Rng = np.random.Generator


def times(log: Log, factor: Any, *groups: str) -> Log:
    return replace(log, **{g: getattr(log, g) * factor for g in groups if getattr(log, g) is not None})


def test_a_sound_log_passes_as_it_is(log: Log) -> None:
    gate = inspect(log, GIVEN)
    assert not {flag.kind for flag in gate.flags} & WRONG
    assert gate.log.q is log.q
    assert gate.log.tau is log.tau
    assert gate.segments == (slice(0, log.samples),)
    assert gate.period == pytest.approx(1e-3, rel=1e-9)
    np.testing.assert_array_equal(gate.rows, np.arange(log.samples))


def test_what_there_is_of_each_joint(log: Log) -> None:
    for one in inspect(log, GIVEN).joints:
        assert one.moves
        assert one.torque_step == 0
        assert one.torque_noise == pytest.approx(0.3, rel=0.05)
        assert one.limit == np.inf
    steps = inspect(replace(log, tau=np.round(log.tau, 1)), GIVEN).joints
    assert [one.torque_step for one in steps] == pytest.approx([0.1, 0.1, 0.1])


@pytest.mark.parametrize(
    ("kind", "spoil"),
    [
        ("garbage", lambda log: put(log, "q", (500, 1), np.nan)),
        ("garbage", lambda log: put(log, "tau", (500, 2), -np.inf)),
        ("garbage", lambda log: put(log, "q", 500, 1e-300 + 1e20)),
        ("garbage", lambda log: put(log, "t", 500, 2.7e154)),
        ("stray_time", lambda log: put(log, "t", 500, 9e3)),
        ("stray_time", lambda log: put(log, "t", 500, 0.1)),
        ("spike", lambda log: put(log, "q", (500, 0), 1.5)),
        ("spike", lambda log: put(log, "tau", (500, 1), 900.0)),
        ("spike", lambda log: put(put(log, "tau", (500, 1), 900.0), "q", (500, 1), 9.0)),
    ],
)
def test_a_broken_row_is_left_out_and_filled_in(log: Log, kind: str, spoil: Callable[[Log], Log]) -> None:
    gate = inspect(spoil(log), GIVEN)
    for flag in gate.flags_of(kind):
        assert [(span.first, span.last) for span in flag.spans] == [(501, 501)]
    assert gate.flags_of(kind)
    assert flag_of(gate, "missing").spans[0].first == 500
    assert gate.log.samples == log.samples
    np.testing.assert_allclose(gate.log.q[500], log.q[500], atol=2e-4)
    np.testing.assert_allclose(np.delete(gate.log.q, 500, 0), np.delete(log.q, 500, 0), atol=1e-9)


def test_the_joint_of_a_broken_number_is_named(log: Log) -> None:
    flag = flag_of(inspect(put(log, "tau", (500, 2), np.nan), GIVEN), "garbage")
    assert (flag.where, flag.joints) == ("tau3", (3,))
    assert "row 501 (t = 0.5 s)" in str(flag)


def test_rows_that_stand_twice(log: Log) -> None:
    twice = at(log, np.sort(np.r_[0 : log.samples, 70, 300:310]))
    gate = inspect(twice, GIVEN)
    assert rows_of(gate, "duplicated")[0] == (72, 72)
    np.testing.assert_array_equal(gate.log.tau, log.tau)


def test_a_gap_cuts_the_log(log: Log) -> None:
    gate = inspect(at(log, np.r_[0:3000, 3500 : log.samples]), GIVEN)
    assert rows_of(gate, "gap") == [(3000, 3001)]
    assert flag_of(gate, "gap").spans[0].end == pytest.approx(3.5)
    assert gate.segments == (slice(0, 3000), slice(3000, log.samples - 500))
    np.testing.assert_array_equal(gate.log.q[gate.segments[1]], log.q[3500:])


def test_a_jump_of_the_position_cuts_the_log(log: Log) -> None:
    gate = inspect(put(log, "q", np.s_[3000:, 1], log.q[3000:, 1] + 0.5), GIVEN)
    assert rows_of(gate, "jump") == [(3001, 3001)]
    assert [part.start for part in gate.segments] == [0, 3000]


def test_uneven_times_are_resampled(log: Log) -> None:
    rng = np.random.default_rng(2)
    t = log.t + rng.uniform(-2e-4, 2e-4, log.samples)
    course = np.stack([np.interp(t, log.t, log.q[:, j]) for j in range(3)], axis=1)
    gate = inspect(replace(log, t=t, q=course), GIVEN)
    assert gate.flags_of("jitter")
    np.testing.assert_allclose(np.diff(gate.log.t), gate.period, rtol=1e-6)
    within = np.stack([np.interp(gate.log.t, log.t, log.q[:, j]) for j in range(3)], axis=1)
    np.testing.assert_allclose(gate.log.q[2:-2], within[2:-2], atol=1e-4)


def test_times_with_few_digits_are_even(log: Log) -> None:
    thin = at(log, np.arange(0, log.samples, 4))
    gate = inspect(replace(thin, t=np.round(thin.t, 3)), GIVEN)
    assert not gate.flags_of("jitter")
    assert gate.log.q is thin.q


def test_a_slower_source_is_seen(log: Log) -> None:
    held = np.arange(log.samples) // 8 * 8
    gate = inspect(replace(log, q=log.q[held], qd=None, tau=log.tau[held]), GIVEN)
    assert gate.flags_of("held")
    assert gate.period == pytest.approx(8e-3)
    np.testing.assert_array_equal(gate.log.q, log.q[::8])


REFUSED: dict[str, tuple[Callable[[Log], Log], str]] = {
    "10 samples": (lambda log: at(log, slice(10)), "10 rows"),
    "numbers missing": (lambda log: put(log, "q", np.s_[500:1500, 1], np.nan), "q2.*row 501"),
    "no torque": (lambda log: put(log, "tau", np.s_[:, 2], np.nan), "tau3"),
    "counts": (lambda log: times(log, 20000.0, "q"), "q1 cannot be used"),
    "backwards": (lambda log: at(log, slice(None, None, -1)), "time runs backwards.*row 2"),
    "two runs": (lambda log: at(log, np.r_[0:5000, 0:5000]), "time runs backwards.*row 5001"),
    "shuffled": (lambda log: at(log, np.random.default_rng(0).permutation(log.samples)), "backwards"),
    "few digits": (lambda log: replace(log, t=np.round(log.t, 2)), "times repeat.*more digits"),
    "milliseconds": (lambda log: replace(log, t=1e3 * log.t), "t in seconds"),
    "other robot": (lambda log: replace(log, q=log.q[:, :2], qd=None, tau=log.tau[:, :2]), "2 joints"),
    "degrees": (lambda log: times(log, 180 / np.pi, "q", "qd"), "q1, q2, q3: degrees for radians.*pi/180"),
    "degrees in q": (lambda log: times(log, 180 / np.pi, "q"), "degrees for radians in the position"),
    "degrees in qd": (lambda log: times(log, 180 / np.pi, "qd"), "degrees for radians in the rate"),
    "sign of qd2": (lambda log: times(log, [1.0, -1.0, 1.0], "qd"), "qd2 does not fit q2: its sign"),
    "sign of tau2": (lambda log: times(log, [1.0, -1.0, 1.0], "tau"), "tau2: the sign"),
    "sign of tau": (lambda log: times(log, -1.0, "tau"), "tau1, tau2, tau3: the sign"),
    "sign of q2": (lambda log: times(log, [1.0, -1.0, 1.0], "q", "qd"), "q2: the sign"),
    "order of qd": (lambda log: swapped(log, 0, 2, "qd"), "joints 1 and 3 are swapped"),
    "order of tau": (lambda log: swapped(log, 1, 2, "tau"), "tau2, tau3: swapped"),
    "sign of all q": (lambda log: times(log, -1.0, "q", "qd"), "q1, q2, q3: the sign of all positions"),
    "joint 3 turned": (lambda log: times(log, [1.0, 1.0, -1.0], "q", "qd", "tau"), "q3, tau3: the joint"),
    "order of q": (lambda log: swapped(log, 0, 2, "q", "qd"), "q1, q3: swapped"),
    "joints 1 and 2": (lambda log: swapped(log, 0, 1, "q", "qd", "tau"), "joints 1 and 2: swapped"),
    "joints 1 and 3": (lambda log: swapped(log, 0, 2, "q", "qd", "tau"), "joints 1 and 3: swapped"),
    "amperes": (lambda log: times(log, 1 / 30, "tau"), "tau1, tau2, tau3: another unit.*torque constant"),
    "N mm": (lambda log: times(log, 1e3, "tau"), "another unit.*divide by 1000"),
    "kN m": (lambda log: times(log, 1e-3, "tau"), "another unit.*multiply by 1000"),
    "order of joints": (lambda log: swapped(log, 1, 2, "q", "qd", "tau"), "joints 2 and 3: swapped"),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_a_log_that_misleads_is_refused(log: Log, name: str) -> None:
    spoil, says = REFUSED[name]
    with pytest.raises(InputError, match=says) as caught:
        inspect(spoil(log), GIVEN, source="log.csv")
    assert str(caught.value).startswith("log.csv: ")
    assert caught.value.remedy


def test_a_flipped_sign_under_much_friction(log: Log) -> None:
    friction = 40 * np.tanh(log.qd[:, 2] / 0.05)  # type: ignore[index]
    rubbed = put(log, "tau", np.s_[:, 2], log.tau[:, 2] + friction)
    assert not {flag.kind for flag in inspect(rubbed, GIVEN).flags} & WRONG
    with pytest.raises(InputError, match="tau3: the sign"):
        inspect(times(rubbed, [1.0, 1.0, -1.0], "tau"), GIVEN)
