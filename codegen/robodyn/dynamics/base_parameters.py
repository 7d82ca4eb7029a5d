"""Modified Newton-Euler on base parameters: lambda with first and second moments.

With ``F = m a + lambda h`` and the moment about the frame's origin straight from moments of mass, the
masses may be zero or negative and the arm's parameters regrouped (:mod:`robodyn.dynamics.regroup`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.arm import Arm, Motion, Symmetric
from robodyn.dynamics.modified_newton_euler import Kinematics, backward_pass, forward_pass, inertia_moment
from robodyn.dynamics.regroup import Lump, MomentForm
from robodyn.dynamics.vectors import Mark, Vector, cross, named, plus, scaled, unmarked


def second_moment_moment(k: Symmetric, at: Kinematics) -> Vector:
    """The integral of ``r x lambda r``: the antisymmetric part of ``lambda K``."""
    (l11, l12, l13), (l21, l22, l23), (l31, l32, l33) = at.lam.rows
    return (
        (l32 * k.yy - l23 * k.zz) + (l33 - l22) * k.yz + (l31 * k.xy - l21 * k.xz),
        (l13 * k.zz - l31 * k.xx) + (l11 - l33) * k.xz + (l12 * k.yz - l32 * k.xy),
        (l21 * k.xx - l12 * k.yy) + (l22 - l11) * k.xy + (l23 * k.xz - l13 * k.yz),
    )


def base_newton_euler(
    arm: Arm,
    motion: Motion,
    lumps: Sequence[Lump],
    forms: Sequence[MomentForm],
    mark: Mark = unmarked,
) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) from moments of mass about the frames' origins."""
    links = forward_pass(arm, motion, mark)
    forces: list[Vector] = []
    moments: list[Vector] = []
    for i, (at, lump, form) in enumerate(zip(links, lumps, forms, strict=True)):
        force = plus(scaled(lump.mass, at.a), at.lam.times(lump.first))
        forces.append(named(mark, force, i + 1, "fc"))
        if form == "inertia":
            turning = inertia_moment(lump.inertia(), at)
        else:
            turning = second_moment_moment(lump.second, at)
        moments.append(named(mark, plus(turning, cross(lump.first, at.a)), i + 1, "nc"))
    return backward_pass(arm, motion, links, forces, moments, mark)
