"""The thesis's recursion, step by step, with a step as it is printed in the place of the right one.

A :class:`Recursion` has the steps of Table 2.4 (method I), right, as methods. Each slip is a subclass with
one step as the thesis prints it. Torques of both are held against the plain Newton-Euler recursion of
:mod:`robodyn.verify.reference`, which shares nothing with them but the robot.
Source: Dhanaraj 1990, Tables 2.3 and 2.4, Eqs 2.22 to 2.39, B.7 to B.13, D.2, D.3, Table 4.1.
"""

from __future__ import annotations

from functools import cache
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.arm import Arm, Body, Motion, build_arm, build_motion, origin, trigonometry_at
from robodyn.dynamics.modified_newton_euler import NO_ROTATION, Lambda
from robodyn.dynamics.transforms import Matrix, rotation
from robodyn.dynamics.vectors import ZERO, Vector, plus
from robodyn.robot import load
from robodyn.robot.model import Robot
from robodyn.thesis import method_steps as steps
from robodyn.thesis.slips.comparison import Comparison, compared
from robodyn.verify.numbers import real
from robodyn.verify.reference import Reference

Floats = NDArray[np.float64]

#: States drawn for a comparison, and reaches of positions, rates and accelerations [rad or m, per second].
STATES: Final = 1000
REACH: Final = (3.0, 2.0, 3.0)
_SEED: Final = 1990
PUMA: Final = "puma560_d2"
STANFORD: Final = "stanford_d3"
_NEWTON_EULER: Final = "torques by Newton-Euler of {}, 1000 states"


class Recursion:
    """The steps of Table 2.4 as they must be, over any scalar; ``i`` counts links from 0."""

    def rotation(self, i: int, body: Body, c: Any, s: Any) -> Matrix:
        """From the link's axes to those before."""
        return rotation(body, c, s)

    def origins(self, arm: Arm, motion: Motion) -> list[Vector]:
        """The links' origins in the frames before [m]."""
        return [origin(body, d) for body, d in zip(arm.bodies, motion.d, strict=True)]

    def lambda_of(self, i: int, w: Vector, alpha: Vector) -> Lambda:
        """Step 2A of a revolute joint."""
        return steps.lambda_I(w, alpha)

    def lambda_carried(self, R: Matrix, before: Lambda) -> Lambda:
        """Step 2A of a prismatic joint."""
        return steps.lambda_carried(R, before)

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

    def moment(
        self, N: Vector, s: Vector, F: Vector, p: Vector, f_next: tuple[Vector, Vector], n_next: Vector
    ) -> Vector:
        """Step 8; ``f_next`` is the force of the link beyond, along this link's axes and along its own."""
        return steps.moment(N, s, F, p, f_next[0], n_next)

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
            R = self.rotation(i, body, motion.c[i], motion.s[i])
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
                lam = self.lambda_carried(R, lam)
            point = self.centre(body, arm.gravity)
            forces.append(self.force(i, body.mass, a, self.relative(w, alpha, lam, point)))
            moments.append(self.euler(body, alpha, lam))
            rotations.append(R)
        torques: list[Any] = [None] * len(arm.bodies)
        f_next, n_next, p_next = (ZERO, ZERO), ZERO, ZERO
        for i in reversed(range(len(arm.bodies))):
            body = arm.bodies[i]
            n = self.moment(moments[i], body.com, forces[i], p_next, f_next, n_next)
            f = plus(forces[i], f_next[0])
            torques[i] = self.torque(body, f, n) + body.motor_inertia * motion.qdd[i]
            f_next = steps.turned(rotations[i], f), f
            n_next, p_next = steps.turned(rotations[i], n), origins[i]
        return torques


# --- against Newton-Euler ---------------------------------------------------------------------------------


def states(robot: Robot) -> tuple[Floats, Floats, Floats]:
    """Positions, rates and accelerations [K, n] at random."""
    rng = np.random.default_rng(_SEED)
    q, qd, qdd = (rng.uniform(-reach, reach, (STATES, robot.n)) for reach in REACH)
    return q, qd, qdd


@cache
def bundled(name: str) -> Robot:
    """A bundled robot without its warnings."""
    return load(name, warn=lambda _: None)


def scalars(robot: Robot, at: tuple[Floats, Floats, Floats]) -> tuple[Arm, Motion]:
    """``robot`` in floats and its motion in arrays over the states ``at``."""
    none: dict[str, float] = {}
    arm = build_arm(robot, real, none.__getitem__)
    q, qd, qdd = (list(x.T) for x in at)
    return arm, build_motion(arm, q, qd, qdd, trigonometry_at(q), real)


def stacked(torques: list[Any]) -> Floats:
    """Torques [K, n] from those of the joints."""
    return np.stack([np.broadcast_to(np.asarray(x, dtype=np.float64), STATES) for x in torques], axis=1)


@cache
def newton_euler(name: str) -> Floats:
    """Torques [K, n] of the plain recursion at :func:`states`."""
    robot = bundled(name)
    return Reference(robot).inverse_dynamics(*states(robot))


def torques(name: str, recursion: Recursion) -> Floats:
    """Torques [K, n] of the bundled robot ``name`` at :func:`states`."""
    robot = bundled(name)
    return stacked(recursion.torques(*scalars(robot, states(robot))))


def of_recursion(slip: type[Recursion], name: str) -> Comparison:
    """The recursion with ``slip`` and the right one against Newton-Euler, of the bundled robot ``name``."""
    return compared(
        torques(name, slip()), torques(name, Recursion()), newton_euler(name), "N m",
        _NEWTON_EULER.format(name),
    )  # fmt: skip
