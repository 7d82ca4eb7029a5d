"""The plain recursive Newton-Euler in double precision: the reference that a kernel is compared with.

Written from the textbook (J. J. Craig, Introduction to Robotics, 6.45 to 6.53; modified DH frames) with
vectors and cross products, over many states at once. It knows nothing of the rest of robodyn but the
robot's description, and nothing in it is simplified.

Rotor inertia acts as ``motor_inertia * qdd`` on the joint's own axis; friction is ``viscous * qd +
coulomb * sgn(qd)`` with sgn(0) = 0, or ``tanh(qd / rest_velocity)`` in place of the sign. Both are left out
where the torque is the link's.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robodyn.errors import InputError
from robodyn.robot.model import Link, Robot
from robodyn.verify.numbers import Parameters, filled, number
from robodyn.verify.numbers import real as rounded

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class _Body:
    """A link in numbers: ``inertia`` [3, 3] about the centre of mass ``com`` [3]."""

    prismatic: bool
    ca: float
    sa: float
    a: float
    d: float
    ct: float
    st: float
    mass: float
    com: Floats
    inertia: Floats
    motor: float
    viscous: float
    coulomb: float


class Reference:
    """Plain dynamics of ``robot`` at given values of its run-time parameters.

    Every method takes one state ``[n]`` or many ``[N, n]`` (rad or m, and per second) and returns as many.

    Raises
    ------
    InputError: a run-time parameter has no value; an array has the wrong shape.
    """

    def __init__(self, robot: Robot, parameters: Parameters | None = None) -> None:
        values = filled(robot, parameters)
        self.robot = robot
        self._bodies = [_body(link, values) for link in robot.links]
        self._gravity = np.array([float(g) for g in robot.gravity])
        self._at_motor = robot.torque_side == "motor"
        self._rest = None if robot.rest_velocity is None else float(robot.rest_velocity)

    def inverse_dynamics(self, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike) -> Floats:
        """Joint torques [N m or N] that give the accelerations ``qdd``; ``[n]`` or ``[N, n]``."""
        (positions, speeds, rates), lead = self._read(q, qd, qdd)
        return self._torque(positions, speeds, rates, self._gravity).reshape((*lead, self.robot.n))

    def gravity(self, q: ArrayLike) -> Floats:
        """Torques [N m or N] that hold the arm still at ``q``; ``[n]`` or ``[N, n]``."""
        (states,), lead = self._read(q)
        rest = np.zeros_like(states)
        return self._torque(states, rest, rest, self._gravity).reshape((*lead, self.robot.n))

    def bias(self, q: ArrayLike, qd: ArrayLike) -> Floats:
        """Torques [N m or N] at zero acceleration: Coriolis, centrifugal, gravity, friction; like ``q``."""
        (positions, speeds), lead = self._read(q, qd)
        rest = np.zeros_like(positions)
        return self._torque(positions, speeds, rest, self._gravity).reshape((*lead, self.robot.n))

    def mass_matrix(self, q: ArrayLike) -> Floats:
        """``[n, n]`` or ``[N, n, n]``: column j is the torque of a unit acceleration of joint j alone."""
        (positions,), lead = self._read(q)
        n = self.robot.n
        rest = np.zeros_like(positions)
        matrix = np.empty((len(positions), n, n))
        for j in range(n):
            unit = np.zeros_like(positions)
            unit[:, j] = 1.0
            matrix[:, :, j] = self._torque(positions, rest, unit, np.zeros(3))
        return matrix.reshape((*lead, n, n))

    def forward_dynamics(self, q: ArrayLike, qd: ArrayLike, tau: ArrayLike) -> Floats:
        """Joint accelerations [rad/s^2 or m/s^2] under the torques ``tau``; ``[n]`` or ``[N, n]``.

        Raises
        ------
        InputError: the mass matrix is singular at one of the states.
        """
        (positions, speeds, torques), lead = self._read(q, qd, tau)
        try:
            rest = torques - self.bias(positions, speeds)
            result: Floats = np.linalg.solve(self.mass_matrix(positions), rest[..., None]).astype(np.float64)
        except np.linalg.LinAlgError:
            raise InputError(
                f"{self.robot.name}: the mass matrix is singular",
                remedy="give the last links mass or inertia, or the joints motor_inertia",
            ) from None
        return result.reshape((*lead, self.robot.n))

    def _read(self, *arrays: ArrayLike) -> tuple[list[Floats], tuple[int, ...]]:
        """The arrays as ``[N, n]`` and the shape that stands before a state's own."""
        read = [np.asarray(array, dtype=np.float64) for array in arrays]
        shape = read[0].shape
        if not 1 <= len(shape) <= 2 or shape[-1] != self.robot.n or any(a.shape != shape for a in read):
            raise InputError(
                f"{self.robot.name}: states of the wrong shape",
                found=", ".join(str(list(array.shape)) for array in read),
                expected=f"[{self.robot.n}] or [N, {self.robot.n}] each",
            )
        return [array.reshape(-1, self.robot.n) for array in read], shape[:-1]

    def _torque(self, q: Floats, qd: Floats, qdd: Floats, gravity: Floats) -> Floats:
        """Newton-Euler over states ``[N, n]``; the comments give Craig's equations."""
        count, z = len(q), np.array([0.0, 0.0, 1.0])
        w = np.zeros((count, 3))  # angular velocity, in the link's own frame
        wd = np.zeros((count, 3))
        v = np.tile(-gravity, (count, 1))  # acceleration of the frame's origin, gravity in it
        turns, arms, forces, moments = [], [], [], []
        for i, body in enumerate(self._bodies):
            R, p = _transform(body, q[:, i])
            speed, rate = qd[:, i, None] * z, qdd[:, i, None] * z
            back = np.swapaxes(R, 1, 2)
            carried = _apply(back, v + _cross(wd, p) + _cross(w, _cross(w, p)))  # 6.47
            w, wd = _apply(back, w), _apply(back, wd)
            if body.prismatic:
                v = carried + 2 * _cross(w, speed) + rate  # 6.35
            else:
                wd = wd + _cross(w, speed) + rate  # 6.46
                w = w + speed  # 6.45
                v = carried
            at_com = v + _cross(wd, body.com) + _cross(w, _cross(w, body.com))  # 6.48
            forces.append(body.mass * at_com)  # 6.49
            moments.append(wd @ body.inertia.T + _cross(w, w @ body.inertia.T))  # 6.50
            turns.append(R)
            arms.append(p)
        tau = np.empty_like(q)
        f = np.zeros((count, 3))  # what link i+1 takes from link i, in frame i
        n = np.zeros((count, 3))
        for i in reversed(range(len(self._bodies))):
            body = self._bodies[i]
            n = moments[i] + n + _cross(body.com, forces[i])  # 6.52
            f = forces[i] + f  # 6.51
            tau[:, i] = (f if body.prismatic else n)[:, 2]  # 6.53
            if self._at_motor:
                way = np.sign(qd[:, i]) if self._rest is None else np.tanh(qd[:, i] / self._rest)
                tau[:, i] += body.motor * qdd[:, i] + body.viscous * qd[:, i] + body.coulomb * way
            f = _apply(turns[i], f)
            n = _apply(turns[i], n) + _cross(arms[i], f)
        return tau


