"""Small URDF texts for tests: links with a mass, joints in a line or as stated."""

from __future__ import annotations


def link(name: str, inside: str | None = None) -> str:
    """A link of 1 kg; ``inside`` replaces its inertial."""
    inertial = (
        '<inertial><origin xyz="0.1 0 0"/><mass value="1"/>'
        '<inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial>'
    )
    return f'<link name="{name}">{inertial if inside is None else inside}</link>'


def joint(name: str, parent: str, child: str, kind: str = "revolute", inside: str = "") -> str:
    """A joint 0.3 m along x of its parent, about z; a limit unless ``inside`` has one."""
    limit = "" if "<limit" in inside or kind in ("fixed", "continuous") else '<limit lower="-1" upper="2"/>'
    axis = "" if "<axis" in inside else '<axis xyz="0 0 1"/>'
    return (
        f'<joint name="{name}" type="{kind}"><origin xyz="0.3 0 0"/><parent link="{parent}"/>'
        f'<child link="{child}"/>{axis}{limit}{inside}</joint>'
    )


def robot(*parts: str, name: str = "arm") -> str:
    """The whole text, a part a line."""
    return "\n".join([f'<robot name="{name}">', *parts, "</robot>"])


#: A chain of two joints with a gripper of two fingers, the second of which follows the first.
GRIPPER = robot(
    link("base"),
    link("upper"),
    link("lower"),
    link("hand"),
    link("left"),
    link("right"),
    joint("shoulder", "base", "upper"),
    joint("elbow", "upper", "lower"),
    joint("flange", "lower", "hand", "fixed"),
    joint("finger", "hand", "left", "prismatic", '<limit lower="0.01" upper="0.04"/>'),
    joint("other_finger", "hand", "right", "prismatic", '<mimic joint="finger" multiplier="-1"/>'),
)
