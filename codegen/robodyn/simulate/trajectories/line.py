"""Straight lines of a point, with joint rates from the Jacobian and its rate."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from robodyn.arrays import Floats
from robodyn.dynamics.inverse import Numerical
from robodyn.errors import InputError
from robodyn.robot.model import Placement, Robot
from robodyn.robot.values import quarter_turns
from robodyn.simulate.kinematics import Kinematics, closest_turns, is_revolute, position_limits
from robodyn.simulate.poses import PoseSolver, Solution
from robodyn.simulate.trajectories.joints import Profile, ProfileName, profile_of
from robodyn.simulate.trajectories.trajectory import PERIOD, Trajectory, hermite, joint_vector, sample_times

#: How far a joint may go from one sample to the next [rad or m]: further is another branch.
_LARGEST_JUMP = math.pi / 2
#: Positions [K, 3 or 6] (rad or m) of the led joints along a path [K, 3] (m), continuous.
Solver = Callable[[Floats], Floats]

#: Below this share of the largest singular value of the Jacobian the smallest counts as none.
SINGULAR = 1e-4
_MISSED = 1e-8  # [m, rad] by which a solver's joints may be off
_MET = 1e-8  # [m, rad] from where one more step of Newton's method is enough
_NEWTON = 10


def line(
    kinematics: Kinematics,
    start_point: ArrayLike,
    end_point: ArrayLike,
    duration: float,
    profile: ProfileName = "quintic",
    *,
    solver: Solver | None = None,
    rotation: ArrayLike | None = None,
    start: ArrayLike | None = None,
    period: float = PERIOD,
) -> Trajectory:
    """The point of ``kinematics`` along the straight line from ``start_point`` to ``end_point`` [3] (m).

    The point alone is led by the three joints up to its link; with ``rotation`` [3, 3], which the link then
    keeps, by six. Joints beyond stay where ``start`` [n] has them. Positions of the led joints come from
    ``solver``, by default those of the arm's own closed form or a search, nearest to ``start`` (0 by default)
    at the beginning; rates
    are ``J^-1 xd`` and ``J^-1 (xdd - Jd qd)``. ``profile``: at rest at both ends (quintic; trapezoid, whose
    acceleration jumps), or constant speed throughout.

    Raises
    ------
    InputError: the line is not within reach, or passes a singular place (smallest singular value of the
        Jacobian not above :data:`SINGULAR` times the largest); the led joints are not as many as the
        conditions; the solver does not meet the line.
    """
    a, b = _point("start", start_point), _point("end", end_point)
    rows = 3 if rotation is None else 6
    led = kinematics.link
    if led != rows:
        raise InputError(
            f"{kinematics.robot.name}: the line does not fix the joints up to link {led}",
            found=f"{led} joints",
            expected=f"{rows}",
            remedy="a point is led by three joints, a point and a rotation by six; choose another link",
        )
    turn = None if rotation is None else np.asarray(rotation, dtype=np.float64)
    robot = kinematics.robot
    begin = np.zeros(robot.n) if start is None else joint_vector("the start", start, robot.n)
    along = profile_of(profile, float(duration))
    t = sample_times(duration, period, beyond=profile != "constant")
    way = _Line(kinematics, (a, b), turn, along)
    q = way.met(t, begin, None if solver is None else solver(way.path(t)))
    way.regular(t, q)
    q = way.refined(t, q)
    samples = (t, q, *way.rates(t, q))
    provenance: dict[str, Any] = {
        "kind": "line",
        "start": a.tolist(),
        "end": b.tolist(),
        "time": float(duration),
        "profile": profile,
        "point": list(kinematics.point),
        "link": led,
    }
    if turn is not None:
        provenance["rotation"] = turn.tolist()
    return Trajectory(*samples, provenance, partial(_between, way, samples))


@dataclass(frozen=True, slots=True)
class _Line:
    """A line of a point, from the first to the second of ``ends`` [3] (m), and the rotation that is kept."""

    kinematics: Kinematics
    ends: tuple[Floats, Floats]
    rotation: Floats | None
    profile: Profile

    def path(self, t: Floats) -> Floats:
        """The point [K, 3] (m) at ``t`` [K] (s)."""
        start, end = self.ends
        path: Floats = start + self.profile(t)[0][:, None] * (end - start)
        return path

    def met(self, t: Floats, begin: Floats, led: Floats | None) -> Floats:
        """Joint positions [K, n], those of the joints that are not led from ``begin`` [n]. Those that are
        ``led`` are of a solver, or come of inverse kinematics: in closed form, or where there is none, or
        where the path leaves its branch, by Newton's method from sample to sample."""
        path = self.path(t)
        m = self.kinematics.link
        q = np.tile(begin, (len(t), 1))
        if led is None:
            solver = solver_up_to(self.kinematics)
            turn = np.eye(3) if self.rotation is None else self.rotation
            poses = np.concatenate([np.broadcast_to(turn, (len(t), 3, 3)), path[:, :, None]], axis=2)
            led = along_branch(solver, poses, begin[:m])
            if led is None:
                q[0, :m] = self.reached(solver.solve(poses[:1], begin[:m])[0].nearest, path[0])
                return self.followed(t, q)
        if led.shape != (len(t), m):
            found, expected = str(list(led.shape)), str([len(t), m])
            raise InputError("the solver's joints have the wrong shape", found=found, expected=expected)
        q[:, :m] = led
        missed = np.abs(self.missing(t, q)).max(axis=1)
        if missed.max() > _MISSED:
            k = int(np.argmax(missed))
            raise InputError(
                "the solver's joints do not meet the line",
                found=f"{missed[k]:.3g} off at {_place(path[k])}",
                expected=f"at most {_MISSED:g} (m and rad)",
                remedy="do the solver and the kinematics speak of the same point?",
            )
        return q

    def reached(self, solution: Solution, point: Floats) -> Floats:
        """The joints of a ``solution`` that reaches its pose within the limits."""
        if solution.exists and solution.within:
            return solution.q
        raise self.unreachable(point, max(solution.off))

    def followed(self, t: Floats, q: Floats) -> Floats:
        """``q`` [K, n], of which the first row is known, each other from those before it."""
        low, high = position_limits(self.kinematics.robot).T
        m = self.kinematics.link
        for k, point in enumerate(self.path(t)[1:], 1):
            q[k] = 2 * q[k - 1] - q[k - 2] if k > 1 else q[0]
            missing = self.off(point, q[k])
            for _ in range(_NEWTON):
                if np.abs(missing).max() < _MET:
                    break
                J = self.kinematics.jacobian(q[k])[:m, :m]
                q[k, :m] += np.linalg.lstsq(J, missing, rcond=None)[0]
                missing = self.off(point, q[k])
            missed = float(np.abs(missing).max())
            is_near = np.abs(q[k] - q[k - 1]).max() <= _LARGEST_JUMP
            if not (missed <= _MISSED and is_near and (low <= q[k]).all() and (q[k] <= high).all()):
                raise self.unreachable(point, missed)
        return q

    def unreachable(self, point: Floats, missed: float) -> InputError:
        """What to say of a ``point`` that the arm does not come to, but for so much."""
        return InputError(
            f"{self.kinematics.robot.name}: the point {_place(point)} of the line cannot be reached",
            found=f"{missed:.3g} (m or rad) missing, or a joint beyond its limits",
            remedy="move it into the arm's reach, widen the joints' limits, or give another start",
        )

    def refined(self, t: Floats, q: Floats) -> Floats:
        """``q`` [K, n] brought onto the line by Newton's method, from nearby."""
        q = q.copy()
        m = self.kinematics.link
        for _ in range(_NEWTON):
            missing = self.missing(t, q)
            q[:, :m] += np.linalg.solve(self._led(self.kinematics.jacobian(q)), missing[..., None])[..., 0]
            if np.abs(missing).max() < _MET:
                break
        return q

    def missing(self, t: Floats, q: Floats) -> Floats:
        """What is missing to the line: [K, 3] (m), with a rotation [K, 6] (and rad, if little)."""
        return self.off(self.path(t), q)

    def off(self, point: Floats, q: Floats) -> Floats:
        """What is missing to a ``point`` [3], or to one for each state of ``q``."""
        position, rotation = self.kinematics.pose(q)
        off: Floats = point - position
        if self.rotation is None:
            return off
        turn = self.rotation @ np.swapaxes(rotation, -1, -2)
        sines = [turn[..., j, i] - turn[..., i, j] for i, j in ((1, 2), (2, 0), (0, 1))]
        return np.concatenate([off, np.stack(sines, axis=-1) / 2], axis=-1)

    def rates(self, t: Floats, q: Floats) -> tuple[Floats, Floats]:
        """Joint velocities and accelerations [K, n]."""
        _, rate, rate_rate = self.profile(t)
        m = self.kinematics.link
        ahead = self.ends[1] - self.ends[0]
        J = self._led(self.kinematics.jacobian(q))
        xd, xdd = np.zeros((2, len(t), m))
        xd[:, :3], xdd[:, :3] = rate[:, None] * ahead, rate_rate[:, None] * ahead
        qd, qdd = np.zeros_like(q), np.zeros_like(q)
        qd[:, :m] = np.linalg.solve(J, xd[..., None])[..., 0]
        Jd = self._led(self.kinematics.jacobian_rate(q, qd))
        rest = xdd[..., None] - Jd @ qd[:, :m, None]
        qdd[:, :m] = np.linalg.solve(J, rest)[..., 0]
        return qd, qdd

    def regular(self, t: Floats, q: Floats) -> None:
        """Refuses the first singular place, one between two samples as well."""
        J = self._led(self.kinematics.jacobian(q))
        sizes = np.linalg.svd(J, compute_uv=False)
        bad = sizes[:, -1] <= SINGULAR * sizes[:, 0]
        turned = np.sign(np.linalg.det(J))
        bad[1:] |= turned[1:] * turned[:-1] < 0
        if bad.any():
            k = int(np.argmax(bad))
            raise InputError(
                f"{self.kinematics.robot.name}: the line passes a singular place",
                found=f"{_place(self.path(t)[k])} at {t[k]:.6g} s, smallest singular value of the Jacobian "
                f"{sizes[k, -1] / sizes[k, 0]:.2g} times the largest",
                expected=f"more than {SINGULAR:g} times, all the way",
                remedy="lead the line past it",
            )

    def _led(self, J: Floats) -> Floats:
        """The square part of Jacobians [K, 6, n] that belongs to the conditions and the led joints."""
        m = self.kinematics.link
        return J[:, :m, :m]


