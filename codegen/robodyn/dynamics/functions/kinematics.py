"""Kinematics: where the tool and the links are, and how the tool moves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.dynamics.arm import Motion, in_stated_frame, inertial
from robodyn.dynamics.articulated import articulated_bodies
from robodyn.dynamics.drift import tool_drift
from robodyn.dynamics.dual import moving_along, slopes, values
from robodyn.dynamics.functions.arguments import POSE, QD, Array, Q
from robodyn.dynamics.functions.record import Derivative, Function, Pair
from robodyn.dynamics.jacobians import Column, columns
from robodyn.dynamics.kinematics import frames, jacobian
from robodyn.dynamics.mass_matrix import factoring
from robodyn.dynamics.operational import by_elimination, lambda_inverse
from robodyn.dynamics.poses import link_places, placed, pose, rows_of, seen_from_tool
from robodyn.dynamics.responses import lambda_inverse_by_answers
from robodyn.dynamics.state import Dynamics, Vector
from robodyn.dynamics.transforms import Matrix, applied, axial, poses, product, transposed
from robodyn.dynamics.vectors import flat, plus, scaled

LINK_POSITIONS = Array("link_positions", "origins of the links in the world", "m", shape=("n", 3))
LINK_ROTATIONS = Array(
    "link_rotations", "turn vectors of the links' frames into the world's", "", shape=("n", 3, 3)
)
JAC = Array(
    "jac",
    "velocity and angular velocity of the tool along the world's axes, for each rate",
    "m and 1",
    "1 and 0",
    shape=(6, "n"),
)
JAC_TOOL = Array(
    "jac_tool",
    "velocity and angular velocity of the tool along its own axes, for each rate",
    "m and 1",
    "1 and 0",
    shape=(6, "n"),
)
DRIFT = Array(
    "drift",
    "acceleration and angular acceleration of the tool at qdd = 0 in the world",
    "m/s^2 and rad/s^2",
    shape=(6,),
)
LAMBDA_INVERSE = Array(
    "lambda_inv", "inverse of the tool's mass matrix", "1/kg, 1/(kg m), 1/(kg m^2)", shape=(6, 6)
)


def _forward_kinematics(at: Dynamics) -> Sequence[Any]:
    return pose(at)


def _link_poses(at: Dynamics) -> Sequence[Any]:
    arm = placed(at)
    axes = [arm.links[i] for i in range(len(arm.links))]
    rotations = [rows_of(in_stated_frame(at.arm, i, *axes[i])) for i in range(len(axes))]
    at.cheapest([[flat(flat(rotations))]])
    places = link_places(at, arm)
    if at.arm.stated_frames:
        places = [
            plus(place, scaled(a, x))
            for place, (x, _, _), (a, _, _) in zip(places, axes, at.arm.stated_frames, strict=True)
        ]
    return [*flat(places), *flat(flat(rotations))]


def _jacobian(at: Dynamics) -> Sequence[Any]:
    return _by_rows(columns(at))


def _nested_jacobian(at: Dynamics) -> Sequence[Any]:
    return _by_rows(columns(at, nested_only=True))


def _tool_jacobian(at: Dynamics) -> Sequence[Any]:
    return _by_rows(columns(at, seen_from_tool))


def _nested_tool_jacobian(at: Dynamics) -> Sequence[Any]:
    return _by_rows(columns(at, seen_from_tool, nested_only=True))


def _by_rows(jacobian_columns: Sequence[Column]) -> list[Any]:
    return flat(transposed(tuple((*v, *w) for v, w in jacobian_columns)))


def _drift(at: Dynamics) -> Sequence[Any]:
    return tool_drift(at)


def _lambda_inverse(at: Dynamics) -> Sequence[Any]:
    return flat(lambda_inverse(at))


def _lambda_by_answers(at: Dynamics) -> Sequence[Any]:
    return flat(lambda_inverse_by_answers(at))


# --- by other ways: transforms, and poses differentiated ----------------------------------------------------


def _tool_pose(at: Dynamics) -> Sequence[Any]:
    T = poses(at.arm, at.motion(at.rest, at.rest))[-1]
    return flat(T[:3])


def _all_poses(at: Dynamics) -> Sequence[Any]:
    placed_links = poses(at.arm, at.motion(at.rest, at.rest))[:-1]
    if at.arm.stated_frames:
        ends = (((1, 0, 0, a), (0, c, -s, 0), (0, s, c, 0), (0, 0, 0, 1)) for a, c, s in at.arm.stated_frames)
        placed_links = [product(T, end) for T, end in zip(placed_links, ends, strict=True)]
    places = (row[3] for T in placed_links for row in T[:3])
    return [*places, *(x for T in placed_links for row in T[:3] for x in row[:3])]


def _along(at: Dynamics, motion: Motion, rates: Sequence[Any]) -> Motion:
    """``motion`` as duals that move at ``rates``."""
    return moving_along(at.arm, motion, rates, at.rest, at.rest)


def _velocity(at: Dynamics, rates: Sequence[Any]) -> tuple[list[Any], list[Any], Matrix]:
    """Velocity, angular velocity and rotation of the tool at the rates, by differentiating its pose."""
    T = poses(at.arm, _along(at, at.motion(at.rest, at.rest), rates))[-1]
    R = tuple(tuple(values(row[:3])) for row in T[:3])
    R_rate = tuple(tuple(slopes(row[:3])) for row in T[:3])
    return slopes([row[3] for row in T[:3]]), axial(product(R_rate, transposed(R))), R


def _moves_the_tool(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """Velocities at random rates: as telling as all columns, at a fraction of the cost."""
    velocity, spin, _ = _velocity(at, x)
    return _times(result, x), [*velocity, *spin]


def _moves_the_tool_along_its_axes(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    velocity, spin, R = _velocity(at, x)
    return _times(result, x), [y for u in (velocity, spin) for y in applied(transposed(R), tuple(u))]


def _times(rows: Sequence[Any], x: Vector) -> list[Any]:
    n = len(x)
    return [sum(rows[n * i + j] * x[j] for j in range(n)) for i in range(len(rows) // n)]


def _second_derivative(at: Dynamics) -> Sequence[Any]:
    """The tool's pose differentiated twice at constant rates."""
    qd = at.inputs["qd"]
    T = poses(at.arm, _along(at, _along(at, at.motion(at.rest, at.rest), qd), qd))[-1]
    R = tuple(tuple(values(values(row[:3]))) for row in T[:3])
    rate, again = (tuple(tuple(slopes(part(row[:3]))) for row in T[:3]) for part in (values, slopes))
    spun = zip(axial(product(again, transposed(R))), axial(product(rate, transposed(rate))), strict=True)
    return [*slopes(slopes([row[3] for row in T[:3]])), *(x + y for x, y in spun)]


