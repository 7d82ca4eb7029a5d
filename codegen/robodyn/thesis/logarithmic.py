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
from robodyn.errors import InputError
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
MOST_JOINTS: Final = 48
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


def compared(most: int, tell: Callable[[str], None] = lambda _: None) -> dict[str, Any]:
    """Chains and work of all forms for 2 to ``most`` joints, and from which number on a logarithmic form has
    the shorter chain.

    Raises
    ------
    InputError: fewer than two joints, or more than take seconds.
    """
    if not 2 <= most <= MOST_JOINTS:
        raise InputError("forms need joints", found=f"--links {most}", expected=f"2 to {MOST_JOINTS}")
    rows: list[dict[str, Any]] = []
    costs: dict[str, dict[int, Cost]] = {form: {} for form in FORMS}
    for n in range(2, most + 1):
        tell(f"{n} joints")
        for form in FORMS:
            costs[form][n] = cost(form, n)
        rows.append(
            {
                "joints": n,
                "thesis_tasks_chain": thesis_chain(n),
                **{form: {"chain": costs[form][n].chain, "work": costs[form][n].work} for form in FORMS},
            }
        )
    chains = {form: {n: one.chain for n, one in costs[form].items()} for form in FORMS}
    thesis = {n: thesis_chain(n) for n in range(2, most + 1)}
    against = {**{form: chains[form] for form in LINEAR}, "thesis_tasks": thesis}
    return {
        "titles": dict(TITLES),
        "rows": rows,
        "shorter_from": {
            form: {other: _first(chains[form], than) for other, than in against.items()}
            for form in LOGARITHMIC
        },
    }


def _first(own: dict[int, int], other: dict[int, int]) -> int | None:
    """From which number of joints on ``own`` is shorter, up to the last one."""
    first = None
    for n in sorted(own, reverse=True):
        if own[n] >= other[n]:
            break
        first = n
    return first


def forms_text(comparison: dict[str, Any]) -> str:
    """The comparison for a person."""
    forms = list(FORMS)
    lines = [
        "Operations one after another (chain) and in all (work), revolute arms with right angles, single "
        "operations,",
        "processors being plenty; sines and cosines given. Thesis: its tasks of three, 12 n + 9.",
        "",
        "joints  thesis  " + "  ".join(form.rjust(22) for form in forms),
        "                " + "  ".join("chain / work".rjust(22) for _ in forms),
    ]
    for row in comparison["rows"]:
        cells = "  ".join(f"{row[form]['chain']:>13} / {row[form]['work']:<6}" for form in forms)
        lines.append(f"{row['joints']:>6}  {row['thesis_tasks_chain']:>6}  {cells}".rstrip())
    lines.append("")
    for form, against in comparison["shorter_from"].items():
        crossings = ", ".join(
            f"{other} from {n} joints on" if n else f"{other} at no number here"
            for other, n in against.items()
        )
        lines.append(f"{form}: a shorter chain than {crossings}")
    last = comparison["rows"][-1]
    base = last["modified newton-euler"]["work"]
    for form in LOGARITHMIC:
        lines.append(
            f"{form}: {last[form]['work'] / base:.2f} times the work of modified newton-euler at "
            f"{last['joints']} joints"
        )
    lines += ["", *(f"{name}: {title}" for name, title in comparison["titles"].items())]
    return "\n".join(lines) + "\n"
