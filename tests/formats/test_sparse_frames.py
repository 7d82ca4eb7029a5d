"""Frames are chosen where numbers vanish: oblique offsets between parallel axes, lines of sliding joints."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from robodyn.formats.chain import Body, Chain, ChainJoint, Pose
from robodyn.formats.frames import description_of
from robodyn.robot import Robot
from robodyn.robot.values import Value
from robodyn.verify import Reference
from robodyn_testing import require_module
from robodyn_testing.random_chains import pinocchio_model

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
BODY = Body(2.0, (0.01, 0.02, 0.03), (0.01, 0.02, 0.02, 0.001, 0.0, 0.0))


def offsets(robot: Robot) -> list[list[Value]]:
    return [[link.joint.a, link.joint.b, link.joint.d] for link in robot.links]


def check_torques(chain: Chain) -> None:
    pin = require_module("pinocchio")
    model, n = pinocchio_model(chain), len(chain.joints)
    q, qd, qdd = np.random.default_rng(1).uniform(-2, 2, (3, n))
    tau = pin.rnea(model, model.createData(), q, qd, qdd)
    found = Reference(description_of(chain)).inverse_dynamics(q[None], qd[None], qdd[None])[0]
    np.testing.assert_allclose(found, tau, rtol=0, atol=1e-12 * np.abs(tau).max())


def test_an_oblique_offset_between_parallel_axes_is_two_lengths_and_no_angle() -> None:
    """An elbow 20 mm beside the upper arm's axis."""
    chain = Chain(
        "arm",
        (
            ChainJoint("waist", "a", "revolute", body=BODY),
            ChainJoint("shoulder", "b", "revolute", Pose((0.0, 0.15, 0.0)), Y, BODY),
            ChainJoint("elbow", "c", "revolute", Pose((0.4318, 0.0, 0.0203)), Y, BODY),
            ChainJoint("wrist", "d", "revolute", Pose((0.0, 0.0, 0.4331)), Z, BODY),
        ),
    )
    robot = description_of(chain)
    assert all(link.joint.theta.quarter is not None for link in robot.links)
    assert [abs(x) for x in offsets(robot)[2]] in [  # type: ignore[arg-type]
        [Fraction(one), Fraction(other), Fraction("0.15")]
        for one, other in (("0.4318", "0.0203"), ("0.0203", "0.4318"))
    ]
    check_torques(chain)


def test_a_gantry_has_no_offsets() -> None:
    chain = Chain(
        "gantry",
        tuple(
            ChainJoint(name, name, "prismatic", Pose(xyz), axis, BODY)
            for name, xyz, axis in (
                ("x", (0.1, 0.2, 1.3), X),
                ("y", (0.4, -0.2, 0.3), Y),
                ("z", (0.0, 0.7, -0.6), Z),
            )
        ),
        tool=Pose((0.0, 0.0, -0.2)),
    )
    robot = description_of(chain)
    assert offsets(robot) == [[0, 0, 0]] * 3
    check_torques(chain)


def test_a_sliding_joint_has_its_line_through_the_next_axis() -> None:
    """A SCARA whose quill slides on a rail beside it: the rail's place costs nothing."""

    def quill(aside: float) -> Chain:
        return Chain(
            "scara",
            (
                ChainJoint("shoulder", "a", "revolute", body=BODY),
                ChainJoint("elbow", "b", "revolute", Pose((0.4, 0.0, 0.1)), Z, BODY),
                ChainJoint("lift", "c", "prismatic", Pose((0.3, aside, 0.2)), Z, BODY),
                ChainJoint("quill", "d", "revolute", Pose((0.05, -aside, -0.1)), Z, BODY),
            ),
        )

    robots = [description_of(quill(aside)) for aside in (0.0, 0.08)]
    assert offsets(robots[0]) == offsets(robots[1])
    assert sum(x != 0 for row in offsets(robots[1]) for x in row) <= 3
    check_torques(quill(0.08))
