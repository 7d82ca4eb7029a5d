"""Names by chance: no more than stated where dates mean nothing, and shapes that compete."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from robodyn.fleet.pool.events import program_changes
from robodyn.fleet.pool.names import courses_of, names_of
from robodyn.fleet.pool.numbers import Places
from robodyn.fleet.pool.population import population_of
from robodyn.fleet.pool.programs import chances_of, is_same
from robodyn.fleet.pool.scan import Course, calendar_of, course_of
from robodyn.identify.normal import layout_of

DAY = 86400.0


def fleet(seed: int, units: int = 20, drift: float = 0.0) -> Any:
    """Readings of three features in units of up to three programs, which differ by more than logs do; the
    first unit drifts in the first feature."""
    rng = np.random.default_rng(seed)
    counts = rng.integers(8, 13, units)
    unit = np.repeat(np.arange(units), counts)
    program = np.concatenate([rng.integers(int(rng.integers(1, 4)), size=k) for k in counts])
    dates = np.concatenate([np.sort(rng.uniform(0, 365 * DAY, k)) for k in counts])
    group = 8 * unit + program
    population = []
    for c in range(3):
        value = rng.standard_normal(units)[unit] + 0.1 * rng.standard_normal(8 * units)[group]
        value = value + 0.03 * rng.standard_t(5, len(unit))
        value[unit == 0] += drift * (c == 0) * np.clip((dates[unit == 0] / DAY - 150) / 60, 0, 1)
        nothing = np.zeros((len(unit), 0))
        population.append(population_of(value, np.full(len(unit), 0.01), unit, group, nothing))
    features = [SimpleNamespace(kind="friction", name=f"friction_{c}") for c in range(3)]
    return SimpleNamespace(
        features=features, population=population, units=list(map(str, range(units))), unit=unit, dates=dates,
        group=group, logs_of=lambda u: np.flatnonzero(unit == u),
    )  # fmt: skip


def named(model: Any) -> set[int]:
    return {unit for _, unit in names_of([model], courses_of([model]), 0.05)}


@pytest.mark.thorough
def test_a_drift_is_named_and_chance_is_not() -> None:
    assert named(fleet(2, drift=0.5)) == {0}
    assert sum(bool(named(fleet(seed))) for seed in range(3, 13)) <= 1


def course(value: np.ndarray) -> Course:
    """Of readings of one program, a log every ten days."""
    K = len(value)
    values = np.concatenate([value, 0.1 * np.random.default_rng(1).standard_normal(60)])
    unit = np.repeat(np.arange(7), [K, *[10] * 6])
    one = population_of(values, np.full(K + 60, 0.01), unit, unit, np.zeros((K + 60, 0)))
    calendar = calendar_of(np.arange(K), 10 * DAY * np.arange(K, dtype=np.float64), unit[:K], 1)
    found = course_of(calendar, one, rises=False)
    assert found is not None
    return found


def test_one_odd_log_is_no_change_and_a_step_is() -> None:
    noise = 0.1 * np.random.default_rng(2).standard_normal(12)
    odd, step = noise.copy(), noise.copy()
    odd[5] += 5.0
    step[6:] += 1.0
    assert course(odd).orbit[0] < 2
    assert int(np.argmax(course(odd).odd)) == 5
    stepped = course(step)
    assert stepped.orbit[0] > max(20, stepped.orbit[1:].max())
    share = stepped.share[int(np.argmax(stepped.gains(stepped.share)))]
    size, error = stepped.amount(share)
    assert size == pytest.approx(1.0, abs=4 * error)
    assert stepped.holds(share, size)
    assert not course(noise).holds(share, 1.0)


def test_dates_are_permuted_within_programs_and_logs_alone_in_one_are_left_out() -> None:
    group = np.array([4, 7, 4, 9, 7, 4])
    calendar = calendar_of(np.arange(10, 16), np.arange(6.0), group, 1)
    assert calendar.logs.tolist() == [10, 11, 12, 14, 15]
    assert calendar.orders[0].tolist() == [0, 1, 2, 3, 4]
    assert (calendar.group[calendar.orders] == calendar.group).all()
    assert len(np.unique(calendar.orders, axis=0)) == 12  # of 3! times 2!


def test_numbers_of_a_log_stand_where_its_columns_do() -> None:
    layout, places = layout_of(3, rotors=True, offsets=True), Places(3)
    columns = places.columns(layout)
    for drive in ("viscous", "coulomb", "offset"):
        assert [columns[places.of(drive, j)] for j in range(3)] == layout.joint(drive).tolist()
    assert [columns[places.of("gain", j)] for j in range(3)] == [layout.size + j for j in range(3)]


def path(seed: int, part: float = 1.0) -> np.ndarray:
    """A closed path through joint space [200, 3], or a part of it, with what sensors add."""
    drawn = np.random.default_rng(seed)
    t = np.linspace(0, 2 * np.pi * part, 200)[:, None]
    waves = sum(drawn.uniform(-1, 1, 3) * np.sin((k + 1) * t + drawn.uniform(0, 6, 3)) for k in range(2))
    return np.asarray(waves + 0.01 * np.random.default_rng(0).standard_normal((200, 3)))


def test_programs_are_told_by_their_paths() -> None:
    assert is_same((path(1), 0.12), (path(1), 0.12))
    assert is_same((path(1), 0.12), (path(1, part=0.6), 0.12))
    assert not is_same((path(1), 0.12), (path(2), 0.12))


def changes(programs: list[int], *, named: int = 0, units: int = 1) -> list[int]:
    """In which units, all of which run ``programs``, a change of them is told."""
    K = len(programs)
    model = SimpleNamespace(
        unit=np.repeat(np.arange(units), K), program=np.tile(programs, units), units=list(range(units)),
        dates=np.arange(units * K, dtype=np.float64), logs_of=lambda u: np.arange(K * u, K * (u + 1)),
    )  # fmt: skip
    return [unit for _, unit in program_changes([model], named, 0.05)]  # type: ignore[list-item]


def test_a_change_of_program_is_one_that_does_not_come_back() -> None:
    assert chances_of(np.array([0, 0, 0, 1, 1])).tolist() == pytest.approx([2.2, 0.2, 0.2])
    assert changes([0, 0, 0, 0, 1, 1, 1, 1]) == [0]
    assert changes([0, 1, 0, 0, 1, 0, 1, 1]) == []
    assert changes([0] * 20 + [1]) == []  # one log is none yet
    assert changes([0, 0, 0, 1, 1]) == []  # two programs in turn look so by chance
    assert changes([0, 0, 0, 1, 1], named=5) == [0]  # among so many names one may
    assert changes([0] * 30 + [1] * 10, units=3) == [0, 1, 2]
