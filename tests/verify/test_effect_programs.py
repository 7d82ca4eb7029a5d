"""The programs of robots with effects, which kernels are made of, beside the reference."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from effects.cases import CASES, draw, entry
from robodyn.drives.drive import rigid_part
from robodyn.dynamics.functions import function_named
from robodyn.ir import Input
from robodyn.ir.evaluate import evaluate
from robodyn.kernels.with_effects import layered
from robodyn.optimize.programs import Choice, build
from robodyn.robot.model import Inertia, Robot
from robodyn.verify import Reference
from robodyn_testing.random_robots import random_robot

TENSOR = Inertia(
    Fraction(1, 50), Fraction(1, 40), Fraction(1, 60), Fraction(1, 500), Fraction(0), Fraction(-1, 400)
)
LOAD = {"mass": Fraction(5, 2), "com": (Fraction(1, 10), Fraction(-1, 20), Fraction(1, 8)), "inertia": TENSOR}


def everything(seed: int) -> Robot:
    """A random arm with a random effect of each kind that fits, some of them at one joint."""
    rng = random.Random(seed)
    robot = random_robot(seed, joints=4, exotic=0.0, degenerate=0.0)
    robot = replace(robot, torque_side=rng.choice(["motor", "motor", "link"]))
    rest, band = rng.choice([(Fraction(1, 3), None), (None, Fraction(1, 3)), (None, None)])
    robot = replace(robot, rest_velocity=rest, dead_band=band)
    entries, taken = [entry("payload", None, **LOAD)], set()
    for case in CASES.values():
        joint = rng.randint(1, 4)
        revolute = robot.links[joint - 1].joint.kind == "revolute"
        if case.id == "rotor_inertia" or not (case.revolute if revolute else case.prismatic):
            continue
        given = draw(case, rng)
        if case.id == "motor_coupling":
            given["with"] = joint % 4 + 1
        if case.id == "load_dependent_friction" or (case.id, joint) not in taken:
            entries.append(entry(case.id, joint, **given))
            taken.add((case.id, joint))
    return replace(robot, effects=tuple(entries))


@pytest.mark.parametrize("seed", range(6))
def test_programs_are_the_reference(seed: int) -> None:
    robot = everything(seed)
    q, qd, qdd = np.random.default_rng(seed).uniform(-3, 3, (3, 3, 4))
    reference = Reference(robot)
    forgets = replace(robot, effects=tuple(e for e in robot.effects if e.effect != "presliding_hysteresis"))
    for function, expected in (
        ("inverse_dynamics", Reference(forgets).inverse_dynamics(q, qd, qdd)),
        ("gravity", reference.gravity(q)),
        ("bias", reference.bias(q, qd)),
        ("mass_matrix", reference.mass_matrix(q)),
    ):
        rigid = {"mass_matrix": build(rigid_part(robot), "mass_matrix", Choice())}
        arm = forgets if function == "inverse_dynamics" else robot
        program = layered(arm, function_named(function), rigid.get, "modified_newton_euler")
        result = "M" if function == "mass_matrix" else "tau"
        for k in range(len(q)):
            inputs = {
                Input(name, i): float(x)
                for name, array in (("q", q), ("qd", qd), ("qdd", qdd))
                for i, x in enumerate(array[k])
            }
            wanted = expected[k].ravel()
            found = evaluate(program, inputs)[result]
            np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-11 * np.abs(wanted).max())
