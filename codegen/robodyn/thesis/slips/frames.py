"""Transforms, rotations and lambda matrices as they are printed, entry by entry.

The reference is put together of turns and shifts about single axes, in numpy.
Source: Dhanaraj 1990, Eqs 2.1 to 2.4, 2.36, 2.41, 4.4, 4.19, B.7 and B.9.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.counts.general import Tally
from robodyn.dynamics.arm import Body, Symmetric
from robodyn.dynamics.modified_newton_euler import Kinematics, inertia_moment
from robodyn.dynamics.transforms import Matrix, rotation, transform, transposed
from robodyn.dynamics.vectors import ZERO
from robodyn.robot import bundled_names
from robodyn.robot.values import quarter_turns
from robodyn.thesis import method_steps as steps
from robodyn.thesis.slips.comparison import Comparison, compared
from robodyn.thesis.slips.recursion import Recursion, bundled, scalars, states
from robodyn.thesis.slips.recursion_slips import PlusIn36

Floats = NDArray[np.float64]

PUMA = "puma560"
STANFORD = "stanford"


# --- turns and shifts about single axes --------------------------------------------------------------------


def _turn(axis: int, angle: Any) -> Floats:
    """Transforms [..., 4, 4] of a turn about x (0) or z (2) by ``angle`` [...] (rad)."""
    c, s = np.cos(angle), np.sin(angle)
    T = np.broadcast_to(np.eye(4), (*np.shape(angle), 4, 4)).copy()
    i, j = (1, 2) if axis == 0 else (0, 1)
    T[..., i, i], T[..., i, j], T[..., j, i], T[..., j, j] = c, -s, s, c
    return T


def _shift(axis: int, length: Any) -> Floats:
    """Transforms [..., 4, 4] of a shift along x (0) or z (2) by ``length`` [...] (m)."""
    T = np.broadcast_to(np.eye(4), (*np.shape(length), 4, 4)).copy()
    T[..., axis, 3] = length
    return T


def _array(matrix: Any, count: int) -> Floats:
    """Arrays [K, m, n] from rows of numbers or arrays [K]."""
    rows = [[np.broadcast_to(np.asarray(x, dtype=np.float64), count) for x in row] for row in matrix]
    return np.moveaxis(np.array(rows), -1, 0)


def _transforms(name: str) -> tuple[Floats, Floats, Floats]:
    """Of all links of a bundled robot at random states: robodyn's transforms, those of the turns and shifts
    about ``X_(i-1)`` and ``Z_i``, and those of the same about ``Z_(i-1)`` and ``X_i``; each [n, K, 4, 4]."""
    robot = bundled(name)
    at = states(robot)
    arm, motion = scalars(robot, at)
    ours, right, printed = [], [], []
    for i, body in enumerate(arm.bodies):
        count = len(at[0])
        ours.append(_array(transform(body, motion.c[i], motion.s[i], motion.d[i]), count))
        theta = np.arctan2(motion.s[i], motion.c[i]) * np.ones(count)
        alpha, a = np.arctan2(body.sin_alpha, body.cos_alpha) * np.ones(count), body.a * np.ones(count)
        d = motion.d[i] * np.ones(count)
        about_x = _turn(0, alpha) @ _shift(0, a)
        about_z = _turn(2, theta) @ _shift(2, d)
        right.append(about_x @ about_z)
        printed.append(about_z @ about_x)
    return np.array(ours), np.array(right), np.array(printed)


def axes_of_the_moves() -> Comparison:
    """2.1, 2.2: the moves about ``X_i`` and ``Z_(i-1)``, which are those of the other convention of
    Denavit and Hartenberg, against the transforms that robodyn's kinematics has."""
    ours, right, printed = _transforms(PUMA)
    return compared(printed, right, ours, "entry", f"transforms of {PUMA}, 1000 states")


def sign_of_a() -> Comparison:
    """2.4: entry (1,4) is ``-a``."""
    ours, right, _ = _transforms(PUMA)
    printed = ours.copy()
    printed[..., 0, 3] *= -1
    return compared(printed, ours, right, "m", f"turns and shifts of {PUMA}, 1000 states")


# --- lambda -----------------------------------------------------------------------------------------------


def _skew(u: Floats) -> Floats:
    x, y, z = u
    none = np.zeros_like(x)
    return np.moveaxis(np.array([[none, -z, y], [z, none, -x], [-y, x, none]]), -1, 0)


def entry_of_36() -> Comparison:
    """2.36: lambda of the Stanford arm's slide from that of link 2, against ``[alpha x] + [w x]^2`` of the
    slide's own rates."""
    at = states(bundled(STANFORD))
    arm, motion = scalars(bundled(STANFORD), at)
    count = len(at[0])
    rng = np.random.default_rng(36)
    w, alpha = rng.uniform(-2, 2, (2, 3, count))
    before = steps.lambda_I(tuple(w), tuple(alpha))
    R = rotation(arm.bodies[2], motion.c[2], motion.s[2])
    turned = _array(R, count)
    own_w, own_alpha = (np.einsum("kji,jk->ik", turned, u) for u in (w, alpha))
    truth = _skew(own_alpha) + _skew(own_w) @ _skew(own_w)
    printed, right = (_array(run.lambda_carried(R, before).rows, count) for run in (PlusIn36(), Recursion()))
    return compared(printed, right, truth, "1/s^2", "[alpha x] + [w x]^2 of the slide, 1000 states")


