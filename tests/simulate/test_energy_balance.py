"""Energy is kept where nothing takes it, and accounted for where motors, contacts and losses do."""

from __future__ import annotations

from collections.abc import Callable
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


def kinds_of(robot: Robot) -> dict[str, Effects]:
    """Effects that lose energy, by name."""
    n, joints = robot.n, range(1, robot.n + 1)
    coulomb = each(robot, "coulomb_friction", level=1.0)
    viscous = each(robot, "viscous_friction", coefficient=0.5)
    gears: list[dict[str, Any]] = [
        {"efficiency": 0.7},
        {"efficiency": EFFICIENCY, "rated_torque": 30.0},
        {"efficiency": EFFICIENCY, "rated_torque": 30.0, "interpolation": "cubic"},
    ]
    pair = {"with": n - 1, "inertia": 0.25, "ratio": 0.7, "viscous": 0.3, "coulomb": 0.8}
    return {
        "dry and viscous": coulomb + viscous,
        "asymmetric": each(robot, "asymmetric_friction", positive=2.0, negative=1.0),
        "stribeck": each(robot, "stribeck_friction", level=1.0, static=2.0, velocity=0.2),
        "thinned": each(robot, "power_law_friction", level=1.0, exponent=0.6),
        "bristles": each(robot, "presliding_hysteresis", level=1.0, stiffness=200.0, damping=0.2),
        "gears": [effect("transmission_loss", j, breakaway=0.5, **gears[j % 3]) for j in joints],
        "damped elastic": each(robot, "joint_elasticity", stiffness=2000.0, damping=2.0) + coulomb,
        "damped play": each(robot, "backlash", gap=0.01) + coulomb,
        "lossy pair": [effect("motor_coupling", n, **pair), *coulomb],
        "limits": coulomb + viscous + each(robot, "torque_saturation", limit=6.0, clips="drive"),
        "bearings": [
            effect("load_dependent_friction", j, **kind) for j, kind in zip(joints, BEARINGS, strict=False)
        ],
    }


BEARINGS: list[dict[str, Any]] = [
    {"bearing": "journal", "mu": 0.05, "radius": 0.1, "span": 0.2},
    {"bearing": "journal", "mu": 0.05, "radius": 0.1, "span": 0.2, "variant": "printed"},
    {"bearing": "linear", "mu": 0.05, "span": 0.3},
    {"bearing": "thrust", "mu": 0.1, "radius": 0.05},
    {"bearing": "radial", "mu_r": 0.01},
    {"bearing": "torque", "mu": 0.1},
]
KINDS = list(kinds_of(arm("stanford")))
#: Kinds in the normal run and in CI; all others in `make prove-all`.
MARKS: dict[str, Any] = {
    **{f"puma560_3dof {kind}": () for kind in ("dry and viscous", "thinned", "limits")},
    **dict.fromkeys(
        ("puma560_3dof bristles", "puma560_3dof gears", "stanford bearings"), pytest.mark.thorough
    ),
}
CASES = [
    pytest.param(name, kind, id=f"{name} {kind}", marks=MARKS.get(f"{name} {kind}", pytest.mark.slow))
    for name in ("puma560_3dof", "stanford")
    for kind in KINDS
    if (name, kind) != ("puma560_3dof", "bearings")  # a linear one needs a slide
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


@pytest.mark.parametrize(("name", "kind"), CASES)
def test_energy_is_accounted_for(name: str, kind: str) -> None:
    robot = hung(name, rotors, lambda bare: kinds_of(bare)[kind])
    stiff = kind.startswith("damped")
    for options in ({**TIGHT, "rtol": 1e-11}, {"method": "rk4", "step": 1e-4 if stiff else 1e-3}):
        run = shaken(robot, **options)
        found = run.balance()
        assert found.error < 1e-8
        assert found.loss[-1] > 1
        assert np.diff(found.loss).min() > -1e-12
        assert found.work[-1] == pytest.approx(motors_work(run), abs=1e-9 * found.scale)
        np.testing.assert_allclose(run.command[:-1], table_of(robot), atol=1e-12)
        if kind == "limits":
            assert np.abs(run.applied).max() == 6.0
            assert np.abs(run.command).max() > 14
        elif kind not in ("bristles", "thinned"):  # nothing sticks
            assert run.record.counters["events"] > 0


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
    robot = arm(name, *rotors(bare), *kinds_of(bare)["dry and viscous"], touch)
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


def test_every_effect_that_loses_energy_has_its_case() -> None:
    used = {entry.effect for effects in kinds_of(arm("stanford")).values() for entry in effects}
    places = {"bearing", "coupler", "gear", "motor", "pair"}
    lossy = {id for id, one in CATALOGUE.items() if one.place in places} - {"torque_ripple"}
    assert lossy <= used


def pairs(robot: Robot) -> Effects:
    return [
        effect("motor_coupling", robot.n, **{"with": robot.n - 1}, inertia=0.25, ratio=0.7),
        effect("motor_coupling", 1, **{"with": 2}, inertia=0.25, ratio=-0.7),
    ]


def springs(robot: Robot) -> Effects:
    return each(robot, "spring", stiffness=30.0, rest=0.2, cubic=5.0)


def ripple(robot: Robot) -> Effects:
    return each(robot, "torque_ripple", amplitude=1.5, cycles_per_rev=9.0, phase=0.3)


def elastic(robot: Robot) -> Effects:
    return rotors(robot) + each(robot, "joint_elasticity", stiffness=400.0)


def play(robot: Robot) -> Effects:
    return rotors(robot) + each(robot, "backlash", gap=0.02, stiffness=2000.0, damping=0.0, transition=0.5)


TOGETHER = (springs, ripple, pairs)
KEPT_KINDS: dict[str, tuple[Callable[[Robot], Effects], ...]] = {
    "rigid": (), "springs": (springs,), "ripple": (ripple,), "pairs": (pairs,), "elastic": (elastic,),
    "play": (play,), "together": TOGETHER, "all elastic": (elastic, *TOGETHER),
}  # fmt: skip
#: Kinds in the normal run and in CI; all others in `make prove-all`.
KEPT_MARKS: dict[str, Any] = {
    "stanford springs": (), "puma560_3dof play": (),
    "puma560_3dof elastic": pytest.mark.thorough, "puma560 together": pytest.mark.thorough,
}  # fmt: skip
KEPT_CASES = [
    pytest.param(name, kind, id=f"{name} {kind}", marks=KEPT_MARKS.get(f"{name} {kind}", pytest.mark.slow))
    for name in ("puma560", "stanford", "panda", "puma560_3dof")
    for kind in KEPT_KINDS
]


@pytest.mark.parametrize(("name", "kind"), KEPT_CASES)
def test_energy_is_kept(name: str, kind: str) -> None:
    """Ten seconds of falling, swinging and twisting."""
    robot = hung(name, *KEPT_KINDS[kind])
    run = simulate(
        robot, start=start_of(robot), duration=10.0, sample_period=0.02, plant=plant_of(robot), **TIGHT
    )
    found = run.balance()
    drift = float(np.abs(found.residual).max()) / float(np.ptp(found.kinetic))
    print(f"{name} {kind}: drift {drift:.1e} of {np.ptp(found.kinetic):.3g} J")
    assert np.ptp(found.kinetic) > 5
    assert drift < 1e-8
    assert (found.work == 0).all()
    assert np.abs(found.loss).max() < 1e-12 * np.ptp(found.kinetic)
