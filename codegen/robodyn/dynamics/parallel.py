"""Chains of parallel joint axes, turned as one: ``cos(q2 + q3)`` in the place of ``cos q3``.

The links of a chain see the angular velocity of what carries the chain through the sum of their angles
and turn about one axis with the sum of their rates, so that a link further out need not wait for the
ones before it, and the zeros of the carrier's velocity are not lost.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm, JointAngle, Motion, Trigonometry, about_z, origin
from robodyn.dynamics.vectors import Vector
from robodyn.effects.scalars import is_zero
from robodyn.robot.values import quarter_turns


class Turns(NamedTuple):
    """How each link stands to its chain's first joint: ``c, s`` [n] of the whole turn about z, its
    ``rate`` and ``acceleration`` [n], and whether the link ``follows`` [n] the one before in a chain."""

    c: tuple[Any, ...]
    s: tuple[Any, ...]
    rate: tuple[Any, ...]
    acceleration: tuple[Any, ...]
    follows: tuple[bool, ...]


def chained(arm: Arm) -> tuple[bool, ...]:
    """For each link [n] whether its joint axis is parallel to the one before, both revolute.

    The first joint begins no chain: nothing turns before it. Offsets of the angles must be quarter turns,
    lest the kernel add them up.
    """
    parallel = [False] * len(arm.bodies)
    for i in range(2, len(arm.bodies)):
        pair = arm.bodies[i - 1 : i + 1]
        parallel[i] = is_zero(arm.bodies[i].sin_alpha) and all(
            body.revolute and body.theta.quarter is not None for body in pair
        )
    return tuple(parallel)


def single_turns(motion: Motion) -> Turns:
    """Every joint for itself."""
    return Turns(motion.c, motion.s, motion.qd, motion.qdd, (False,) * len(motion.c))


def chain_turns(
    arm: Arm, motion: Motion, trigonometry: Trigonometry, wanted: Sequence[bool] | None = None
) -> Turns:
    """The turns of ``arm`` with its chains of parallel joints taken together; a link that is not ``wanted``
    [n] in a chain begins a new one."""
    follows = chained(arm)
    if wanted is not None:
        follows = tuple(can and want for can, want in zip(follows, wanted, strict=True))
    c, s, rate, acceleration = list(motion.c), list(motion.s), list(motion.qd), list(motion.qdd)
    angle: list[JointAngle | None] = [None] * len(c)
    for i, body in enumerate(arm.bodies):
        if not body.revolute:
            continue
        angle[i] = JointAngle(((i, 1),), body.theta)
        before = angle[i - 1]
        if follows[i] and before is not None:
            way = int(body.cos_alpha)  # +1, or -1 where the axes point against each other
            terms = tuple((joint, way * sign) for joint, sign in before.terms)
            quarters = way * (before.offset.quarter or 0) + (body.theta.quarter or 0)
            angle[i] = JointAngle((*terms, (i, 1)), quarter_turns(quarters))
            c[i], s[i] = trigonometry(angle[i])  # type: ignore[arg-type]
            rate[i] = way * rate[i - 1] + rate[i]
            acceleration[i] = way * acceleration[i - 1] + acceleration[i]
    return Turns(tuple(c), tuple(s), tuple(rate), tuple(acceleration), follows)


def reaches(arm: Arm, motion: Motion, turns: Turns) -> list[Vector]:
    """The next origin from each [n - 1], along the axes in which the composite of the two links is formed."""
    reach: list[Vector] = []
    for i in range(1, len(arm.bodies)):
        p = origin(arm.bodies[i], motion.d[i])
        reach.append(about_z(turns.c[i - 1], turns.s[i - 1], p) if turns.follows[i] else p)
    return reach
