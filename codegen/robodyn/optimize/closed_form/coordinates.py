"""Coordinates of an arm's closed form: angles of chains of parallel joints, their rates, shifted slides.

The torques come out of the plain recursion, run on polynomials: exact, for every arm.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm, JointAngle, build_arm, build_motion
from robodyn.dynamics.joints import smoothed_sign
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.effects.scalars import is_zero
from robodyn.ir.evaluate import turn
from robodyn.ir.graph import Graph
from robodyn.optimize.polynomial import Polynomial, Ring, Terms, terms_of
from robodyn.optimize.programs import exact, turned
from robodyn.robot.model import Robot
from robodyn.robot.values import Angle, quarter_turns

#: A variable: what it is and of which joint (from 0) or parameter. ``c s`` of an angle, ``x`` a displacement,
#: ``v a`` rate and acceleration of a coordinate, ``qd qdd`` those of a joint, ``sgn`` the sign of ``qd``.
Leaf = tuple[str, int | str]


@dataclass(frozen=True, slots=True)
class Coordinates:
    """How an arm's state enters its closed form.

    ``summed`` [n]: whether joint i's angle is added to the one before; ``absolute``: whether the rates of
    parallel joints are; ``squares`` [n]: ``"s"`` where sines have no squares, ``"c"`` where cosines have
    none; ``shifts`` [n]: what is added to a displacement.
    """

    summed: tuple[bool, ...]
    absolute: bool
    squares: tuple[str, ...]
    shifts: tuple[Fraction, ...]


@dataclass(slots=True)
class Model:
    """The closed form of an arm: ``torques`` [n] by terms, without what ``extras`` [n] add in joints that
    turn on another (their rotors and friction). With ``ways`` [n] not 0, joint i turns about joint i-1's axis
    in that sense, and its torque is to be added to that of i-1 with that sign."""

    leaves: list[Leaf]
    torques: list[Terms]
    extras: list[Terms]
    ways: tuple[int, ...]

    @property
    def size(self) -> int:
        """Terms in all."""
        return sum(map(len, self.torques)) + sum(map(len, self.extras))


def parallels(arm: Arm) -> tuple[int, ...]:
    """For each joint [n] +1 or -1 where it turns about the axis of the one before, else 0."""
    ways = [0] * len(arm.bodies)
    for i in range(1, len(arm.bodies)):
        before, body = arm.bodies[i - 1 : i + 1]
        if is_zero(body.sin_alpha) and before.revolute and body.revolute:
            ways[i] = 1 if body.cos_alpha > 0 else -1
    return tuple(ways)


def angles(arm: Arm, summed: Sequence[bool]) -> list[JointAngle | None]:
    """The angle whose cosine and sine stand for joint i [n]; None at prismatic joints.

    Quarter turns and sums of offsets are left out, since polynomials take them in; the only offset in a sum
    stays, since one addition is less than what expanding it costs.
    """
    ways = parallels(arm)
    joint_angles: list[JointAngle | None] = []
    for i, body in enumerate(arm.bodies):
        if not body.revolute:
            joint_angles.append(None)
            continue
        offset = quarter_turns(0) if body.theta.quarter is not None else body.theta
        terms: tuple[tuple[int, int], ...] = ((i, 1),)
        before = joint_angles[i - 1] if summed[i] else None
        if before is not None:
            terms = (*((joint, ways[i] * sign) for joint, sign in before.terms), *terms)
            offset = _the_one(before.offset if ways[i] > 0 else -before.offset, offset)
        joint_angles.append(JointAngle(terms, offset))
    return joint_angles


def _the_one(a: Angle, b: Angle) -> Angle:
    if a.quarter is None and b.quarter is None:
        return quarter_turns(0)
    return b if b.quarter is None else a


def model(robot: Robot, at: Coordinates) -> Model:
    """The closed form of ``robot`` in the coordinates ``at``."""
    leaves: list[Leaf] = []
    leaf_index: dict[Leaf, int] = {}

    def new(kind: str, of: int | str) -> int:
        leaf = (kind, of)
        if leaf not in leaf_index:
            leaf_index[leaf] = len(leaves)
            leaves.append(leaf)
        return leaf_index[leaf]

    plain = build_arm(robot, exact, lambda _: 1)
    ways = parallels(plain)
    n = robot.n
    partner: dict[int, int] = {}
    for i, angle in enumerate(angles(plain, at.summed)):
        if angle is not None:
            c, s = new("c", i), new("s", i)
            partner[s if at.squares[i] == "s" else c] = c if at.squares[i] == "s" else s
    ring = Ring(partner)

    def variable(kind: str, of: int | str) -> Polynomial:
        return ring.variable(new(kind, of))

    arm = build_arm(robot, exact, lambda name: variable("parameter", name))
    none = replace(arm, bodies=tuple(replace(b, motor_inertia=0, viscous=0, coulomb=0) for b in arm.bodies))
    turns: list[tuple[Any, Any]] = []  # of each joint by itself, its offset included
    circles: list[tuple[Any, Any]] = []  # of the angle that stands for it
    for i, (angle, body) in enumerate(zip(angles(plain, at.summed), arm.bodies, strict=True)):
        if angle is None:
            turns.append((body.theta.cos, body.theta.sin))
            circles.append((1, 0))
            continue
        circle = (variable("c", i), variable("s", i))
        circles.append(circle)
        offset = (exact(angle.offset.cos), -exact(angle.offset.sin))
        own = turn(circle, offset)
        if at.summed[i]:
            previous = turn(circles[i - 1], _undone(plain, at, i - 1))
            own = turn(own, (previous[0], -ways[i] * previous[1]))
        turns.append(turn(own, (exact(body.theta.cos), exact(body.theta.sin))))
    q = [0 if b.revolute else variable("x", i) - at.shifts[i] for i, b in enumerate(arm.bodies)]

    def rates(kind: str, of_joint: str) -> list[Any]:
        row: list[Any] = []
        for i, way in enumerate(ways if at.absolute else (0,) * n):
            if way:
                before = variable(kind if ways[i - 1] else of_joint, i - 1)
                row.append(variable(kind, i) - way * before)
            else:
                row.append(variable(of_joint, i))
        return row

    qd, qdd = rates("v", "qd"), rates("a", "qdd")
    motion = build_motion(none, q, qd, qdd, lambda joint: turns[joint.terms[0][0]], exact)
    tau = newton_euler(none, motion)
    torques, extras = [], []
    for i, body in enumerate(arm.bodies):
        way = ways[i + 1] if at.absolute and i + 1 < n else 0
        own_terms = tau[i] - way * tau[i + 1] if way else tau[i]
        extra: Any = 0
        for factor, kind in ((body.motor_inertia, "qdd"), (body.viscous, "qd"), (body.coulomb, "sgn")):
            if not is_zero(factor):
                extra = extra + factor * variable(kind, i)
        alone = not (at.absolute and ways[i])
        torques.append(terms_of(own_terms + extra if alone else own_terms))
        extras.append({} if alone else terms_of(extra))
    return Model(leaves, torques, extras, ways if at.absolute else (0,) * n)


def _undone(arm: Arm, at: Coordinates, i: int) -> tuple[Any, Any]:
    angle = angles(arm, at.summed)[i]
    assert angle is not None
    return exact(angle.offset.cos), -exact(angle.offset.sin)


def values(graph: Graph, robot: Robot, at: Coordinates, leaves: Sequence[Leaf]) -> list[Any]:
    """The variables ``leaves`` as nodes of ``graph``."""
    n = robot.n
    arm = build_arm(robot, exact, graph.input)
    ways = parallels(build_arm(robot, exact, lambda _: 1))
    q, qd, qdd = ([graph.input(array, i) for i in range(n)] for array in ("q", "qd", "qdd"))
    absolute: dict[str, list[Any]] = {"v": list(qd), "a": list(qdd)}
    for i in range(1, n):
        if ways[i]:
            for row in absolute.values():
                row[i] = ways[i] * row[i - 1] + row[i]
    circles = [None if a is None else turned(graph, q, a) for a in angles(arm, at.summed)]
    nodes: list[Any] = []
    for kind, of in leaves:
        if isinstance(of, str):
            nodes.append(graph.input(of))
        elif kind in ("c", "s"):
            circle = circles[of]
            assert circle is not None
            nodes.append(circle[kind == "s"])
        elif kind in ("v", "a"):
            nodes.append(absolute[kind][of])
        elif kind == "x":
            nodes.append(q[of] + exact(at.shifts[of]))
        elif kind == "sgn":
            nodes.append(smoothed_sign(qd[of], arm.rest_velocity, arm.dead_band))
        else:
            nodes.append((qd if kind == "qd" else qdd)[of])
    return nodes
