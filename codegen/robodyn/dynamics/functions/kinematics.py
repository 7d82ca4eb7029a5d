"""Kinematics: where the tool and the links are, and how the tool moves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from robodyn.dynamics.arm import in_stated_frame, inertial
from robodyn.dynamics.functions.record import POSE, QD, Array, Derivative, Function, Pair, Q, Writing
from robodyn.dynamics.mass_matrix import Factored, factoring
from robodyn.dynamics.state import CoordinateDynamics, Dynamics, Vector
from robodyn.dynamics.vectors import flat, inner, plus, products, scaled

LINK_POSITIONS = Array("link_positions", "origins of the links in the world", "m", shape=("l", 3))
LINK_ROTATIONS = Array(
    "link_rotations", "turn vectors of the links' frames into the world's", "", shape=("l", 3, 3)
)


def _jacobian_along(name: str, axes: str) -> Array:
    holds = f"velocity and angular velocity of the tool along {axes} axes, for each rate"
    return Array(name, holds, "m and 1", "1 and 0", (6, "n"))


JAC, JAC_TOOL = _jacobian_along("jac", "the world's"), _jacobian_along("jac_tool", "its own")
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
    from robodyn.dynamics.poses import pose

    return pose(at)


def _link_poses(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.poses import link_places, placed, rows_of

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


def _jacobian(*, of_tool: bool = False, nested_only: bool = False) -> Writing:
    def written(at: Dynamics) -> Sequence[Any]:
        from robodyn.dynamics.jacobians import columns
        from robodyn.dynamics.poses import placed, seen_from_tool

        both = columns(at, seen_from_tool if of_tool else placed, nested_only=nested_only)
        return flat(list(zip(*((*v, *w) for v, w in both), strict=True)))

    return written


def _drift(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.jacobians import tool_drift

    return tool_drift(at)


def _lambda_inverse(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.operational import lambda_inverse

    return lambda_inverse(at)


def _lambda_by_responses(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.operational import lambda_inverse_by_responses

    return lambda_inverse_by_responses(at)


# --- by other ways: transforms, and poses differentiated ----------------------------------------------------


def _poses(at: Dynamics, *rates: Vector) -> list[Any]:
    """Transforms of the links and of the tool, as duals of duals that move at the ``rates``."""
    from robodyn.dynamics.dual import moving_along
    from robodyn.dynamics.transforms import poses

    motion = at.motion(at.rest, at.rest)
    for rate in rates:
        still = at.spread(at.rest)
        motion = moving_along(at.arm, motion, at.spread(rate), still, still)
    return poses(at.arm, motion)


def _tool_pose(at: Dynamics) -> Sequence[Any]:
    return flat(_poses(at)[-1][:3])


def _all_poses(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.transforms import product

    links = _poses(at)[:-1]
    if at.arm.stated_frames:
        ends = (((1, 0, 0, a), (0, c, -s, 0), (0, s, c, 0), (0, 0, 0, 1)) for a, c, s in at.arm.stated_frames)
        links = [product(T, end) for T, end in zip(links, ends, strict=True)]
    rows = [row for T in links for row in T[:3]]
    return [*(row[3] for row in rows), *(x for row in rows for x in row[:3])]


def _moves_the_tool(at: Dynamics, result: Sequence[Any], x: Vector, *, along_its_axes: bool = False) -> Pair:
    """Velocities at random rates: as telling as all columns, at a fraction of the cost."""
    from robodyn.dynamics.dual import slopes, values
    from robodyn.dynamics.transforms import applied, axial, product, transposed

    T = _poses(at, x)[-1]
    R, R_rate = (tuple(tuple(part(row[:3])) for row in T[:3]) for part in (values, slopes))
    velocities: list[Sequence[Any]] = [
        slopes([row[3] for row in T[:3]]),
        axial(product(R_rate, transposed(R))),
    ]
    if along_its_axes:
        velocities = [applied(transposed(R), tuple(u)) for u in velocities]
    return products(result, x), flat(velocities)


def _second_derivative(at: Dynamics) -> Sequence[Any]:
    """The tool's pose differentiated twice at constant rates."""
    from robodyn.dynamics.dual import slopes, values
    from robodyn.dynamics.transforms import axial, product, transposed

    T = _poses(at, at.inputs["qd"], at.inputs["qd"])[-1]
    R = tuple(tuple(values(values(row[:3]))) for row in T[:3])
    rate, again = (tuple(tuple(slopes(part(row[:3]))) for row in T[:3]) for part in (values, slopes))
    spun = zip(axial(product(again, transposed(R))), axial(product(rate, transposed(rate))), strict=True)
    return [*slopes(slopes([row[3] for row in T[:3]])), *(x + y for x, y in spun)]


