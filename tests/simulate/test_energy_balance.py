"""Energy is accounted for: what motors and contacts put in is stored, or lost to friction and damping."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from peers.numbers import placement
from robodyn.effects.catalogue import CATALOGUE
from robodyn.robot.model import Robot
from robodyn.simulate.simulation import Simulation, Torques, simulate
from simulate.arms import TIGHT, Effects, Floats, arm, each, effect, hung, plant_of, rotors, start_of

PERIOD = 1e-2
EFFICIENCY = ((0.0, 0.3), (0.5, 0.7), (1.0, 0.8))


def coulomb(robot: Robot) -> Effects:
    return each(robot, "coulomb_friction", level=1.0)


def dry_and_viscous(robot: Robot) -> Effects:
    return coulomb(robot) + each(robot, "viscous_friction", coefficient=0.5)


def asymmetric(robot: Robot) -> Effects:
    return each(robot, "asymmetric_friction", positive=2.0, negative=1.0)


def stribeck(robot: Robot) -> Effects:
    return each(robot, "stribeck_friction", level=1.0, static=2.0, velocity=0.2)


def thinned(robot: Robot) -> Effects:
    return each(robot, "power_law_friction", level=1.0, exponent=0.6)


def bristles(robot: Robot) -> Effects:
    return each(robot, "presliding_hysteresis", level=1.0, stiffness=200.0, damping=0.2)


def bearings(robot: Robot) -> Effects:
    """Of every kind, on the Stanford arm."""
    kinds: list[dict[str, Any]] = [
        {"bearing": "journal", "mu": 0.05, "radius": 0.1, "span": 0.2},
        {"bearing": "journal", "mu": 0.05, "radius": 0.1, "span": 0.2, "variant": "printed"},
        {"bearing": "linear", "mu": 0.05, "span": 0.3},
        {"bearing": "thrust", "mu": 0.1, "radius": 0.05},
        {"bearing": "radial", "mu_r": 0.01},
        {"bearing": "torque", "mu": 0.1},
    ]
    return [effect("load_dependent_friction", j, **kind) for j, kind in enumerate(kinds, 1)]


def gears(robot: Robot) -> Effects:
    kinds: list[dict[str, Any]] = [
        {"efficiency": 0.7},
        {"efficiency": EFFICIENCY, "rated_torque": 30.0},
        {"efficiency": EFFICIENCY, "rated_torque": 30.0, "interpolation": "cubic"},
    ]
    joints = range(1, robot.n + 1)
    return [effect("transmission_loss", j, breakaway=0.5, **kinds[j % 3]) for j in joints]


def damped_elastic(robot: Robot) -> Effects:
    return each(robot, "joint_elasticity", stiffness=2000.0, damping=2.0) + coulomb(robot)


def damped_play(robot: Robot) -> Effects:
    return each(robot, "backlash", gap=0.01) + coulomb(robot)


def lossy_pair(robot: Robot) -> Effects:
    more = {"with": robot.n - 1, "inertia": 0.25, "ratio": 0.7, "viscous": 0.3, "coulomb": 0.8}
    return [effect("motor_coupling", robot.n, **more), *coulomb(robot)]


def limits(robot: Robot) -> Effects:
    return dry_and_viscous(robot) + each(robot, "torque_saturation", limit=6.0, clips="drive")


LOSSES = [
    dry_and_viscous, asymmetric, stribeck, thinned, bristles, gears, damped_elastic, damped_play, lossy_pair,
    limits,
]  # fmt: skip
MARKS = {
    **dict.fromkeys((asymmetric, stribeck, lossy_pair, damped_elastic, damped_play), pytest.mark.slow),
    **dict.fromkeys((bristles, gears), pytest.mark.thorough),
}
LOSS_CASES = [
    *(pytest.param("puma560_3dof", kind, id=kind.__name__, marks=MARKS.get(kind, ())) for kind in LOSSES),
    pytest.param("stanford", bearings, id="bearings", marks=pytest.mark.thorough),
    *(
        pytest.param("stanford", kind, id=f"stanford {kind.__name__}", marks=pytest.mark.slow)
        for kind in LOSSES
    ),
]


def table_of(robot: Robot) -> Floats:
    """Torques [200, n] that turn every joint to and fro."""
    sizes = np.array([15.0 if link.joint.kind == "revolute" else 4.0 for link in robot.links])
    table: Floats = sizes * np.sin(np.outer(np.arange(200) * PERIOD, 6 + 2 * np.arange(robot.n)))
    return table


def shaken(robot: Robot, **options: Any) -> Simulation:
    """Two seconds of those torques."""
    return simulate(
        robot, Torques(table_of(robot), PERIOD), start=start_of(robot), duration=2.0, plant=plant_of(robot),
        **{"sample_period": PERIOD, **options},
    )  # fmt: skip


def motors_work(run: Simulation) -> float:
    """Held torques times ways: exact."""
    way = np.diff(run.record.y[:, list(run.plant.system.motors)], axis=0)
    return float((run.applied[:-1] * way).sum())


@pytest.mark.parametrize(("name", "kind"), LOSS_CASES)
def test_energy_is_accounted_for(name: str, kind: Callable[[Robot], Effects]) -> None:
    robot = hung(name, rotors, kind)
    stiff = kind in (damped_play, damped_elastic)
    for options in ({**TIGHT, "rtol": 1e-11}, {"method": "rk4", "step": 1e-4 if stiff else 1e-3}):
        run = shaken(robot, **options)
        found = run.balance()
        print(
            f"{name} {kind.__name__}: {found.error:.1e} of {found.scale:.3g} J, {found.loss[-1]:.3g} J lost"
        )
        assert found.error < 1e-8
        assert found.loss[-1] > 1
        assert np.diff(found.loss).min() > -1e-12
        assert found.work[-1] == pytest.approx(motors_work(run), abs=1e-9 * found.scale)
        np.testing.assert_allclose(run.command[:-1], table_of(robot), atol=1e-12)
        if kind is limits:
            assert np.abs(run.applied).max() == 6.0
            assert np.abs(run.command).max() > 14
        elif kind not in (bristles, thinned):  # nothing sticks
            assert run.record.counters["events"] > 0


@pytest.mark.slow
def test_friction_smooth_at_rest_is_accounted_for_too() -> None:
    robot = replace(
        arm("puma560_3dof", *dry_and_viscous(arm("puma560_3dof"))), rest_velocity=Fraction(1, 100)
    )
    found = shaken(robot, **TIGHT).balance()
    assert found.error < 1e-8
    assert found.loss[-1] > 1


def test_the_loss_is_level_by_way_and_coefficient_by_squared_speed() -> None:
    """By Simpson's rule over fine samples, wherever no joint turns between them."""
    bare = arm("puma560_3dof")
    robot = arm("puma560_3dof", *rotors(bare), *dry_and_viscous(bare))
    run = shaken(robot, **TIGHT, sample_period=1e-3)
    speeds = np.abs(run.qd)
    power = (speeds + 0.5 * speeds**2).sum(axis=1)
    thirds = 1e-3 / 3 * (power[:-2:2] + 4 * power[1:-1:2] + power[2::2])
    turned = (np.diff(run.record.s, axis=0) != 0).any(axis=1)
    smooth = ~(turned[::2] | turned[1::2])
    assert smooth.mean() > 0.9
    loss = run.record.loss
    np.testing.assert_allclose(np.diff(loss[::2])[smooth], thirds[smooth], atol=1e-9)
    assert loss[-1] == pytest.approx(thirds.sum(), rel=1e-3)


