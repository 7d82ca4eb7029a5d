"""What a sample that cannot be does to effects that remember: its own torque is lost, and nothing else."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.effects.scalars import is_duration, is_finite, is_positive, updated_if
from robodyn.ir import Input
from robodyn.ir.evaluate import evaluate
from robodyn.kernels.generate import maker
from robodyn.kernels.kernel import Kernel
from robodyn.kernels.options import Options
from robodyn.kernels.robot_kernel import compile as compile_kernel
from robodyn.robot import Robot, read_text
from robodyn.verify.stateful import Stepping
from robodyn_testing import representative, require_tool
from robodyn_testing.effect_arms import arm

Floats = NDArray[Any]

DT = 1 / 1024
VALUES = {"k_b": 2500.0}
NAN, INF = float("nan"), float("inf")
#: Which states of the arm are whose: two bristles, and three of an elastic joint and of one with play.
BRISTLES = {"z1": 2 / 3000, "z3": 1 / 2500}
BAD = [
    *(((name,), value) for name in ("q", "qd", "qdd") for value in (NAN, INF, -INF)),
    *((("dt",), value) for value in (NAN, INF, -INF, -1.0, -DT, -2.0, -1e-30)),
    (("q", "qd", "qdd", "dt"), NAN),
    (("qd", "dt"), INF),
]


@cache
def kernel(language: str, scalar: str) -> Kernel:
    require_tool("cc" if language == "c" else "gfortran")
    return compile_kernel(arm("remembering"), language=language, scalar=scalar)  # type: ignore[arg-type]


def motion(steps: int, scalar: str) -> dict[str, Floats]:
    """A motion through several reversals; small and slow enough for the bristles to bend and to slide."""
    t = np.arange(steps)[:, None] * DT
    rate, phase = np.array([40.0, 55.0, 75.0]), np.array([0.0, 1.0, 2.0])
    size = np.array([2e-3, 5e-3, 1e-3])
    q = size * np.sin(rate * t + phase)
    qd, qdd = size * rate * np.cos(rate * t + phase), -size * rate**2 * np.sin(rate * t + phase)
    kind = np.float64 if scalar == "double" else np.float32
    arrays = {"q": q, "qd": qd, "qdd": qdd, "dt": np.full(steps, DT)}
    return {name: array.astype(kind) for name, array in arrays.items()}


def stepped(made: Kernel, samples: dict[str, Floats]) -> tuple[Floats, Floats]:
    """Torques and states [K, ...] along ``samples``, by the compiled function itself, whatever dt is."""
    function = made.inverse_dynamics
    lib, view = function.library.lib, function.library.ffi.from_buffer
    kind = f"{made.scalar}[]"
    state = np.zeros(len(function.signature.states), made.dtype)
    values = view(kind, np.array([VALUES[name] for name in made.parameters], made.dtype))
    torques, states = [], []
    for k in range(-1, len(samples["dt"])):  # first at rest
        rows = [np.ascontiguousarray(samples[name][max(k, 0)]) for name in ("q", "qd", "qdd")]
        tau = np.empty(3, made.dtype)
        dt = float(samples["dt"][k]) if k >= 0 else 0.0
        arrays = [view(kind, row) for row in rows]
        lib.inverse_dynamics_robodyn_batch(
            1, *arrays, view(kind, tau, True), values, view(kind, state, True), dt
        )
        torques.append(tau)
        states.append(state.copy())
    return np.array(torques)[1:], np.array(states)[1:]


def spoilt(samples: dict[str, Floats], at: int, names: tuple[str, ...], value: float) -> dict[str, Floats]:
    """With one more sample before that ``at``, a copy of it with ``value`` in place of ``names``."""
    found = {name: np.insert(array, at, array[at], axis=0) for name, array in samples.items()}
    for name in names:
        found[name][at] = value
    return found


def assert_bent_little(made: Kernel, states: Floats) -> None:
    """Finite, and no bristle is bent further than it slides."""
    assert np.isfinite(states).all()
    for k, name in enumerate(names_of(made)):
        if name in BRISTLES:
            assert np.abs(states[:, k]).max() <= BRISTLES[name] * (1 + 1e-5)


def names_of(made: Kernel) -> list[str]:
    return list(made.inverse_dynamics.signature.states)


@pytest.mark.parametrize(("names", "value"), BAD, ids=str)
def test_one_bad_sample(names: tuple[str, ...], value: float) -> None:
    made, samples, at = kernel("c", "double"), motion(60, "double"), 30
    good_tau, good = stepped(made, samples)
    tau, states = stepped(made, spoilt(samples, at, names, value))
    assert np.isfinite(states).all()
    assert np.isfinite(np.delete(tau, at, axis=0)).all()
    if names != ("dt",):  # it shows, once
        assert not np.isfinite(tau[at]).any()
    else:  # no time is no reason for no torque
        assert np.isfinite(tau[at]).all()
        assert np.abs(tau[at]).max() < 2 * np.abs(good_tau).max()
    order = names_of(made)
    bent = {"qd", "dt"}.isdisjoint(names)  # bristles know nothing of the others
    still = [k for k, name in enumerate(order) if not (bent and name in BRISTLES)]
    np.testing.assert_array_equal(states[at][still], states[at - 1][still])
    if len(still) == len(order):  # as if it had not been, to the bit
        np.testing.assert_array_equal(np.delete(tau, at, axis=0), good_tau)
        np.testing.assert_array_equal(np.delete(states, at, axis=0), good)
    else:  # the bristles have gone the way of that sample: a step like all others
        np.testing.assert_allclose(tau[-1], good_tau[-1], rtol=0.05, atol=0.05 * np.abs(good_tau).max())


@pytest.mark.parametrize("value", [0.0, 1e-30, 1.0, 1e6, 1e18, 1e30])
def test_a_dt_that_is_out_of_all_proportion(value: float) -> None:
    made, samples, at = kernel("c", "double"), motion(200, "double"), 30
    good_tau, _ = stepped(made, samples)
    tau, states = stepped(made, spoilt(samples, at, ("dt",), value))
    assert np.isfinite(tau).all()
    assert_bent_little(made, states)
    np.testing.assert_allclose(tau[-1], good_tau[-1], rtol=0.02, atol=0.02 * np.abs(good_tau).max())


def test_samples_that_are_bad_again_and_again() -> None:
    made, rng = kernel("c", "double"), np.random.default_rng(3)
    samples = motion(400, "double")
    odd = [NAN, INF, -INF, 0.0, -1.0, 1e30, -1e30, 1e-30, np.finfo(made.dtype).max, np.finfo(made.dtype).tiny]
    for array in samples.values():
        chosen = rng.random(array.shape) < 0.05
        chosen[-40:] = False
        array[chosen] = rng.choice(odd, chosen.sum())
    tau, states = stepped(made, samples)
    assert np.isfinite(tau[-20:]).all()
    assert_bent_little(made, states)


@pytest.mark.parametrize("scalar", representative(["double", "float"], "double"))
def test_c_and_fortran_give_the_same_bits(scalar: str) -> None:
    for names, value in BAD:
        samples = spoilt(motion(40, scalar), 20, names, value)
        one, other = (stepped(kernel(language, scalar), samples) for language in ("c", "fortran"))
        for a, b in zip(one, other, strict=True):
            np.testing.assert_array_equal(a, b)  # nan where nan is
            assert a[np.isfinite(a)].tobytes() == b[np.isfinite(b)].tobytes()


@pytest.mark.parametrize(("names", "value"), [bad for bad in BAD if bad[0] != ("q",)], ids=str)
def test_the_program_and_the_reference_agree(names: tuple[str, ...], value: float) -> None:
    """The definition run by Python, and the equations written anew."""
    robot = arm("remembering")
    program = maker(robot, Options()).program("inverse_dynamics")
    reference, at = Stepping(robot, VALUES), 8
    samples = spoilt(motion(16, "double"), at, names, value)
    state, own = np.zeros(8), np.zeros((1, 8))
    for k in range(-1, len(samples["dt"])):
        dt = float(samples["dt"][k]) if k >= 0 else 0.0
        row = {name: samples[name][max(k, 0)] for name in ("q", "qd", "qdd")}
        inputs = {Input(name, i): float(x) for name, array in row.items() for i, x in enumerate(array)}
        inputs |= {Input("state", i): float(x) for i, x in enumerate(state)}
        inputs |= {Input("dt", 0): dt, Input("k_b", None): VALUES["k_b"]}
        found = evaluate(program, inputs)
        with np.errstate(all="ignore"):
            tau, own = reference.step(*(array[None] for array in row.values()), own, dt)
        state = np.array(found["state"])
        np.testing.assert_allclose(state, own[0], rtol=1e-9, atol=1e-12)
        if k != at or names == ("dt",):
            np.testing.assert_allclose(found["tau"], tau[0], rtol=1e-9, atol=1e-9)
        else:
            assert not np.isfinite(found["tau"]).any()
            assert not np.isfinite(tau).any()


def test_one_bristle_alone_shows_a_bad_velocity() -> None:
    """In an arm whose other torques know nothing of velocities."""
    text = """
