"""Kinematics as a user of a symbolic tool writes them."""

from __future__ import annotations

from benchmarks.functions.state import Rows, State, Values, dot, flat, turned
from benchmarks.peers.textbook import Vector, add, cross, down, minus, origin, scaled, up

# --- kinematics -------------------------------------------------------------------------------------------


def poses(at: State) -> tuple[list[Rows], list[Vector]]:
    """Rotation [3, 3] and place of every link in the world."""
    rows: Rows = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    place: Vector = (0, 0, 0)
    turns, rotations, places = at.turns(), [], []
    for link, (c, s), x in zip(at.arm.links, turns, at.q, strict=True):
        place = add(place, turned(rows, origin(link, x)))
        columns = [up(link, c, s, unit) for unit in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
        rows = [[dot(row, column) for column in columns] for row in rows]
        rotations.append(rows)
        places.append(place)
    return rotations, places


def forward_kinematics(at: State) -> Values:
    rotations, places = poses(at)
    return [x for row, p in zip(rotations[-1], places[-1], strict=True) for x in (*row, p)]


def link_poses(at: State) -> Values:
    rotations, places = poses(at)
    return [x for place in places for x in place] + [x for rows in rotations for x in flat(rows)]


def jacobian(at: State) -> Rows:
    """``z x (p_tool - p)`` and ``z`` of every joint."""
    columns = []
    rotations, places = poses(at)
    for link, rows, place in zip(at.arm.links, rotations, places, strict=True):
        z = (rows[0][2], rows[1][2], rows[2][2])
        arm = (minus(places[-1][0], place[0]), minus(places[-1][1], place[1]), minus(places[-1][2], place[2]))
        columns.append([*cross(z, arm), *z] if link.revolute else [*z, 0, 0, 0])
    return [list(row) for row in zip(*columns, strict=True)]


def tool_jacobian(at: State) -> Values:
    """The world's Jacobian, turned."""
    axes = list(zip(*poses(at)[0][-1], strict=True))
    J = jacobian(at)
    columns = [
        [dot(axis, u) for u in (column[:3], column[3:]) for axis in axes] for column in zip(*J, strict=True)
    ]
    return flat([list(row) for row in zip(*columns, strict=True)])


def tool_jacobian_inwards(at: State) -> Values:
    """Place and axes of every joint from the tool's frame."""
    columns: Rows = []
    rows: Rows = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]  # turns the link's vectors into the tool's frame
    arm: Vector = (0, 0, 0)  # from the link's origin to the tool's, in the tool's frame
    for link, (c, s), x in reversed(list(zip(at.arm.links, at.turns(), at.q, strict=True))):
        z = (rows[0][2], rows[1][2], rows[2][2])
        columns.insert(0, [*cross(z, arm), *z] if link.revolute else [*z, 0, 0, 0])
        axes = [down(link, c, s, unit) for unit in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
        rows = [[dot(row, column) for column in axes] for row in rows]
        arm = add(arm, turned(rows, origin(link, x)))
    return flat([list(row) for row in zip(*columns, strict=True)])


def jacobian_dot_qd(at: State) -> Values:
    """The recursion of accelerations, turned into the world at the end."""
    w: Vector = (0, 0, 0)
    dw: Vector = (0, 0, 0)
    dv: Vector = (0, 0, 0)
    for link, (c, s), x, rate in zip(at.arm.links, at.turns(), at.q, at.qd, strict=True):
        p = origin(link, x)
        dv = down(link, c, s, add(dv, add(cross(dw, p), cross(w, cross(w, p)))))
        before, along = down(link, c, s, w), (0, 0, rate)
        dw = down(link, c, s, dw)
        if link.revolute:
            w, dw = add(before, along), add(dw, cross(before, along))
        else:
            w, dv = before, add(dv, scaled(2, cross(before, along)))
    rows = poses(at)[0][-1]
    return [*turned(rows, dv), *turned(rows, dw)]


def drift_differentiated(at: State) -> Values:
    """The Jacobian times the rates, differentiated along the rates."""
    velocity = [dot(row, at.qd) for row in jacobian(at)]
    return [dot(row, at.qd) for row in at.tool.jacobian(velocity, at.q)]