def _between(
    way: _Line, samples: tuple[Floats, Floats, Floats, Floats], t: Floats
) -> tuple[Floats, Floats, Floats]:
    """The law of a line that is known at ``samples``: near them, so on their branch."""
    q = way.refined(t, hermite(*samples, t)[0])
    return q, *way.rates(t, q)


def _point(name: str, value: ArrayLike) -> Floats:
    point = np.asarray(value, dtype=np.float64)
    if point.shape != (3,) or not np.isfinite(point).all():
        raise InputError(
            f"the {name} of the line is not a point", found=str(point.tolist()), expected="[x, y, z] in m"
        )
    return point


def _place(point: Floats) -> str:
    return "[" + ", ".join(f"{x:.6g}" for x in point) + "]"


def solver_up_to(kinematics: Kinematics) -> PoseSolver:
    """Inverse kinematics of the arm up to the link of ``kinematics``, whose point is its tool."""
    robot, straight = kinematics.robot, quarter_turns(0)
    x, y, z = (Fraction(value) for value in kinematics.point)
    arm: Robot = replace(
        robot,
        links=robot.links[: kinematics.link],
        tool=Placement((x, y, z), (straight, straight, straight)),
        effects=(),
    )
    return PoseSolver(arm, {name: kinematics.parameters[name] for name in arm.parameters})


def along_branch(solver: PoseSolver, poses: Floats, start: Floats) -> Floats | None:
    """Joint positions [K, n] for ``poses`` [K, 3, 4], within the limits, the first those nearest to ``start``
    [n]; None where branches are not known, a pose is not reached, or a joint would have to jump."""
    if isinstance(solver.solver, Numerical) and solver.solver.alone:
        return None
    q, usable = solver.branches(poses, start)
    revolute = is_revolute(solver.robot)
    low, high = position_limits(solver.robot).T
    joints = np.empty((len(q), solver.robot.n))
    last = start
    for k, (rows, here) in enumerate(zip(q, usable, strict=True)):
        turned = np.where(revolute, closest_turns(rows, last), rows)
        rows = np.where((turned >= low) & (turned <= high), turned, rows)
        steps = np.where(here, np.abs(rows - last).max(axis=1), math.inf)
        best = int(np.argmin(np.where(here, ((rows - last) ** 2).sum(axis=1), math.inf)))
        if not here[best] or (k and steps[best] > _LARGEST_JUMP):
            return None
        joints[k] = last = rows[best]
    return joints
