"""Random chains whose joints follow others, the same for the same seed, as text in URDF, MJCF and SDF.

Followers follow joints before or behind them in the chain, also other followers; ratios are of either sign,
whole numbers and others, with offsets or without. ``G`` and ``o`` of ``q = G u + o`` are solved for as linear
equations, which nothing in robodyn does.
"""

from __future__ import annotations

import math
import random
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

#: A palletizer, whose level axis undoes what both arms turn the hand by.
PALLETIZER = """name: palletizer
links:
  - {name: waist, joint: revolute, mass: 8, com: [0, 0.01, 0.2], inertia: {xx: 0.3, yy: 0.3, zz: 0.2}}
  - {name: lower, joint: revolute, alpha: -pi/2, a: 0.2, mass: 6, com: [0.3, 0.02, 0],
     inertia: {xx: 0.05, yy: 0.25, zz: 0.25, xy: 0.01, xz: 0.002, yz: 0.003}}
  - {name: upper, joint: revolute, a: 0.7, mass: 4, com: [0.3, 0, 0.05],
     inertia: {xx: 0.05, yy: 0.2, zz: 0.2, xz: 0.01}}
  - {name: level, joint: revolute, a: 0.8, mass: 1.5, com: [0.05, 0, 0.01],
     inertia: {xx: 0.01, yy: 0.01, zz: 0.01}}
  - {name: hand, joint: revolute, alpha: pi/2, a: 0.1, d: -0.1, mass: 0.8, com: [0.01, 0, -0.05],
     inertia: {xx: 0.002, yy: 0.002, zz: 0.001}}
couplings:
  - {joint: level, of: lower, ratio: -1}
  - {joint: level, of: upper, ratio: -1, offset: pi/2}
"""

#: Slides that follow turns, followers that follow each other, sums, rotors, friction, gears, a run-time name.
MIXED = """name: mixed
base: {xyz: [0, 0.1, 0.2], rpy: [0.3, 0, pi/2]}
tool: {xyz: [0, 0, 0.1], rpy: [0, 0.2, 0]}
links:
  - {name: a, joint: revolute, theta: 0.3, mass: 8, com: [0, 0.01, 0.2], inertia: {xx: 0.3, yy: 0.3, zz: 0.2},
     motor_inertia: 0.2, friction: {viscous: 0.3, coulomb: 0.5}, gear: {ratio: 50, torque_constant: 0.1}}
  - {name: b, joint: prismatic, alpha: -pi/2, a: 0.2, mass: 6, com: [0.3, 0.02, 0],
     inertia: {xx: 0.05, yy: 0.25, zz: 0.25, xy: 0.01}, motor_inertia: 0.3,
     friction: {viscous: 0.2, coulomb: 0.1}}
  - {name: c, joint: revolute, alpha: 0.4, a: 0.7, theta: 0.2, mass: m_c, com: [0.3, 0, 0.05],
     inertia: {xx: 0.05, yy: 0.2, zz: 0.2, xz: 0.01}, motor_inertia: 0.01, friction: {viscous: 0.2}}
  - {name: d, joint: revolute, a: 0.8, theta: pi/2, mass: 1.5, com: [0.05, 0, 0.01],
     inertia: {xx: 0.01, yy: 0.01, zz: 0.01}, gear: {ratio: -20, torque_constant: 0.1}}
  - {name: e, joint: prismatic, alpha: pi/2, a: 0.1, d: -0.1, mass: 0.8, com: [0.01, 0, -0.05],
     inertia: {xx: 0.002, yy: 0.002, zz: 0.001}}
couplings:
  - {joint: b, of: a, ratio: 0.05, offset: 0.1}
  - {joint: c, of: d, ratio: -1/3, offset: 0.25}
  - {joint: e, of: b, ratio: -2, offset: -0.01}
  - {joint: e, of: d, ratio: 0.1}
"""


@dataclass(frozen=True)
class Follows:
    leader: int
    ratio: float
    offset: float


@dataclass(frozen=True)
class Part:
    """A joint and its link: the joint's frame in the frame before, its axis, the body, friction."""

    kind: str
    xyz: tuple[float, ...]
    rpy: tuple[float, ...]
    axis: tuple[float, ...]
    mass: float
    com: tuple[float, ...]
    inertia: tuple[float, ...]  # xx yy zz xy xz yz
    damping: float
    friction: float
    follows: Follows | None = None


def random_parts(seed: int) -> list[Part]:
    rng = random.Random(f"followers {seed}")
    n = rng.randint(3, 6)
    order = rng.sample(range(n), n)  # whoever follows follows one that stands before it here
    count = rng.randint(1, n - 1)
    leaders = {order[k]: order[rng.randrange(k)] for k in rng.sample(range(1, n), count)}
    parallel = rng.random() < 0.5
    return [_part(rng, leaders.get(i), parallel) for i in range(n)]


def _part(rng: random.Random, leader: int | None, parallel: bool) -> Part:
    def numbers(size: float) -> tuple[float, ...]:
        return tuple(round(rng.uniform(-size, size), 3) for _ in range(3))

    kind = "prismatic" if rng.random() < 0.2 else "revolute"
    points = np.array([[rng.gauss(0, 0.2) for _ in range(3)] for _ in range(5)])
    t = np.einsum("pi,pi,jk->jk", points, points, np.eye(3)) - points.T @ points
    inertia = tuple(round(float(x), 6) for x in (t[0, 0], t[1, 1], t[2, 2], t[0, 1], t[0, 2], t[1, 2]))
    axis = rng.choice(((0.0, 1.0, 0.0), (0.0, -1.0, 0.0))) if parallel else numbers(1.0)
    follows = None
    if leader is not None:
        ratio = rng.choice((1.0, -1.0, 2.0, -0.5, 1 / 3, round(rng.uniform(-2, 2), 3)))
        follows = Follows(leader, ratio or 1.0, rng.choice((0.0, math.pi / 2, round(rng.uniform(-1, 1), 3))))
    turned = (0.0, 0.0, 0.0) if parallel else numbers(2.0)
    damping, friction = rng.choice((0.0, 0.3)), rng.choice((0.0, 0.2))
    return Part(
        kind, numbers(0.4), turned, axis, round(rng.uniform(0.5, 4), 3), numbers(0.2), inertia, damping,
        friction, follows,
    )  # fmt: skip


