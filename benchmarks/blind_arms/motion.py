"""The arm moved by MuJoCo under a controller, step by step.

Steps are a leapfrog's: positions q_k, torques u_k and accelerations a_k at t_k fulfil the equations of
motion, and a_k is the central second difference of the positions. What depends smoothly on velocities (the
rigid arm, dampers, the controller) goes by those at t_k, foreseen from half a step before to the second
order: torques that are half a step late would pass for a damping. Friction goes by those half a step before,
which is what lets it hold a joint at rest.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from benchmarks.blind_arms.forces import Forces, forces
from benchmarks.blind_arms.model import Tool, build_model
from benchmarks.blind_arms.now import Now, Scale

from peers.numbers import Array
from robodyn.robot.model import Robot
from robodyn.simulate.trajectories.trajectory import Law

_POSES = 40
#: Where the drive clips, the controller answers to errors by at most this share of its limit.
_ANSWER = 0.25


@dataclass(frozen=True, slots=True)
class Run:
    """What happened: times [K]; positions, rates and command torques [K, n] on the encoders' side."""

    t: Array
    q: Array
    qd: Array
    qdd: Array
    tau: Array


@dataclass(frozen=True, slots=True)
class Drive:
    """The controller: ``kp``, ``kd`` [n] and torques ``ahead`` [steps, n] of reference ``q``, ``qd``
    [steps, n]; encoders are off by ``offset`` [n]; the drives give at most ``limit`` [n]."""

    q: Array
    qd: Array
    ahead: Array
    kp: Array
    kd: Array
    offset: Array
    limit: Array


def inverse(robot: Robot, q: Array, qd: Array, qdd: Array) -> Array:
    """Torques [K, n] of the rigid arm with rotors and payload, by ``mj_inverse``; no friction."""
    model = build_model(robot, 1e-3)
    data = mujoco.MjData(model)
    result = np.empty_like(q)
    handler = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(lambda _: None)
    try:
        for k in range(len(q)):
            data.qpos[:], data.qvel[:], data.qacc[:] = q[k], qd[k], qdd[k]
            mujoco.mj_inverse(model, data)
            result[k] = data.qfrc_inverse
    finally:
        mujoco.set_mju_user_warning(handler)
    return result


