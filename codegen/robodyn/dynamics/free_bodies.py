"""Forces and moments in the joints of the rigid arm from free bodies, over any scalar.

All that lies beyond a joint is cut free there: what the joint passes on is the rate of its momentum, and of
its angular momentum, less the weight and what else acts on it. Velocities and rates are derivatives of poses,
so that no recursion of velocities, accelerations or forces is in it: recursions are checked by it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.dual import moving_along, slopes, values
from robodyn.dynamics.transforms import Matrix, applied, axial, poses, product, transposed
from robodyn.dynamics.vectors import Vector, cross, plus, scaled


def reactions(arm: Arm, motion: Motion, w: Sequence[Any]) -> list[tuple[Vector, Vector]]:
    """Force [N] and moment [N m] of link i-1 on link i for each joint, base to tip, along the axes and about
    the origin of link i's frame, while ``w`` [6], force and moment along the world's axes, acts on the tool
    at its origin."""
    in_time = moving_along(arm, motion, motion.qd, motion.qdd, [0] * len(motion.qd))
    moving = moving_along(arm, in_time, in_time.qd, in_time.qdd, [0] * len(motion.qd))
    *links, tool = poses(arm, moving)
    g = _matrix_vector(arm.base.rotation(), arm.gravity)
    push, twist = (w[0], w[1], w[2]), (w[3], w[4], w[5])
    f = scaled(-1, push)  # about the world's origin from here on
    n = scaled(-1, plus(twist, cross(_place(tool), push)))
    joints: list[tuple[Vector, Vector]] = []
    for body, T in zip(reversed(arm.bodies), reversed(links), strict=True):
        now = tuple(tuple(values(row)) for row in T[:3])  # with its derivative in time
        rate = tuple(tuple(slopes(row)) for row in T[:3])
        R, R_rate = (tuple(row[:3] for row in rows) for rows in (now, rate))
        com, velocity = (_matrix_vector(rows, (*body.com, 1)) for rows in (now, rate))
        spin = _vector(axial(product(R_rate, transposed(R))))
        momentum = scaled(body.mass, velocity)
        inner = body.inertia.times(_matrix_vector(transposed(R), spin))
        angular = plus(_matrix_vector(R, inner), cross(com, momentum))
        weight = scaled(body.mass, g)
        f = plus(f, _vector(slopes(momentum)), scaled(-1, weight))
        n = plus(n, _vector(slopes(angular)), scaled(-1, cross(_vector(values(com)), weight)))
        back = transposed(tuple(tuple(values(row)) for row in R))
        about = plus(n, scaled(-1, cross(_place(T), f)))
        joints.append((_matrix_vector(back, f), _matrix_vector(back, about)))
    return joints[::-1]


def _place(T: Matrix) -> Vector:
    """The origin of a frame, without derivatives."""
    return _vector(values(values([row[3] for row in T[:3]])))


def _vector(x: Sequence[Any]) -> Vector:
    return x[0], x[1], x[2]


def _matrix_vector(A: Matrix, u: Sequence[Any]) -> Vector:
    return _vector(applied(A, tuple(u)))
