"""Steps of the recursion as the thesis prints them, one slip a class.

Source: Dhanaraj 1990, Tables 2.2 to 2.4 and 4.1, Eqs 2.22 to 2.39, 4.3, 4.5, B.11, B.13, D.2, D.3.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

from robodyn.dynamics.arm import Arm, Body, Motion, origin
from robodyn.dynamics.modified_newton_euler import Lambda
from robodyn.dynamics.transforms import Matrix, product, rotation, transposed
from robodyn.dynamics.vectors import ZERO, Vector, cross, plus, scaled
from robodyn.thesis import method_steps as steps
from robodyn.thesis.slips.recursion import Recursion


class Unbracketed(Recursion):
    """2.22: ``w x w x r`` from the left."""

    def relative(self, w: Vector, alpha: Vector, lam: Lambda, r: Vector) -> Vector:
        return plus(cross(alpha, r), cross(cross(w, w), r))


class _Entry(Recursion, ABC):
    """Entries of lambda, by row and column from 1, as they are printed."""

    @abstractmethod
    def entries(self, w: Vector, alpha: Vector) -> dict[tuple[int, int], Any]:
        """The entries of the matrix of angular velocity ``w`` and acceleration ``alpha``."""

    def lambda_of(self, i: int, w: Vector, alpha: Vector) -> Lambda:
        return replaced(steps.lambda_I(w, alpha), self.entries(w, alpha))


class SquareIn31(_Entry):
    """2.25, 2.27: (3,1) begins with ``w_x w_x``."""

    def entries(self, w: Vector, alpha: Vector) -> dict[tuple[int, int], Any]:
        return {(3, 1): w[0] * w[0] - alpha[1]}


class MinusIn21(_Entry):
    """2.30, 2.31: (2,1) has ``- alpha_z``."""

    def entries(self, w: Vector, alpha: Vector) -> dict[tuple[int, int], Any]:
        return {(2, 1): w[0] * w[1] - alpha[2]}


class XIn21(_Entry):
    """Table 2.4: lambda_21 is ``k_x + alpha_x``."""

    def entries(self, w: Vector, alpha: Vector) -> dict[tuple[int, int], Any]:
        return {(2, 1): w[1] * w[2] + alpha[0]}


class ExchangedT10(_Entry):
    """Table 4.1, T10: ``k_x + alpha_x`` for lambda_21 and ``k_z + alpha_z`` for lambda_32."""

    def entries(self, w: Vector, alpha: Vector) -> dict[tuple[int, int], Any]:
        return {(2, 1): w[1] * w[2] + alpha[0], (3, 2): w[0] * w[1] + alpha[2]}


class CarriedForth(Recursion):
    """2.29: ``R lambda R^T``; only lambda, as its products ``k`` are formed from the rates."""

    def lambda_carried(self, R: Matrix, before: Lambda) -> Lambda:
        return Lambda(_rows(product(product(R, before.rows), transposed(R))), _k(R, before))


class SignsOf37(Recursion):
    """2.37: ``-l13, +l12, -l31, +l21`` at (1,2), (1,3), (2,1) and (3,1)."""

    def lambda_carried(self, R: Matrix, before: Lambda) -> Lambda:
        right = steps.lambda_carried(R, before)
        entries = ((1, 2), (1, 3), (2, 1), (3, 1))
        return replaced(right, {(i, j): -right.rows[i - 1][j - 1] for i, j in entries})


class PlusIn36(Recursion):
    """2.36: (2,1) is ``w_2x w_2z + alpha_2y``, which is lambda_2's (1,3)."""

    def lambda_carried(self, R: Matrix, before: Lambda) -> Lambda:
        return replaced(steps.lambda_carried(R, before), {(2, 1): before.rows[0][2]})


class MiddleOf38(Recursion):
    """2.38: (2,2) of the matrix that is turned is ``l33``."""

    def lambda_carried(self, R: Matrix, before: Lambda) -> Lambda:
        turned = replaced(before, {(2, 2): before.rows[2][2]})
        return Lambda(steps.lambda_carried(R, turned).rows, _k(R, before))


class MomentAboutX(Recursion):
    """Table 2.3, step 9: ``n_x``."""

    def torque(self, body: Body, f: Vector, n: Vector) -> Any:
        return n[0] if body.revolute else f[2]


