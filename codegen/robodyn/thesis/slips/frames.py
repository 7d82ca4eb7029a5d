"""Transforms, rotations and lambda matrices as they are printed, entry by entry.

The reference is put together of turns and shifts about single axes, in numpy.
Source: Dhanaraj 1990, Eqs 2.1 to 2.4, 2.36, 2.41, 4.4, 4.19, B.7 and B.9.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.counts.general import Tally
from robodyn.dynamics.arm import Body, Symmetric
from robodyn.dynamics.modified_newton_euler import Kinematics, inertia_moment
from robodyn.dynamics.transforms import Matrix, rotation, transform, transposed
from robodyn.dynamics.vectors import ZERO
from robodyn.robot import bundled_names
from robodyn.robot.values import quarter_turns
from robodyn.thesis import steps
from robodyn.thesis.printed import bundled
from robodyn.thesis.slips import Comparison, compare
from robodyn.thesis.slips.recursion import SLIPS, STATES, Recursion, scalars, states

PUMA: Final = "puma560"
STANFORD: Final = "stanford"


def _moved(axis: int, angle: Any, length: Any) -> Floats:
    """Transforms [K, 4, 4] of a turn about x (0) or z (2) by ``angle`` [K] (rad) and a shift [K] (m) along
    it."""
    T = np.zeros((STATES, 4, 4))
    i, j = (1, 2) if axis == 0 else (0, 1)
    T[:, axis, axis] = T[:, 3, 3] = 1
    T[:, i, i] = T[:, j, j] = np.cos(angle)
    T[:, j, i] = np.sin(angle)
    T[:, i, j] = -T[:, j, i]
    T[:, axis, 3] = length
    return T


def _array(matrix: Any) -> Floats:
    """Arrays [K, ...] from rows of numbers or arrays [K], or from one of them."""
    rows = [[np.broadcast_to(np.asarray(x, dtype=np.float64), STATES) for x in row] for row in matrix]
    return np.moveaxis(np.array(rows), -1, 0)


def _transforms(name: str) -> tuple[Floats, Floats, Floats]:
    """Of all links of a bundled robot at random states: robodyn's transforms, those of the turns and shifts
    about ``X_(i-1)`` and ``Z_i``, and those of the same about ``Z_(i-1)`` and ``X_i``; each [n, K, 4, 4]."""
    robot = bundled(name)
    arm, motion = scalars(robot, states(robot))
    ours, right, printed = [], [], []
    for i, body in enumerate(arm.bodies):
        ours.append(_array(transform(body, motion.c[i], motion.s[i], motion.d[i])))
        about_x = _moved(0, np.arctan2(body.sin_alpha, body.cos_alpha), body.a)
        about_z = _moved(2, np.arctan2(motion.s[i], motion.c[i]), motion.d[i])
        right.append(about_x @ about_z)
        printed.append(about_z @ about_x)
    return np.array(ours), np.array(right), np.array(printed)


def axes_of_the_moves() -> Comparison:
    """2.1, 2.2: the moves about ``X_i`` and ``Z_(i-1)``, which are those of the other convention of
    Denavit and Hartenberg, against the transforms that robodyn's kinematics has."""
    ours, right, printed = _transforms(PUMA)
    return compare(printed, right, ours, "entry", f"transforms of {PUMA}, 1000 states")


def sign_of_a() -> Comparison:
    """2.4: entry (1,4) is ``-a``."""
    ours, right, _ = _transforms(PUMA)
    printed = ours.copy()
    printed[..., 0, 3] *= -1
    return compare(printed, ours, right, "m", f"turns and shifts of {PUMA}, 1000 states")


# --- lambda -----------------------------------------------------------------------------------------------


def _skew(u: Floats) -> Floats:
    x, y, z = u
    return _array(((0, -z, y), (z, 0, -x), (-y, x, 0)))


def entry_of_36() -> Comparison:
    """2.36: lambda of the Stanford arm's slide from that of link 2, against ``[alpha x] + [w x]^2`` of the
    slide's own rates."""
    robot = bundled(STANFORD)
    arm, motion = scalars(robot, states(robot))
    w, alpha = np.random.default_rng(36).uniform(-2, 2, (2, 3, STATES))
    before = steps.lambda_I(tuple(w), tuple(alpha))
    R = rotation(arm.bodies[2], motion.c[2], motion.s[2])
    own_w, own_alpha = (np.einsum("kji,jk->ik", _array(R), u) for u in (w, alpha))
    truth = _skew(own_alpha) + _skew(own_w) @ _skew(own_w)
    slip = SLIPS["(2,1) of 2.36 is (1,3) of lambda_2"]
    printed, right = (_array(run.lambda_turned(R, before).rows) for run in (slip, Recursion()))
    return compare(printed, right, truth, "1/s^2", "[alpha x] + [w x]^2 of the slide, 1000 states")


