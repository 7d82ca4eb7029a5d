"""What the logarithmic forms cost and from how many joints on they pay: task graphs of any arm of n joints.

All forms run on the same arm, of which nothing is special, and are cut into single operations, so that
their longest chains and their work compare. Constants of the model are numbers, what depends on them alone is
formed beforehand, and sines and cosines are given.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any, Final

from robodyn.counts.general import general_arm
from robodyn.dynamics.arm import Arm
from robodyn.dynamics.modified_newton_euler import modified_newton_euler
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.ir.graph import Graph, Node
from robodyn.ir.lowering import lower
from robodyn.ir.program import Program
from robodyn.schedule.cutting import cut
from robodyn.schedule.graph import TaskGraph
from robodyn.schedule.tasks import FLOPS_PER_TASK
from robodyn.thesis.formulations.logarithmic import logarithmic

Form = Callable[..., list[Any]]

#: The forms by name: the recursions from link to link, and those by running totals.
FORMS: Final[dict[str, Form]] = {
    "newton-euler": newton_euler,
    "modified newton-euler": modified_newton_euler,
    "lee-chang": partial(logarithmic, running="doubling"),
    "lathrop": partial(logarithmic, running="tree"),
}
LINEAR: Final = ("newton-euler", "modified newton-euler")
LOGARITHMIC: Final = ("lee-chang", "lathrop")
TITLES: Final = {
    "newton-euler": "Newton-Euler, link by link (Luh, Walker and Paul 1980)",
    "modified newton-euler": "modified Newton-Euler, link by link (the thesis)",
    "lee-chang": "recursive doubling (Lee and Chang 1986)",
    "lathrop": "trees (Lathrop 1985)",
}


def general_program(form: str, n: int, *, right_angled: bool = True) -> Program:
    """The program of ``form`` for a revolute arm of ``n`` joints; with ``right_angled`` all angles alpha are
    90 degrees and tensors of inertia diagonal, which is what the thesis's tasks are cut for.

    Inputs are ``c``, ``s``, ``qd`` and ``qdd`` [n].
    """
    graph = Graph()
    constants = _constants()
    variables = (graph.input(array, i) for array in ("c", "s", "qd", "qdd") for i in range(n))

    def number(fixed: bool) -> Fraction | Node:
        return next(constants) if fixed else next(variables)

    arm, motion = general_arm(n, (), number)
    arm = _right_angled(arm) if right_angled else _turned(arm)
    torques = FORMS[form](arm, motion, graph.label)
    return lower(graph, [("tau", torques)])


def _constants() -> Iterator[Fraction]:
    """Numbers of which no product or sum is 0, 1 or another of them by chance."""
    value = 1009
    while True:
        value = value * 48271 % 2147483647
        yield Fraction(value, 65537)


def _right_angled(arm: Arm) -> Arm:
    """``arm`` with right angles and diagonal tensors, gravity along z of the base, its first axis upright."""
    bodies = tuple(
        replace(
            body,
            cos_alpha=1 if i == 0 else 0,
            sin_alpha=0 if i == 0 else 1,
            inertia=replace(body.inertia, xy=0, xz=0, yz=0),
        )
        for i, body in enumerate(arm.bodies)
    )
    return replace(arm, bodies=bodies, gravity=(0, 0, arm.gravity[2]))


def form_graph(form: str, n: int, *, k: int = 1, right_angled: bool = True) -> TaskGraph:
    """The task graph of ``form`` for ``n`` joints, ``k`` operations a task."""
    return cut(general_program(form, n, right_angled=right_angled), k).graph


def _turned(arm: Arm) -> Arm:
    """``arm`` with angles alpha that have a cosine and a sine."""
    bodies = tuple(
        replace(body, cos_alpha=(1 - t * t) / (1 + t * t), sin_alpha=2 * t / (1 + t * t))
        for body, t in ((body, Fraction(i + 2, 7)) for i, body in enumerate(arm.bodies))
    )
    return replace(arm, bodies=bodies)


@dataclass(frozen=True, slots=True)
class Cost:
    """``work`` operations, of which ``chain`` one after another."""

    work: int
    chain: int


def cost(form: str, n: int) -> Cost:
    """Operations and longest chain of ``form`` for ``n`` joints."""
    graph = form_graph(form, n)
    return Cost(len(graph), graph.critical_path)


def thesis_chain(n: int) -> int:
    """Operations one after another in the thesis's tasks of three: ``3 (4 n + 3)``."""
    return FLOPS_PER_TASK * (4 * n + 3)


def first_shorter(form: str, than: Callable[[int], int], most: int = 64) -> int | None:
    """The number of joints from which on (up to ``most``) the chain of ``form`` is shorter than ``than``;
    None if it is not at ``most``."""
    shorter = None
    for n in range(most, 1, -1):
        if form_graph(form, n).critical_path >= than(n):
            break
        shorter = n
    return shorter
