"""The thesis's recursion, step by step, with a step as it is printed in the place of the right one.

A :class:`Recursion` has the steps of Table 2.4 (method I), right; :data:`SLIPS` have one step each as the
thesis prints it. Torques of both are held against the plain Newton-Euler recursion of
:mod:`robodyn.verify.reference`, which shares nothing with them but the robot.
Source: Dhanaraj 1990, Tables 2.2 to 2.4 and 4.1, Eqs 2.22 to 2.39, 4.3, 4.5, B.7 to B.13, D.2, D.3.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.dynamics.arm import Arm, Body, Motion, build_arm, build_motion, origin, trigonometry_at
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.modified_newton_euler import NO_ROTATION, Lambda
from robodyn.dynamics.transforms import Matrix, product, rotation, transposed, turned
from robodyn.dynamics.vectors import ZERO, Vector, cross, plus, scaled, unmarked
from robodyn.robot.model import Robot
from robodyn.thesis import steps
from robodyn.thesis.printed import bundled
from robodyn.thesis.slips import Comparison, compare
from robodyn.verify.numbers import real
from robodyn.verify.reference import Reference

States = tuple[Floats, Floats, Floats]

#: States drawn for a comparison, and reaches of positions, rates and accelerations [rad or m, per second].
STATES: Final = 1000
REACH: Final = (3.0, 2.0, 3.0)
_SEED: Final = 1990


class Recursion:
    """The steps of Table 2.4 as they must be, over any scalar, but those that are given in their place; ``i``
    counts links from 0."""

    def __init__(self, **given: Callable[..., Any]) -> None:
        vars(self).update(given)

    def rotation(self, body: Body, c: Any, s: Any) -> Matrix:
        """From the link's axes to those before."""
        return rotation(body, c, s)

    def origins(self, arm: Arm, motion: Motion) -> list[Vector]:
        """The links' origins in the frames before [m]."""
        return [origin(body, d) for body, d in zip(arm.bodies, motion.d, strict=True)]

    def lambda_of(self, i: int, w: Vector, alpha: Vector) -> Lambda:
        """Step 2A of a revolute joint."""
        return steps.lambda_I(w, alpha)

    def lambda_turned(self, R: Matrix, before: Lambda) -> Lambda:
        """Step 2A of a prismatic joint."""
        return steps.lambda_turned(R, before)

    def relative(self, w: Vector, alpha: Vector, lam: Lambda, r: Vector) -> Vector:
        """Acceleration of ``r`` relative to the origin, in steps 3 and 4."""
        return lam.times(r)

    def centre(self, body: Body, gravity: Vector) -> Vector:
        """The point of step 4."""
        return body.com

    def slide(self, R: Matrix, moved: Vector, w: Vector, qd: Any, qdd: Any) -> Vector:
        """Step 3 of a prismatic joint, ``moved`` being ``a + lambda p`` in the frame before."""
        return plus(steps.turned_back(R, moved), steps.slide_I(w, qd, qdd))

    def force(self, i: int, mass: Any, a: Vector, relative: Vector) -> Vector:
        """Step 5, of ``a_c = a + relative``."""
        return steps.inertial_force(mass, plus(a, relative))

    def euler(self, body: Body, alpha: Vector, lam: Lambda) -> Vector:
        """Step 6."""
        return steps.euler_I(body.inertia, alpha, lam.k)

    def force_beyond(self, along_this_link: Vector, along_its_own: Vector) -> Vector:
        """The force of the link beyond in step 8."""
        return along_this_link

    def torque(self, body: Body, f: Vector, n: Vector) -> Any:
        """Step 9."""
        return n[2] if body.revolute else f[2]

    def torques(self, arm: Arm, motion: Motion) -> list[Any]:
        """Joint torques [n] (N m; N at prismatic joints)."""
        gx, gy, gz = arm.gravity
        w, alpha, a, lam = ZERO, ZERO, (-gx, -gy, -gz), NO_ROTATION
        rotations, forces, moments = [], [], []
        origins = self.origins(arm, motion)
        for i, body in enumerate(arm.bodies):
            R = self.rotation(body, motion.c[i], motion.s[i])
            qd, qdd = motion.qd[i], motion.qdd[i]
            moved = plus(a, self.relative(w, alpha, lam, origins[i]))
            if body.revolute:
                a = steps.turned_back(R, moved)
                w = steps.omega(R, w, qd)
                alpha = steps.alpha_I(R, alpha, w, qd, qdd)
                lam = self.lambda_of(i, w, alpha)
            else:
                w, alpha = steps.turned_back(R, w), steps.turned_back(R, alpha)
                a = self.slide(R, moved, w, qd, qdd)
                lam = self.lambda_turned(R, lam)
            point = self.centre(body, arm.gravity)
            forces.append(self.force(i, body.mass, a, self.relative(w, alpha, lam, point)))
            moments.append(self.euler(body, alpha, lam))
            rotations.append(R)
        torques: list[Any] = [None] * len(arm.bodies)
        f_next, f_own, n_next, p_next = ZERO, ZERO, ZERO, ZERO
        for i in reversed(range(len(arm.bodies))):
            body = arm.bodies[i]
            beyond = self.force_beyond(f_next, f_own)
            n = steps.moment(moments[i], body.com, forces[i], p_next, beyond, n_next)
            f_own = plus(forces[i], f_next)
            torques[i] = joint_torque(arm, i, motion, self.torque(body, f_own, n), unmarked)
            f_next, n_next, p_next = turned(rotations[i], f_own), turned(rotations[i], n), origins[i]
        return torques


