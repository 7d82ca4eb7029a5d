"""Inverse dynamics in many digits, in the world's frame: shares nothing with the library but the description.

Every vector is along the base's axes: poses by multiplying transforms, velocities and accelerations by
summing over joints, torques from the balance of moments about each joint's axis of all links beyond. Source:
any textbook of mechanics; Craig only for what his frames are.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath

from robodyn.robot.model import EffectEntry, Inertia, Link, Robot
from robodyn.robot.values import Affine, Angle, Value

Vector = list[Any]


def number(value: Value, parameters: Mapping[str, Any]) -> Any:
    """A number of the description in the digits in use."""
    if isinstance(value, Affine):
        terms = [number(factor, {}) * parameters[name] for name, factor in value.terms]
        return sum(terms, number(value.constant, {}))
    return mpmath.mpf(value.numerator) / value.denominator


def cross(u: Vector, v: Vector) -> Vector:
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def plus(*vectors: Vector) -> Vector:
    return [sum(parts) for parts in zip(*vectors, strict=True)]


def times(k: Any, u: Vector) -> Vector:
    return [k * x for x in u]


def dot(u: Vector, v: Vector) -> Any:
    return sum(x * y for x, y in zip(u, v, strict=True))


def matrix_vector(R: list[Vector], u: Vector) -> Vector:
    return [dot(row, u) for row in R]


@dataclass(frozen=True, slots=True)
class Loads:
    """What the links and the payload take from their joints: ``tau`` [n] (N m or N); ``f`` and ``n`` [n][3]
    (N, N m): force and moment, about the origins and along the axes of the links' frames."""

    tau: list[Any]
    f: list[Vector]
    n: list[Vector]


def torques(
    robot: Robot,
    q: Sequence[Any],
    qd: Sequence[Any],
    qdd: Sequence[Any],
    parameters: Mapping[str, Any] | None = None,
) -> list[Any]:
    """Torques [n] of the rigid arm with its rotors, viscous and Coulomb friction, and payloads."""
    named = parameters or {}
    result = loads(robot, q, qd, qdd, named).tau
    if robot.torque_side == "motor":
        for j, link in enumerate(robot.links):
            joint = link.joint
            result[j] += number(joint.motor_inertia, named) * qdd[j] + number(joint.viscous, named) * qd[j]
            result[j] += number(joint.coulomb, named) * direction(robot, qd[j])
    return result


def loads(
    robot: Robot,
    q: Sequence[Any],
    qd: Sequence[Any],
    qdd: Sequence[Any],
    parameters: Mapping[str, Any] | None = None,
) -> Loads:
    """What the rigid arm takes from its joints; errors of links and payloads are looked up in the effects."""
    named = parameters or {}

    def scalar(value: Value) -> Any:
        return number(value, named)

    R = [[mpmath.mpf(r == c) for c in range(3)] for r in range(3)]
    p: Vector = [mpmath.mpf(0)] * 3
    w, alpha, a = ([mpmath.mpf(0)] * 3 for _ in range(3))
    axes, origins, frames, turning, bodies = [], [], [], [], []
    for i, link in enumerate(robot.links):
        joint = link.joint
        turns = joint.kind == "revolute"
        R_x = _turned(R, *_fixed(joint.alpha), about_x=True)
        d = scalar(joint.d) + (0 if turns else q[i])
        z = [row[2] for row in R_x]
        x, y = [row[0] for row in R], [row[1] for row in R_x]
        step = plus(times(scalar(joint.a), x), times(scalar(joint.b), y), times(d, z))
        # A frame's origin moves with the frame before it, and along its own axis where it slides.
        a = plus(a, cross(alpha, step), cross(w, cross(w, step)))
        p = plus(p, step)
        if turns:
            alpha = plus(alpha, times(qdd[i], z), cross(w, times(qd[i], z)))
            w = plus(w, times(qd[i], z))
        else:
            a = plus(a, times(qdd[i], z), times(2 * qd[i], cross(w, z)))
        R = _turned(R_x, *(_sum(joint.theta, q[i]) if turns else _fixed(joint.theta)), about_x=False)
        axes.append(z)
        origins.append(p)
        frames.append([list(column) for column in zip(*R, strict=True)])
        turning.append(turns)
        solids = [_body(link, robot.effects_at(i + 1), scalar)]
        if i == robot.n - 1:
            solids += [_payload(e, scalar) for e in robot.effects if e.effect == "payload"]
        for mass, com, rows in solids:
            r = matrix_vector(R, com)
            gravity = [scalar(x) for x in robot.base_gravity]
            a_com = plus(a, cross(alpha, r), cross(w, cross(w, r)))
            force = times(mass, plus(a_com, times(-1, gravity)))
            own = frames[-1]  # R transposed

            def inertia(u: Vector, R: Any = R, rows: Any = rows, own: Any = own) -> Vector:
                return matrix_vector(R, matrix_vector(rows, matrix_vector(own, u)))

            moment = plus(inertia(alpha), cross(w, inertia(w)))
            bodies.append((i, plus(p, r), force, moment))
    loads = Loads([], [], [])
    for j in range(robot.n):
        total, about = [mpmath.mpf(0)] * 3, [mpmath.mpf(0)] * 3
        for i, where, force, moment in bodies:
            if i >= j:
                total = plus(total, force)
                about = plus(about, moment, cross(plus(where, times(-1, origins[j])), force))
        loads.tau.append(dot(axes[j], about if turning[j] else total))
        loads.f.append(matrix_vector(frames[j], total))
        loads.n.append(matrix_vector(frames[j], about))
    return loads


