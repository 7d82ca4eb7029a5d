"""Arms that miss a class of inverse kinematics by a little, as calibrated arms do."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Final

from robodyn.robot.model import Inertia, Joint, Link, Robot
from robodyn.robot.parts import Placement
from robodyn.robot.values import PI, angle

#: Rows of classes, and of arms that are of none: the joint's kind, its twist (0, a Quarter turn or iNclined),
#: and its lengths ``a`` and ``d`` (0 or a Length).
SHAPES: Final[dict[str, str]] = {
    "parallel_then_wrist": "R00L RQ0L R0LL RQLL RQ00 RQ00",
    "meeting_then_wrist": "R00L RQ00 RQLL RQLL RQ00 RQ00",
    "inclined_wrist": "R00L RN00 RNLL RNLL RN00 RN00",
    "inclined_parallel": "R00L RNLL R0LL RNLL RN00 RN00",
    "stanford": "R00L RQ0L PQ0L R000 RQ00 RQ00",
    "stanford_meeting": "R00L RQ00 PQ0L R000 RQ00 RQ00",
    "scara_and_wrist": "R00L R0LL P0LL R000 RQ00 RQ00",
    "slide_between": "R00L P0LL R0LL RQL0 RQ00 RQ00",
    "slide_across": "R00L PQLL RQLL RQL0 RQ00 RQ00",
    "turn_and_slides": "R00L P0LL PQ0L R000 RQ00 RQ00",
    "cylinder": "P00L R0LL PQ0L R000 RQ00 RQ00",
    "gantry_and_wrist": "P00L PQ0L PQ0L R000 RQ00 RQ00",
    "three_parallel": "R00L RQ0L R0LL R0LL RQ0L RQ00",
    "three_parallel_inclined": "R00L RNLL R0LL R0LL RNLL RN00",
    "shoulder_first": "R00L RQ00 RQ00 RQLL R0LL RQLL",
    "seven_joints": "R00L RQ00 RQ0L RQ00 RQ0L RQ00 RQ0L",
    "seven_with_offsets": "R00L RQ00 RQ0L RQL0 RQLL RQ00 RQL0",
    "two_spheres": "R00L RQ00 RQ0L RQLL RN00 RN00",
    "elbow": "R00L RQ0L R0LL",
    "crossing": "R00L RQ00 RQLL",
    "turns_and_slide": "R00L RQ0L PQ0L",
    "scara_place": "R00L R0LL P0LL",
    "cylinder_place": "P00L R0LL PQ0L",
    "slide_across_place": "R00L PQLL RQLL",
    "slides": "P00L PQ0L PQ0L",
    "two_turns": "R00L RQLL",
    "scara": "R00L R0LL P0LL R000",
    "palletizer": "R00L RQ00 R0L0 R0L0",
    "five": "R00L RQ00 R0L0 R0L0 RQ0L",
    "planar": "R00L R0L0 R0L0",
    "eight": "R00L RQ00 RQ0L RQ00 RQ0L RQ00 RQ0L RQL0",
}


def nearly(shape: str, seed: int, *, exactly: bool = False) -> Robot:
    """An arm of that ``shape``, all its numbers off by 1e-7 to 1e-3 rad or m, or ``exactly`` of it."""
    chance = random.Random(f"{shape} {seed}")
    size = 10 ** chance.uniform(-7, -3) * (not exactly)

    def off() -> Fraction:
        return Fraction(round(chance.gauss(0, 0.4) * size, 12)) if chance.random() < 0.8 else Fraction(0)

    def length(word: str) -> Fraction:
        drawn = Fraction(chance.randint(1000, 8000) * chance.choice((-1, 1)), 10_000)
        return off() + (drawn if word == "L" else 0)

    def twist(word: str) -> Fraction:
        inclined = Fraction(chance.randint(-26_000, 26_000), 10_000)
        return off() + {"0": Fraction(0), "Q": chance.choice((-1, 1)) * PI / 2, "N": inclined}[word]

    links = []
    for k, (kind, alpha, a, d) in enumerate(map(tuple, SHAPES[shape].split())):
        theta = chance.choice((Fraction(0), PI / 2, -PI / 2, Fraction(13, 10))) + off()
        joint = Joint(
            kind="revolute" if kind == "R" else "prismatic",
            alpha=angle(twist(alpha)),
            a=length(a),
            d=length(d),
            theta=angle(theta if kind == "R" else Fraction(0)),
        )
        zero = Fraction(0)
        links.append(Link(f"link_{k + 1}", joint, Fraction(1), (zero, zero, zero), Inertia()))
    tool = None
    if chance.random() < 0.6:
        turns = (angle(PI / 2), angle(Fraction(0)), angle(Fraction(3, 10)))
        tool = Placement((Fraction(1, 10), Fraction(-1, 5), Fraction(3, 20)), turns)
    return Robot(name=f"{shape}_{seed}", links=tuple(links), tool=tool)
