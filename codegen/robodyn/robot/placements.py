"""Frames that a description states: poses of links, base and tool, and where rows of standard DH end."""

from __future__ import annotations

from fractions import Fraction

from robodyn.robot.dh import standard_end
from robodyn.robot.document import describe
from robodyn.robot.fields import Section
from robodyn.robot.keys import ROW
from robodyn.robot.parts import Link, Placement
from robodyn.robot.values import ZERO


def placement_at(section: Section, key: str) -> Placement | None:
    """The frame at ``key``; None where it is left out."""
    frame = section.section(key)
    if frame is None:
        return None
    x, y, z = (value for value in frame.vector("xyz") or (ZERO,) * 3 if isinstance(value, Fraction))
    return Placement((x, y, z), frame.angles("rpy"))


def standard_end_of(section: Section, sections: list[Section], last: Link) -> Placement:
    """Where the frame of ``last``, the last standard row, stands in the modified frame."""
    for part in sections:
        if "b" in part.values:
            part.source.fail(
                part.values["b"],
                f"{part.path('b')} is an offset of modified DH rows",
                found="convention: sdh",
                remedy="delete it, or state modified rows (convention: mdh)",
            )
    if "standard_end" in section.values:
        section.source.fail(
            section.values["standard_end"],
            "standard_end is of rows that were converted",
            found="convention: sdh",
            remedy="delete it: the last row says it",
        )
    if not isinstance(last.joint.a, Fraction):
        part = sections[-1]
        part.source.fail(
            part.values["a"],
            f"{part.path('a')} cannot be a run-time parameter: it places the tool's frame",
            found=describe(part.values["a"]),
            expected="a number",
            remedy="state a number, or modified rows (convention: mdh)",
        )
    return standard_end(last)


def pose_at(section: Section, convention: str) -> Placement | None:
    """The pose of a link's frame that stands in place of its row; None where the row is stated."""
    pose = placement_at(section, "pose")
    beside = [key for key in ROW if key in section.values]
    if pose is not None and (beside or convention == "sdh"):
        section.source.fail(
            section.values["pose"],
            f"{section.path('pose')} stands in place of DH numbers",
            found=", ".join(beside) + " beside it" if beside else "convention: sdh",
            expected=f"pose, or {', '.join(ROW)}",
            remedy="delete the one or the other"
            if beside
            else "convention: mdh: a pose is that of the joint",
        )
    return pose
