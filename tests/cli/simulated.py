"""Robots for the tests of ``robodyn simulate``, and the command itself."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]

SLIDE = """\
name: slide
links:
  - joint: prismatic
    alpha: pi/2
    mass: m
    limits: {position: [-1, 1], velocity: 2, acceleration: 20}
"""
# A pendulum in the plane of x and y of a base whose gravity is along -y.
PENDULUM = """\
name: pendulum
gravity: [0, -9.81, 0]
links:
  - {joint: revolute, theta: -pi/2, mass: 2, com: [0.5, 0, 0], inertia: {zz: 0.1}}
"""
STICKY = PENDULUM.replace("name: pendulum", "name: sticky").replace(
    "inertia: {zz: 0.1}", "inertia: {zz: 0.1}, friction: {coulomb: 10}"
)
WEAK = SLIDE.replace("name: slide", "name: weak").replace("mass: m", "mass: 2") + (
    "    effects: [{effect: torque_saturation, limit: 1}]\n"
)
ELASTIC = """\
name: elastic
gravity: [0, 0, 0]
links:
  - joint: revolute
    inertia: {zz: 1}
    motor_inertia: 0.01
    effects: [{effect: joint_elasticity, stiffness: 1e4, damping: 2}]
"""

SOFT = ELASTIC.replace("name: elastic", "name: soft").replace("1e4, damping: 2", "k, damping: d")


def simulate(capsys: Capture, command: str, code: int = 0) -> tuple[str, str]:
    """Standard output and standard error."""
    assert main(["simulate", *command.split()]) == code, capsys.readouterr().err
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return out, err


def made() -> set[str]:
    """What there is in the folder besides the robots."""
    return {path.name for path in Path().iterdir() if path.suffix != ".yaml"}
