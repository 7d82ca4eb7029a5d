"""What a kernel's functions should give, from the textbook and from docs/, by other means than robodyn's.

Nothing here imports robodyn. Bodies are 4 x 4 matrices of their masses' moments, places 4 x 4 products of the
rows' matrices, energies traces of both; torques are Lagrange's equations of these energies, with CasADi's
algorithmic differentiation (exact to rounding), and reactions d'Alembert's sums ``int (x'' - g) x^T dm``.
Drives are the formulas of docs/effects.md, in the order that the page states.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from independent import drives

Array = np.ndarray[Any, np.dtype[np.float64]]
SX = Any  # casadi has no types


def turn(axis: int, angle: Any) -> SX:
    """4 x 4: a turn about an axis."""
    matrix, (i, j) = ca.SX.eye(4), ((1, 2), (2, 0), (0, 1))[axis]
    matrix[i, i] = matrix[j, j] = ca.cos(angle)
    matrix[j, i], matrix[i, j] = ca.sin(angle), -ca.sin(angle)
    return matrix


def shift(x: Any = 0, y: Any = 0, z: Any = 0) -> SX:
    """4 x 4: a translation."""
    matrix = ca.SX.eye(4)
    matrix[0, 3], matrix[1, 3], matrix[2, 3] = x, y, z
    return matrix


def pose(place: Mapping[str, Sequence[float]]) -> SX:
    """4 x 4 of ``{xyz, rpy}``: about fixed axes, roll first, as in URDF."""
    roll, pitch, yaw = place.get("rpy", (0, 0, 0))
    return shift(*place.get("xyz", (0, 0, 0))) @ turn(2, yaw) @ turn(1, pitch) @ turn(0, roll)


def moments(mass: Any, com: Any, inertia: Mapping[str, Any]) -> SX:
    """4 x 4: the integrals of ``[x; 1] [x; 1]^T dm`` of a body over its own frame."""
    tensor = ca.SX(3, 3)
    for i in range(3):
        for j in range(3):
            tensor[i, j] = inertia.get("".join(sorted("xyz"[i] + "xyz"[j])), 0)
    c = ca.vertcat(*[ca.SX(x) for x in com])
    second = ca.trace(tensor) / 2 * ca.SX.eye(3) - tensor + mass * c @ c.T
    return ca.vertcat(ca.horzcat(second, mass * c), ca.horzcat(mass * c.T, ca.SX(mass)))


def skew_part(matrix: SX) -> SX:
    """Of ``int a b^T dm`` the vector ``int b x a dm``."""
    return ca.vertcat(matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1])


class Reference:
    """One arm (:mod:`independent.arms`); where its numbers are names, ``values`` has them."""

    def __init__(self, arm: Mapping[str, Any]) -> None:
        self.arm = _numbers(arm, arm.get("values", {}))
        self.links = self.arm["links"]
        self.n = len(self.links)
        self.q, self.qd, self.qdd, self.tau = (ca.SX.sym(x, self.n) for x in ("q", "qd", "qdd", "tau"))
        self.w = ca.SX.sym("w", 6)
        self.effects = drives.entries(self.arm)
        self.motor_side = self.arm.get("torque_side", "motor") == "motor"
        self._compiled: dict[str, Any] = {}
        self._place()

    def _place(self) -> None:
        """Frames of the links (those of the rows), and frames with z along each joint, in the world."""
        self.base = pose(self.arm.get("base", {}))
        place, self.frames, self.joints = self.base, [], []
        for k, link in enumerate(self.links):
            a, alpha, d, theta = (link.get(x, 0) for x in ("a", "alpha", "d", "theta"))
            if link["joint"] == "revolute":
                theta = theta + self.q[k]
            else:
                d = d + self.q[k]
            twist, screw = shift(x=a) @ turn(0, alpha), turn(2, theta) @ shift(z=d)
            if self.arm.get("convention", "mdh") == "mdh":
                joint = place = place @ twist @ screw
            else:
                joint = place @ screw
                place = joint @ twist
            self.frames.append(place)
            self.joints.append(joint)
        self.tool = place @ pose(self.arm.get("tool", {}))

    @cached_property
    def bodies(self) -> list[SX]:
        """Moments of each link over its frame, with errors of its numbers and the payload of the last."""
        bodies = []
        for k, link in enumerate(self.links):
            mass, com = link.get("mass", 0), list(link.get("com", (0, 0, 0)))
            inertia = dict(link.get("inertia", {}))
            for entry in self.effects.of("inertial_error", k):
                mass = mass + entry.get("delta_mass", 0)
                com = [x + entry.get(f"delta_com_{axis}", 0) for x, axis in zip(com, "xyz", strict=True)]
                for ij in ("xx", "yy", "zz", "xy", "xz", "yz"):
                    inertia[ij] = inertia.get(ij, 0) + entry.get(f"delta_{ij}", 0)
            bodies.append(moments(mass, com, inertia))
        for entry in self.effects.of("payload", None):
            load = moments(entry["mass"], entry.get("com", (0, 0, 0)), entry.get("inertia", {}))
            bodies[-1] = bodies[-1] + load
        return bodies

    @cached_property
    def gravity(self) -> SX:
        """Along the world's axes, which are the base's where there is no ``base``."""
        g = ca.vertcat(*[ca.SX(x) for x in self.arm.get("gravity", (0, 0, -9.81))])
        for entry in self.effects.of("base_tilt", None):
            g = (turn(1, entry.get("tilt_y", 0)) @ turn(0, entry.get("tilt_x", 0)))[:3, :3] @ g
        return g

    def rate(self, x: SX) -> SX:
        """The derivative by time."""
        state = ca.vertcat(self.q, self.qd)
        return ca.reshape(ca.jtimes(ca.vec(x), state, ca.vertcat(self.qd, self.qdd)), x.shape)

    # energies, and Lagrange's equations

    @cached_property
    def kinetic_of_links(self) -> SX:
        speeds = [self.rate(frame) for frame in self.frames]
        pairs = zip(speeds, self.bodies, strict=True)
        return sum(ca.trace(v @ body @ v.T) / 2 for v, body in pairs)

    @cached_property
    def kinetic_of_motors(self) -> SX:
        """Of rotors, and of motors that drive two joints; 0 where torques are those behind the gears."""
        if not self.motor_side:
            return ca.SX(0)
        energy = ca.SX(0)
        for k, link in enumerate(self.links):
            rotor = link.get("motor_inertia", 0) + sum(
                x["inertia"] for x in self.effects.of("rotor_inertia", k)
            )
            energy += rotor * self.qd[k] ** 2 / 2
            for entry in self.effects.of("motor_coupling", k):
                turns = self.qd[k] + entry.get("ratio", 1) * self.qd[entry["with"] - 1]
                energy += entry.get("inertia", 0) * turns**2 / 2
        return energy

    @cached_property
    def potential(self) -> SX:
        """0 where a mass stands at the origin of the base frame."""
        origin = self.base[:3, 3]
        energy = ca.SX(0)
        for frame, body in zip(self.frames, self.bodies, strict=True):
            first = (frame @ body[:, 3])[:3]  # mass times place
            energy -= self.gravity.T @ (first - body[3, 3] * origin)
        return energy

    def by_lagrange(self, kinetic: SX, potential: SX) -> SX:
        """``d/dt dL/dqd - dL/dq``."""
        momentum = ca.gradient(kinetic, self.qd)
        return self.rate(momentum) - ca.gradient(kinetic - potential, self.q)

    @cached_property
    def of_links(self) -> SX:
        """Torques of the links alone, the wrench on the tool among the forces."""
        return self.by_lagrange(self.kinetic_of_links, self.potential) - self.jacobian.T @ self.w

    @cached_property
    def of_motors(self) -> SX:
        """Torques of what turns with the motors."""
        return self.by_lagrange(self.kinetic_of_motors, ca.SX(0))

    @cached_property
    def reactions(self) -> list[tuple[SX, SX]]:
        """Force and moment of the link before on each link, about the joint's frame and along its axes."""
        far = self.tool[:3, 3]
        found = []
        for k, joint in enumerate(self.joints):
            origin, axes = joint[:3, 3], joint[:3, :3]
            force, moment = -self.w[:3], -self.w[3:] - ca.cross(far - origin, self.w[:3])
            for frame, body in zip(self.frames[k:], self.bodies[k:], strict=True):
                second = self.rate(self.rate(frame)) @ body @ frame.T  # int x'' [x; 1]^T dm
                first = (frame @ body[:, 3])[:3]
                pushed = second[:3, 3] - self.gravity * body[3, 3]
                force += pushed
                moment += skew_part(second[:3, :3] - self.gravity @ first.T) - ca.cross(origin, pushed)
            found.append((axes.T @ force, axes.T @ moment))
        return found

    @cached_property
    def torques(self) -> SX:
        """What inverse dynamics gives, the drives in it."""
        return drives.torques(self)

    @cached_property
    def columns(self) -> dict[tuple[str, int], SX]:
        """Torques by the numbers of each link (from 1) that enter linearly, a column each: mass, first and
        second moments about the joint's frame, rotor and friction."""
        found = {}
        for k, (joint, link) in enumerate(zip(self.joints, range(1, self.n + 1), strict=True)):
            for name, body in _units().items():
                kinetic = ca.trace(self.rate(joint) @ body @ self.rate(joint).T) / 2
                first = (joint @ body[:, 3])[:3] - body[3, 3] * self.base[:3, 3]
                found[name, link] = self.by_lagrange(kinetic, -self.gravity.T @ first)
            if self.motor_side:
                unit = ca.SX.eye(self.n)[:, k]
                found["rotor", link] = unit * self.qdd[k]
                found["viscous", link] = unit * self.qd[k]
                found["coulomb", link] = unit * drives.direction(self.arm, self.qd[k])
        return found

    # kinematics

    @cached_property
    def jacobian(self) -> SX:
        turning = self.tool[:3, :3]
        columns = []
        for k in range(self.n):
            spun = ca.reshape(ca.jacobian(ca.vec(turning), self.q[k]), 3, 3) @ turning.T
            columns.append(ca.vertcat(spun[2, 1], spun[0, 2], spun[1, 0]))
        return ca.vertcat(ca.jacobian(self.tool[:3, 3], self.q), ca.horzcat(*columns))

    @cached_property
    def rigid_mass_matrix(self) -> SX:
        return ca.hessian(self.kinetic_of_links, self.qd)[0]

    @cached_property
    def mass_matrix(self) -> SX:
        return ca.hessian(self.kinetic_of_links + self.kinetic_of_motors, self.qd)[0]

    @cached_property
    def christoffel(self) -> list[list[SX]]:
        """``h[i][k]``, a row over m: symbols of the first kind."""
        M, q = self.rigid_mass_matrix, self.q
        by = [ca.reshape(ca.jacobian(ca.vec(M), q[k]), self.n, self.n) for k in range(self.n)]
        return [
            [
                ca.horzcat(*[(by[m][i, k] + by[k][i, m] - by[i][k, m]) / 2 for m in range(self.n)])
                for k in range(self.n)
            ]
            for i in range(self.n)
        ]

    @cached_property
    def coriolis_matrix(self) -> SX:
        return ca.vertcat(
            *[ca.horzcat(*[self.christoffel[i][k] @ self.qd for k in range(self.n)]) for i in range(self.n)]
        )

    # numbers

    def value(self, name: str, expression: Callable[[], SX], **at: Any) -> Array:
        """An expression's value; ``name`` is what it is remembered by, inputs left out are 0."""
        if name not in self._compiled:
            inputs = [self.q, self.qd, self.qdd, self.w]
            self._compiled[name] = ca.Function("f", inputs, [ca.densify(expression())])
        state = [at.get(x, np.zeros(self.n)) for x in ("q", "qd", "qdd")]
        return np.array(self._compiled[name](*state, at.get("w", np.zeros(6))), dtype=np.float64)

    def inverse_dynamics(self, **at: Any) -> Array:
        return self.value("torques", lambda: self.torques, **at).ravel()

    def slopes(self, by: str, **at: Any) -> Array:
        """Of inverse dynamics by ``q``, ``qd`` or ``qdd``."""
        return self.value(f"by {by}", lambda: ca.jacobian(self.torques, getattr(self, by)), **at)

    def accelerations(self, tau: Array, **at: Any) -> Array:
        """Where torques are affine in the accelerations."""
        at.pop("qdd", None)
        return np.asarray(
            np.linalg.solve(self.slopes("qdd", **at), tau - self.inverse_dynamics(**at)), np.float64
        )


def _numbers(value: Any, values: Mapping[str, float]) -> Any:
    """Plain data with numbers in the place of run-time parameters."""
    if isinstance(value, dict):
        return {key: _numbers(x, values) for key, x in value.items()}
    if isinstance(value, list | tuple):
        return [_numbers(x, values) for x in value]
    return values.get(value, value) if isinstance(value, str) else value


def _units() -> dict[str, SX]:
    """Bodies of which one moment is 1 and all others are 0."""
    found = {}
    places = {"mx": (0, 3), "my": (1, 3), "mz": (2, 3), "m": (3, 3)}
    places |= {"K" + "xyz"[i] + "xyz"[j]: (i, j) for i in range(3) for j in range(i, 3)}
    for name, (i, j) in places.items():
        body = ca.SX(4, 4)
        body[i, j] = body[j, i] = 1
        found[name] = body
    return found


def same_turn(first: float, second: float) -> float:
    """How far two angles are apart."""
    return abs(math.remainder(first - second, 2 * math.pi))
