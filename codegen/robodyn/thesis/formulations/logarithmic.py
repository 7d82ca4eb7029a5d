"""Inverse dynamics in a time that grows with the logarithm of the joints, over any scalar.

Along the base's axes the Newton-Euler recursions are running products and running sums: of rotations, of
``z_i qd_i``, of accelerations, of forces, of moments. What runs can be had by *recursive doubling*, in
``log2 n`` stages on many processors. Sources: Lathrop 1985 (sums and products by trees); Lee and Chang 1986
(homogeneous linear recurrences by recursive doubling, after Kogge and Stone 1973). Their papers are not at
hand: the two ways of running are theirs, how the recursion between is written is ours.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from robodyn.dynamics.arm import Arm, Motion, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.transforms import Matrix, product, rotation, transposed, turned
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, dot, named, plus, scaled, unmarked

Item = TypeVar("Item")
#: Joins two neighbours, the earlier first.
Join = Callable[[Item, Item], Item]
#: Makes all running totals of a row.
Running = Callable[[Sequence[Any], Join[Any]], list[Any]]


def doubling(items: Sequence[Item], join: Join[Item]) -> list[Item]:
    """All running totals of ``items``: every stage joins each with the one twice as far before it.

    ``ceil(log2 n)`` stages, about ``n log2 n`` joins (Kogge and Stone 1973).
    """
    prefixes = list(items)
    reach = 1
    while reach < len(prefixes):
        prefixes = [item if i < reach else join(prefixes[i - reach], item) for i, item in enumerate(prefixes)]
        reach *= 2
    return prefixes


def tree(items: Sequence[Item], join: Join[Item]) -> list[Item]:
    """All running totals of ``items``: pairs are joined, their totals run, and each second one is made
    from its neighbour. About ``2 log2 n`` stages, fewer than ``2 n`` joins (Brent and Kung 1982)."""
    if len(items) < 2:
        return list(items)
    pairs = [join(items[i], items[i + 1]) for i in range(0, len(items) - 1, 2)]
    totals = tree(pairs, join)
    prefixes = [items[0]]
    for i in range(1, len(items)):
        prefixes.append(totals[i // 2] if i % 2 else join(totals[i // 2 - 1], items[i]))
    return prefixes


def logarithmic(arm: Arm, motion: Motion, mark: Mark = unmarked, *, run: Running = doubling) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    bodies, n = arm.bodies, len(arm.bodies)

    def forward(vectors: Sequence[Vector]) -> list[Vector]:
        return run(vectors, plus)

    def backward(vectors: Sequence[Vector]) -> list[Vector]:
        return run(vectors[::-1], lambda later, own: plus(own, later))[::-1]

    turns = [rotation(body, motion.c[i], motion.s[i]) for i, body in enumerate(bodies)]
    R: list[Matrix] = run(turns, product)
    z = [(turn[0][2], turn[1][2], turn[2][2]) for turn in R]
    rates: list[Vector] = [
        scaled(motion.qd[i], z[i]) if body.revolute else ZERO for i, body in enumerate(bodies)
    ]
    w = forward(rates)
    before = [ZERO, *w[:-1]]
    alpha = forward(
        [
            plus(scaled(motion.qdd[i], z[i]), cross(before[i], rates[i])) if body.revolute else ZERO
            for i, body in enumerate(bodies)
        ]
    )
    origins = [origin(body, motion.d[i]) for i, body in enumerate(bodies)]
    p = [turned(R[i - 1], u) if i else u for i, u in enumerate(origins)]
    gx, gy, gz = arm.gravity
    steps: list[Vector] = []
    for i, body in enumerate(bodies):
        step = _relative(before[i], alpha[i - 1] if i else ZERO, p[i])
        if not body.revolute:
            qd, qdd = motion.qd[i], motion.qdd[i]
            step = plus(step, plus(scaled(qdd, z[i]), scaled(2 * qd, cross(before[i], z[i]))))
        steps.append(plus((-gx, -gy, -gz), step) if i == 0 else step)
    a = forward(steps)

    forces, moments = [], []
    for i, body in enumerate(bodies):
        s = turned(R[i], body.com)
        force = scaled(body.mass, plus(a[i], _relative(w[i], alpha[i], s)))
        back = transposed(R[i])
        own_w, own_alpha = turned(back, w[i]), turned(back, alpha[i])
        own = plus(body.inertia.times(own_alpha), cross(own_w, body.inertia.times(own_w)))
        forces.append(named(mark, force, i + 1, "fc"))
        moments.append(plus(turned(R[i], own), cross(s, force)))
    f = backward(forces)
    passed_on = [plus(moments[i], cross(p[i + 1], f[i + 1])) if i + 1 < n else moments[i] for i in range(n)]
    moment = backward(passed_on)
    return [
        joint_torque(arm, i, motion, dot(z[i], moment[i] if body.revolute else f[i]), mark)
        for i, body in enumerate(bodies)
    ]


def _relative(w: Vector, alpha: Vector, r: Vector) -> Vector:
    """``alpha x r + w x (w x r)``."""
    return plus(cross(alpha, r), cross(w, cross(w, r)))