# --- slips ------------------------------------------------------------------------------------------------


def with_entries(lam: Lambda, entries: Mapping[tuple[int, int], Any]) -> Lambda:
    """``lam`` with ``entries`` by row and column from 1; ``k`` stays."""
    rows = [[entries.get((i, j), x) for j, x in enumerate(row, 1)] for i, row in enumerate(lam.rows, 1)]
    return steps.lambda_rows(tuple(map(tuple, rows)), lam.k)


def _formed(entries: Callable[[Vector, Vector], Mapping[tuple[int, int], Any]]) -> Recursion:
    """Some entries of lambda, formed of ``w`` and ``alpha``, as they are printed."""
    return Recursion(lambda_of=lambda i, w, alpha: with_entries(steps.lambda_I(w, alpha), entries(w, alpha)))


def _other_way(R: Matrix, before: Lambda) -> Lambda:
    """``R lambda R^T``; only lambda, as its products ``k`` are formed from the rates."""
    rows = product(product(R, before.rows), transposed(R))
    return steps.lambda_rows(rows, steps.lambda_turned(R, before).k)


def _middle(R: Matrix, before: Lambda) -> Lambda:
    """``R^T lambda R`` with l33 for the l22 of lambda; its products ``k`` are formed from the rates."""
    turned_back = steps.lambda_turned(R, with_entries(before, {(2, 2): before.rows[2][2]}))
    return Lambda(turned_back.rows, steps.lambda_turned(R, before).k)


def _signs(R: Matrix, before: Lambda) -> Lambda:
    right = steps.lambda_turned(R, before)
    negated = ((1, 2), (1, 3), (2, 1), (3, 1))
    return with_entries(right, {(i, j): -right.rows[i - 1][j - 1] for i, j in negated})


def _other_dx(body: Body, alpha: Vector, lam: Lambda) -> Vector:
    i, (kx, ky, kz) = body.inertia, lam.k
    turning = ((i.xx - i.yy) * kx, (i.xx - i.zz) * ky, (i.yy - i.xx) * kz)
    return plus((i.xx * alpha[0], i.yy * alpha[1], i.zz * alpha[2]), turning)


def _diagonal(i: int, w: Vector, alpha: Vector) -> Lambda:
    right = steps.lambda_I(w, alpha)
    return right if i else Lambda((ZERO, ZERO, (0, 0, w[2] * w[2] - alpha[2])), right.k)


def _slide_beyond(arm: Arm, motion: Motion) -> list[Vector]:
    """Origins with the displacement of a prismatic joint in that of the link beyond."""
    origins = Recursion().origins(arm, motion)
    for i, body in enumerate(arm.bodies[:-1]):
        if not body.revolute:
            origins[i] = origin(body, body.d)
            origins[i + 1] = origin(arm.bodies[i + 1], motion.d[i + 1] + (motion.d[i] - body.d))
    return origins