def _transform(body: _Body, q: Floats) -> tuple[Floats, Floats]:
    """Frame i in frame i-1: rotation ``[N, 3, 3]`` and origin ``[N, 3]`` (Craig 3.6)."""
    if body.prismatic:
        c, s, d = np.full_like(q, body.ct), np.full_like(q, body.st), body.d + q
    else:
        cq, sq = np.cos(q), np.sin(q)
        c, s = cq * body.ct - sq * body.st, sq * body.ct + cq * body.st
        d = np.full_like(q, body.d)
    zero = np.zeros_like(q)
    rows = [
        [c, -s, zero],
        [s * body.ca, c * body.ca, zero - body.sa],
        [s * body.sa, c * body.sa, zero + body.ca],
    ]
    R = np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)
    return R, np.stack([zero + body.a, -body.sa * d, body.ca * d], axis=-1)


def _apply(R: Floats, x: Floats) -> Floats:
    result: Floats = np.einsum("kij,kj->ki", R, x)
    return result


def _cross(x: Floats, y: Floats) -> Floats:
    return np.stack(
        [
            x[..., 1] * y[..., 2] - x[..., 2] * y[..., 1],
            x[..., 2] * y[..., 0] - x[..., 0] * y[..., 2],
            x[..., 0] * y[..., 1] - x[..., 1] * y[..., 0],
        ],
        axis=-1,
    )


def _body(link: Link, parameters: Parameters) -> _Body:
    def real(value: Any) -> float:
        return rounded(number(value, parameters))

    joint, i = link.joint, link.inertia
    tensor = [[i.xx, i.xy, i.xz], [i.xy, i.yy, i.yz], [i.xz, i.yz, i.zz]]
    return _Body(
        prismatic=joint.kind == "prismatic",
        ca=float(joint.alpha.cos),
        sa=float(joint.alpha.sin),
        a=real(joint.a),
        d=real(joint.d),
        ct=float(joint.theta.cos),
        st=float(joint.theta.sin),
        mass=real(link.mass),
        com=np.array([real(x) for x in link.com]),
        inertia=np.array([[real(x) for x in row] for row in tensor]),
        motor=real(joint.motor_inertia),
        viscous=real(joint.viscous),
        coulomb=real(joint.coulomb),
    )
