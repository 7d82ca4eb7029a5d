"""Force and moment in every joint: what bearings and housings bear, and what friction under load depends on.

Source: Dhanaraj 1990, Table 2.4, steps 7 and 8 (f_i, n_i), which its Eqs 3.1 to 3.5 start from.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.functions.arguments import QD, QDD, WRENCH, Array, Q
from robodyn.dynamics.functions.record import WITH_WRENCH, Function
from robodyn.dynamics.state import Dynamics, Vector

R = Array(
    "R",
    "force and moment of the link before on each link, about the origin and along the axes of its frame",
    "N, N m",
    shape=("n", 6),
)


def _reactions(at: Dynamics) -> Sequence[Any]:
    return _rows(at, [0] * 6)


def _under_wrench(at: Dynamics) -> Sequence[Any]:
    return _rows(at, at.inputs["w"])


def _rows(at: Dynamics, w: Vector) -> list[Any]:
    joints = at.reactions(at.inputs["qd"], at.inputs["qdd"], w)
    return [x for force, moment in joints for x in (*force, *moment)]


_PURPOSE = "force and moment that each joint passes on to its link"

FUNCTIONS = (
    Function(
        "joint_reactions",
        _PURPOSE,
        (Q, QD, QDD),
        (R,),
        _reactions,
        expected=_reactions,
        drives=False,
    ),
    Function(
        "joint_reactions" + WITH_WRENCH,
        f"{_PURPOSE}, while a wrench pushes the tool",
        (Q, QD, QDD, WRENCH),
        (R,),
        _under_wrench,
        expected=_under_wrench,
        drives=False,
    ),
)