class MomentOfSlide(Recursion):
    """Table 2.4, step 9: ``n_z`` for every joint."""

    def torque(self, body: Body, f: Vector, n: Vector) -> Any:
        return n[2]


class OtherDx(Recursion):
    """Table 2.4: ``D_x = Ixx - Iyy``."""

    def euler(self, body: Body, alpha: Vector, lam: Lambda) -> Vector:
        i = body.inertia
        turning = ((i.xx - i.yy) * lam.k[0], (i.xx - i.zz) * lam.k[1], (i.yy - i.xx) * lam.k[2])
        return plus((i.xx * alpha[0], i.yy * alpha[1], i.zz * alpha[2]), turning)


class ForceAlongItsOwnAxes(Recursion):
    """Table 2.4, step 8, and 4.15: ``f_(i+1)`` taken along the axes of link i + 1."""

    def moment(
        self, N: Vector, s: Vector, F: Vector, p: Vector, f_next: tuple[Vector, Vector], n_next: Vector
    ) -> Vector:
        return steps.moment(N, s, F, p, f_next[1], n_next)


class SlideInside(Recursion):
    """B.11, B.13: ``z qdd`` and the Coriolis acceleration turned by ``R^T`` with the rest."""

    def slide(self, R: Matrix, moved: Vector, w: Vector, qd: Any, qdd: Any) -> Vector:
        return steps.turned_back(R, plus(moved, steps.slide_I(w, qd, qdd)))


class Transposed(Recursion):
    """4.3, 4.5: ``R^T`` under the name of ``R``."""

    def rotation(self, i: int, body: Body, c: Any, s: Any) -> Matrix:
        return transposed(rotation(body, c, s))


class GravityAsCentre(Recursion):
    """Table 4.1, T20 to T22: products of lambda and ``g``."""

    def centre(self, body: Body, gravity: Vector) -> Vector:
        return gravity


class DiagonalLambda1(Recursion):
    """D.2: lambda of link 1 is ``diag(0, 0, V1^2 - A1)``."""

    def lambda_of(self, i: int, w: Vector, alpha: Vector) -> Lambda:
        right = steps.lambda_I(w, alpha)
        if i > 0:
            return right
        return Lambda((ZERO, ZERO, (0, 0, w[2] * w[2] - alpha[2])), right.k)


class SlideInNextRow(Recursion):
    """Table 2.2, D.3: the displacement of a prismatic joint in the origin of the link beyond."""

    def origins(self, arm: Arm, motion: Motion) -> list[Vector]:
        origins = super().origins(arm, motion)
        for i, body in enumerate(arm.bodies[:-1]):
            if not body.revolute:
                beyond = arm.bodies[i + 1]
                origins[i] = origin(body, body.d)
                shift = motion.d[i] - body.d
                origins[i + 1] = origin(beyond, motion.d[i + 1] + shift)
        return origins


class TwistAndAngleExchanged(Recursion):
    """Table 2.2: joint 3 of the Stanford arm with alpha 0 and theta pi/2."""

    def rotation(self, i: int, body: Body, c: Any, s: Any) -> Matrix:
        return rotation(body, c, s) if body.revolute else ((0, -1, 0), (1, 0, 0), (0, 0, 1))


class MassLostInLink3(Recursion):
    """D.3.3: ``a`` without the mass in the force of link 3."""

    def force(self, i: int, mass: Any, a: Vector, relative: Vector) -> Vector:
        return plus(scaled(mass, relative), a) if i == 2 else super().force(i, mass, a, relative)


def replaced(lam: Lambda, entries: dict[tuple[int, int], Any]) -> Lambda:
    """``lam`` with ``entries`` by row and column from 1; ``k`` stays."""
    rows = [list(row) for row in lam.rows]
    for (i, j), value in entries.items():
        rows[i - 1][j - 1] = value
    return Lambda(_rows(rows), lam.k)


def _rows(matrix: Any) -> tuple[Vector, Vector, Vector]:
    x, y, z = ((row[0], row[1], row[2]) for row in matrix)
    return x, y, z


def _k(R: Matrix, before: Lambda) -> Vector:
    return steps.lambda_carried(R, before).k
