"""Arms that are singular, weightless, overflow, or have given sines and effects."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.ir.signature import Signature
from robodyn.robot.model import Inertia, Joint, Link, Robot
from robodyn.robot.values import PI, ZERO, angle
from robodyn.verify import Reference, verify
from robodyn_testing import covering, representative
from verify.checked import Stand, check


def test_a_singular_arm_is_compared_where_it_can_be(arm: Robot) -> None:
    tip = replace(
        arm.links[-1], mass=ZERO, inertia=Inertia(), joint=replace(arm.links[-1].joint, motor_inertia=ZERO)
    )
    robot = replace(arm, links=(*arm.links[:-1], tip))
    report = check(robot, Stand(robot))
    assert report.uncompared == ("forward_dynamics",)
    assert not report.passed
    assert report.skipped == {"forward_dynamics": "the mass matrix is singular at every state"}
    assert all(comparison.passed for comparison in report.comparisons)


def test_singular_states_are_left_out_and_counted() -> None:
    """A point mass whose arm goes through zero: at q2 = 0 nothing turns."""
    turn = Joint("revolute", angle(ZERO), ZERO, ZERO, angle(ZERO))
    slide = Joint("prismatic", angle(PI / 2), ZERO, ZERO, angle(ZERO))
    robot = Robot("polar", (Link("post", turn), Link("ball", slide, mass=Fraction(2))))
    report = check(robot, Stand(robot, functions=("mass_matrix",)), states=20)
    assert report.passed

    class Careful(Stand):
        def __getattr__(self, name: str) -> Callable[..., Any]:
            def call(q: Any, qd: Any, tau: Any, params: Any = None) -> Any:
                found = np.full_like(q, np.nan)
                fit = q[:, 1] != 0
                found[fit] = Reference(self.model).forward_dynamics(q[fit], qd[fit], tau[fit])
                return found

            return call

    report = check(robot, Careful(robot, functions=("forward_dynamics",)), states=20)
    assert report.passed
    assert {c.against: (c.states, c.left_out) for c in report.comparisons}["reference"] == (19, 1)
    assert "19 (-1)" in report.to_text()


def test_an_arm_that_needs_no_torque() -> None:
    robot = Robot("ghost", (Link("nothing", Joint("revolute", angle(ZERO), ZERO, ZERO, angle(ZERO))),))
    torques = ("inverse_dynamics", "gravity")
    report = check(robot, Stand(robot, functions=torques))
    assert report.passed
    assert report.largest_torque == 0.0
    heavy = Robot("ghost", (Link("thing", robot.links[0].joint, inertia=Inertia(zz=Fraction(1))),))
    assert not check(robot, Stand(heavy, functions=torques)).passed


def test_given_sines_and_cosines(arm: Robot) -> None:
    class Given(Stand):
        def signature(self, function: str) -> Signature:
            return Signature(self.robot, function, (("sc", 6),), (("tau", 3),))

        def __getattr__(self, name: str) -> Callable[..., Any]:
            def call(sc: Any, params: Any = None) -> Any:
                assert params is None
                return Reference(self.model).gravity(np.arctan2(sc[:, :3], sc[:, 3:]))

            return call

    turning = replace(
        arm, links=tuple(replace(k, joint=replace(k.joint, kind="revolute")) for k in arm.links)
    )
    kernel = Given(turning, functions=("gravity",))
    assert check(turning, kernel, trig=lambda q: np.hstack([np.sin(q), np.cos(q)])).passed
    assert not check(turning, kernel, trig=lambda q: np.hstack([np.cos(q), np.sin(q)])).passed
    with pytest.raises(InputError, match="takes sines and cosines; expected trig"):
        check(turning, kernel)


@pytest.mark.parametrize(("size", "scalar"), covering([10**154, 9 * 10**307], ["double", "float"]))
def test_a_model_that_overflows_does_not_pass(arm: Robot, size: int, scalar: Any) -> None:
    """Neither does it warn, which would be an error here, nor stop."""
    first, second, third = arm.links
    heavy = replace(third, mass=Fraction(size), joint=replace(third.joint, a=Fraction(size)))
    robot = replace(arm, links=(first, second, heavy))
    report = check(robot, Stand(robot, scalar))
    assert not report.passed
    assert {c.error for c in report.comparisons if c.function == "mass_matrix"} == {np.inf}
    json.dumps(report.to_dict(), allow_nan=False)
    assert "FAILED" in report.to_text()


@pytest.mark.parametrize("name", representative(["rubbing", "remembering", "banded"], "rubbing"))
def test_arms_with_effects_against_the_reference(name: str) -> None:
    from robodyn.kernels.robot_kernel import compile as compile_kernel
    from robodyn_testing.effect_arms import arm as effect_arm

    robot = effect_arm(name)
    report = verify(robot, compile_kernel(robot), states=40)
    assert report.passed
    assert {c.function for c in report.comparisons} >= {"inverse_dynamics", "bias", "gravity", "mass_matrix"}
    assert "exact and Lagrangian torques" in report.skipped
