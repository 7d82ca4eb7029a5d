"""The plain recursive Newton-Euler in double precision: the reference that a kernel is compared with.

Written from the textbook (J. J. Craig, Introduction to Robotics, 6.45 to 6.53; modified DH frames) with
vectors and cross products, over many states at once. It knows nothing of the rest of robodyn but the
robot's description, and nothing in it is simplified.

On top of the recursion come the drives (:mod:`robodyn.verify.effects`). Rotor inertia acts as
``motor_inertia * qdd`` on the joint's own axis; friction is ``viscous * qd + coulomb * sgn(qd)`` with
sgn(0) = 0, or ``tanh(qd / rest_velocity)`` in place of the sign, or 0 within a dead band. All that is behind
the gear is left out where the torque is the link's.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.robot.coupling import no_couplings
from robodyn.robot.model import EffectEntry, Inertia, Link, Placement, Robot
from robodyn.verify.effects import Drives, Reactions
from robodyn.verify.numbers import Parameters, exact_value, filled
from robodyn.verify.numbers import real as rounded

#: Newton's rounds for accelerations under friction that depends on them, and halvings of a step.
_ROUNDS, _HALVINGS = 60, 40
#: Its square is nothing beside 1, whatever it is multiplied by.
_IMAGINARY_STEP = 1e-60
#: What share of the torques may be left over: what ends the search, and what is refused after it.
_CONVERGED, _TOO_MUCH = 1e-14, 1e-9


@dataclass(frozen=True, slots=True)
class _Solid:
    """A rigid body in numbers: ``inertia`` [3, 3] about the centre of mass ``com`` [3]."""

    mass: float
    com: Floats
    inertia: Floats


@dataclass(frozen=True, slots=True)
class _Body:
    """A link in numbers: its frame, and the solids that are fixed to it."""

    prismatic: bool
    ca: float
    sa: float
    a: float
    b: float
    d: float
    ct: float
    st: float
    solids: tuple[_Solid, ...]


class Reference:
    """Plain dynamics of ``robot`` and its effects at given values of its run-time parameters.

    Effects that remember are in their steady form. Every method takes one state ``[n]`` or many ``[N, n]``
    (rad or m, and per second) and returns as many.

    Raises
    ------
    InputError: a run-time parameter has no value; an array has the wrong shape; joints follow others
        (:mod:`robodyn.verify.coupled`).
    """

    def __init__(self, robot: Robot, parameters: Parameters | None = None) -> None:
        no_couplings(robot, "a reference of joints")
        values = filled(robot, parameters)
        self.robot = robot
        loads = [_load(entry, values) for entry in robot.effects if entry.effect == "payload"]
        self._bodies = [
            _body(link, loads if i == robot.n else [], values) for i, link in enumerate(robot.links, 1)
        ]
        self._gravity = np.array([float(g) for g in robot.base_gravity])
        self._drives = Drives(robot, values)

    def inverse_dynamics(
        self, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, wrench: Floats | None = None
    ) -> Floats:
        """Joint torques [N m or N] that give the accelerations ``qdd``; ``[n]`` or ``[N, n]``. ``wrench``
        ``[N, 6]``: force [N] and moment [N m] on the tool, at its origin, along the world's axes."""
        (positions, speeds, rates), lead = self._read(q, qd, qdd)
        return self._torque(positions, speeds, rates, wrench).reshape((*lead, self.robot.n))

    def gravity(self, q: ArrayLike) -> Floats:
        """Torques [N m or N] that hold the arm still at ``q``; ``[n]`` or ``[N, n]``."""
        (states,), lead = self._read(q)
        rest = np.zeros_like(states)
        return self._torque(states, rest, rest).reshape((*lead, self.robot.n))

    def bias(self, q: ArrayLike, qd: ArrayLike) -> Floats:
        """Torques [N m or N] at zero acceleration: Coriolis, centrifugal, gravity, friction; like ``q``."""
        (positions, speeds), lead = self._read(q, qd)
        rest = np.zeros_like(positions)
        return self._torque(positions, speeds, rest).reshape((*lead, self.robot.n))

    def mass_matrix(self, q: ArrayLike) -> Floats:
        """``[n, n]`` or ``[N, n, n]``: column j is the torque of a unit acceleration of joint j alone.
        Friction is not in it."""
        (positions,), lead = self._read(q)
        n = self.robot.n
        rest = np.zeros_like(positions)
        matrix = np.empty((len(positions), n, n))
        for j in range(n):
            unit = np.zeros_like(positions)
            unit[:, j] = 1.0
            matrix[:, :, j] = self._rigid(positions, rest, unit, np.zeros(3)).tau
        return (matrix + self._drives.inertia()).reshape((*lead, n, n))

    def tool_pose(self, q: ArrayLike) -> Floats:
        """Frame ``[R p]`` of the tool in the world (1 and m); ``[3, 4]`` or ``[N, 3, 4]``."""
        return np.asarray(self.frames(q)[..., -1, :, :])

    def frames(self, q: ArrayLike) -> Floats:
        """Frames ``[R p]`` of the links and of the tool in the world (1 and m); ``[n + 1, 3, 4]`` or
        ``[N, n + 1, 3, 4]``."""
        (states,), lead = self._read(q)
        R, p = (np.broadcast_to(x, (len(states), *x.shape)) for x in _placed(self.robot.base))
        steps = [_transform(body, states[:, i]) for i, body in enumerate(self._bodies)]
        frames = []
        for turn, arm in (*steps, _placed(self.robot.tool)):
            R, p = R @ turn, p + (R @ arm[..., None])[..., 0]
            frames.append(np.concatenate([R, p[:, :, None]], axis=2))
        return np.stack(frames, axis=1).reshape((*lead, self.robot.n + 1, 3, 4))

    def torque_slope(
        self, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, dq: ArrayLike, dqd: ArrayLike
    ) -> Floats:
        """Derivative of the torques [N m or N] at the accelerations ``qdd`` along the direction ``dq, dqd``
        of positions and velocities; ``[n]`` or ``[N, n]``.

        By an imaginary step (W. Squire and G. Trapp 1998): as no difference is taken, it is as exact as the
        torques. Where ``|x|`` and ``sgn x`` have no derivative it is 0.
        """
        (positions, speeds, rates, turned, hastened), lead = self._read(q, qd, qdd, dq, dqd)
        step = 1j * _IMAGINARY_STEP
        arrays: tuple[Any, ...] = (positions + step * turned, speeds + step * hastened, rates + 0j)
        tau = self._torque(*arrays)
        return np.imag(tau).reshape((*lead, self.robot.n)) / _IMAGINARY_STEP

    def forward_dynamics(self, q: ArrayLike, qd: ArrayLike, tau: ArrayLike) -> Floats:
        """Joint accelerations [rad/s^2 or m/s^2] under the torques ``tau``; ``[n]`` or ``[N, n]``.

        Raises
        ------
        InputError: the mass matrix is singular at one of the states; friction that depends on the load locks
        the arm, so that no accelerations, or many, fit the torques.
        """
        (positions, speeds, torques), lead = self._read(q, qd, tau)
        try:
            rest = torques - self.bias(positions, speeds)
            result = _solve(self.mass_matrix(positions), rest)
            if self._drives.feels_load:
                result = self._implicit(positions, speeds, torques, result)
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

    def _implicit(self, q: Floats, qd: Floats, tau: Floats, qdd: Floats) -> Floats:
        """Accelerations whose torques are ``tau``, from the guess ``qdd``; all ``[N, n]``.

        Newton's method with differences for slopes, which halves a step that does not bring it nearer.
        """
        bias = self._torque(q, qd, np.zeros_like(q))
        yardstick = np.abs(tau).max(1) + np.abs(bias).max(1)
        left = self._torque(q, qd, qdd) - tau
        for _ in range(_ROUNDS):
            slopes = np.empty((*q.shape, self.robot.n))
            for j in range(self.robot.n):
                moved = qdd.copy()
                moved[:, j] += 1e-6 * (1 + np.abs(qdd[:, j]))
                change = self._torque(q, qd, moved) - tau - left
                slopes[:, :, j] = change / (moved - qdd)[:, j, None]
            step = -_solve(slopes, left)
            near = np.abs(left).max(1) <= _CONVERGED * yardstick
            gone = near.copy()
            for halvings in range(_HALVINGS):
                tried = np.where(gone[:, None], qdd, qdd + step * 0.5**halvings)
                then = self._torque(q, qd, tried) - tau
                nearer = ~gone & (np.linalg.norm(then, axis=1) < np.linalg.norm(left, axis=1))
                qdd, left = np.where(nearer[:, None], tried, qdd), np.where(nearer[:, None], then, left)
                gone |= nearer
                if gone.all():
                    break
            if (gone == near).all():
                break
        lost = int(np.sum(np.abs(left).max(1) > _TOO_MUCH * yardstick))
        if lost:
            raise InputError(
                f"{self.robot.name}: no accelerations fit the torques",
                found=f"{lost} of {len(q)} states where friction that depends on the load locks the arm",
                remedy="lower mu or the radius of its bearings, or raise the efficiency of its gears",
            )
        return qdd

    def _torque(self, q: Floats, qd: Floats, qdd: Floats, wrench: Floats | None = None) -> Floats:
        """Torques of the rigid arm and of its drives over states ``[N, n]``."""
        return self._drives.torque(q, qd, qdd, self._rigid(q, qd, qdd, self._gravity, wrench))

    def _rigid(
        self, q: Floats, qd: Floats, qdd: Floats, gravity: Floats, wrench: Floats | None = None
    ) -> Reactions:
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
            force, moment = np.zeros((count, 3)), np.zeros((count, 3))
            for solid in body.solids:
                at_com = v + _cross(wd, solid.com) + _cross(w, _cross(w, solid.com))  # 6.48
                F = solid.mass * at_com  # 6.49
                N = wd @ solid.inertia.T + _cross(w, w @ solid.inertia.T)  # 6.50
                force, moment = force + F, moment + N + _cross(solid.com, F)
            forces.append(force)
            moments.append(moment)
            turns.append(R)
            arms.append(p)
        vectors = np.empty((2, *q.shape, 3), q.dtype)
        reactions = Reactions(np.empty_like(q), *vectors)
        f = np.zeros((count, 3))  # what link i+1 takes from link i, in frame i
        n = np.zeros((count, 3))
        if wrench is not None:  # the world is the link beyond the last: what acts from it need not be held
            back = np.swapaxes(self.tool_pose(q)[:, :, :3], 1, 2)
            turn, arm = _placed(self.robot.tool)
            f = -_apply(back, wrench[:, :3]) @ turn.T
            n = -_apply(back, wrench[:, 3:]) @ turn.T + _cross(np.broadcast_to(arm, f.shape), f)
        for i in reversed(range(len(self._bodies))):
            body = self._bodies[i]
            n = moments[i] + n  # 6.52, moments about the frame's origin
            f = forces[i] + f  # 6.51
            reactions.f[:, i], reactions.n[:, i] = f, n
            reactions.tau[:, i] = (f if body.prismatic else n)[:, 2]  # 6.53
            f = _apply(turns[i], f)
            n = _apply(turns[i], n) + _cross(arms[i], f)
        return reactions


