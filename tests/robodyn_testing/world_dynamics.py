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
import numpy as np
from numpy.typing import NDArray

from robodyn.robot.model import EffectEntry, Inertia, Link, Robot
from robodyn.robot.values import Affine, Angle, Value

#: Of numbers in many digits.
Vector = NDArray[Any]


def number(value: Value, parameters: Mapping[str, Any]) -> Any:
    """A number of the description in the digits in use."""
    if isinstance(value, Affine):
        terms = [number(factor, {}) * parameters[name] for name, factor in value.terms]
        return sum(terms, number(value.constant, {}))
    return mpmath.mpf(value.numerator) / value.denominator


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

    R, p = np.array([[mpmath.mpf(r == c) for c in range(3)] for r in range(3)]), _vector(0, 0, 0)
    w, alpha, a = _vector(0, 0, 0), _vector(0, 0, 0), _vector(0, 0, 0)
    gravity = _vector(*map(scalar, robot.base_gravity))
    axes, origins, frames, turning, bodies = [], [], [], [], []
    for i, link in enumerate(robot.links):
        joint = link.joint
        turns = joint.kind == "revolute"
        x = R[:, 0]
        R = R @ _about_x(*_fixed(joint.alpha))
        z = R[:, 2]
        d = scalar(joint.d) + (0 if turns else q[i])
        step = scalar(joint.a) * x + scalar(joint.b) * R[:, 1] + d * z
        # A frame's origin moves with the frame before it, and along its own axis where it slides.
        a = a + np.cross(alpha, step) + np.cross(w, np.cross(w, step))
        p = p + step
        if turns:
            alpha = alpha + qdd[i] * z + np.cross(w, qd[i] * z)
            w = w + qd[i] * z
        else:
            a = a + qdd[i] * z + 2 * qd[i] * np.cross(w, z)
        R = R @ _about_z(*(_sum(joint.theta, q[i]) if turns else _fixed(joint.theta)))
        axes.append(z)
        origins.append(p)
        frames.append(R.T)
        turning.append(turns)
        solids = [_body(link, robot.effects_at(i + 1), scalar)]
        if i == robot.n - 1:
            solids += [_payload(e, scalar) for e in robot.effects if e.effect == "payload"]
        for mass, com, tensor in solids:
            r, inertia = R @ com, R @ tensor @ R.T
            force = mass * (a + np.cross(alpha, r) + np.cross(w, np.cross(w, r)) - gravity)
            bodies.append((p + r, force, inertia @ alpha + np.cross(w, inertia @ w)))
    loads = Loads([], [], [])
    for j in range(robot.n):
        beyond = bodies[j:]  # of the last link also its payloads
        total = sum((force for _, force, _ in beyond), _vector(0, 0, 0))
        moment = sum((m + np.cross(at - origins[j], f) for at, f, m in beyond), _vector(0, 0, 0))
        loads.tau.append(axes[j] @ (moment if turning[j] else total))
        loads.f.append(frames[j] @ total)
        loads.n.append(frames[j] @ moment)
    return loads


Solid = tuple[Any, Vector, Vector]


def _vector(*numbers: Any) -> Vector:
    return np.array([x + mpmath.mpf(0) for x in numbers])


def _body(link: Link, effects: Sequence[EffectEntry], scalar: Callable[[Value], Any]) -> Solid:
    """Mass, centre of mass and tensor of a link, with what its description says they are off by."""
    mass, com, tensor = scalar(link.mass), _vector(*map(scalar, link.com)), _tensor(link.inertia, scalar)
    for e in effects:
        if e.effect == "inertial_error":
            mass += scalar(e["delta_mass"])
            com = com + _vector(*(scalar(e[f"delta_com_{axis}"]) for axis in "xyz"))
            error = Inertia(*(e[f"delta_{axes}"] for axes in ("xx", "yy", "zz", "xy", "xz", "yz")))
            tensor = tensor + _tensor(error, scalar)
    return mass, com, tensor


def _payload(e: EffectEntry, scalar: Callable[[Value], Any]) -> Solid:
    tensor = _tensor(e["inertia"] if "inertia" in e else Inertia(), scalar)
    return scalar(e["mass"]), _vector(*map(scalar, e["com"])), tensor


def _tensor(i: Inertia, scalar: Callable[[Value], Any]) -> Vector:
    rows = (i.xx, i.xy, i.xz), (i.xy, i.yy, i.yz), (i.xz, i.yz, i.zz)
    return np.array([_vector(*map(scalar, row)) for row in rows])


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


def _about_x(c: Any, s: Any) -> Vector:
    return np.array([_vector(1, 0, 0), _vector(0, c, -s), _vector(0, s, c)])


def _about_z(c: Any, s: Any) -> Vector:
    return np.array([_vector(c, -s, 0), _vector(s, c, 0), _vector(0, 0, 1)])


def direction(robot: Robot, speed: Any) -> Any:
    """sgn of ``speed``; tanh over a velocity; or 0 within a dead band, half at its edge."""
    if robot.rest_velocity is not None:
        return mpmath.tanh(speed / number(robot.rest_velocity, {}))
    plain = (speed > 0) - (speed < 0)
    band: Any = number(robot.dead_band or Fraction(0), {})
    return plain if abs(speed) > band else mpmath.mpf(plain) / 2 if abs(speed) == band else 0