def origin(robot: Robot, q: Floats, link: int) -> Floats:
    """Of the frame of ``link`` (from 1), in the base."""
    rotation, position = np.eye(3), np.zeros(3)
    for body, angle in zip(robot.links[:link], q, strict=False):
        turn, way = placement(body.joint)
        position = position + rotation @ way
        rotation = rotation @ turn
        if body.joint.kind == "revolute":
            c, s = np.cos(angle), np.sin(angle)
            rotation = rotation @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        else:
            position = position + rotation[:, 2] * angle
    return position


@pytest.mark.parametrize(
    ("name", "link"), [("puma560_3dof", 3), pytest.param("stanford", 4, marks=pytest.mark.slow)]
)
def test_a_contact_works_by_force_and_way(name: str, link: int) -> None:
    """In a window that begins and ends between samples of the control."""
    bare = arm(name)
    force = np.array([20.0, -10.0, 5.0])
    window = {"start": 0.503, "end": 1.107}
    axes = {f"force_{axis}": float(f) for axis, f in zip("xyz", force, strict=True)}
    touch = effect("external_contact", None, link=link, **window, **axes)
    robot = arm(name, *rotors(bare), *dry_and_viscous(bare), touch)
    run = shaken(robot, **TIGHT, sample_period=1e-3)
    found = run.balance()
    ends = [int(np.argmin(np.abs(run.t - t))) for t in window.values()]
    way = np.subtract(*(origin(robot, run.q[k], link) for k in reversed(ends)))
    tau = np.repeat(table_of(robot), 10, axis=0)
    motors = float((tau * np.diff(run.q, axis=0)).sum())
    print(f"contact on link {link}: {force @ way:.4g} J, {found.error:.1e}")
    assert abs(force @ way) > 0.05
    assert found.error < 1e-8
    assert found.work[-1] - motors == pytest.approx(force @ way, abs=1e-9 * found.scale)


def test_the_balance_notices() -> None:
    """Steps too long for the arm, and a loss left out."""
    bare = arm("puma560_3dof")
    robot = arm("puma560_3dof", *rotors(bare), *dry_and_viscous(bare))
    assert shaken(robot, step=PERIOD).balance().error > 1e-10
    found = shaken(robot, **TIGHT).balance()
    assert replace(found, loss=found.loss * (1 + 1e-7)).error > 1e-8


def test_every_effect_that_loses_energy_has_its_case() -> None:
    robot = arm("stanford")
    used = {entry.effect for kind in (*LOSSES, bearings) for entry in kind(robot)}
    places = {"bearing", "coupler", "gear", "motor", "pair"}
    lossy = {id for id, one in CATALOGUE.items() if one.place in places} - {"torque_ripple"}
    assert lossy <= used
