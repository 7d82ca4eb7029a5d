"""The steps of the thesis's two Newton-Euler methods, one function each, over any scalar.

Method II is the conventional recursion (Table 2.3), method I the one with the lambda matrix (Table 2.4, its
misprints mended). Written as those tables have them, term by term and with ``R`` a full 3x3 matrix, which is
how Table 2.9 counts them joint by joint; :func:`by_steps` puts the steps together to the recursion. For
kernels there are :mod:`robodyn.dynamics.modified_newton_euler` and :mod:`robodyn.dynamics.newton_euler`.

Source: Dhanaraj 1990, Tables 2.3, 2.4 and 2.9. ``R`` is the rotation from a link's axes to those before,
``p`` the link's origin in the frame before, ``s`` its centre of mass.
"""

from __future__ import annotations

from typing import Any, Literal

from robodyn.dynamics.arm import Arm, Motion, Symmetric, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.modified_newton_euler import NO_ROTATION, Lambda, lambda_matrix
from robodyn.dynamics.transforms import Matrix, applied, product, rotation, transposed
from robodyn.dynamics.vectors import ZERO, Vector, cross, plus, scaled, unmarked

Method = Literal["I", "II"]


def turned(R: Matrix, u: Vector) -> Vector:
    """``R u``."""
    x, y, z = applied(R, u)
    return x, y, z


def turned_back(R: Matrix, u: Vector) -> Vector:
    """``R^T u``."""
    return turned(transposed(R), u)


# --- what both methods have -------------------------------------------------------------------------------


def omega(R: Matrix, w: Vector, qd: Any) -> Vector:
    """Step 1: ``R^T w + z qd`` of a revolute joint."""
    return plus(turned_back(R, w), (0, 0, qd))


def inertial_force(mass: Any, a_c: Vector) -> Vector:
    """Step 5: ``F = m a_c``."""
    return scaled(mass, a_c)


def moment(N: Vector, s: Vector, F: Vector, p_next: Vector, f_next: Vector, n_next: Vector) -> Vector:
    """Step 8: ``n = N + s x F + p x (R f) + R n``, ``f_next`` and ``n_next`` being ``R f`` and ``R n``."""
    return plus(N, cross(p_next, f_next), cross(s, F), n_next)


# --- method I: the lambda matrix --------------------------------------------------------------------------


def alpha_I(R: Matrix, alpha: Vector, w: Vector, qd: Any, qdd: Any) -> Vector:
    """Step 2: ``R^T alpha + (w_y qd, -w_x qd, qdd)``, ``w`` being the link's own."""
    return plus(turned_back(R, alpha), (w[1] * qd, -(w[0] * qd), qdd))


def lambda_I(w: Vector, alpha: Vector) -> Lambda:
    """Step 2A of a revolute joint."""
    return lambda_matrix(w, alpha, 0, unmarked)


def lambda_carried(R: Matrix, before: Lambda) -> Lambda:
    """Step 2A of a prismatic joint: ``R^T lambda R``; ``k`` are the products of a symmetric tensor."""
    kx, ky, kz = before.k
    rows = product(product(transposed(R), before.rows), R)
    k = product(product(transposed(R), ((0, kz, ky), (kz, 0, kx), (ky, kx, 0))), R)
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rows
    return Lambda(((xx, xy, xz), (yx, yy, yz), (zx, zy, zz)), (k[1][2], k[2][0], k[0][1]))


def a_I(R: Matrix, a: Vector, before: Lambda, p: Vector) -> Vector:
    """Step 3: ``R^T (a + lambda p)``, both of the link before."""
    return turned_back(R, plus(a, before.times(p)))


def slide_I(w: Vector, qd: Any, qdd: Any, double: Any = 2) -> Vector:
    """What a prismatic joint adds in step 3: ``2 (w_y qd, -w_x qd, 0) + z qdd``."""
    rate = double * qd
    return rate * w[1], -(rate * w[0]), qdd


def a_c_I(a: Vector, lam: Lambda, s: Vector) -> Vector:
    """Step 4: ``a + lambda s``."""
    return plus(a, lam.times(s))


def euler_I(inertia: Symmetric, alpha: Vector, k: Vector) -> Vector:
    """Step 6: ``I alpha + D k`` (Eq 2.41) of a diagonal tensor, ``D = (Izz - Iyy, Ixx - Izz, Iyy - Ixx)``."""
    i = inertia
    return plus(
        (i.xx * alpha[0], i.yy * alpha[1], i.zz * alpha[2]),
        ((i.zz - i.yy) * k[0], (i.xx - i.zz) * k[1], (i.yy - i.xx) * k[2]),
    )