Solid = tuple[Any, Vector, list[Vector]]


def _body(link: Link, effects: Sequence[EffectEntry], scalar: Callable[[Value], Any]) -> Solid:
    """Mass, centre of mass and tensor of a link, with what its description says they are off by."""
    mass, com, tensor = scalar(link.mass), [scalar(x) for x in link.com], _rows(link.inertia, scalar)
    for e in effects:
        if e.effect == "inertial_error":
            mass += scalar(e["delta_mass"])
            com = [x + scalar(e[f"delta_com_{axis}"]) for x, axis in zip(com, "xyz", strict=True)]
            error = Inertia(*(e[f"delta_{axes}"] for axes in ("xx", "yy", "zz", "xy", "xz", "yz")))
            tensor = [plus(u, v) for u, v in zip(tensor, _rows(error, scalar), strict=True)]
    return mass, com, tensor


def _payload(e: EffectEntry, scalar: Callable[[Value], Any]) -> Solid:
    tensor = _rows(e["inertia"] if "inertia" in e else Inertia(), scalar)
    return scalar(e["mass"]), [scalar(x) for x in e["com"]], tensor


def _rows(tensor: Inertia, scalar: Callable[[Value], Any]) -> list[Vector]:
    rows = (tensor.xx, tensor.xy, tensor.xz), (tensor.xy, tensor.yy, tensor.yz)
    return [[scalar(x) for x in row] for row in (*rows, (tensor.xz, tensor.yz, tensor.zz))]


def _fixed(angle: Angle) -> tuple[Any, Any]:
    """Cosine and sine as the description has them, rational points of the circle."""
    return number(angle.cos, {}), number(angle.sin, {})


def _sum(offset: Angle, variable: Any) -> tuple[Any, Any]:
    """Cosine and sine of a joint's angle, of which kernels take the sine as a whole."""
    if offset.quarter is None:
        total = mpmath.mpf(offset.radians) + variable
        return mpmath.cos(total), mpmath.sin(total)
    (c, s), (e, f) = _fixed(offset), (mpmath.cos(variable), mpmath.sin(variable))
    return c * e - s * f, s * e + c * f


def _turned(R: list[Vector], c: Any, s: Any, *, about_x: bool) -> list[Vector]:
    if about_x:
        return [[x, c * y + s * z, c * z - s * y] for x, y, z in R]
    return [[c * x + s * y, c * y - s * x, z] for x, y, z in R]


def direction(robot: Robot, speed: Any) -> Any:
    """sgn of ``speed``; tanh over a velocity; or 0 within a dead band, half at its edge."""
    if robot.rest_velocity is not None:
        return mpmath.tanh(speed / number(robot.rest_velocity, {}))
    plain = (speed > 0) - (speed < 0)
    band: Any = number(robot.dead_band or Fraction(0), {})
    return plain if abs(speed) > band else mpmath.mpf(plain) / 2 if abs(speed) == band else 0
