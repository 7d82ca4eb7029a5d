"""A robot's dynamics over samples ``[K, n]``: torques, loads on the joints, mass matrix, regressor."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.drives.drive import (
    Acting,
    Layer,
    Loads,
    Rates,
    at_motors,
    combined,
    layer_of,
    passed_on,
    rigid_part,
)
from robodyn.dynamics.arm import Arm, Motion, build_arm, build_motion, trigonometry_at
from robodyn.dynamics.joints import smoothed_sign
from robodyn.dynamics.kinematics import frames
from robodyn.dynamics.modified_newton_euler import forward_pass
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.vectors import unmarked
from robodyn.ir.program import Label
from robodyn.robot.filling import without_values
from robodyn.robot.masses import require_masses
from robodyn.robot.model import AXES, Robot

#: Positions, velocities and accelerations [K, n].
Moved = tuple[Floats, Floats, Floats]

#: Results of a rigid arm along a log that are kept for models that differ in their drives.
KEPT_RESULTS: Final = 6

#: Standard inertial parameters of a link, about its frame's origin.
PARAMETERS = ("m", "mx", "my", "mz", *AXES)


@dataclass(frozen=True, slots=True, eq=False)
class Evaluated:
    """A model along a motion, [K, n] each: the rigid arm's torque ``rigid``; what the drives pass on,
    ``passed``; ``total``; forces ``f`` and moments ``m`` [K, n, 3] in the joints."""

    rigid: Floats
    passed: Floats
    total: Floats
    f: Floats
    m: Floats


class Reuse:
    """What models of one rigid arm have in common along the same arrays of motion, worked out once: of models
    that differ in their drives only, the arm is evaluated once. Keeps the ``most`` recent results."""

    def __init__(self, most: int = KEPT_RESULTS) -> None:
        self._most = most
        self._results: list[tuple[str, Arm, Moved, Any]] = []
        self._shifted: list[tuple[Floats, Floats, Floats]] = []

    def shifted(self, q: Floats, by: Floats) -> Floats:
        """``q`` [K, n] less ``by`` [n]; the same array when it is asked for again."""
        if not by.any():
            return q
        for positions, offset, shifted in self._shifted:
            if positions is q and np.array_equal(offset, by):
                return shifted
        shifted = q - by
        self._shifted = [*self._shifted[1 - self._most :], (q, by, shifted)]
        return shifted

    def of(self, what: str, arm: Arm, motion: Moved, evaluate: Callable[[], Any]) -> Any:
        """The result ``what`` of ``arm`` along ``motion``: kept, or from ``evaluate``."""
        for kind, known, arrays, result in self._results:
            if kind == what and all(a is b for a, b in zip(arrays, motion, strict=True)) and known == arm:
                return result
        result = evaluate()
        self._results = [*self._results[1 - self._most :], (what, arm, motion, result)]
        return result


@dataclass(frozen=True, slots=True, eq=False)
class Rigid:
    """The rigid arm along a motion: torques [K, n], forces and moments in the joints [K, n, 3]."""

    tau: Floats
    f: Floats
    m: Floats


class Model:
    """A robot on arrays: ``q, qd, qdd`` [K, n]. Stateful effects are at their steady values. ``reuse`` is
    shared by models that may have the same rigid arm. ``sticking`` [n]: speeds [rad/s or m/s] below which dry
    friction fades to 0 in proportion to the speed, 0 where it does not.

    Raises
    ------
    InputError: a run-time parameter has no value.
    """

    def __init__(
        self,
        robot: Robot,
        parameters: Mapping[str, float] | None = None,
        reuse: Reuse | None = None,
        sticking: Floats | None = None,
    ) -> None:
        self.robot = robot
        self.reuse = reuse
        self._sticking = sticking
        values = dict(parameters or {})
        complaint = without_values(robot, values)
        if complaint is not None:
            raise complaint
        self.n = robot.n
        self.arm: Arm = build_arm(rigid_part(robot, bare=True), float, values.__getitem__)
        self._layer: Layer = layer_of(robot, float, values.__getitem__, bare=True)
        self._rest = None if robot.rest_velocity is None else float(robot.rest_velocity)
        self._band = None if robot.dead_band is None else float(robot.dead_band)

    def along(self, reuse: Reuse) -> Model:
        """The same model along the motion of another ``reuse``."""
        model = copy(self)
        model.reuse = reuse
        return model

    @property
    def couplers(self) -> dict[int, Acting]:
        """What lies between motor and link where the encoder is on the motor, by joint (from 0)."""
        return {
            j: drive.coupler
            for j, drive in enumerate(self._layer.joints)
            if drive.coupler is not None and drive.coupler.values["encoder"] == "motor"
        }

    def motion(self, q: Floats, qd: Floats, qdd: Floats) -> Motion:
        """The rigid arm's motion, over arrays of states."""
        columns = list(q.T)
        return build_motion(self.arm, columns, list(qd.T), list(qdd.T), trigonometry_at(columns), float)

    def direction(self, qd: Floats) -> Floats:
        """Directions of motion as the robot has them near rest."""
        way = np.asarray(smoothed_sign(qd, self._rest, self._band), dtype=np.float64)
        if self._sticking is not None and qd.ndim == 2:  # joints', and not of motors that drive two
            way *= np.minimum(np.abs(qd) / np.maximum(self._sticking, 1e-300), 1.0)
        return way

    def direction_of(self, speed: Floats, ratios: Mapping[int, float]) -> Floats:
        """The direction [K] of a motor's ``speed`` [K] that sums those of joints (from 0) by ``ratios``."""
        way = np.asarray(smoothed_sign(speed, self._rest, self._band), dtype=np.float64)
        if self._sticking is not None:
            unresolved = np.sqrt(sum((ratio * self._sticking[j]) ** 2 for j, ratio in ratios.items()))
            way *= np.minimum(np.abs(speed) / max(float(unresolved), 1e-300), 1.0)
        return way

    def evaluate(self, q: Floats, qd: Floats, qdd: Floats, motors: Moved | None = None) -> Evaluated:
        """The model's torques along a motion of the links; that of the ``motors`` is the same unless it is
        given."""
        if self.reuse is None or motors is not None:
            arm = self.rigid(q, qd, qdd)
        else:
            arm = self.reuse.of("loads", self.arm, (q, qd, qdd), lambda: self.rigid(q, qd, qdd))
        return self.driven(arm, q, qd, qdd, motors)

    def driven(
        self, arm: Rigid, q: Floats, qd: Floats, qdd: Floats, motors: Moved | None = None
    ) -> Evaluated:
        """What the drives make of the rigid ``arm``, as :meth:`evaluate` has it."""
        f, m = arm.f, arm.m
        loads = Loads(
            list(arm.tau.T),
            {i: (f[:, i, 0], f[:, i, 1], f[:, i, 2]) for i in range(self.n)},
            {i: (m[:, i, 0], m[:, i, 1], m[:, i, 2]) for i in range(self.n)},
        )
        way = self.direction(qd)
        rates = Rates(list(q.T), list(qd.T), list(qdd.T), list(way.T))
        passed = passed_on(self._layer, loads, rates)
        if motors is not None:
            rates = Rates(*(list(x.T) for x in (*motors, self.direction(motors[1]))))
        pairs = [
            self.direction_of(combined(pair, rates.qd), {pair.one: 1.0, pair.other: float(pair.ratio)})
            for pair in self._layer.pairs
        ]
        total = at_motors(self._layer, passed, rates, pairs)

        zeros = np.zeros(len(q))

        def table(rows: list[Any]) -> Floats:
            return np.stack([row + zeros for row in rows], axis=1)

        return Evaluated(arm.tau, table(passed), table(total), f, m)

    def rigid_torque(self, q: Floats, qd: Floats, qdd: Floats) -> Floats:
        """The torques [K, n] of the arm without its drives.

        Raises
        ------
        InputError: they would rest on masses that nobody knows.
        """
        require_masses(self.robot)
        rows = newton_euler(self.arm, self.motion(q, qd, qdd), unmarked)
        return np.stack([row + np.zeros(len(q)) for row in rows], axis=1)

    def rigid(self, q: Floats, qd: Floats, qdd: Floats) -> Rigid:
        """The arm without its drives; raises as :meth:`rigid_torque`."""
        require_masses(self.robot)
        f, m = (np.zeros((self.n, 3, len(q))).transpose(2, 0, 1) for _ in range(2))
        tables = {"f": f, "n": m}

        def mark(value: Any, label: Label) -> Any:
            if label.quantity in tables:
                tables[label.quantity][:, label.link - 1, "xyz".index(label.axis)] = value
            return value

        tau = np.zeros((self.n, len(q))).T
        for i, torque in enumerate(newton_euler(self.arm, self.motion(q, qd, qdd), mark)):
            tau[:, i] = torque
        return Rigid(tau, f, m)

    def torque(self, q: Floats, qd: Floats, qdd: Floats) -> Floats:
        """Motor torques [K, n]."""
        return self.evaluate(q, qd, qdd).total

    def mass_matrix(self, q: Floats) -> Floats:
        """Mass matrices [K, n, n] (kg m^2, kg m, kg) with the inertia of the rotors: column j is the torque
        of a unit acceleration of joint j alone. Friction is not in it; raises as :meth:`rigid_torque`."""
        require_masses(self.robot)
        arm = replace(self.arm, gravity=(0.0, 0.0, 0.0))
        columns, zeros = list(q.T), [np.zeros(len(q))] * self.n
        matrices = np.zeros((len(q), self.n, self.n))
        for j in range(self.n):
            unit = [np.full(len(q), float(i == j)) for i in range(self.n)]
            motion = build_motion(arm, columns, zeros, unit, trigonometry_at(columns), float)
            for i, torque in enumerate(newton_euler(arm, motion, unmarked)):
                matrices[:, i, j] = torque
        for rotor in self._layer.rotors():
            row = np.zeros(self.n)
            for joint, ratio in rotor.rates:
                row[joint] = ratio
            matrices += rotor.inertia * np.outer(row, row)
        return matrices

    def regressor(self, q: Floats, qd: Floats, qdd: Floats) -> Floats:
        """Torques [K, n, n, 10] by the standard inertial parameters of each link: joint, link, parameter."""
        motion = self.motion(q, qd, qdd)
        count = len(q)
        zeros = np.zeros(count)
        placed = frames(self.arm, motion)

        def vector(u: Any) -> Floats:
            return np.stack([x + zeros for x in u], axis=1)

        origins = [vector(frame.origin) for frame in placed]
        turns = [np.stack([vector(axis) for axis in (f.x, f.y, f.z)], axis=2) for f in placed]
        links = forward_pass(self.arm, motion, unmarked)
        Y = np.zeros((count, self.n, self.n, 10))
        unit = np.eye(3)
        for k, at in enumerate(links):
            w, alpha, a = vector(at.w), vector(at.alpha), vector(at.a)
            skew, lam = (-np.cross(u[:, None, :], unit) for u in (w, alpha))
            lam = lam + skew @ skew
            force = np.zeros((count, 10, 3))
            moment = np.zeros((count, 10, 3))
            force[:, 0] = a
            for j in range(3):
                force[:, 1 + j] = lam[:, :, j]
                moment[:, 1 + j] = np.cross(unit[j], a)
            for j in range(6):
                moment[:, 4 + j] = _inertia(j, alpha) + np.cross(w, _inertia(j, w))
            force = force @ np.swapaxes(turns[k], 1, 2)
            moment = moment @ np.swapaxes(turns[k], 1, 2)
            for i in range(k + 1):
                axis = turns[i][:, None, :, 2]
                if self.arm.bodies[i].revolute:
                    lever = (origins[k] - origins[i])[:, None, :]
                    Y[:, i, k] = np.sum(axis * (moment + np.cross(lever, force)), axis=2)
                else:
                    Y[:, i, k] = np.sum(axis * force, axis=2)
        return Y

    def standard_parameters(self) -> Floats:
        """The model's own standard parameters [n, 10]; raises as :meth:`rigid_torque`."""
        require_masses(self.robot)
        rows = []
        for body in self.arm.bodies:
            m = float(body.mass)
            c = np.array([float(x) for x in body.com])
            i = body.inertia
            about = np.array([float(getattr(i, axes)) for axes in AXES])
            rows.append([m, *(m * c), *(about + _shift(m, c))])
        return np.array(rows)


def physical(phi: Floats) -> Floats:
    """Mass, centre of mass, and inertia about it, of standard parameters [10]."""
    m = phi[0]
    c = phi[1:4] / m if m > 0 else np.zeros(3)
    return np.concatenate([[m], c, phi[4:] - _shift(m, c)])


def _shift(m: float, c: Floats) -> Floats:
    """What a mass ``m`` at ``c`` [3] adds to an inertia [6], by Huygens and Steiner."""
    tensor = m * (c @ c * np.eye(3) - np.outer(c, c))
    return np.array([tensor["xyz".index(axes[0]), "xyz".index(axes[1])] for axes in AXES])


def _inertia(j: int, u: Floats) -> Floats:
    """A tensor whose entry j (xx yy zz xy xz yz) is 1, times ``u``."""
    rotated = np.zeros_like(u)
    a, b = ("xyz".index(axis) for axis in AXES[j])
    rotated[:, a], rotated[:, b] = u[:, b], u[:, a]
    return rotated