def _placed(place: Placement | None) -> tuple[Floats, Floats]:
    """Rotation ``[3, 3]`` and origin ``[3]`` of a frame in another."""
    if place is None:
        return np.eye(3), np.zeros(3)
    return np.array(place.rotation, np.float64), np.array(place.xyz, np.float64)


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
    y, z = body.ca * body.b - body.sa * d, body.sa * body.b + body.ca * d
    return R, np.stack([zero + body.a, y, z], axis=-1)


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


def _solve(matrix: Floats, vector: Floats) -> Floats:
    result: Floats = np.linalg.solve(matrix, vector[..., None])[..., 0].astype(np.float64)
    return result


def _solid(mass: Any, com: Any, i: Inertia, parameters: Parameters) -> _Solid:
    tensor = [[i.xx, i.xy, i.xz], [i.xy, i.yy, i.yz], [i.xz, i.yz, i.zz]]
    numbers = [[rounded(exact_value(x, parameters)) for x in row] for row in ([mass], com, *tensor)]
    return _Solid(numbers[0][0], np.array(numbers[1]), np.array(numbers[2:]))


def _load(entry: EffectEntry, parameters: Parameters) -> _Solid:
    inertia = entry["inertia"] if "inertia" in entry else Inertia()
    return _solid(entry["mass"], entry["com"], inertia, parameters)


def _body(link: Link, loads: list[_Solid], parameters: Parameters) -> _Body:
    joint = link.joint
    a, b, d = (rounded(exact_value(x, parameters)) for x in (joint.a, joint.b, joint.d))
    ca, sa, ct, st = map(float, (joint.alpha.cos, joint.alpha.sin, joint.theta.cos, joint.theta.sin))
    solids = (_solid(link.mass, link.com, link.inertia, parameters), *loads)
    return _Body(joint.kind == "prismatic", ca, sa, a, b, d, ct, st, solids)