def _plain_jacobian(at: Dynamics) -> list[list[Any]]:
    """Rows [6][n] by the textbook."""
    from robodyn.dynamics.kinematics import frames, jacobian

    links = frames(at.arm, at.motion(at.rest, at.rest), at.arm.base)
    return [list(at.folded(row)) for row in jacobian(at.arm, links, at.arm.tool.origin)]


def _solved_for(at: Dynamics) -> Sequence[Any]:
    """Joint accelerations for a force or moment at the tool, and the tool's for those."""
    return _responses(at, _plain_jacobian(at))


def _in_coordinates(at: CoordinateDynamics) -> Sequence[Any]:
    """The same of another function's Jacobian."""
    elements, n = at.of("jacobian"), len(at.rest)
    J = [elements[n * k : n * (k + 1)] for k in range(6)]
    X = [Factored(at.mass_matrix(), at.mark).solve(row) for row in J]
    return [inner(y, x) for y in J for x in X]


def _responses(at: Dynamics, J: Sequence[Vector]) -> Sequence[Any]:
    from robodyn.dynamics.operational import by_elimination

    X = by_elimination(at.mass_matrix(), list(zip(*J, strict=True)))
    return [inner(y, column) for y in J for column in zip(*X, strict=True)]


def _answers_a_push(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """The tool's acceleration for one random push, as telling as all six: that of the joint accelerations
    which the push gives. Whatever these were worked out by, they are right where they need its torques."""
    from robodyn.dynamics.articulated import articulated_bodies

    if at.link_count:  # joints that follow others do not answer one body after another
        return result, _solved_for(at)
    J = _plain_jacobian(at)
    push = list(x)
    while len(push) < 6:
        push = [*push, *(y * power for y, power in zip(x, push[-len(x) :], strict=True))]
    push = push[:6]
    torques = [inner(column, push) for column in zip(*J, strict=True)]
    moving = at.links(at.rest, at.rest)
    qdd = articulated_bodies(replace(moving, arm=inertial(moving.arm)), torques)
    return [*products(result, push), *at.inertial_torques(at.rest, qdd)], [*products(flat(J), qdd), *torques]


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
        _jacobian(),
        condition=_moves_the_tool,
        others=(_jacobian(nested_only=True),),
        geometric=True,
    ),
    Function(
        "tool_jacobian",
        "the Jacobian along the tool's axes",
        (Q,),
        (JAC_TOOL,),
        _jacobian(of_tool=True),
        condition=partial(_moves_the_tool, along_its_axes=True),
        others=(_jacobian(of_tool=True, nested_only=True),),
        geometric=True,
    ),
    Function(
        "lambda_inverse",
        "inverse of the tool's mass matrix, J M^-1 J^T, along the world's axes",
        (Q,),
        (LAMBDA_INVERSE,),
        _lambda_inverse,
        in_coordinates=_in_coordinates,
        expected=_solved_for,
        condition=_answers_a_push,
        parts=("mass_matrix",),
        solves=True,
        of_long_arms=(_lambda_by_responses,),
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
