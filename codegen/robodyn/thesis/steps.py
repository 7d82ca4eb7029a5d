"""The steps of the thesis's two Newton-Euler methods, one function each, over any scalar, and what each
costs.

Method II is the conventional recursion (Table 2.3), method I the one with the lambda matrix (Table 2.4, its
misprints mended). Written as those tables have them, term by term and with ``R`` a full 3x3 matrix, which is
how Table 2.9 counts them joint by joint. For kernels there are :mod:`robodyn.dynamics.modified_newton_euler`
and :mod:`robodyn.dynamics.newton_euler`.

Source: Dhanaraj 1990, Tables 2.3, 2.4 and 2.9. ``R`` is the rotation from a link's axes to those before,
``p`` the link's origin in the frame before, ``s`` its centre of mass.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

from robodyn.counts.count import Count
from robodyn.counts.general import Tally
from robodyn.dynamics.arm import Symmetric
from robodyn.dynamics.modified_newton_euler import Lambda, lambda_matrix
from robodyn.dynamics.transforms import Matrix, product, transposed, turned
from robodyn.dynamics.vectors import ZERO, Vector, cross, plus, scaled, unmarked

Method = Literal["I", "II"]


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


def lambda_rows(matrix: Matrix, k: Vector) -> Lambda:
    """A lambda matrix of those rows, ``k`` beside it."""
    x, y, z = ((row[0], row[1], row[2]) for row in matrix)
    return Lambda((x, y, z), k)


def lambda_turned(R: Matrix, before: Lambda) -> Lambda:
    """Step 2A of a prismatic joint: ``R^T lambda R``; ``k`` are the products of a symmetric tensor."""
    kx, ky, kz = before.k
    k = product(product(transposed(R), ((0, kz, ky), (kz, 0, kx), (ky, kx, 0))), R)
    return lambda_rows(product(product(transposed(R), before.rows), R), (k[1][2], k[2][0], k[0][1]))


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


def a_II(R: Matrix, a: Vector, w: Vector, alpha: Vector, p: Vector) -> Vector:
    """Step 3: ``R^T (a + alpha x p + w x (w x p))``, all of the link before."""
    return turned_back(R, a_c_II(a, w, alpha, p))


def slide_II(w: Vector, rate: Vector, double: Any = 2) -> Vector:
    """The Coriolis acceleration of a prismatic joint: ``2 w x rate``."""
    return scaled(double, cross(w, rate))


def a_c_II(a: Vector, w: Vector, alpha: Vector, s: Vector) -> Vector:
    """Step 4: ``a + alpha x s + w x (w x s)``."""
    return plus(a, plus(cross(alpha, s), cross(w, cross(w, s))))


def euler_II(inertia: Symmetric, w: Vector, alpha: Vector) -> Vector:
    """Step 6: ``I alpha + w x (I w)``."""
    return plus(inertia.times(alpha), cross(w, inertia.times(w)))


# --- Table 2.9 --------------------------------------------------------------------------------------------

#: How ``R`` is counted: full, or right-angled, all 0 and 1.
Rotation = Literal["full", "right-angled"]


class _Scratch:
    """Unknown numbers by the dozen, and what is done with them."""

    def __init__(self, rotation: Rotation, revolute: bool) -> None:
        self.ledger: dict[str, int] = {}
        self.rotation, self.revolute = rotation, revolute

    def number(self, fixed: bool = False) -> Any:
        """A number of the state, or of the model where ``fixed``."""
        return Tally(self.ledger, fixed)

    def vector(self, fixed: bool = False) -> Vector:
        return self.number(fixed), self.number(fixed), self.number(fixed)

    def R(self) -> Matrix:
        """The rotation of a joint."""
        if self.rotation == "right-angled":
            return ((1, 0, 0), (0, 0, -1), (0, 1, 0))
        return tuple(self.vector(not self.revolute) for _ in range(3))

    def lam(self) -> Lambda:
        return Lambda((self.vector(), self.vector(), self.vector()), self.vector())


def step_counts(method: Method, *, revolute: bool, rotation: Rotation = "full") -> dict[str, Count]:
    """Multiplications and additions of each step for one joint, by the row of Table 2.9.

    The thesis's convention there: ``R`` is a full matrix (a product with a vector is 9 multiplications and 6
    additions, although a DH matrix has a zero), tensors of inertia are diagonal in method I and full in
    method II, what depends on the model alone is free, and so is doubling the Coriolis acceleration of a
    prismatic joint. Behind such a joint the thesis takes ``R`` for right-angled, so that it costs nothing, in
    some rows and for full in others: hence both ways of counting.
    """
    counts = {}
    for row, step in (_steps_I if method == "I" else _steps_II)(revolute).items():
        scratch = _Scratch(rotation, revolute)
        step(scratch)
        counts[row] = Count(**scratch.ledger)
    return counts


_Steps = dict[str, Callable[[_Scratch], object]]


def _steps_I(revolute: bool) -> _Steps:
    def lam(x: _Scratch) -> object:
        if revolute or x.rotation == "full":  # formed anew, which is cheaper than R^T lambda R
            return lambda_I(x.vector(), x.vector())
        return lambda_turned(x.R(), x.lam())

    def a(x: _Scratch) -> object:
        a = a_I(x.R(), x.vector(), x.lam(), x.vector(fixed=revolute))
        return a if revolute else plus(a, slide_I(x.vector(), x.number(), x.number(), double=1))

    return {
        "omega": _turning(revolute, lambda x: omega(x.R(), x.vector(), x.number())),
        "alpha": _turning(revolute, lambda x: alpha_I(x.R(), x.vector(), x.vector(), x.number(), x.number())),
        "lambda": lam,
        "a": a,
        "a_c": lambda x: a_c_I(x.vector(), x.lam(), x.vector(fixed=True)),
        "F": _force,
        "N": lambda x: euler_I(Symmetric(*x.vector(fixed=True), *ZERO), x.vector(), x.vector()),
        "f": lambda x: plus(x.vector(), x.vector()),
        "f_rotated": lambda x: turned(x.R(), x.vector()),
        "n": _moment,
    }


def _steps_II(revolute: bool) -> _Steps:
    def a(x: _Scratch) -> object:
        a = a_II(x.R(), x.vector(), x.vector(), x.vector(), x.vector(fixed=revolute))
        return a if revolute else plus(a, slide_II(x.vector(), x.vector(), double=1), (0, 0, x.number()))

    return {
        "omega": _turning(revolute, lambda x: omega(x.R(), x.vector(), x.number())),
        "alpha": _turning(
            revolute, lambda x: alpha_II(x.R(), x.vector(), x.vector(), x.vector(), x.number())
        ),
        "lambda": lambda x: None,
        "a": a,
        "a_c": lambda x: a_c_II(x.vector(), x.vector(), x.vector(), x.vector(fixed=True)),
        "F": _force,
        "N": lambda x: euler_II(Symmetric(*x.vector(True), *x.vector(True)), x.vector(), x.vector()),
        "f": lambda x: plus(x.vector(), turned(x.R(), x.vector())),
        "f_rotated": lambda x: None,
        "n": _moment,
    }


def _turning(revolute: bool, step: Callable[[_Scratch], object]) -> Callable[[_Scratch], object]:
    """``step`` of a revolute joint; a prismatic one only turns what the link before has."""
    return step if revolute else lambda x: turned_back(x.R(), x.vector())


def _force(x: _Scratch) -> object:
    return inertial_force(x.number(fixed=True), x.vector())


def _moment(x: _Scratch) -> object:
    N, F, f_next = x.vector(), x.vector(), x.vector()
    return moment(N, x.vector(fixed=True), F, x.vector(fixed=True), f_next, turned(x.R(), x.vector()))