name: lone
links:
  - {joint: prismatic, mass: 1, effects: [{effect: presliding_hysteresis, stiffness: 1000, level: 3}]}
"""
    robot: Robot = read_text(text)
    made = compile_kernel(robot)
    state = np.array([1e-3])
    for value in (NAN, INF, -INF):
        assert np.isnan(made.inverse_dynamics([0.0], [value], [0.0], state=state, dt=DT)).all()
        assert state.tolist() == [1e-3]
    still = float(made.inverse_dynamics([0.0], [0.0], [0.0], state=state, dt=DT)[0])
    assert still == pytest.approx(9.81 + 1.0)
    assert state.tolist() == [1e-3]


# --- what they are made of --------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", [float, np.float64, lambda x: np.array([x])])
def test_what_tells_numbers_from_others(kind: Any) -> None:
    for x, positive, finite, duration in (
        (2.5, 1, 1, 1), (5e-324, 1, 1, 1), (1e300, 1, 1, 1), (0.0, 0, 1, 1), (-0.0, 0, 1, 1),
        (-1.0, 0, 1, 0), (-1e-300, 0, 1, 0), (INF, 1, 0, 0), (-INF, 0, 0, 0), (NAN, 0, 0, 0),
    ):  # fmt: skip
        with np.errstate(all="ignore"):
            found = [is_positive(kind(x)), is_finite(kind(x)), is_duration(kind(x))]
        assert [float(np.squeeze(each)) for each in found] == [positive, finite, duration]
        kept = updated_if(kind(0.0), kind(x), kind(7.0))
        assert float(np.squeeze(kept)) == 7.0
        if finite:
            taken = float(np.squeeze(updated_if(kind(1.0), kind(x), kind(7.0))))
            assert taken == x
