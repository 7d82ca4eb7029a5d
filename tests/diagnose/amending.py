"""What test_amend and test_amended_sums share."""

from __future__ import annotations

from fractions import Fraction

from robodyn.diagnose.amend.amend import Amendment, amended, amended_text
from robodyn.robot import Robot, read_text

F = Fraction


def read(text: str) -> Robot:
    return read_text(text, warn=lambda _: None)


def amend(text: str, *amendments: Amendment, notes: dict[int, str] | None = None) -> str:
    """The text with the amendments, held to what the data say."""
    robot = read(text)
    new = amended_text(text, robot, amendments, notes or {})
    assert read(new) == amended(robot, amendments)
    return new


HAND = """\
# An arm   (kept: odd   spaces)
name: arm   # its name
links:   # base to tip
  # the first
  - joint: revolute   # J1
    mass: 2.50   # kg
    friction: {viscous: 1.0, coulomb: 2.0}   # N m s/rad, N m
    # between
    com: [0.1, 0, 0]   # m

  - {joint: prismatic, mass: m_tool, friction: {coulomb: 1}}   # J2
# the end
"""
