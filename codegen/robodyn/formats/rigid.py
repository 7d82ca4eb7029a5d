"""Rigid bodies and poses put together: sums are exact before they are rounded, so decimals stay short."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from robodyn.formats.chain import Body, Pose, Vector, about_axis, product, scaled
from robodyn.formats.limits import ROUNDING
from robodyn.formats.quantities import turned_inertia
from robodyn.formats.tree import TURNING, TreeJoint
from robodyn.robot.numbers import shortest

_Exact = tuple[Fraction, Fraction, Fraction]


def composed(pose: Pose, child: Pose) -> Pose:
    """``child``, stated in the frame of ``pose``, as a pose in its parent."""
    if child == Pose():
        return pose
    return Pose(_position(pose, child.xyz), product(pose.rotation, child.rotation))


def carried(pose: Pose, body: Body) -> Body:
    """``body``, stated in the frame of ``pose``, in its parent."""
    if pose == Pose():
        return body
    return Body(body.mass, _position(pose, body.com), turned_inertia(pose.rotation, body.inertia))


def motion(joint: TreeJoint, position: float) -> Pose:
    """The motion of ``joint`` at ``position`` [rad or m]: the frame behind it in the frame before it.

    Joints of other kinds than revolute, continuous and prismatic are where the file puts them.
    """
    displacement = float(shortest(position) - shortest(joint.reference))
    if joint.kind in TURNING:
        return Pose(rotation=about_axis(joint.axis, displacement))
    if joint.kind == "prismatic":
        return Pose(scaled(displacement, joint.axis))
    return Pose()


def lumped(bodies: Iterable[Body]) -> Body:
    """One body out of several in the same frame, by the parallel axis theorem."""
    bodies = [body for body in bodies if body != Body()]
    if len(bodies) < 2:
        return bodies[0] if bodies else Body()
    masses = [shortest(body.mass) for body in bodies]
    centres = [_exact(body.com) for body in bodies]
    mass = sum(masses, Fraction(0))
    if mass:
        x, y, z = (
            sum((m * c[k] for m, c in zip(masses, centres, strict=True)), Fraction(0)) / mass
            for k in range(3)
        )
    else:
        x = y = z = Fraction(0)
    entries = [Fraction(0)] * 6
    for body, m, centre in zip(bodies, masses, centres, strict=True):
        dx, dy, dz = centre[0] - x, centre[1] - y, centre[2] - z
        steiner = (
            dy * dy + dz * dz, dx * dx + dz * dz, dx * dx + dy * dy, -dx * dy, -dx * dz, -dy * dz
        )  # fmt: skip
        for k in range(6):
            entries[k] += shortest(body.inertia[k]) + m * steiner[k]
    xx, yy, zz, xy, xz, yz = map(float, entries)
    return Body(float(mass), (float(x), float(y), float(z)), (xx, yy, zz, xy, xz, yz))


def _position(pose: Pose, point: Vector) -> Vector:
    """``R point + xyz``, rounded once an entry."""
    inner = _exact(point)
    x, y, z = (
        float(shortest(origin) + sum((shortest(r) * c for r, c in zip(row, inner, strict=True)), Fraction(0)))
        for origin, row in zip(pose.xyz, pose.rotation, strict=True)
    )
    return (x, y, z)


def _exact(vector: Vector) -> _Exact:
    x, y, z = map(shortest, vector)
    return (x, y, z)


def tidy(pose: Pose) -> Pose:
    """``pose`` with 0 and +-1 in the rotation where rounding left something else."""
    a, b, c = ((_entry(row[0]), _entry(row[1]), _entry(row[2])) for row in pose.rotation)
    return Pose(pose.xyz, (a, b, c))


def _entry(x: float) -> float:
    whole = round(x)
    return float(whole) if abs(x - whole) <= ROUNDING else x
