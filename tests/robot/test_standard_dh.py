"""Standard DH rows against an independent Newton-Euler in standard frames, and the same arm converted."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.robot import Inertia, Robot, read_text
from robodyn.robot.values import parameter
from robodyn.verify import Reference
from robodyn_testing import exactly

Array = NDArray[np.float64]
AXES = ("xx", "yy", "zz", "xy", "xz", "yz")


class Row(NamedTuple):
    """One standard row: joint, a, alpha, d, theta, mass, centre, inertia (xx yy zz xy xz yz)."""

    joint: str
    a: float
    alpha: str
    d: float
    theta: str
    mass: float
    com: tuple[float, float, float]
    inertia: tuple[float, float, float, float, float, float]


ANGLES = {"0": 0.0, "pi/2": np.pi / 2, "-pi/2": -np.pi / 2, "pi": np.pi, "0.3": 0.3, "-pi/5": -np.pi / 5}


def _random_rows(seed: int, n: int) -> list[Row]:
    random = np.random.default_rng(seed)
    rows = []
    for _ in range(n):
        points = random.normal(size=(5, 3)) * 0.2  # a body of point masses has a physical tensor
        t = np.einsum("pi,pi,jk->jk", points, points, np.eye(3)) - points.T @ points
        t = np.round(t, 6)
        rows.append(
            Row(
                str(random.choice(["revolute", "revolute", "prismatic"])),
                float(np.round(random.normal() * random.integers(0, 2), 3)),
                str(random.choice(list(ANGLES))),
                float(np.round(random.normal(), 3)),
                str(random.choice(list(ANGLES))),
                float(np.round(random.uniform(0.1, 5), 3)),
                tuple(np.round(random.normal(size=3), 3)),
                (t[0, 0], t[1, 1], t[2, 2], t[0, 1], t[0, 2], t[1, 2]),
            )
        )
    return rows


def _yaml(rows: list[Row]) -> str:
    text = "name: arm\nconvention: sdh\ngravity: [0.3, -0.2, -9.8]\nlinks:\n"
    for row in rows:
        inertia = ", ".join(f"{k}: {v!r}" for k, v in zip(AXES, map(float, row.inertia), strict=True))
        text += (
            f"  - {{joint: {row.joint}, a: {row.a!r}, alpha: {row.alpha}, d: {row.d!r}, theta: {row.theta}, "
            f"mass: {row.mass!r}, com: {[float(x) for x in row.com]}, inertia: {{{inertia}}}}}\n"
        )
    return text


def _rotation(axis: str, angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]] if axis == "x" else [[c, -s, 0], [s, c, 0], [0, 0, 1]])


def _tensor(entries: tuple[float, ...]) -> Array:
    xx, yy, zz, xy, xz, yz = entries
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def _standard_torques(rows: list[Row], gravity: Array, q: Array, qd: Array, qdd: Array) -> Array:
    """Newton-Euler with standard DH frames (Luh, Walker, Paul 1980): frame i at the far end of link i."""
    n = len(rows)
    z = np.array([0.0, 0.0, 1.0])
    w, wd, vd = np.zeros(3), np.zeros(3), -gravity
    turns, offsets, forces, moments = [], [], [], []
    for row, x, xd, xdd in zip(rows, q, qd, qdd, strict=True):
        revolute = row.joint == "revolute"
        theta = ANGLES[row.theta] + (x if revolute else 0.0)
        d = row.d + (0.0 if revolute else x)
        turn = _rotation("z", theta) @ _rotation("x", ANGLES[row.alpha])  # from frame i to frame i-1
        p = turn.T @ (_rotation("z", theta) @ np.array([row.a, 0, 0]) + np.array([0, 0, d]))  # in frame i
        axis = turn.T @ z  # of joint i, in frame i
        w_before, wd_before = turn.T @ w, turn.T @ wd
        if revolute:
            w = w_before + axis * xd
            wd = wd_before + np.cross(w_before, axis * xd) + axis * xdd
            extra = np.zeros(3)
        else:
            w, wd = w_before, wd_before
            extra = 2 * np.cross(w, axis * xd) + axis * xdd
        vd = turn.T @ vd + np.cross(wd, p) + np.cross(w, np.cross(w, p)) + extra
        c, tensor = np.array(row.com), _tensor(row.inertia)
        forces.append(row.mass * (vd + np.cross(wd, c) + np.cross(w, np.cross(w, c))))
        moments.append(tensor @ wd + np.cross(w, tensor @ w))
        turns.append(turn)
        offsets.append(p)
    tau = np.zeros(n)
    f, m = np.zeros(3), np.zeros(3)  # of the link above on this one, in frame i, at the origin of frame i
    for i in reversed(range(n)):
        c = np.array(rows[i].com)
        m = m + np.cross(offsets[i], f) + np.cross(offsets[i] + c, forces[i]) + moments[i]
        f = f + forces[i]
        axis = turns[i].T @ z
        tau[i] = axis @ (m if rows[i].joint == "revolute" else f)
        f, m = turns[i] @ f, turns[i] @ m
    return tau


def _assert_same_torques(robot: Robot, rows: list[Row], seed: int) -> None:
    q, qd, qdd = np.random.default_rng(seed).uniform(-2, 2, (3, 20, len(rows)))
    gravity = np.array([0.3, -0.2, -9.8])
    expected = [_standard_torques(rows, gravity, *state) for state in zip(q, qd, qdd, strict=True)]
    torques = Reference(robot).inverse_dynamics(q, qd, qdd)
    np.testing.assert_allclose(torques, expected, rtol=1e-11, atol=1e-10)


@pytest.mark.parametrize("seed", range(12))
def test_the_converted_arm_has_the_same_torques(seed: int) -> None:
    rows = _random_rows(seed, 1 + seed % 7)
    _assert_same_torques(read_text(_yaml(rows), strict=True), rows, seed + 1000)


Body = tuple[float, Array, Array]


def _joined(one: Body, other: Body) -> Body:
    """Two bodies, each (mass, centre, tensor about it), as one."""
    mass = one[0] + other[0]
    centre = (one[0] * one[1] + other[0] * other[1]) / mass
    tensor = np.zeros((3, 3))
    for m, c, about_own in (one, other):
        r = c - centre
        tensor += about_own + m * (r @ r * np.eye(3) - np.outer(r, r))
    return mass, centre, tensor


def _six(tensor: Array) -> tuple[float, float, float, float, float, float]:
    xx, yy, zz, xy, xz, yz = (
        float(tensor[i, j]) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    )
    return xx, yy, zz, xy, xz, yz


@pytest.mark.parametrize("seed", range(6))
def test_the_payload_moves_along_with_the_last_link(seed: int) -> None:
    """Joined to the last link in standard frames, and as it is read in modified ones: equal torques."""
    rows = _random_rows(seed + 50, 1 + seed % 4)
    mass, com, inertia = 1.7, (0.1, -0.2, 0.3), (0.02, 0.03, 0.04, 0.001, -0.002, 0.003)
    entries = ", ".join(f"{axes}: {x}" for axes, x in zip(AXES, inertia, strict=True))
    robot = read_text(
        _yaml(rows)
        + f"effects: [{{effect: payload, mass: {mass}, com: {list(com)}, inertia: {{{entries}}}}}]\n"
    )
    last = rows[-1]
    joined = _joined(
        (last.mass, np.array(last.com), _tensor(last.inertia)), (mass, np.array(com), _tensor(inertia))
    )
    rows[-1] = last._replace(mass=joined[0], com=tuple(joined[1]), inertia=_six(joined[2]))
    _assert_same_torques(robot, rows, seed)


def test_effects_of_a_standard_arm() -> None:
    robot = read_text(
        "name: arm\nconvention: sdh\nlinks:\n"
        "  - {joint: revolute, alpha: pi/2, a: 1, mass: 1, com: [0, 0, 1],\n"
        "     effects: [{effect: inertial_error, delta_com_y: dy}, {effect: spring, stiffness: 2}]}\n"
        "effects: [{effect: payload, mass: m, com: [0, y, 0], inertia: {yy: 1}}]\n"
    )
    spring, payload = robot.effects
    assert robot.links[0].com == exactly(1, -1, parameter("dy"))  # an error is one of the standard row
    assert spring["stiffness"] == 2
    assert payload["com"] == (1, 0, parameter("y"))
    assert payload["inertia"] == Inertia(zz=Fraction(1))


def test_names_go_through() -> None:
    robot = read_text(
        "name: arm\nconvention: sdh\nlinks:\n"
        "  - {joint: revolute, alpha: pi/2, a: reach, mass: m, com: [x, y, z], inertia: {yy: j}}\n"
        "  - {joint: revolute, alpha: 0.3, mass: 1, com: [0, y, 1]}\n"
    )
    first, second = robot.links
    reach, x, y, z, j = map(parameter, ("reach", "x", "y", "z", "j"))
    assert second.joint.a == reach
    assert first.com == (reach + x, -z, y)
    assert first.inertia == Inertia(zz=j)
    sine, cosine = (Fraction(repr(float(f(0.3)))) for f in (np.sin, np.cos))
    assert second.com[1] == y * cosine - sine
    assert robot.parameters == ("m", "reach", "x", "z", "y", "j")


def test_right_angles_stay_exact_and_others_are_doubles() -> None:
    robot = read_text(
        "name: arm\nconvention: sdh\nlinks:\n"
        "  - {joint: revolute, alpha: pi/2, a: 1/3, mass: 1, com: [1/3, 1/7, 0]}\n"
        "  - {joint: revolute, alpha: pi/3, a: 0.1, mass: 1, com: [1/3, 0.1, 0]}\n"
    )
    assert robot.links[0].com == exactly(Fraction(2, 3), 0, Fraction(1, 7))
    assert robot.links[1].com[2] == Fraction(repr(float(np.sin(np.pi / 3) * 0.1)))
