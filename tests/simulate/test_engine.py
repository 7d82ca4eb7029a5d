"""Smooth motion: the order of the methods, their accuracy, energy; and how a run is carried out."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.errors import InputError, ToolError
from robodyn.simulate import engine as engines
from robodyn.simulate.control import Control
from robodyn.simulate.engine import Record, build_engine
from robodyn_testing import require_module, require_tool
from simulate.systems import BLOCK, BRISTLE, LIFT, PENDULUM, STRICT, engine

GRAVITY = 9.81
START = [1.0, 0.5]


def slopes(t: float, x: NDArray[np.float64], viscous: float) -> NDArray[np.float64]:
    """Of the double pendulum, written apart from the C."""
    (p, q), v = x[:2], x[2:]
    M = np.array([[2.0, math.cos(p - q)], [math.cos(p - q), 1.0]])
    turning = math.sin(p - q) * np.array([v[1] ** 2, -(v[0] ** 2)])
    rest = -turning - GRAVITY * np.array([2 * math.sin(p), math.sin(q)]) - viscous * v
    return np.concatenate([v, np.linalg.solve(M, rest)])


def reference(duration: float, viscous: float = 0.0, start: list[float] = START) -> NDArray[np.float64]:
    integrate = require_module("scipy.integrate")
    solved = integrate.solve_ivp(
        slopes, (0, duration), [*start, 0, 0], method="DOP853", rtol=1e-13, atol=1e-14, args=(viscous,)
    )
    end: NDArray[np.float64] = solved.y[:, -1]
    return end


def swing(duration: float, viscous: float = 0.0, start: list[float] = START, **options: Any) -> Record:
    made = engine(PENDULUM).run(
        start,
        [0, 0],
        duration=duration,
        parameters=[GRAVITY, viscous],
        **{"sample_period": duration, **options},
    )
    assert made.status == "done"
    return made


def off(made: Record, truth: NDArray[np.float64]) -> float:
    return float(np.abs(np.concatenate([made.y[-1], made.v[-1]]) - truth).max())


def test_fixed_steps_are_of_fourth_order() -> None:
    truth = reference(2.0)
    steps = [0.01, 0.005, 0.0025]
    errors = [off(swing(2.0, step=step), truth) for step in steps]
    order = np.polyfit(np.log(steps), np.log(errors), 1)[0]
    assert 3.9 < order < 4.1
    assert errors[-1] < 1e-8


def test_the_tolerance_is_what_the_adaptive_error_follows() -> None:
    truth = reference(2.0, viscous=0.3)
    errors = [
        off(swing(2.0, 0.3, method="adaptive", step=1.0, rtol=tolerance, atol=tolerance), truth)
        for tolerance in (1e-6, 1e-8, 1e-10, 1e-12)
    ]
    for tolerance, error in zip((1e-6, 1e-8, 1e-10, 1e-12), errors, strict=True):
        assert error < 30 * tolerance
    assert errors[0] > 1e3 * errors[2] > 0


def test_samples_inside_adaptive_steps_are_as_good_as_their_ends() -> None:
    made = swing(1.0, method="adaptive", sample_period=0.01, step=1.0, rtol=1e-9, atol=1e-9)
    assert made.counters["steps"] < 95
    for k in (13, 50, 77):
        truth = reference(made.t[k])
        assert np.abs(np.concatenate([made.y[k], made.v[k]]) - truth).max() < 1e-7
        exact = slopes(0.0, np.concatenate([made.y[k], made.v[k]]), 0.0)[2:]
        np.testing.assert_allclose(made.a[k], exact, rtol=1e-12)


Method = Literal["rk4", "adaptive"]


def test_fast_internal_states_are_stepped_as_fast_as_they_need() -> None:
    integrate = require_module("scipy.integrate")
    stiffness, level = 1e4, 1.0
    bristles = integrate.solve_ivp(
        lambda t, x: [x[1], -4 * x[0] - x[2], stiffness * (x[1] - abs(x[1]) * x[2] / level)],
        (0, 1), [2.0, 0.0, 0.0], method="Radau", rtol=1e-10, atol=1e-12,
    )  # fmt: skip
    for options in ({"step": 2e-3}, {"method": "adaptive", "rtol": 1e-9, "atol": 1e-11}):
        made = engine(BRISTLE).run(
            [2.0], [0.0], [0.0], duration=1.0, sample_period=0.1, parameters=[stiffness, level], **options
        )
        found = [made.y[-1, 0], made.v[-1, 0], made.z[-1, 0]]
        np.testing.assert_allclose(found, bristles.y[:, -1], atol=1e-6)


@pytest.mark.parametrize("method", ["rk4", "adaptive"])
def test_a_run_in_parts_is_the_run(method: Method, monkeypatch: pytest.MonkeyPatch) -> None:
    def run() -> tuple[Record, list[float]]:
        times: list[float] = []
        made = engine(BLOCK).run(
            [0.0], [0.0], duration=5.0, sample_period=0.0123, method=method, step=0.01,
            parameters=[0.2, 10, 1.5, 0.8, 0.1, 0, 1.0], breaks=[1.0],
            control=Control.held([[0.1], [-0.2]], 0.7), progress=times.append,
        )  # fmt: skip
        assert made.counters["events"] > 0
        assert np.count_nonzero(np.diff(made.s[:, 0])) == 3
        return made, times

    whole, few = run()
    monkeypatch.setattr(engines, "_CHUNK", 0.0)
    parts, many = run()
    assert len(many) > len(few)
    assert many == sorted(many)
    for name in ("t", "y", "v", "a", "s", "command", "work", "loss"):
        assert getattr(whole, name).tobytes() == getattr(parts, name).tobytes(), name


@pytest.mark.parametrize("method", ["rk4", "adaptive"])
def test_what_is_not_finite_ends_the_run(method: Method) -> None:
    made = engine(PENDULUM).run(
        [0, 0], [0, 0], duration=10, sample_period=0.01, method=method, parameters=[0.0, 0.0],
        control=Control.held([[0.0, 0.0], [1e200, 0.0]], 0.5),
    )  # fmt: skip
    assert made.status == "not finite"
    assert 0.5 <= made.time < 0.52
    assert 51 <= len(made.t) < 53
    assert np.isfinite(made.y).all()


def test_steps_are_counted_and_bounded() -> None:
    made = swing(1.0, step=0.01)
    assert made.counters["steps"] == 100
    assert made.counters["evaluations"] == 401
    stopped = engine(PENDULUM).run(
        START, [0, 0], duration=1, sample_period=0.1, step=0.01, parameters=[GRAVITY, 0], max_steps=35
    )
    assert stopped.status == "too many steps"
    assert len(stopped.t) == 4
    assert stopped.time == pytest.approx(0.35)


def test_no_acceleration() -> None:
    made = engine(LIFT).run([0, 0], [0, 1.0], duration=1, sample_period=0.1, parameters=[0.3, 1e-320, 0.0])
    assert made.status == "no acceleration"
    assert len(made.t) == 0


def test_input_is_checked() -> None:
    pendulum = engine(PENDULUM)
    good: dict[str, Any] = {"duration": 1.0, "sample_period": 0.1, "parameters": [1.0, 0.0]}
    cases: list[tuple[list[float], dict[str, Any], str]] = [
        ([0.0], {}, "y has the wrong length; found 1; expected 2"),
        ([0.0, math.nan], {}, "y has a number that is not finite"),
        ([0, 0], {"parameters": []}, "parameters has the wrong length; found 0; expected 2"),
        ([0, 0], {"sample_period": 0.0}, "sample_period is not a time"),
        ([0, 0], {"step": -1.0}, "step is not a time"),
        ([0, 0], {"duration": math.inf}, "duration is not a time"),
        ([0, 0], {"method": "euler"}, "no such method; found 'euler'; expected rk4 or adaptive"),
        ([0, 0], {"control": Control.held(np.zeros((1, 3)), 1.0)}, "motors that the system does not"),
    ]
    for y, options, message in cases:
        with pytest.raises(InputError, match=message):
            pendulum.run(y, [0, 0], **{**good, **options})
    control = Control.computed([[0.0]], [[0.0]], [[0.0]], 1.0, 1.0, 1.0)
    with pytest.raises(InputError, match="without a model"):
        engine(BLOCK).run([0], [0], duration=1, sample_period=1, parameters=[0] * 7, control=control)


def test_a_glue_that_is_no_c_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ToolError, match="engine"):
        build_engine("#error nothing", cache=tmp_path)


@pytest.mark.parametrize("name", ["gcc", pytest.param("clang", marks=pytest.mark.thorough)])
def test_compilers_have_nothing_to_say(name: str) -> None:
    require_tool(name)
    for glue in (BLOCK, LIFT):
        assert build_engine(glue, cc=name, flags=STRICT).n > 0
