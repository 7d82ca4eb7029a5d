"""Random chains of joint axes in any direction, the same for the same seed, and Pinocchio's model of a chain.

They are rich in what breaks frames: axes that are parallel, nearly parallel, at right angles and nearly so,
intersecting and nearly intersecting, coincident; angles and lengths written with few digits or many.
"""

from __future__ import annotations

import math
import random
from typing import Any

import numpy as np

from robodyn.formats.chain import Body, Chain, ChainJoint, Pose, Vector

__all__ = ["pinocchio_model", "random_chain", "tip_poses"]


def random_chain(seed: int, joints: int | None = None) -> Chain:
    """The random chain ``seed``: of 1 to 8 joints, where ``joints`` does not say how many."""
    rng = random.Random(seed)
    count = joints or rng.randint(1, 8)
    upright = rng.random() < 0.7
    return Chain(
        f"chain_{seed}",
        tuple(_joint(rng, i) for i in range(1, count + 1)),
        gravity=(0.0, 0.0, -9.81) if upright else (rng.gauss(0, 5), rng.gauss(0, 5), rng.gauss(0, 5)),
        base=Pose() if rng.random() < 0.5 else _pose(rng),
        tool=Pose() if rng.random() < 0.2 else _pose(rng),
    )


def _joint(rng: random.Random, index: int) -> ChainJoint:
    points = np.array([[rng.gauss(0, 0.1) for _ in range(3)] for _ in range(5)])
    t = np.einsum("pi,pi,jk->jk", points, points, np.eye(3)) - points.T @ points
    inertia = (t[0, 0], t[1, 1], t[2, 2], t[0, 1], t[0, 2], t[1, 2])
    body = Body(round(rng.uniform(0.1, 5), 3), (_length(rng), _length(rng), _length(rng)), inertia)
    return ChainJoint(
        f"joint_{index}",
        f"link_{index}",
        "prismatic" if rng.random() < 0.2 else "revolute",
        _pose(rng),
        _axis(rng),
        body,
        motor_inertia=rng.choice((0.0, 0.25)),
    )


def _pose(rng: random.Random) -> Pose:
    return Pose.from_rpy([_length(rng) for _ in range(3)], [_angle(rng) for _ in range(3)])


def _axis(rng: random.Random) -> Vector:
    if rng.random() < 0.4:
        chosen, way = rng.randrange(3), rng.choice((-1.0, 1.0))
        return (way * (chosen == 0), way * (chosen == 1), way * (chosen == 2))
    x, y, z = (rng.gauss(0, 1) for _ in range(3))
    length = math.hypot(x, y, z)
    return (x / length, y / length, z / length)


def _angle(rng: random.Random) -> float:
    kind, quarter = rng.random(), rng.choice((0, 1, -1, 2)) * math.pi / 2
    if kind < 0.5:
        return quarter
    if kind < 0.7:
        return quarter + rng.choice((-1, 1)) * 10 ** rng.uniform(-15, -2)
    return round(rng.uniform(-3.2, 3.2), rng.choice((1, 3, 6, 16)))


def _length(rng: random.Random) -> float:
    kind = rng.random()
    if kind < 0.3:
        return 0.0
    return 10 ** rng.uniform(-15, -3) if kind < 0.4 else round(rng.uniform(-0.5, 0.5), rng.choice((1, 3, 16)))


def pinocchio_model(chain: Chain) -> Any:
    """The chain as ``pin`` has it: its own frames and axes, rotors as armature."""
    import pinocchio as pin

    model = pin.Model()
    model.gravity = pin.Motion(np.array(chain.gravity), np.zeros(3))
    parent, before = 0, _placed(chain.base)
    for joint in chain.joints:
        turns = joint.kind == "revolute"
        kind = pin.JointModelRevoluteUnaligned if turns else pin.JointModelPrismaticUnaligned
        place = before * _placed(joint.pose)
        parent = model.addJoint(parent, kind(np.array(joint.axis)), place, joint.name)
        xx, yy, zz, xy, xz, yz = joint.body.inertia
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        body = pin.Inertia(joint.body.mass, np.array(joint.body.com), tensor)
        model.appendBodyToJoint(parent, body, pin.SE3.Identity())
        before = pin.SE3.Identity()
    model.armature = np.array([joint.motor_inertia for joint in chain.joints])
    return model


def tip_poses(chain: Chain, q: Any) -> Any:
    """Pose [N, 4, 4] of the tool's frame in the world at ``q`` [N, n], by Pinocchio."""
    import pinocchio as pin

    model = pinocchio_model(chain)
    data = model.createData()
    poses = []
    for row in q:
        pin.forwardKinematics(model, data, row)
        poses.append((data.oMi[len(chain.joints)] * _placed(chain.tool)).homogeneous)
    return np.array(poses)


def _placed(pose: Pose) -> Any:
    import pinocchio as pin

    return pin.SE3(np.array(pose.rotation), np.array(pose.xyz))