def gyroscopic_moment() -> Comparison:
    """2.41 with products of inertia, right as printed, against ``I alpha + w x I w`` in numpy."""
    rng = np.random.default_rng(41)
    w, alpha = rng.uniform(-2, 2, (2, 3, 1000))
    xx, yy, zz, xy, xz, yz = rng.uniform(-1, 1, (6, 1000))
    I = np.moveaxis(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]), -1, 0)
    lam = steps.lambda_I(tuple(w), tuple(alpha))
    at = Kinematics(tuple(w), tuple(alpha), lam, ZERO, ZERO)
    ours = np.array(inertia_moment(Symmetric(xx, yy, zz, xy, xz, yz), at))
    momentum = np.einsum("kij,jk->ki", I, w)
    truth = np.einsum("kij,jk->ki", I, alpha) + np.cross(w.T, momentum)
    return compared(ours.T, ours.T, truth, "N m", "I alpha + w x I w, 1000 random bodies")


# --- angular acceleration ---------------------------------------------------------------------------------


def parent_of_alpha() -> Comparison:
    """B.7, B.9: ``R^T alpha_i`` for ``R^T alpha_(i-1)``, with the angular accelerations that the arm has:
    sums over the joints below, ``z qdd + w x z qd`` along the base's axes."""
    robot = bundled(PUMA)
    q, qd, qdd = at = states(robot)
    arm, motion = scalars(robot, at)
    count = len(q)
    W = np.broadcast_to(np.eye(3), (count, 3, 3))
    w, alpha = np.zeros((count, 3)), np.zeros((count, 3))
    printed, right, truth = [], [], []
    before: Any = (0.0, 0.0, 0.0)
    for i, body in enumerate(arm.bodies):
        R = rotation(body, motion.c[i], motion.s[i])
        W = W @ _array(R, count)
        z = W[:, :, 2]
        alpha = alpha + z * qdd[:, [i]] + np.cross(w, z * qd[:, [i]])
        w = w + z * qd[:, [i]]
        acceleration = np.einsum("kji,kj->ik", W, alpha)
        rates = tuple(np.einsum("kji,kj->ik", W, w))
        right.append(steps.alpha_I(R, before, rates, qd[:, i], qdd[:, i]))
        printed.append(steps.alpha_I(R, tuple(acceleration), rates, qd[:, i], qdd[:, i]))
        truth.append(acceleration)
        before = tuple(acceleration)
    by_print, mended = ([[np.broadcast_to(x, count) for x in u] for u in form] for form in (printed, right))
    return compared(by_print, mended, truth, "rad/s^2", f"sums over the joints of {PUMA}, 1000 states")


# --- rotations --------------------------------------------------------------------------------------------


def _perpendicular() -> Body:
    """A joint of which the axis is perpendicular to the one before, alpha = pi/2."""
    none = Symmetric(0, 0, 0, 0, 0, 0)
    return Body(True, 0, 1, 0, 0, quarter_turns(0), 0, ZERO, none, 0, 0, 0)


def sign_in_4_4() -> Comparison:
    """4.4: R with its second column negated for R^T, against turns about single axes."""
    theta = np.random.default_rng(44).uniform(-np.pi, np.pi, 1000)
    R = rotation(_perpendicular(), np.cos(theta), np.sin(theta))
    negated = tuple((row[0], -row[1], row[2]) for row in R)
    truth = (_turn(0, np.full(1000, np.pi / 2)) @ _turn(2, theta))[:, :3, :3].swapaxes(1, 2)
    by_print, mended = (_array(matrix, 1000) for matrix in (negated, transposed(R)))
    return compared(by_print, mended, truth, "entry", "R^T of perpendicular axes, 1000 angles")


def _operations(matrix: Matrix, row: int, ledger: dict[str, int]) -> int:
    """Operations of a component of a product with a vector, entries 0 and +-1 for nothing."""
    ledger.clear()
    u = (Tally(ledger), Tally(ledger), Tally(ledger))
    terms = [x if isinstance(m, int) and abs(m) == 1 else m * x
             for m, x in zip(matrix[row], u, strict=True) if not (isinstance(m, int) and m == 0)]  # fmt: skip
    total = terms[0]
    for term in terms[1:]:
        total = total + term
    return sum(ledger.values())


def free_component() -> Comparison:
    """4.4: the component of ``R^T u`` that costs nothing is y as printed, and z."""
    ledger: dict[str, int] = {}
    c, s = Tally(ledger), Tally(ledger)
    matrix = transposed(((c, -s, 0), (0, 0, -1), (s, c, 0)))
    y, z = (_operations(matrix, row, ledger) for row in (1, 2))
    return compared([y], [z], [0], "operations", "a component for nothing")


def determinant_in_4_19() -> Comparison:
    """4.4, 4.19: a matrix of determinant -1 for a rotation; right are R of all bundled robots' joints."""
    right = []
    for name in bundled_names():
        at = states(bundled(name))
        arm, motion = scalars(bundled(name), at)
        for i, body in enumerate(arm.bodies):
            turns = _array(rotation(body, motion.c[i], motion.s[i]), len(at[0]))
            right.append(np.linalg.det(turns))
    theta = np.random.default_rng(44).uniform(-np.pi, np.pi, 1000)
    R = rotation(_perpendicular(), np.cos(theta), np.sin(theta))
    printed = np.linalg.det(_array(tuple((row[0], -row[1], row[2]) for row in R), 1000))
    off = float(np.abs(np.concatenate(right) - 1).max())
    return compared(
        [printed.max(), 1.0], [1 + off, 1.0], [1, 1], "determinant", "the determinant +1 of a turn"
    )
