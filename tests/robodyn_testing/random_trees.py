"""Random mechanisms as URDF text: axes in any direction, fixed joints, branches, limits beside zero."""

from __future__ import annotations

import math
import random


def _three(values: list[float]) -> str:
    return " ".join(map(repr, values))


def _axis(draw: random.Random) -> list[float]:
    """Any direction; a coordinate axis, also backwards; or nearly one."""
    unit = [0.0, 0.0, 0.0]
    unit[draw.randrange(3)] = draw.choice([1.0, -1.0])
    kind = draw.random()
    if kind < 0.4:
        return unit
    spread = 1.0 if kind < 0.7 else 10 ** draw.uniform(-8, -2)
    axis = [x + spread * draw.gauss(0, 1) for x in unit]
    length = math.hypot(*axis)
    return [x / length for x in axis]


def _origin(draw: random.Random) -> str:
    quarter = math.pi / 2
    rpy = [draw.choice([0.0, quarter * draw.randrange(-2, 3), draw.uniform(-3, 3)]) for _ in range(3)]
    xyz = [
        draw.choice([0.0, round(draw.uniform(-0.5, 0.5), 3), 10 ** draw.uniform(-6, -3)]) for _ in range(3)
    ]
    return f'<origin xyz="{_three(xyz)}" rpy="{_three(rpy)}"/>'


def _inertial(draw: random.Random) -> str:
    """A solid ellipsoid of random axes, somewhere in the link."""
    mass = round(draw.uniform(0.1, 8), 3)
    a, b, c = (draw.uniform(0.02, 0.3) ** 2 for _ in range(3))
    xx, yy, zz = mass * (b + c) / 5, mass * (a + c) / 5, mass * (a + b) / 5
    entries = {"ixx": xx, "iyy": yy, "izz": zz, "ixy": 0.0, "ixz": 0.0, "iyz": 0.0}
    text = " ".join(f'{name}="{value!r}"' for name, value in entries.items())
    return f'<inertial>{_origin(draw)}<mass value="{mass!r}"/><inertia {text}/></inertial>'


def _limit(draw: random.Random, kind: str) -> str:
    if kind in ("fixed", "continuous"):
        return ""
    low = draw.choice([-2.0, -1.5, 0.25])
    return f'<limit lower="{low}" upper="{low + 3}" effort="50" velocity="2"/>'


def random_urdf(seed: int) -> str:
    """A tree of 2 to 20 links; its last link is at the end of a chain with a joint that moves."""
    draw = random.Random(seed)
    count = draw.randrange(2, 21)
    lines = [f'<robot name="tree{seed}">', '<link name="l0"/>']
    for i in range(1, count):
        last = i == count - 1
        parent = i - 1 if draw.random() < 0.75 else draw.randrange(i)
        kinds = ["revolute", "continuous", "prismatic"] + ([] if last else ["fixed", "fixed"])
        kind = draw.choice(kinds)
        inertial = _inertial(draw) if last or draw.random() < 0.85 else ""
        lines.append(f'<link name="l{i}">{inertial}</link>')
        lines.append(f'<joint name="j{i}" type="{kind}"><parent link="l{parent}"/><child link="l{i}"/>')
        lines.append(f'{_origin(draw)}<axis xyz="{_three(_axis(draw))}"/>{_limit(draw, kind)}</joint>')
    return "\n".join([*lines, "</robot>"])