def felt_inertia(robot: Robot, Q: Array) -> tuple[Array, Array]:
    """Mean of the mass matrix's diagonal, and the least inertia that a motor feels, [n] each."""
    model = build_model(robot, 1e-3)
    data = mujoco.MjData(model)
    diagonal, least = np.zeros(robot.n), np.full(robot.n, np.inf)
    poses = Q[:: max(1, len(Q) // _POSES)]
    for q in poses:
        data.qpos[:] = q
        mujoco.mj_forward(model, data)
        inverse_of = np.zeros((robot.n, robot.n))
        mujoco.mj_solveM(model, data, inverse_of, np.eye(robot.n))
        diagonal += np.diag(np.linalg.inv(inverse_of)) / len(poses)
        least = np.minimum(least, 1 / np.diag(inverse_of))
    return diagonal, least


def reference(law: Law, duration: float, step: float) -> tuple[Array, Array, Array, Array]:
    """Times [K] and the motion [K, n] at every step."""
    t = np.arange(round(duration / step) + 1) * step
    return t, *law(t)


def run(robot: Robot, drive: Drive, scale: Scale, every: int, tool: Tool | None = None) -> Run:
    """The motion of ``robot`` with its effects, every ``every``-th step of it."""
    acting = forces(robot, scale)
    return _Stepper(robot, drive, scale, acting, tool).run(every)


class _Stepper:
    def __init__(self, robot: Robot, drive: Drive, scale: Scale, acting: Forces, tool: Tool | None) -> None:
        self.robot, self.drive, self.scale, self.acting = robot, drive, scale, acting
        self.motors = sorted(acting.twist)
        self.model = build_model(robot, scale.step, self.motors, tool)
        self.data = mujoco.MjData(self.model)
        n = robot.n
        self.first = n + (tool is not None)
        self.rotor = self.model.dof_armature[:n].copy()
        # Where the encoder of a joint with a motor apart sits, and where its motor does.
        self.seen = np.arange(n)
        self.place = np.arange(n)
        for k, j in enumerate(self.motors):
            self.place[j] = self.first + k
            side = next(e for e in robot.effects_at(j + 1) if e.effect in ("joint_elasticity", "backlash"))
            self.seen[j] = self.place[j] if side.text("encoder") == "motor" else j
        self.apart = bool(self.motors)
        self.contacts = [e for e in robot.effects if e.effect == "external_contact"]

    def run(self, every: int) -> Run:
        model, data, drive, n = self.model, self.data, self.drive, self.robot.n
        acting, h = self.acting, self.scale.step
        steps = len(drive.q)
        rows = (steps - 1) // every + 1
        Q, V, A, U = (np.empty((rows, n)) for _ in range(4))
        q, v, a, f = data.qpos, data.qvel, data.qacc, data.qfrc_applied
        q[:n] = drive.q[0] - drive.offset
        v[:n] = drive.qd[0]
        self._preload()
        now = Now(n, sticks=self.scale.sticks)
        now.q, now.theta = q[:n], q[:n]
        now.a = now.alpha = a[:n]
        now.load = self._rigid_at_rest()
        now.f, now.m = np.zeros((n, 3)), np.zeros((n, 3))
        clipped = bool(np.isfinite(drive.limit).any())
        forces_of_joint = (*acting.link, *acting.bearing, *acting.gear, *acting.motor)
        between, place = v.copy(), q.copy()
        now.v, now.w = between[:n], between[:n]
        for k in range(steps):
            v[:] = between + (h / 2 if k else 0.0) * a
            place[:] = q
            if self.apart:
                now.theta, now.w, now.alpha = q[self.place], between[self.place], a[self.place]
                y, rate = q[self.seen], v[self.seen]
            else:
                y, rate = q[:n], v[:n]
            answer = drive.kp * (drive.q[k] - y - drive.offset) + drive.kd * (drive.qd[k] - rate)
            if clipped:
                answer = np.clip(answer, -_ANSWER * drive.limit, _ANSWER * drive.limit)
            command = drive.ahead[k] + answer
            given = np.clip(command, -drive.limit, drive.limit) if clipped else command
            now.begin_step(k * h)
            for force in forces_of_joint:
                force(now)
            if now.sticks:
                model.dof_frictionloss[:] = 0
                model.dof_frictionloss[:n] = now.held_link
                model.dof_frictionloss[self.place] += now.held_motor
            mujoco.mj_step1(model, data)
            f[:n] = given - now.link - now.gear - now.motor
            if self.apart:
                self._couple(now, given)
            outside = self._touch(now.t) if self.contacts else None
            if outside is not None:
                f[: len(outside)] += outside
            if acting.couplings:
                self._add_coupled_inertia()
            if k % every == 0:
                row = k // every
                Q[row], V[row], U[row] = y, between[self.seen], command
            mujoco.mj_step2(model, data)
            between += h * a
            q[:] = place + h * between
            if k % every == 0:
                A[k // every] = a[self.seen] if self.apart else a[:n]
            now.load = f[:n] + data.qfrc_constraint[:n] - self.rotor * a[:n]
            if outside is not None:
                now.load -= outside[:n]
            for c in acting.couplings:
                now.load += c.row * (c.inertia * float(c.row @ a[:n]))
            if acting.reactions:
                self._react(now)
        V += A * (h / 2)
        return Run(np.arange(rows) * (every * h), Q, V, A, U)

    def _preload(self) -> None:
        """Motors apart start with the twist that holds the arm."""
        if not self.motors:
            return
        held = self._rigid_at_rest()
        for j in self.motors:
            low, high = -1.0, 1.0
            for _ in range(60):
                middle = (low + high) / 2
                low, high = (middle, high) if self.acting.twist[j](middle, 0.0) < held[j] else (low, middle)
            self.data.qpos[self.place[j]] = self.data.qpos[j] + (low + high) / 2
            self.data.qvel[self.place[j]] = self.data.qvel[j]

    def _rigid_at_rest(self) -> Array:
        mujoco.mj_forward(self.model, self.data)
        return self.data.qfrc_bias[: self.robot.n].copy()

    def _couple(self, now: Now, given: Array) -> None:
        q, v, f = self.data.qpos, self.data.qvel, self.data.qfrc_applied
        for j in self.motors:
            at = self.place[j]
            passed = self.acting.twist[j](float(q[at] - q[j]), float(v[at] - v[j]))
            f[at] = given[j] - now.motor[j] - now.gear[j] - passed
            f[j] = passed - now.link[j]

    def _touch(self, t: float) -> Array | None:
        total = None
        for entry in self.contacts:
            if entry.number("start") <= t < entry.number("end"):
                total = np.zeros(self.model.nv) if total is None else total
                body = int(entry["link"])
                push = np.array([entry.number(f"force_{axis}") for axis in "xyz"])
                place = self.data.xpos[body].copy()
                if "rise" in entry:  # acts beside the frame's origin, rises and fades
                    beside = np.array([entry.number(axis) for axis in "xyz"])
                    place += self.data.xmat[body].reshape(3, 3) @ beside
                    edge = min(t - entry.number("start"), entry.number("end") - t)
                    rise = entry.number("rise")
                    push *= np.sin(np.pi / 2 * edge / rise) ** 2 if edge < rise else 1.0
                mujoco.mj_applyFT(self.model, self.data, push, np.zeros(3), place, body, total)
        return total

    def _add_coupled_inertia(self) -> None:
        """The motor's inertia on two joints: what its acceleration takes, by the matrix-inversion lemma."""
        data, model = self.data, self.model
        for c in self.acting.couplings:
            if not c.inertia:
                continue
            both = np.zeros((2, model.nv))
            both[0, : len(c.row)] = c.row
            # Friction that sticks is not known yet: that of a step ago.
            both[1] = data.qfrc_applied + data.qfrc_passive - data.qfrc_bias + data.qfrc_constraint
            solved = np.zeros_like(both)
            mujoco.mj_solveM(model, data, solved, both)
            turned = both[0] @ solved[1] / (1 + c.inertia * (both[0] @ solved[0]))
            data.qfrc_applied[: len(c.row)] -= c.row * (c.inertia * turned)

    def _react(self, now: Now) -> None:
        data = self.data
        mujoco.mj_rnePostConstraint(self.model, data)
        root = data.subtree_com[1]
        for j in self.acting.reactions:
            twist, force = data.cfrc_int[j + 1, :3], data.cfrc_int[j + 1, 3:]
            R = data.xmat[j + 1].reshape(3, 3)
            x, y, z = (root - data.xpos[j + 1]).tolist()
            fx, fy, fz = force.tolist()
            now.f[j] = force @ R
            turned = np.array([y * fz - z * fy, z * fx - x * fz, x * fy - y * fx])
            now.m[j] = (twist + turned) @ R
