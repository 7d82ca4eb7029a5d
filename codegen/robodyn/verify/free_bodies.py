"""Joint reaction forces and moments by d'Alembert's principle, at many states, in floats or exact Fractions.

The method is independent of the recursions over velocities, accelerations and forces that the reference and
the kernels use. Link frames are 4x4 transforms ``T_i`` to the base, differentiated twice with respect to
time. Each body is its pseudo-inertia matrix ``J_i``. Consider the matrix

    sum over i >= j of  (Tdd_i - G) J_i T_i^T,   G = [0 g; 0 0]

Its last column is the force that joint j transmits. Its skew part is the moment about the base's origin
(R. Paul, Robot Manipulators, chapter 6, defines the matrices). Drives do not contribute.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.robot.model import Inertia, Placement, Robot
from robodyn.robot.values import circle_point
from robodyn.verify.numbers import Parameters, exact_value, filled

Numbers = NDArray[Any]


def joint_reactions(
    robot: Robot,
    q: Numbers,
    qd: Numbers,
    qdd: Numbers,
    w: Numbers | None = None,
    parameters: Parameters | None = None,
    *,
    exact: bool = False,
) -> Numbers:
    """Force [N] and moment [N m] that each link receives from the link before it: ``[N, n, 6]``.

    Moments are about the origin of the joint's frame (z is the joint's axis), and components are along its
    axes. States are ``[N, n]``. ``w`` ``[N, 6]`` is a wrench on the tool, along the world's axes. With
    ``exact`` the results are Fractions with errors below 1e-28.

    Raises
    ------
    InputError: a run-time parameter has no value.
    """
    values, count = filled(robot, parameters), len(q)
    dtype: Any = object if exact else np.float64

    def array(x: Any) -> Numbers:
        """Exact numbers, rounded to floats unless ``exact``."""
        entries = np.asarray(x, object)
        return entries if exact else entries.astype(np.float64)

    def as_numbers(x: Numbers) -> Numbers:
        """Floats, converted to Fractions without rounding if ``exact``."""
        if not exact:
            return np.asarray(x, np.float64)
        return np.array([Fraction(e) for e in x.ravel().tolist()], object).reshape(x.shape)

    base, tool = array(_frame(robot.base)), array(_frame(robot.tool))
    speeds, rates = as_numbers(qd), as_numbers(qdd)
    g = np.zeros((4, 4), dtype)
    g[:3, 3] = array(list(robot.base_gravity))
    T = np.broadcast_to(array(_frame(None)), (count, 4, 4))
    Td, Tdd = np.zeros((2, count, 4, 4), dtype)
    frames, sums = [], []
    for k, link in enumerate(robot.links):
        joint = link.joint
        ca, sa, ct, st = (
            array(x) for x in (joint.alpha.cos, joint.alpha.sin, joint.theta.cos, joint.theta.sin)
        )
        a, b, d = (array(exact_value(x, values)) for x in (joint.a, joint.b, joint.d))
        tilt = array([[1, 0, 0, a], [0, ca, -sa, ca * b], [0, sa, ca, sa * b], [0, 0, 0, 1]])
        step, slope, second = np.zeros((3, count, 4, 4), dtype)
        step[:, 2, 2] = step[:, 3, 3] = array(1)
        step[:, 2, 3] = d
        if joint.kind == "prismatic":
            step[:, 2, 3] = d + as_numbers(q[:, k])
            slope[:, 2, 3] = array(1)
            c, s = np.broadcast_to(ct, count), np.broadcast_to(st, count)
        else:
            angles = as_numbers(q[:, k])
            if exact:
                cq, sq = np.array(list(map(circle_point, angles)), object).T
            else:
                cq, sq = np.cos(angles), np.sin(angles)
            c, s = cq * ct - sq * st, sq * ct + cq * st
            slope[:, 0, 0], slope[:, 0, 1], slope[:, 1, 0], slope[:, 1, 1] = -s, -c, c, -s
            second[:, 0, 0], second[:, 0, 1], second[:, 1, 0], second[:, 1, 1] = -c, s, -s, -c
        step[:, 0, 0], step[:, 0, 1], step[:, 1, 0], step[:, 1, 1] = c, -s, s, c
        A, A1, A2 = (tilt @ x for x in (step, slope, second))
        v, rate = speeds[:, k, None, None], rates[:, k, None, None]
        Tdd = Tdd @ A + 2 * v * (Td @ A1) + T @ (v * v * A2 + rate * A1)
        Td = Td @ A + v * (T @ A1)
        T = T @ A
        solids = [(link.mass, link.com, link.inertia)]
        if k == robot.n - 1:
            solids += [
                (e["mass"], e["com"], e["inertia"] if "inertia" in e else Inertia())
                for e in robot.effects
                if e.effect == "payload"
            ]
        J = sum(array(_pseudo_inertia(*solid, values)) for solid in solids)
        frames.append(T)
        sums.append((Tdd - g) @ J @ np.swapaxes(T, 1, 2))
    tool_force, tool_moment = np.zeros((2, count, 3), dtype)
    if w is not None:
        wrench = as_numbers(w)
        tool_force, tool_moment = wrench[:, :3] @ base[:3, :3], wrench[:, 3:] @ base[:3, :3]
        tool_moment = tool_moment + _cross((T @ tool)[:, :3, 3], tool_force)
    result = np.empty((count, robot.n, 6), dtype)
    total = np.zeros((count, 4, 4), dtype)
    for k in reversed(range(robot.n)):
        total = total + sums[k]
        force = total[:, :3, 3] - tool_force
        S = total
        moment = np.stack(
            [S[:, 2, 1] - S[:, 1, 2], S[:, 0, 2] - S[:, 2, 0], S[:, 1, 0] - S[:, 0, 1]], axis=-1
        )
        moment = moment - tool_moment - _cross(frames[k][:, :3, 3], force)
        R = frames[k][:, :3, :3]
        for half, u in ((slice(0, 3), force), (slice(3, 6), moment)):
            result[:, k, half] = (u[:, None, :] @ R)[:, 0, :]
    return result


def _frame(place: Placement | None) -> list[list[Any]]:
    """The 4x4 homogeneous transform of ``place``, exact."""
    rotation = place.rotation if place is not None else ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    origin = place.xyz if place is not None else (0, 0, 0)
    return [*([*row, p] for row, p in zip(rotation, origin, strict=True)), [0, 0, 0, 1]]


def _pseudo_inertia(mass: Any, com: Any, i: Inertia, values: Parameters) -> list[list[Any]]:
    """The pseudo-inertia matrix: the integral of ``[x; 1] [x; 1]^T dm``, exact."""
    m, c = exact_value(mass, values), [exact_value(x, values) for x in com]
    xx, yy, zz, xy, xz, yz = (exact_value(x, values) for x in (i.xx, i.yy, i.zz, i.xy, i.xz, i.yz))
    half = (xx + yy + zz) / 2
    spread = [[half - xx, -xy, -xz], [-xy, half - yy, -yz], [-xz, -yz, half - zz]]
    rows = [[spread[r][k] + m * c[r] * c[k] for k in range(3)] + [m * c[r]] for r in range(3)]
    return [*rows, [m * x for x in c] + [m]]


def _cross(x: Numbers, y: Numbers) -> Numbers:
    (a, b, c), (d, e, f) = np.moveaxis(x, -1, 0), np.moveaxis(y, -1, 0)
    return np.stack([b * f - c * e, c * d - a * f, a * e - b * d], axis=-1)