def gyroscopic_moment() -> Comparison:
    """2.41 with products of inertia, right as printed, against ``I alpha + w x I w`` in numpy."""
    rng = np.random.default_rng(41)
    w, alpha = rng.uniform(-2, 2, (2, 3, STATES))
    xx, yy, zz, xy, xz, yz = rng.uniform(-1, 1, (6, STATES))
    I = _array(((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)))
    lam = steps.lambda_I(tuple(w), tuple(alpha))
    at = Kinematics(tuple(w), tuple(alpha), lam, ZERO, ZERO)
    ours = np.array(inertia_moment(Symmetric(xx, yy, zz, xy, xz, yz), at)).T
    truth = np.einsum("kij,jk->ki", I, alpha) + np.cross(w.T, np.einsum("kij,jk->ki", I, w))
    return compare(ours, ours, truth, "N m", "I alpha + w x I w, 1000 random bodies")


# --- angular acceleration ---------------------------------------------------------------------------------


def parent_of_alpha() -> Comparison:
    """B.7, B.9: ``R^T alpha_i`` for ``R^T alpha_(i-1)``, with the angular accelerations that the arm has:
    sums over the joints below, ``z qdd + w x z qd`` along the base's axes."""
    robot = bundled(PUMA)
    _, qd, qdd = at = states(robot)
    arm, motion = scalars(robot, at)
    W = np.broadcast_to(np.eye(3), (STATES, 3, 3))
    w, alpha = np.zeros((STATES, 3)), np.zeros((STATES, 3))
    printed, right, truth = [], [], []
    before: Any = (0.0, 0.0, 0.0)
    for i, body in enumerate(arm.bodies):
        R = rotation(body, motion.c[i], motion.s[i])
        W = W @ _array(R)
        z = W[:, :, 2]
        alpha = alpha + z * qdd[:, [i]] + np.cross(w, z * qd[:, [i]])
        w = w + z * qd[:, [i]]
        rates, own = (tuple(np.einsum("kji,kj->ik", W, u)) for u in (w, alpha))
        right.append(_array([steps.alpha_I(R, before, rates, qd[:, i], qdd[:, i])]))
        printed.append(_array([steps.alpha_I(R, own, rates, qd[:, i], qdd[:, i])]))
        truth.append(_array([own]))
        before = own
    return compare(printed, right, truth, "rad/s^2", f"sums over the joints of {PUMA}, 1000 states")


# --- rotations --------------------------------------------------------------------------------------------


def _perpendicular() -> tuple[Floats, Matrix, Matrix]:
    """Angles [K] (rad), rotations of a joint whose axis is perpendicular to the one before, and the same with
    the second column negated."""
    theta = np.random.default_rng(44).uniform(-np.pi, np.pi, STATES)
    body = Body(True, 0, 1, 0, 0, quarter_turns(0), 0, ZERO, Symmetric(0, 0, 0, 0, 0, 0), 0, 0, 0)
    R = rotation(body, np.cos(theta), np.sin(theta))
    return theta, R, tuple((row[0], -row[1], row[2]) for row in R)


def sign_in_4_4() -> Comparison:
    """4.4: R with its second column negated for R^T, against turns about single axes."""
    theta, R, negated = _perpendicular()
    truth = (_moved(0, np.pi / 2, 0) @ _moved(2, theta, 0))[:, :3, :3].swapaxes(1, 2)
    forms = _array(negated), _array(transposed(R))
    return compare(*forms, truth, "entry", "R^T of perpendicular axes, 1000 angles")


def free_component() -> Comparison:
    """4.4: the component of ``R^T u`` that costs nothing is y as printed, and z; entries 0 and +-1 are for
    nothing."""
    ledger: dict[str, int] = {}
    c, s = Tally(ledger), Tally(ledger)
    y, z = (component_cost(row, ledger) for row in transposed(((c, -s, 0), (0, 0, -1), (s, c, 0)))[1:])
    return compare(y, z, 0, "operations", "a component for nothing")


def component_cost(row: Any, ledger: dict[str, int]) -> int:
    """Operations of a row of a matrix times a vector of numbers, noted in ``ledger``."""
    ledger.clear()
    total: Any = 0
    for entry in row:
        total = total + entry * Tally(ledger)
    return sum(ledger.values())


def determinant_in_4_19() -> Comparison:
    """4.4, 4.19: a matrix of determinant -1 for a rotation; right are R of all bundled robots' joints."""
    right = []
    for robot in map(bundled, bundled_names()):
        arm, motion = scalars(robot, states(robot))
        for i, body in enumerate(arm.bodies):
            right.append(np.linalg.det(_array(rotation(body, motion.c[i], motion.s[i]))))
    printed = np.linalg.det(_array(_perpendicular()[2])).max()
    off = float(np.abs(np.concatenate(right) - 1).max())
    return compare([printed, 1.0], [1 + off, 1.0], [1, 1], "determinant", "the determinant +1 of a turn")