# --- method II: cross products ----------------------------------------------------------------------------


def alpha_II(R: Matrix, alpha: Vector, w: Vector, rate: Vector, qdd: Any) -> Vector:
    """Step 2: ``R^T alpha + (R^T w) x rate + z qdd``, ``w`` of the link before, ``rate`` the vector
    ``z qd``: the table forms ``R^T w`` anew and the cross product in full."""
    return plus(plus(turned_back(R, alpha), cross(turned_back(R, w), rate)), (0, 0, qdd))


def relative(w: Vector, alpha: Vector, r: Vector) -> Vector:
    """``alpha x r + w x (w x r)``."""
    return plus(cross(alpha, r), cross(w, cross(w, r)))


def a_II(R: Matrix, a: Vector, w: Vector, alpha: Vector, p: Vector) -> Vector:
    """Step 3: ``R^T (a + alpha x p + w x (w x p))``, all of the link before."""
    return turned_back(R, plus(a, relative(w, alpha, p)))


def slide_II(w: Vector, rate: Vector, double: Any = 2) -> Vector:
    """The Coriolis acceleration of a prismatic joint: ``2 w x rate``."""
    return scaled(double, cross(w, rate))


def a_c_II(a: Vector, w: Vector, alpha: Vector, s: Vector) -> Vector:
    """Step 4: ``a + alpha x s + w x (w x s)``."""
    return plus(a, relative(w, alpha, s))


def euler_II(inertia: Symmetric, w: Vector, alpha: Vector) -> Vector:
    """Step 6: ``I alpha + w x (I w)``."""
    return plus(inertia.times(alpha), cross(w, inertia.times(w)))


# --- the recursion ----------------------------------------------------------------------------------------


def by_steps(arm: Arm, motion: Motion, method: Method) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``, step by step.

    Method I takes tensors of inertia for diagonal.
    """
    gx, gy, gz = arm.gravity
    w, alpha, a, lam = ZERO, ZERO, (-gx, -gy, -gz), NO_ROTATION
    rotations, origins, forces, moments = [], [], [], []
    for i, body in enumerate(arm.bodies):
        R, p = rotation(body, motion.c[i], motion.s[i]), origin(body, motion.d[i])
        qd, qdd = motion.qd[i], motion.qdd[i]
        a = a_I(R, a, lam, p) if method == "I" else a_II(R, a, w, alpha, p)
        w, alpha, lam = _turning(method, body.revolute, R, w, alpha, lam, qd, qdd)
        if not body.revolute:
            if method == "I":
                a = plus(a, slide_I(w, qd, qdd))
            else:
                a = plus(a, slide_II(w, (0, 0, qd)), (0, 0, qdd))
        a_c = a_c_I(a, lam, body.com) if method == "I" else a_c_II(a, w, alpha, body.com)
        euler = euler_I(body.inertia, alpha, lam.k) if method == "I" else euler_II(body.inertia, w, alpha)
        rotations.append(R)
        origins.append(p)
        forces.append(inertial_force(body.mass, a_c))
        moments.append(euler)
    torques: list[Any] = [None] * len(arm.bodies)
    f_next = n_next = p_next = ZERO
    for i in reversed(range(len(arm.bodies))):
        body = arm.bodies[i]
        n = moment(moments[i], body.com, forces[i], p_next, f_next, n_next)
        f = plus(forces[i], f_next)
        torques[i] = joint_torque(arm, i, motion, n[2] if body.revolute else f[2], unmarked)
        f_next, n_next, p_next = turned(rotations[i], f), turned(rotations[i], n), origins[i]
    return torques


def _turning(
    method: Method, revolute: bool, R: Matrix, w: Vector, alpha: Vector, lam: Lambda, qd: Any, qdd: Any
) -> tuple[Vector, Vector, Lambda]:
    """``w``, ``alpha`` and lambda (method I) of the link, from those of the link before."""
    if not revolute:
        carried = lambda_carried(R, lam) if method == "I" else NO_ROTATION
        return turned_back(R, w), turned_back(R, alpha), carried
    now = omega(R, w, qd)
    if method == "II":
        return now, alpha_II(R, alpha, w, (0, 0, qd), qdd), NO_ROTATION
    alpha = alpha_I(R, alpha, now, qd, qdd)
    return now, alpha, lambda_I(now, alpha)
