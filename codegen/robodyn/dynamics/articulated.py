"""Forward dynamics by articulated bodies, over any scalar: operations grow with the joints, not their cube.

Each link, with all beyond it free to move in its joints, resists an acceleration ``(alpha, a)`` of its frame
with the moment ``A alpha + B a + n`` about and the force ``B^T alpha + M a + f`` at its origin. Source:
Featherstone 2008, chapter 7; in classical accelerations (those of the frame's origin), so that of the motion
nothing but the velocity of turning is needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Symmetric, about_x, about_z, into_child, origin
from robodyn.dynamics.composite import Rows, rows_about_x, rows_about_z
from robodyn.dynamics.functions.record import Moving
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.regroup import tensor_about_x, tensor_about_z
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, dot, named, plus, scaled, unmarked
from robodyn.effects.scalars import is_zero
from robodyn.ir.program import Label


@dataclass(frozen=True, slots=True)
class _Body:
    """An articulated body about its frame's origin: ``A`` and ``M``, symmetric, ``B`` by rows, and the moment
    ``n`` and force ``f`` that it resists with at no acceleration."""

    A: Symmetric
    B: Rows
    M: Symmetric
    n: Vector
    f: Vector

    def with_(self, other: _Body) -> _Body:
        """Both, moving as one."""
        one, two, three = (plus(u, v) for u, v in zip(self.B, other.B, strict=True))
        return _Body(
            _sum(self.A, other.A),
            (one, two, three),
            _sum(self.M, other.M),
            plus(self.n, other.n),
            plus(self.f, other.f),
        )

    def resists(self, alpha: Vector, a: Vector) -> tuple[Vector, Vector]:
        """The moment and force that the accelerations take."""
        columns = zip(*self.B, strict=True)
        bx, by, bz = (dot((x, y, z), alpha) for x, y, z in columns)
        mx, my, mz = (dot(row, a) for row in self.B)
        return plus(self.A.times(alpha), (mx, my, mz)), plus((bx, by, bz), self.M.times(a))


@dataclass(frozen=True, slots=True)
class _Joint:
    """How a joint gives way: the moment and force ``along`` which the body resists a unit of its
    acceleration, the ``inverse`` of what that is along the joint itself, and the torque that is ``left``
    for acceleration."""

    along: tuple[Vector, Vector]
    inverse: Any
    left: Any


def articulated_bodies(at: Moving, tau: Sequence[Any], mark: Mark = unmarked) -> list[Any]:
    """Accelerations [n] (rad/s^2; m/s^2 at prismatic joints) that the torques ``tau`` [n] give."""
    arm, motion, n = at.arm, at.motion, len(at.arm.bodies)
    origins = [origin(body, d) for body, d in zip(arm.bodies, motion.d, strict=True)]
    rates, carried = _rates(at, origins, mark)
    joints: list[_Joint] = []
    beyond: _Body | None = None
    for i in reversed(range(n)):
        body = _rigid(at.lumps[i], rates[i])
        body = _named(body if beyond is None else body.with_(beyond), i + 1, mark)
        joint = _joint(at, i, body, tau[i], mark)
        joints.insert(0, joint)
        if i:
            beyond = _in_parent(at, i, _giving_way(at, i, body, joint, carried[i]), origins[i])
    gx, gy, gz = arm.gravity
    alpha, a = ZERO, (-gx, -gy, -gz)
    accelerations = []
    for i, (link, joint) in enumerate(zip(arm.bodies, joints, strict=True)):
        c, s = motion.c[i], motion.s[i]
        a = plus(into_child(link, c, s, plus(a, cross(alpha, origins[i]))), carried[i][1])
        alpha = plus(into_child(link, c, s, alpha), carried[i][0])
        taken = dot(joint.along[0], alpha) + dot(joint.along[1], a)
        qdd = mark((joint.left - taken) * joint.inverse, Label(i + 1, "qdd", ""))
        accelerations.append(qdd)
        if link.revolute:
            alpha = plus(alpha, (0, 0, qdd))
        else:
            a = plus(a, (0, 0, qdd))
        alpha, a = named(mark, alpha, i + 1, "alpha"), named(mark, a, i + 1, "a")
    return accelerations


def _rates(
    at: Moving, origins: Sequence[Vector], mark: Mark
) -> tuple[list[Vector], list[tuple[Vector, Vector]]]:
    """The links' angular velocities, and what velocities add to their accelerations, angular and linear."""
    w: Vector = ZERO
    rates, carried = [], []
    for i, link in enumerate(at.arm.bodies):
        c, s, qd = at.motion.c[i], at.motion.s[i], at.motion.qd[i]
        linear = into_child(link, c, s, cross(w, cross(w, origins[i])))
        w = into_child(link, c, s, w)
        across = (w[1] * qd, -(w[0] * qd), 0)
        if link.revolute:
            w = plus(w, (0, 0, qd))
            carried.append((across, linear))
        else:
            carried.append((ZERO, plus(linear, scaled(2, across))))
        w = named(mark, w, i + 1, "w")
        rates.append(w)
    return rates, carried