def transmission(parts: list[Part]) -> tuple[Array, Array, list[int]]:
    """``G`` [n, m] and ``o`` [n], and which joints the coordinates are."""
    n = len(parts)
    free = [i for i, part in enumerate(parts) if part.follows is None]
    follow, own, start = np.zeros((n, n)), np.zeros((n, len(free))), np.zeros(n)
    for i, part in enumerate(parts):
        if part.follows is None:
            own[i, free.index(i)] = 1.0
        else:
            follow[i, part.follows.leader], start[i] = part.follows.ratio, part.follows.offset
    solved: Array = np.array(np.linalg.solve(np.eye(n) - follow, np.column_stack([own, start])), np.float64)
    return solved[:, :-1], solved[:, -1], free


def _text(numbers: tuple[float, ...]) -> str:
    return " ".join(map(repr, numbers))


def urdf(parts: list[Part]) -> str:
    lines = ['<robot name="arm"><link name="l0"/>']
    for i, p in enumerate(parts):
        xx, yy, zz, xy, xz, yz = p.inertia
        lines.append(
            f'<link name="l{i + 1}"><inertial><origin xyz="{_text(p.com)}"/><mass value="{p.mass}"/>'
            f'<inertia ixx="{xx}" iyy="{yy}" izz="{zz}" ixy="{xy}" ixz="{xz}" iyz="{yz}"/></inertial></link>'
        )
        f = p.follows
        mimic = f and f'<mimic joint="j{f.leader}" multiplier="{f.ratio!r}" offset="{f.offset!r}"/>'
        lines.append(
            f'<joint name="j{i}" type="{p.kind}"><origin xyz="{_text(p.xyz)}" rpy="{_text(p.rpy)}"/>'
            f'<parent link="l{i}"/><child link="l{i + 1}"/><axis xyz="{_text(p.axis)}"/>'
            f'<limit lower="-2" upper="2" effort="9" velocity="3"/>'
            f'<dynamics damping="{p.damping}" friction="{p.friction}"/>{mimic or ""}</joint>'
        )
    return "\n".join([*lines, "</robot>"])


def mjcf(parts: list[Part]) -> str:
    inner, equations = "", []
    for i, p in reversed(list(enumerate(parts))):
        if p.follows is not None:
            powers = f"{p.follows.offset!r} {p.follows.ratio!r} 0 0 0"
            equations.append(f'<joint joint1="j{i}" joint2="j{p.follows.leader}" polycoef="{powers}"/>')
        kind = "hinge" if p.kind == "revolute" else "slide"
        inner = (
            f'<body name="l{i + 1}" pos="{_text(p.xyz)}" euler="{_text(p.rpy)}">'
            f'<inertial pos="{_text(p.com)}" mass="{p.mass}" fullinertia="{_text(p.inertia)}"/>'
            f'<joint name="j{i}" type="{kind}" axis="{_text(p.axis)}" range="-2 2" damping="{p.damping}" '
            f'frictionloss="{p.friction}"/>{inner}</body>'
        )
    # eulerseq XYZ is about the fixed axes, as rpy is
    return (
        '<mujoco model="arm"><compiler angle="radian" eulerseq="XYZ" autolimits="true"/>'
        f"<worldbody>{inner}</worldbody><equality>{''.join(equations)}</equality></mujoco>"
    )


def sdf(parts: list[Part]) -> str:
    lines = ['<sdf version="1.11"><model name="arm"><link name="l0"/>']
    lines.append('<joint name="w" type="fixed"><parent>world</parent><child>l0</child></joint>')
    for i, p in enumerate(parts):
        tags = zip(("ixx", "iyy", "izz", "ixy", "ixz", "iyz"), p.inertia, strict=True)
        tensor = "".join(f"<{tag}>{x}</{tag}>" for tag, x in tags)
        f, mimic = p.follows, ""
        if f is not None:  # in terms of another reference
            mimic = (
                f'<mimic joint="j{f.leader}"><multiplier>{f.ratio!r}</multiplier>'
                f"<offset>{f.offset!r}</offset><reference>0</reference></mimic>"
            )
        passive = f"<damping>{p.damping}</damping><friction>{p.friction}</friction>"
        lines.append(
            f'<joint name="j{i}" type="{p.kind}"><pose relative_to="l{i}">{_text((*p.xyz, *p.rpy))}</pose>'
            f"<parent>l{i}</parent><child>l{i + 1}</child><axis><xyz>{_text(p.axis)}</xyz><limit><lower>-2"
            f"</lower><upper>2</upper></limit><dynamics>{passive}</dynamics>{mimic}</axis></joint>"
            f'<link name="l{i + 1}"><pose relative_to="j{i}"/><inertial><pose>{_text(p.com)} 0 0 0</pose>'
            f"<mass>{p.mass}</mass><inertia>{tensor}</inertia></inertial></link>"
        )
    return "\n".join([*lines, "</model></sdf>"])


#: Text of a chain by the ending of its file.
WRITTEN = {"urdf": urdf, "xml": mjcf, "sdf": sdf}
