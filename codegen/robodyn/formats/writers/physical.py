"""Bodies that move as those of a description do, and that MuJoCo and SDF accept: with mass, and with tensors
that some body has.

A description may state less: only what enters torques, or a table of moments that no body has. A body is here
its pseudo-inertia, the integral of ``[r; 1] [r; 1]^T`` over its mass, which is positive definite for every
body that is not flat. Mass on a revolute joint's axis counts for either link alike, since the axis belongs to
both, and so does the second moment of mass of links that slide along each other: that much is moved from the
link before, and behind the base it is free.

Source: Wensing, Kim and Slotine, RA-L 2018 (pseudo-inertia); Gautier 1991 (what can be moved).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.formats.chain import Body, Pose
from robodyn.formats.limits import LEAST_BODY, SLACK
from robodyn.formats.writers.parts import Frame, PartJoint


def physical(joints: Sequence[PartJoint]) -> tuple[tuple[PartJoint, ...], list[str]]:
    """The ``joints`` with bodies that have mass and physical tensors, those that had them unchanged; and what
    was changed."""
    import numpy as np

    moments = [_moments(joint.body) for joint in joints]
    least = LEAST_BODY * (max(float(np.trace(each)) for each in moments) or 1.0)
    changed: dict[int, Any] = {}
    bad = []
    for index in reversed(range(len(joints))):
        joint = joints[index]
        if index not in changed and _accepted(joint.body, least):
            continue
        extra, possible = _missing(moments[index], joint.kind == "revolute", least)
        if not possible:
            bad.append(joint.name)
        if not extra.any():
            continue
        changed[index] = moments[index] = moments[index] + extra
        if index:
            step = _homogeneous(joint.frame)
            changed[index - 1] = moments[index - 1] = moments[index - 1] - step @ extra @ step.T
    if bad:
        return tuple(joints), [
            f"no body moves as the description says of {', '.join(bad)}: its inertia is written as it "
            "stands, and MuJoCo and Gazebo will refuse it"
        ]
    if not changed:
        return tuple(joints), []
    bodies = [
        replace(joint, body=_body(changed[i])) if i in changed else joint for i, joint in enumerate(joints)
    ]
    names = ", ".join(joints[i].name for i in sorted(changed))
    return tuple(bodies), [
        "links without mass, or with an inertia that no body has, stand there as bodies that move alike: "
        + names
    ]


def _accepted(body: Body, least: float) -> bool:
    """Whether MuJoCo takes the body: mass, and no principal moment above the sum of the two others."""
    import numpy as np

    low, middle, high = np.linalg.eigvalsh(_tensor(body.inertia))
    return bool(body.mass >= least and low >= least and low + middle >= high * (1 + SLACK))


def _missing(moments: Any, revolute: bool, least: float) -> tuple[Any, bool]:
    """What can be added to ``moments`` without changing how the arm moves, for it to be a body's; and whether
    that makes it one."""
    import numpy as np

    extra, free = np.zeros((4, 4)), [2, 3] if revolute else [0, 1, 2]
    kept = [k for k in range(4) if k not in free]
    rigid = moments[np.ix_(kept, kept)]
    lowest, scale = float(np.linalg.eigvalsh(rigid)[0]), float(np.trace(moments))
    if lowest < -SLACK * abs(scale):
        return extra, False
    if lowest < least:  # a mass too small to be noticed
        floor = 2 * least * np.eye(len(kept))
        extra[np.ix_(kept, kept)] = floor
        rigid = rigid + floor
    across = moments[np.ix_(free, kept)]
    needed = across @ np.linalg.solve(rigid, across.T)
    there = moments[np.ix_(free, free)]
    room = SLACK * max(float(np.trace(rigid) + np.trace(needed)), 1e3 * least)
    lacking = needed + room * np.eye(len(free)) - there
    if revolute and lacking[1, 1] < 0:  # it has mass: a moment is all that is moved
        extra[2, 2] = max(float(lacking[0, 0] + lacking[0, 1] ** 2 / -lacking[1, 1]), 0.0)
        return extra, True
    values, vectors = np.linalg.eigh(lacking)
    extra[np.ix_(free, free)] = (vectors * np.maximum(values, 0)) @ vectors.T
    return extra, True


def _tensor(inertia: Sequence[float]) -> Any:
    import numpy as np

    xx, yy, zz, xy, xz, yz = inertia
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def _moments(body: Body) -> Any:
    """The pseudo-inertia [4, 4] about the frame's origin: second and first moments, and mass."""
    import numpy as np

    tensor, com = _tensor(body.inertia), np.array(body.com)
    second = np.trace(tensor) / 2 * np.eye(3) - tensor + body.mass * np.outer(com, com)
    first = (body.mass * com)[:, None]
    return np.block([[second, first], [first.T, np.array([[body.mass]])]])


def _body(moments: Any) -> Body:
    import numpy as np

    mass = float(moments[3, 3])
    com = moments[:3, 3] / mass
    second = moments[:3, :3] - mass * np.outer(com, com)
    tensor = np.trace(second) * np.eye(3) - second
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = tensor.tolist()
    x, y, z = com.tolist()
    return Body(mass, (x, y, z), (xx, yy, zz, xy, xz, yz))


def _homogeneous(frame: Frame) -> Any:
    import numpy as np

    pose, matrix = Pose.from_rpy(frame.xyz, frame.rpy), np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = pose.rotation, pose.xyz
    return matrix
