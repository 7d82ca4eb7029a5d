"""Programs run on arrays of states by numpy, and the robots that functions are tried on."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any, Final

import numpy as np

import robodyn
from ir.programs import interpreted
from robodyn.ir import Input, Program
from robodyn.robot import Robot, load
from robodyn_testing.random_robots import random_robot

BUNDLED: Final = tuple(sorted(path.stem for path in (Path(__file__).parents[2] / "robots").glob("*.yaml")))
RANDOM: Final = tuple(f"random {seed}" for seed in range(200))


#: Functions of arrays.
FUNCTIONS: Final = {"sin": np.sin, "cos": np.cos, "sign": np.sign, "tanh": np.tanh}


@cache
def robot_named(name: str, *, friction: bool = True) -> Robot:
    """A bundled robot, or ``random 7``; its friction left out if that is asked for."""
    if name.startswith("random "):
        robot = random_robot(int(name.removeprefix("random ")))
    else:
        robot = load(name, warn=lambda _: None)
    if friction:
        return robot
    zero = robot.links[0].joint.viscous * 0
    links = [replace(x, joint=replace(x.joint, viscous=zero, coulomb=zero)) for x in robot.links]
    return replace(robot, links=tuple(links))


@cache
def program(robot: Robot, function: str) -> Program:
    """The program that leaves, proven."""
    return robodyn.program(robot, function)


def by_program(robot: Robot, function: str, **arrays: Any) -> Any:
    """The results [N, m] of the program, of arrays [N, k] by name."""
    count = len(next(iter(arrays.values())))

    def leaf(x: Input) -> Any:
        return arrays[x.array][:, x.index]

    results = interpreted(program(robot, function), leaf, FUNCTIONS, float)
    return np.stack([np.broadcast_to(x, (count,)) for x in results], axis=-1)
