"""Arms of fewer than six joints, their forward kinematics by hand, and all joint positions of a pose as a
search from many places finds them: nothing of the code that is tested."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.robot import read_text
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]

#: Rows by arm: the joint's kind, twist (1 and 2 in quarter turns, else rad), ``a``, ``d`` [m], and where it
#: is not 0 the quarter turns about the axis.
ARMS: Final[dict[str, tuple[tuple[Any, ...], ...]]] = {
    "scara": (("R", 0, 0, 0.3), ("R", 0, 0.3, 0), ("P", 2, 0.25, 0), ("R", 0, 0, 0)),
    "scara_slide_first": (("P", 0, 0, 0), ("R", 0, 0.1, 0.3), ("R", 0, 0.35, 0), ("R", 0, 0.25, 0.1)),
    "scara_slide_last": (("R", 0, 0, 0.3), ("R", 0, 0.3, 0), ("R", 0, 0.25, 0), ("P", 2, 0, 0)),
    "shoulder_elbow_wrist": (("R", 0, 0, 0.2), ("R", 1, 0, 0), ("R", 0, 0.3, 0), ("R", 0, 0.3, 0)),
    "desktop": (("R", 0, 0, 0.2), ("R", 1, 0, 0), ("R", 0, 0.3, 0), ("R", 0, 0.25, 0), ("R", 1, 0, 0.1)),
    "palletizer": (
        ("R", 0, 0, 0.7),
        ("R", 1, 0.2, 0),
        ("R", 0, 0.7, 0),
        ("R", 0, 0.8, 0),
        ("R", 1, 0.1, 0.1),
    ),
    "gantry": (("P", 0, 0, 0), ("P", 1, 0, 0, 1), ("P", 1, 0, 0), ("R", 0, 0.1, 0.1), ("R", 1, 0.06, 0.05)),
    "rail": (("P", 0, 0, 0), ("R", 1, 0, 0.2), ("R", 1, 0.1, 0), ("R", 0, 0.4, 0), ("R", 0, 0.3, 0)),
    "meeting_wrist": (
        ("R", 0, 0, 0.3),
        ("R", 1, 0.1, 0),
        ("R", 0, 0.4, 0.1),
        ("R", 1, 0, 0.3),
        ("R", 1, 0, 0),
    ),
    "two_slides": (("R", 0, 0, 0.2), ("P", 0, 0, 0), ("P", 1, 0, 0.2), ("R", 1, 0.1, 0.05), ("R", 1, 0.1, 0)),
    "inclined": (("R", 0, 0, 0.2), ("R", 0.4, 0.3, 0), ("R", 0, 0.3, 0.1), ("R", 0, 0.2, 0)),
    "planar": (("R", 0, 0, 0.1), ("R", 0, 0.3, 0), ("R", 0, 0.2, 0)),
}
_TOOL, _TURN = (0.02, 0.03, 0.15), (0.3, 0.2, 0.1)
#: Starts of the search, its steps at most, and when two solutions are one [rad, m].
STARTS, _STEPS, _SAME = 256, 60, 1e-6


def arm(name: str) -> Robot:
    """The arm as a description has it."""
    text = f"name: {name}\nlinks:\n"
    for kind, twist, a, d, *turned in ARMS[name]:
        alpha = f"{twist}*pi/2" if twist in (1, 2) else str(twist)
        joint = {"R": "revolute", "P": "prismatic"}[kind]
        text += f"  - {{joint: {joint}, alpha: {alpha}, a: {a}, d: {d}, theta: {sum(turned)}*pi/2}}\n"
    tool = f"tool: {{xyz: {list(_TOOL)}, rpy: {list(_TURN)}}}\n"
    return read_text(text + tool, f"{name}.yaml", warn=lambda _: None)


def revolute(name: str) -> NDArray[np.bool_]:
    """Which of its joints turn."""
    return np.array([kind == "R" for kind, *_ in ARMS[name]])


def drawn(name: str, count: int, seed: int = 1) -> Floats:
    """Joint positions ``[count, n]``."""
    reach = np.where(revolute(name), 3.0, 0.5)
    return np.random.default_rng(seed).uniform(-reach, reach, (count, len(reach)))


def poses(name: str, q: Floats) -> Floats:
    """The tool's frames ``[N, 4, 4]`` at ``q`` [N, n]: a row turns about x and goes along it, and then about
    and along z."""
    T = np.tile(np.eye(4), (len(q), 1, 1))
    for (kind, twist, a, d, *turned), x in zip(ARMS[name], q.T, strict=True):
        alpha = twist * math.pi / 2 if twist in (1, 2) else twist
        angle, along = (x, np.full_like(x, d)) if kind == "R" else (np.zeros_like(x), d + x)
        angle = angle + sum(turned) * math.pi / 2
        T = T @ _about(0, np.full_like(x, alpha), a) @ _about(2, angle, along)
    roll, pitch, yaw = (_about(k, np.array([x]), 0.0) for k, x in enumerate(_TURN))
    tool = (yaw @ pitch @ roll)[0]
    tool[:3, 3] = _TOOL
    placed: Floats = T @ tool
    return placed


def _about(axis: int, angle: Floats, along: Floats | float) -> Floats:
    """Turns about a coordinate axis and ways along it."""
    move = np.tile(np.eye(4), (len(angle), 1, 1))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    move[:, i, i] = move[:, j, j] = np.cos(angle)
    move[:, j, i] = np.sin(angle)
    move[:, i, j] = -np.sin(angle)
    move[:, axis, 3] = along
    return move


def apart(name: str, one: Floats, other: Floats) -> Floats:
    """How far joint positions are from each other, whole turns aside."""
    gap = one - other
    gap = np.where(revolute(name), 2 * np.abs(np.sin(gap / 2)), np.abs(gap))
    return np.asarray(gap.max(axis=-1))


def least_motion(name: str, q: Floats) -> Floats:
    """The least singular value of the Jacobian at each of ``q`` [N, n]: almost 0 where it is singular."""
    return np.asarray(np.linalg.svd(_jacobians(name, q, poses(name, q))[1], compute_uv=False)[:, -1], float)


def _jacobians(name: str, q: Floats, T: Floats) -> tuple[Floats, Floats]:
    """By how much the tool misses ``T`` at ``q``, [N, 6], and what each joint does, [N, 6, n]."""
    step, now = 1e-6, poses(name, q)
    columns = []
    for k in range(q.shape[1]):
        aside = step * np.eye(q.shape[1])[k]
        ahead, behind = poses(name, q + aside), poses(name, q - aside)
        columns.append(_between(behind, ahead) / (2 * step))
    return _between(now, T), np.stack(columns, axis=-1)


def _between(one: Floats, other: Floats) -> Floats:
    """From one frame to another: the way, and the sine of the angle about its axis."""
    turn = np.cross(one[:, :3, :3], other[:, :3, :3], axis=1).sum(axis=2) / 2
    return np.concatenate([other[:, :3, 3] - one[:, :3, 3], turn], axis=1)


def searched(name: str, T: Floats) -> list[Floats]:
    """All joint positions of the pose ``T`` [4, 4] that damped Newton steps find from many places."""
    q = drawn(name, STARTS, seed=9)
    goal = np.broadcast_to(T, (STARTS, 4, 4))
    damping = np.full(STARTS, 1e-2)
    error, J = _jacobians(name, q, goal)
    for _ in range(_STEPS):
        normal = np.swapaxes(J, 1, 2) @ J + damping[:, None, None] * np.eye(q.shape[1])
        onward = q + np.linalg.solve(normal, (np.swapaxes(J, 1, 2) @ error[..., None]))[..., 0]
        new_error, new_J = _jacobians(name, onward, goal)
        better = (new_error**2).sum(axis=1) < (error**2).sum(axis=1)
        q, error = np.where(better[:, None], onward, q), np.where(better[:, None], new_error, error)
        J = np.where(better[:, None, None], new_J, J)
        damping = np.where(better, damping / 10, damping * 10)
    found: list[Floats] = []
    arrived = np.abs(poses(name, q) - goal).max(axis=(1, 2)) < 1e-8  # half a turn has no sine either
    for row in q[arrived]:
        if all(apart(name, row, other) > math.sqrt(_SAME) for other in found):
            found.append(row)
    return found