def _solved_for(at: Dynamics) -> Sequence[Any]:
    """Joint accelerations for a force or moment at the tool, and the tool's for those."""
    links = frames(at.arm, at.motion(at.rest, at.rest), at.arm.base)
    J = jacobian(at.arm, links, at.arm.tool.origin)
    X = by_elimination(at.mass_matrix(), list(zip(*J, strict=True)))
    return [sum(x * row[k] for x, row in zip(y, X, strict=True)) for y in J for k in range(6)]


def _answers_a_push(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """The tool's acceleration for one random push, as telling as all six: that of the joint accelerations
    which the push gives. Whatever these were worked out by, they are right where they need its torques."""
    links = frames(at.arm, at.motion(at.rest, at.rest), at.arm.base)
    J = jacobian(at.arm, links, at.arm.tool.origin)
    push = [_power(x[k % len(x)], 1 + k // len(x)) for k in range(6)]
    torques = [sum(row[j] * w for row, w in zip(J, push, strict=True)) for j in range(len(x))]
    moving = at.links(at.rest, at.rest)
    qdd = articulated_bodies(replace(moving, arm=inertial(moving.arm)), torques)
    accelerations = [sum(y * z for y, z in zip(row, qdd, strict=True)) for row in J]
    answer = [sum(result[6 * r + s] * push[s] for s in range(6)) for r in range(6)]
    return [*answer, *at.inertial_torques(at.rest, qdd)], [*accelerations, *torques]


def _power(x: Any, exponent: int) -> Any:
    return x if exponent == 1 else x * _power(x, exponent - 1)


FUNCTIONS = (
    Function(
        "forward_kinematics",
        "frame of the tool: its rotation and, in the last column, its position",
        (Q,),
        (POSE,),
        _forward_kinematics,
        expected=_tool_pose,
        geometric=True,
        derivatives=(Derivative("q", "jacobian", JAC.name, of_frame=True),),
    ),
    Function(
        "link_poses",
        "positions and rotations of the links",
        (Q,),
        (LINK_POSITIONS, LINK_ROTATIONS),
        _link_poses,
        expected=_all_poses,
        geometric=True,
    ),
    Function(
        "jacobian",
        "geometric Jacobian of the tool's origin along the world's axes: three linear rows, three angular",
        (Q,),
        (JAC,),
        _jacobian,
        condition=_moves_the_tool,
        others=(_nested_jacobian,),
        geometric=True,
    ),
    Function(
        "tool_jacobian",
        "the Jacobian along the tool's axes",
        (Q,),
        (JAC_TOOL,),
        _tool_jacobian,
        condition=_moves_the_tool_along_its_axes,
        others=(_nested_tool_jacobian,),
        geometric=True,
    ),
    Function(
        "lambda_inverse",
        "inverse of the tool's mass matrix, J M^-1 J^T, along the world's axes",
        (Q,),
        (LAMBDA_INVERSE,),
        _lambda_inverse,
        expected=_solved_for,
        condition=_answers_a_push,
        parts=("mass_matrix",),
        solves=True,
        of_long_arms=(_lambda_by_answers,),
        beside_parts=factoring,
    ),
    Function(
        "jacobian_dot_qd",
        "how the tool is accelerated while no joint is: the Jacobian's rate times qd",
        (Q, QD),
        (DRIFT,),
        _drift,
        expected=_second_derivative,
        geometric=True,
    ),
)
