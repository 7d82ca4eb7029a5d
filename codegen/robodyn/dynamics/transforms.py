"""Matrices of scalars of any kind: 3x3 rotations, 4x4 transforms, their derivatives, pseudo-inertias.

The Lagrangian formulations are written with them. Sources: Uicker 1965; Hollerbach 1980; Paul, Robot
Manipulators (1981), chapter 6.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm, Body, Motion, origin
from robodyn.dynamics.vectors import Mark, Vector
from robodyn.ir.program import Label

#: A matrix by rows: 3x3, 4x4, or a column vector.
Matrix = tuple[tuple[Any, ...], ...]

IDENTITY_3: Matrix = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
IDENTITY_4: Matrix = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))
ZERO_3: Matrix = ((0, 0, 0),) * 3
ZERO_4: Matrix = ((0, 0, 0, 0),) * 4

#: ``Q`` of ``dA/dq = A Q`` for a revolute joint (about z): for rotations and for transforms.
TURN_3: Matrix = ((0, -1, 0), (1, 0, 0), (0, 0, 0))
TURN_4: Matrix = ((0, -1, 0, 0), (1, 0, 0, 0), (0, 0, 0, 0), (0, 0, 0, 0))
#: ``Q`` of ``dA/dq = A Q`` for a prismatic joint (along z).
SLIDE_4: Matrix = ((0, 0, 0, 0), (0, 0, 0, 0), (0, 0, 0, 1), (0, 0, 0, 0))


def product(A: Matrix, B: Matrix) -> Matrix:
    """``A B``."""
    columns = transposed(B)
    return tuple(tuple(inner(row, column) for column in columns) for row in A)


def inner(u: tuple[Any, ...], v: tuple[Any, ...]) -> Any:
    """``u^T v``."""
    total = u[0] * v[0]
    for x, y in zip(u[1:], v[1:], strict=True):
        total = total + x * y
    return total


def applied(A: Matrix, u: tuple[Any, ...]) -> tuple[Any, ...]:
    """``A u``."""
    return tuple(inner(row, u) for row in A)


def turned(R: Matrix, u: Vector) -> Vector:
    """``R u``."""
    x, y, z = applied(R, u)
    return x, y, z


def outer(u: tuple[Any, ...], v: tuple[Any, ...]) -> Matrix:
    """``u v^T``."""
    return tuple(tuple(x * y for y in v) for x in u)


def summed(*matrices: Matrix) -> Matrix:
    """Sum of matrices, from left to right."""
    first, *rest = matrices
    for other in rest:
        first = tuple(
            tuple(x + y for x, y in zip(row, other_row, strict=True))
            for row, other_row in zip(first, other, strict=True)
        )
    return first


def times(factor: Any, A: Matrix) -> Matrix:
    """``factor A``."""
    return tuple(tuple(factor * x for x in row) for row in A)


def transposed(A: Matrix) -> Matrix:
    """``A^T``."""
    return tuple(zip(*A, strict=True))


def trace(A: Matrix) -> Any:
    """Sum of the diagonal."""
    total = A[0][0]
    for i in range(1, len(A)):
        total = total + A[i][i]
    return total


def marked(mark: Mark, A: Matrix, link: int, quantity: str, prefix: str = "") -> Matrix:
    """``A`` with each entry marked as ``quantity`` of ``link``; the index is ``prefix`` + row + column."""
    return tuple(
        tuple(mark(x, Label(link, quantity, f"{prefix}{i}{j}")) for j, x in enumerate(row, 1))
        for i, row in enumerate(A, 1)
    )


def rotation(body: Body, c: Any, s: Any) -> Matrix:
    """The rotation ``R`` [3, 3] from the link's axes to the parent's axes."""
    ca, sa = body.cos_alpha, body.sin_alpha
    return ((c, -s, 0), (ca * s, ca * c, -sa), (sa * s, sa * c, ca))


def transform(body: Body, c: Any, s: Any, d: Any) -> Matrix:
    """The transform ``A`` [4, 4] of points ``(x, y, z, 1)`` [m] from the link's frame to the parent's."""
    rows = zip(rotation(body, c, s), origin(body, d), strict=True)
    return (*((*row, p) for row, p in rows), (0, 0, 0, 1))


def poses(arm: Arm, motion: Motion) -> list[Matrix]:
    """Transforms [4, 4] from the frames of the links and of the tool to the world."""
    base, tool = (
        (*((*row, p) for row, p in zip(frame.rotation(), frame.origin, strict=True)), (0, 0, 0, 1))
        for frame in (arm.base, arm.tool)
    )
    transforms, last = [], base
    for body, c, s, d in zip(arm.bodies, motion.c, motion.s, motion.d, strict=True):
        last = product(last, transform(body, c, s, d))
        transforms.append(last)
    return [*transforms, product(last, tool)]


def axial(W: Matrix) -> list[Any]:
    """The vector of a skew matrix [3, 3]."""
    return [W[2][1], W[0][2], W[1][0]]


def joint_operator(body: Body) -> Matrix:
    """``Q`` [4, 4] of ``dA/dq = A Q`` for the joint's own variable: Uicker's operator. ``Q`` is on the right
    because in these frames the joint's axis is the z axis of the link that it carries."""
    return TURN_4 if body.revolute else SLIDE_4


def homogeneous(r: Vector) -> tuple[Any, ...]:
    """``(x, y, z, 1)``."""
    return (*r, 1)


def second_moment(body: Body) -> Matrix:
    """``integral of r r^T dm`` [3, 3] about the frame's origin, along the link's axes [kg m^2]."""
    i, m, (x, y, z) = body.inertia, body.mass, body.com
    half = Fraction(1, 2)
    xx = half * (i.yy + i.zz - i.xx) + m * x * x
    yy = half * (i.xx + i.zz - i.yy) + m * y * y
    zz = half * (i.xx + i.yy - i.zz) + m * z * z
    xy, xz, yz = m * x * y - i.xy, m * x * z - i.xz, m * y * z - i.yz
    return ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))


def first_moment(body: Body) -> Vector:
    """``m r`` [kg m] about the frame's origin."""
    x, y, z = body.com
    return body.mass * x, body.mass * y, body.mass * z


def pseudo_inertia(body: Body) -> Matrix:
    """``J`` [4, 4] = ``integral of (x, y, z, 1)^T (x, y, z, 1) dm`` [kg m^2, kg m, kg]."""
    n = first_moment(body)
    rows = zip(second_moment(body), n, strict=True)
    return (*((*row, h) for row, h in rows), (*n, body.mass))