#: The recursion with one step as it is printed.
SLIPS: Final = {
    "w x w x r from the left": Recursion(
        relative=lambda w, alpha, lam, r: plus(cross(alpha, r), cross(cross(w, w), r))
    ),
    "(3,1) begins with w_x w_x": _formed(lambda w, alpha: {(3, 1): w[0] * w[0] - alpha[1]}),
    "(2,1) has - alpha_z": _formed(lambda w, alpha: {(2, 1): w[0] * w[1] - alpha[2]}),
    "lambda_21 = k_x + alpha_x": _formed(lambda w, alpha: {(2, 1): w[1] * w[2] + alpha[0]}),
    "x and z of T10 exchanged": _formed(
        lambda w, alpha: {(2, 1): w[1] * w[2] + alpha[0], (3, 2): w[0] * w[1] + alpha[2]}
    ),
    "R lambda R^T": Recursion(lambda_turned=_other_way),
    "signs of 2.37": Recursion(lambda_turned=_signs),
    "(2,1) of 2.36 is (1,3) of lambda_2": Recursion(
        lambda_turned=lambda R, before: with_entries(
            steps.lambda_turned(R, before), {(2, 1): before.rows[0][2]}
        )
    ),
    "l33 for l22": Recursion(lambda_turned=_middle),
    "n_x": Recursion(torque=lambda body, f, n: n[0] if body.revolute else f[2]),
    "n_z of a slide": Recursion(torque=lambda body, f, n: n[2]),
    "D_x = Ixx - Iyy": Recursion(euler=_other_dx),
    "f along its own axes": Recursion(force_beyond=lambda along_this_link, along_its_own: along_its_own),
    "the slide within R^T": Recursion(
        slide=lambda R, moved, w, qd, qdd: steps.turned_back(R, plus(moved, steps.slide_I(w, qd, qdd)))
    ),
    "R^T for R": Recursion(rotation=lambda body, c, s: transposed(rotation(body, c, s))),
    "g for s": Recursion(centre=lambda body, gravity: gravity),
    "lambda_1 diagonal": Recursion(lambda_of=_diagonal),
    "q3 in the origin beyond": Recursion(origins=_slide_beyond),
    "alpha 0 and theta pi/2 of the slide": Recursion(
        rotation=lambda body, c, s: (
            rotation(body, c, s) if body.revolute else ((0, -1, 0), (1, 0, 0), (0, 0, 1))
        )
    ),
    "link 3's mass on a part": Recursion(
        force=lambda i, mass, a, relative: (
            plus(scaled(mass, relative), a) if i == 2 else steps.inertial_force(mass, plus(a, relative))
        )
    ),
    "none": Recursion(),
}


# --- against Newton-Euler ---------------------------------------------------------------------------------


def states(robot: Robot) -> States:
    """Positions, rates and accelerations [K, n] at random."""
    rng = np.random.default_rng(_SEED)
    q, qd, qdd = (rng.uniform(-reach, reach, (STATES, robot.n)) for reach in REACH)
    return q, qd, qdd


def scalars(robot: Robot, at: States) -> tuple[Arm, Motion]:
    """``robot`` in floats and its motion in arrays over the states ``at``."""
    none: dict[str, float] = {}
    arm = build_arm(robot, real, none.__getitem__)
    q, qd, qdd = (list(x.T) for x in at)
    return arm, build_motion(arm, q, qd, qdd, trigonometry_at(q), real)


def stacked(torques: list[Any]) -> Floats:
    """Torques [K, n] from those of the joints."""
    return np.stack([np.broadcast_to(np.asarray(x, dtype=np.float64), STATES) for x in torques], axis=1)


def torques_of(robot: Robot, at: States | None = None, recursion: Recursion | None = None) -> Floats:
    """Torques [K, n] by the right recursion or another, at :func:`states` or at others."""
    return stacked((recursion or Recursion()).torques(*scalars(robot, at or states(robot))))


@cache
def newton_euler(name: str) -> Floats:
    """Torques [K, n] of the plain recursion at :func:`states`."""
    robot = bundled(name)
    return Reference(robot).inverse_dynamics(*states(robot))


def against_newton_euler(
    name: str, run: Callable[[Any], list[Any]], right: Callable[[Any], list[Any]]
) -> Comparison:
    """A printed ``run`` from an arm in motion to torques, and the ``right`` one, of a bundled robot."""
    robot = bundled(name)
    at = scalars(robot, states(robot))
    against = f"torques by Newton-Euler of {name}, {STATES} states"
    return compare(stacked(run(at)), stacked(right(at)), newton_euler(name), "N m", against)


def of_recursion(slip: str, name: str) -> Comparison:
    """The recursion with ``slip`` and the right one against Newton-Euler, of the bundled robot ``name``."""
    return against_newton_euler(
        name, lambda at: SLIPS[slip].torques(*at), lambda at: Recursion().torques(*at)
    )
