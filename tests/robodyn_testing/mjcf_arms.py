"""MJCF files for tests: an arm of two joints, and a hand that may be attached to it."""

from __future__ import annotations

from pathlib import Path

SOLID = '<inertial pos="0.1 0.02 -0.03" mass="2" diaginertia="0.01 0.02 0.015"/>'
MESH = '<asset><mesh name="m" vertex="0 0 0 0.1 0 0 0 0.1 0 0 0 0.1"/></asset>'

SHAPE = '<geom type="box" size="0.1 0.2 0.3" mass="3" pos="0.1 0.2 0.3"/>'
GRIPPER = (
    '<mujoco model="gripper"><compiler angle="radian"/><default><joint axis="0 1 0" damping="0.5"/>'
    '<default class="g"><geom type="capsule" size="0.02 0.1"/></default></default><worldbody>'
    f'<body name="palm" childclass="g" euler="0.3 0.2 0.1">{SOLID}<geom mass="0.3"/>'
    f'<body name="finger" pos="0 0.1 0.2"><joint name="k" range="-0.5 1"/>{SOLID}</body></body>'
    "</worldbody></mujoco>"
)
HAND = (
    '<mujoco model="hand"><asset><model name="inner" file="gripper.xml"/></asset><worldbody>'
    f'<body name="wrist" pos="0.1 0 0">{SOLID}<attach model="inner" body="palm" prefix="in_"/></body>'
    "</worldbody></mujoco>"
)
MERGED = '<compiler conflict="merge"/>'
TENDONS = (
    '<tendon><fixed name="t"><joint joint="i" coef="2"/></fixed></tendon>'
    '<equality><tendon tendon1="t" %s/></equality>'
)
ATTACHED = '<asset><model name="g" file="%s"/></asset>'


def arm(last: str, head: str = "", tail: str = "", solid: str = SOLID) -> str:
    """Two tilted joints; ``last`` is in the last body."""
    return (
        f'<mujoco model="arm">{head}<worldbody><body name="a" pos="0.1 0 0.3" euler="20 30 40">\n'
        f'<joint name="i" axis="1 2 3"/>{SOLID}<body name="b" pos="0.2 0.1 0" euler="-30 10 70">\n'
        f'<joint name="j" type="slide" axis="0 3 1"/>{solid}\n{last}</body></body></worldbody>{tail}</mujoco>'
    )


def write(folder: Path, files: dict[str, str]) -> Path:
    """Write ``files`` below ``folder``; the path of the first."""
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder / next(iter(files))