def _rigid(lump: Lump, w: Vector) -> _Body:
    """A link alone, turning at ``w``."""
    inertia, m, (x, y, z) = lump.inertia(), lump.mass, lump.first
    n = cross(w, inertia.times(w))
    f = cross(w, cross(w, lump.first))
    return _Body(inertia, ((0, -z, y), (z, 0, -x), (-y, x, 0)), Symmetric(m, m, m, 0, 0, 0), n, f)


def _joint(at: Moving, i: int, body: _Body, tau: Any, mark: Mark) -> _Joint:
    link = at.arm.bodies[i]
    A, B, M = body.A, body.B, body.M
    if link.revolute:
        along = (A.xz, A.yz, A.zz), B[2]
        own, held = A.zz, body.n[2]
    else:
        along = (B[0][2], B[1][2], B[2][2]), (M.xz, M.yz, M.zz)
        own, held = M.zz, body.f[2]
    if not is_zero(link.motor_inertia):
        own = own + link.motor_inertia
    friction = joint_torque(at.arm, i, at.motion, 0, unmarked)
    inverse = mark(Fraction(1) / mark(own, Label(i + 1, "pivot", "")), Label(i + 1, "ipivot", ""))
    return _Joint(along, inverse, tau - friction - held)


def _giving_way(at: Moving, i: int, body: _Body, joint: _Joint, carried: tuple[Vector, Vector]) -> _Body:
    """What of ``body`` is felt through joint ``i``, which gives way, about and at the same origin."""
    link, (n, f) = at.arm.bodies[i], joint.along
    sn, sf = scaled(joint.inverse, n), scaled(joint.inverse, f)
    A = _less(body.A, sn, n)
    M = _less(body.M, sf, f)
    one, two, three = (plus(row, scaled(-share, f)) for row, share in zip(body.B, sn, strict=True))
    if is_zero(link.motor_inertia):  # nothing is felt along the joint; written out it is only almost 0
        if link.revolute:
            A, three = Symmetric(A.xx, A.yy, 0, A.xy, 0, 0), ZERO
        else:
            M = Symmetric(M.xx, M.yy, 0, M.xy, 0, 0)
            one, two, three = ((row[0], row[1], 0) for row in (one, two, three))
    felt = _Body(A, (one, two, three), M, body.n, body.f)
    moment, force = felt.resists(*carried)
    return _Body(
        A,
        felt.B,
        M,
        plus(body.n, moment, scaled(joint.left, sn)),
        plus(body.f, force, scaled(joint.left, sf)),
    )


def _in_parent(at: Moving, i: int, body: _Body, r: Vector) -> _Body:
    """``body`` along the axes of the link before, about its origin, from which its own lies at ``r``."""
    link = at.arm.bodies[i]
    c, s, ca, sa = at.motion.c[i], at.motion.s[i], link.cos_alpha, link.sin_alpha
    A = tensor_about_x(tensor_about_z(body.A, c, s), ca, sa)
    M = tensor_about_x(tensor_about_z(body.M, c, s), ca, sa)
    B = rows_about_x(ca, sa, rows_about_z(c, s, body.B))
    n, f = (about_x(ca, sa, about_z(c, s, u)) for u in (body.n, body.f))
    # With R u = r x u: B + R M, and A - B R + R (B + R M)^T.
    columns = [cross(r, u) for u in ((M.xx, M.xy, M.xz), (M.xy, M.yy, M.yz), (M.xz, M.yz, M.zz))]
    moved = [plus(row, more) for row, more in zip(B, zip(*columns, strict=True), strict=True)]
    right = [cross(row, r) for row in B]
    left = list(zip(*(cross(r, row) for row in moved), strict=True))

    def entry(own: Any, row: int, column: int) -> Any:
        return own - right[row][column] + left[row][column]

    shifted = Symmetric(
        entry(A.xx, 0, 0), entry(A.yy, 1, 1), entry(A.zz, 2, 2),
        entry(A.xy, 0, 1), entry(A.xz, 0, 2), entry(A.yz, 1, 2),
    )  # fmt: skip
    return _Body(shifted, (moved[0], moved[1], moved[2]), M, plus(n, cross(r, f)), f)


def _sum(one: Symmetric, other: Symmetric) -> Symmetric:
    return Symmetric(*(u + v for u, v in zip(one.entries(), other.entries(), strict=True)))


def _less(k: Symmetric, u: Vector, v: Vector) -> Symmetric:
    """``k - u v^T``, which is symmetric."""
    return Symmetric(
        k.xx - u[0] * v[0], k.yy - u[1] * v[1], k.zz - u[2] * v[2],
        k.xy - u[0] * v[1], k.xz - u[0] * v[2], k.yz - u[1] * v[2],
    )  # fmt: skip


def _named(body: _Body, link: int, mark: Mark) -> _Body:
    def tensor(k: Symmetric, quantity: str) -> Symmetric:
        entries = zip(k.entries(), ("xx", "yy", "zz", "xy", "xz", "yz"), strict=True)
        return Symmetric(*(mark(value, Label(link, quantity, axes)) for value, axes in entries))

    x, y, z = (named(mark, row, link, f"B{axis}") for row, axis in zip(body.B, "xyz", strict=True))
    n, f = named(mark, body.n, link, "n"), named(mark, body.f, link, "f")
    return _Body(tensor(body.A, "A"), (x, y, z), tensor(body.M, "M"), n, f)
