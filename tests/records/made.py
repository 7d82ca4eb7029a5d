"""Records to test with: arms of a few joints, their programs, and one that a walk has made better."""

from __future__ import annotations

import functools
from dataclasses import replace
from typing import Final

from robodyn import Options, load, program
from robodyn.counts import count
from robodyn.ir import Program
from robodyn.optimize.records import Record, identity
from robodyn.passes import SPELLING, run
from robodyn.robot import Robot, read_text

#: Every kind of number at run time, friction, a sliding joint, an angle that is no right one.
TOOL: Final = """\
name: tool
links:
  - {joint: revolute, mass: 3, com: [0.1, 0, 0.2], inertia: {zz: 0.25},
     friction: {viscous: 1.5, coulomb: c_1}}
  - {joint: revolute, alpha: pi/2, a: a_2, mass: m_2, com: [0.2, 0.1, y_2], inertia: {xx: i_2, xy: 0.01}}
  - {joint: prismatic, alpha: 0.7, d: 0.2, mass: 1, com: [0, 0, 0.1], motor_inertia: 2,
     friction: {coulomb: 4}}
"""
SMOOTH: Final = TOOL + "friction_at_rest: {smooth: {velocity: 0.001}}\n"

#: An arm of which a walk finds a better program at once.
ELBOW: Final = """\
name: elbow
title: Two joints, all numbers
gravity: [0.3, 0, -9.81]
links:
  - {joint: revolute, alpha: pi/2, a: 0.1, mass: 2, com: [0.1, 0.2, 0.3],
     inertia: {xx: 0.2, yy: 0.3, zz: 0.4, xy: 0.01, xz: 0.02, yz: 0.03}}
  - {joint: revolute, alpha: -pi/2, a: 0.4, d: 0.1, mass: 1.5, com: [0.3, 0.05, 0.1],
     inertia: {xx: 0.1, yy: 0.2, zz: 0.25, xy: 0.02, xz: 0.01, yz: 0.04}}
"""


def arm(text: str) -> Robot:
    """The robot that ``text`` describes."""
    return read_text(text, warn=lambda _: None)


@functools.cache
def bundled(name: str) -> Robot:
    """A bundled robot, doubts about it untold."""
    return load(name, warn=lambda _: None)


@functools.cache
def fast(robot: Robot, function: str = "inverse_dynamics") -> Program:
    """What ``fast`` makes of it."""
    return replace(program(robot, function, Options((function,), optimize="fast")), origin=None)


def recorded(
    robot: Robot, made: Program, function: str = "inverse_dynamics", objective: str = "total"
) -> Record:
    """``made`` as a record of ``robot``."""
    return Record(robot.name, identity(robot), function, objective, "a test", replace(made, origin=None))


@functools.cache
def better(robot: Robot) -> Record:
    """A record of the inverse dynamics that takes fewer operations than ``fast``."""
    from robodyn.search.walk import Walk

    plain = fast(robot)
    walk = Walk([plain], seed=1)
    for _ in range(20):
        walk.run(500, 0.3)
        made = run(walk.best(), SPELLING)
        if count(made).total < count(plain).total:
            return recorded(robot, made)
    raise AssertionError(f"no better program of {robot.name} in 10,000 steps")
