"""Cylinders for pictures: one along each link to the next joint, one about each joint. They weigh nothing."""

from __future__ import annotations

import math
from dataclasses import dataclass

from robodyn.formats.chain import Vector
from robodyn.formats.limits import PICTURE_HUB, PICTURE_RADIUS
from robodyn.formats.writers.parts import Frame, Parts


@dataclass(frozen=True, slots=True)
class Cylinder:
    """A cylinder about z of its ``frame``, which is its middle; ``radius`` and ``length`` in m."""

    frame: Frame
    radius: float
    length: float


def cylinders(parts: Parts) -> list[tuple[Cylinder, ...]]:
    """The cylinders of the base, then of each link, in their frames."""
    radius = _round(PICTURE_RADIUS * parts.size)
    ends = [joint.frame.xyz for joint in parts.joints] + [(parts.tool or Frame()).xyz]
    hub = Cylinder(Frame(), _round(PICTURE_HUB * radius), _round(2 * PICTURE_HUB * radius))
    pictures = [[] if index == 0 or not radius else [hub] for index in range(len(ends))]
    for picture, end in zip(pictures, ends, strict=True):
        if radius and math.hypot(*end) > radius:
            picture.append(_towards(end, radius))
    return [tuple(picture) for picture in pictures]


def _towards(end: Vector, radius: float) -> Cylinder:
    """The cylinder from the origin to ``end``."""
    x, y, z = end
    middle = (_round(x / 2), _round(y / 2), _round(z / 2))
    pitch, yaw = math.atan2(math.hypot(x, y), z), math.atan2(y, x)
    return Cylinder(Frame(middle, (0.0, _round(pitch), _round(yaw))), radius, _round(math.hypot(x, y, z)))


def _round(x: float) -> float:
    """A picture needs four digits; more would only make the file long."""
    return float(f"{x:.4g}")
