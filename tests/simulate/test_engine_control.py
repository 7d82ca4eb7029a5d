"""What drives the motors: tables, PD, computed torque; limits; Ctrl-C."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.errors import InputError
from robodyn.simulate.control import Control
from robodyn.simulate.engine import Record
from simulate.systems import BLOCK, PENDULUM, engine

Floats = NDArray[np.float64]
FREE = [0.0, 0, 0, 0, 1, 0, 0]
"""The block without spring and friction: y'' = torque."""


def slide(control: Control, duration: float = 1.0, **options: Any) -> Record:
    made = engine(BLOCK).run(
        [0.0],
        [1.0],
        duration=duration,
        parameters=FREE,
        control=control,
        **{"sample_period": 0.05, **options},
    )
    assert made.status == "done"
    return made


@pytest.mark.parametrize("method", ["rk4", "adaptive"])
def test_a_linear_table_bends_there_and_its_last_row_stays(method: str) -> None:
    table = [[0.0], [3.0], [-1.0]]
    made = slide(Control.linear(table, 0.3, limit=[2.0]), method=method, step=0.01)
    torque = np.interp(made.t, [0, 0.3, 0.6], [0, 3, -1])
    np.testing.assert_allclose(made.command[:, 0], torque, atol=1e-14)
    np.testing.assert_array_equal(made.applied, np.clip(made.command, -2, 2))
    free = slide(Control.linear(table, 0.3), method=method, step=0.05)
    first = free.t <= 0.3
    np.testing.assert_allclose(free.v[first, 0], 1 + 5 * free.t[first] ** 2, atol=1e-14)
    np.testing.assert_allclose(free.v[-1, 0], 1 + 0.45 + 0.3 - 0.4, atol=1e-13)


def test_motors_drive_and_see_the_coordinates_they_are_at() -> None:
    control = Control.pd([[0.0]], [[0.0]], 0.01, [3.0], [0.5], place=[1], seen=[0])
    made = engine(PENDULUM).run(
        [0.2, -0.4], [0.1, 0.7], duration=0.0, sample_period=1.0, parameters=[0.0, 0.0], control=control
    )
    command = -3.0 * 0.2 - 0.5 * 0.1
    assert made.command[0, 0] == pytest.approx(command, abs=1e-15)
    c, s = np.cos(0.6), np.sin(0.6)
    M = np.array([[2, c], [c, 1]])
    expected = np.linalg.solve(M, [-s * 0.7**2, s * 0.1**2 + command])
    np.testing.assert_allclose(made.a[0], expected, atol=1e-14)


def test_ctrl_c_keeps_what_there_is() -> None:
    def progress(t: float) -> None:
        if t > 0.45:
            raise KeyboardInterrupt

    made = engine(BLOCK).run(
        [0.0], [1.0], duration=1.0, sample_period=0.005, parameters=FREE, progress=progress
    )
    assert made.status == "interrupted"
    assert 91 <= len(made.t) < 201
    assert made.t[-1] <= made.time < 1.0
    np.testing.assert_allclose(made.v[:20, 0], 1.0, atol=1e-12)


def test_controls_are_checked() -> None:
    cases: list[tuple[Callable[[], Control], str]] = [
        (lambda: Control.held([1.0], 0.1), r"table torque has the wrong shape; found \[1\]"),
        (lambda: Control.held([[np.nan]], 0.1), "not finite; found row 0"),
        (lambda: Control.held([[1.0]], 0.0), "not a time"),
        (lambda: Control.held([[1.0]], 0.1, limit=[1, 2]), "limit does not fit"),
        (lambda: Control.held([[1.0]], 0.1, place=[0, 1]), "place does not fit"),
        (lambda: Control.pd([[1.0]], [[1.0], [2.0]], 0.1, 1, 1), "table qd has the wrong shape"),
        (lambda: Control.pd([[1.0]], [[1.0]], 0.1, [1, 2], 1), "kp does not fit"),
    ]
    for make, message in cases:
        with pytest.raises(InputError, match=message):
            make()
