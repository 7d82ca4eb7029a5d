"""A whole arm with Coulomb friction let go: what sticks, what slides, and when it is over."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

from robodyn.robot.model import Robot
from robodyn.simulate.simulation import Simulation, simulate
from robodyn_testing import require_module
from simulate.arms import TIGHT, Floats, arm, effect, plant_of

LEVELS = (0.2, 12.0, 1.5)
METHODS: list[dict[str, Any]] = [{"method": "rk4", "step": 1e-3}, {**TIGHT}]
ROBOT = arm("puma560_3dof", *(effect("coulomb_friction", j, level=x) for j, x in enumerate(LEVELS, 1)))


def let_go(q: Floats, duration: float, **options: Any) -> Simulation:
    return simulate(
        ROBOT, start=q, duration=duration, plant=plant_of(ROBOT), **{"sample_period": 1e-2, **options}
    )


def peer(robot: Robot, Q: Floats) -> tuple[Floats, Floats]:
    """Mass matrices [N, n, n] and gravity torques [N, n] by Pinocchio."""
    require_module("pinocchio")
    from peers import pinocchio_peer

    model = pinocchio_peer.pinocchio_model(robot)
    return pinocchio_peer.mass_matrix(model, robot, Q), pinocchio_peer.gravity(model, robot, Q)


def from_rest(M: Floats, load: Floats) -> Floats:
    """The one acceleration [3] under which every joint sticks within its level or slides against it."""
    found = []
    for ways in itertools.product((-1, 0, 1), repeat=3):
        slides, way = np.array([w != 0 for w in ways]), np.array(ways)
        a = np.zeros(3)
        a[slides] = np.linalg.solve(M[np.ix_(slides, slides)], (load - LEVELS * way)[slides])
        held = load - M @ a
        if (np.abs(held) <= LEVELS)[~slides].all() and (a * way > 0)[slides].all():
            found.append(a)
    assert len(found) == 1
    return found[0]


def poses(count: int) -> Floats:
    return np.random.default_rng(4).uniform(-np.pi, np.pi, (count, 3))


def test_each_pose_sticks_or_slides_as_its_weight_has_it() -> None:
    Q = poses(150)
    M, gravity = peer(ROBOT, Q)
    seen = set()
    for q, mass, weight in zip(Q, M, gravity, strict=True):
        run = let_go(q, 0.0)
        expected = from_rest(mass, -weight)
        np.testing.assert_allclose(run.qdd[0], expected, atol=1e-11)
        np.testing.assert_array_equal(run.record.s[0], np.sign(expected))
        assert (np.abs(weight) < LEVELS).all() == (expected == 0).all()
        seen.add(tuple(expected != 0))
    print("joints that slide:", sorted(seen))
    assert len(seen) >= 5


def test_what_its_friction_holds_is_still_for_five_seconds() -> None:
    """To the last bit."""
    Q = poses(300)
    _, gravity = peer(ROBOT, Q)
    part = (np.abs(gravity) / LEVELS).max(axis=1)
    held = Q[part < 1]
    assert len(held) > 5
    for q, options in zip(held[:6], 3 * METHODS, strict=True):
        run = let_go(q, 5.0, **options)
        assert (run.q == q).all()
        assert not any(x.any() for x in (run.qd, run.qdd, run.record.s, run.record.loss))


def test_an_arm_that_falls_comes_to_rest_and_both_methods_say_where() -> None:
    """Joints stop, are torn loose and stop again. Fixed steps let go a part of a step late, and what that
    moves the arm goes by the square of the delay."""
    q = np.array([2.7838, 0.0712, 2.9923])
    exact = let_go(q, 5.0, sample_period=8e-3, **TIGHT)
    changes = (np.diff(exact.record.s, axis=0) != 0).sum(axis=0)
    assert (changes >= 2).all()
    assert (exact.record.s[-1] == 0).all()
    assert (exact.qd[-1] == 0).all()
    _, weight = peer(ROBOT, exact.q[-1:])
    assert (np.abs(weight[0]) < LEVELS).all()
    steps = np.array([8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4, 1.25e-4])
    off = np.array([np.abs(let_go(q, 5.0, step=h, sample_period=8e-3).q - exact.q).max() for h in steps])
    print("changes", changes, "rk4 apart from adaptive", [f"{x:.1e}" for x in off])
    assert (off < 10 * steps**2).all()
    assert off[-1] < off[0] / 100
    assert exact.balance().error < 1e-10
