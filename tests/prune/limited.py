"""Robots with limits, and programs that are wrong on purpose."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction

from robodyn.ir import Program
from robodyn.robot import Robot
from robodyn.robot.model import Limits
from robodyn_testing.random_robots import random_robot

PI = Fraction(314159265358979, 10**14)
TURN = Limits((-PI, PI), Fraction(3), Fraction(10))
STROKE = Limits((Fraction(-1, 5), Fraction(1, 2)), Fraction(1), Fraction(6))


def limited(robot: Robot) -> Robot:
    """``robot`` with limits at every joint."""
    links = [
        replace(link, joint=replace(link.joint, limits=TURN if link.joint.kind == "revolute" else STROKE))
        for link in robot.links
    ]
    return replace(robot, links=tuple(links))


def random_limited(seed: int, joints: int) -> Robot:
    """A random arm with limits, of ``joints`` joints."""
    return limited(random_robot(seed, joints=joints))


def damaged(program: Program, seed: int, places: int = 3) -> Program:
    """``program`` with the signs of some additions turned or constants changed."""
    rng = random.Random(seed)
    operations = list(program.operations)
    where = [i for i, o in enumerate(operations) if o.op in ("add", "mul") and o.label is None]
    for i in rng.sample(where, min(places, len(where))):
        operation = operations[i]
        if operation.op == "add":
            operations[i] = operation._replace(op="sub")
        else:
            factor, *rest = operation.args
            if isinstance(factor, Fraction):
                operations[i] = operation._replace(args=(factor * Fraction(9, 10), *rest))
    return Program(tuple(operations), program.outputs)
