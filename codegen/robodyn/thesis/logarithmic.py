"""What the logarithmic forms cost and from how many joints on they pay: task graphs of any arm of n joints.

All forms run on the same arm, of which nothing is special, and are cut into single operations, so that
their longest chains and their work compare. Constants of the model are numbers, what depends on them alone is
formed beforehand, and sines and cosines are given.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any, Final, NamedTuple

from robodyn.counts.general import general_arm
from robodyn.dynamics.modified_newton_euler import modified_newton_euler
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.errors import InputError
from robodyn.ir.graph import Graph, Node
from robodyn.ir.lowering import lower
from robodyn.ir.program import Program
from robodyn.schedule.cutting import cut
from robodyn.schedule.graph import TaskGraph
from robodyn.schedule.tasks import FLOPS_PER_TASK
from robodyn.thesis.formulations.logarithmic import doubling, logarithmic, tree

#: The forms by name: the recursions from link to link, and those by running totals.
FORMS: Final[dict[str, Callable[..., list[Any]]]] = {
    "newton-euler": newton_euler,
    "modified newton-euler": modified_newton_euler,
    "lee-chang": partial(logarithmic, run=doubling),
    "lathrop": partial(logarithmic, run=tree),
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


def general_program(form: str, n: int) -> Program:
    """The program of ``form`` for a revolute arm of ``n`` joints whose angles alpha are 90 degrees and whose
    tensors of inertia are diagonal, gravity along z of the base, the first axis upright: what the thesis's
    tasks are cut for.

    Inputs are ``c``, ``s``, ``qd`` and ``qdd`` [n].
    """
    graph = Graph()
    constants = _constants()
    variables = (graph.input(array, i) for array in ("c", "s", "qd", "qdd") for i in range(n))

    def number(fixed: bool) -> Fraction | Node:
        return next(constants) if fixed else next(variables)

    arm, motion = general_arm(n, (), number)
    bodies = tuple(
        replace(
            body,
            cos_alpha=int(i == 0),
            sin_alpha=int(i > 0),
            inertia=replace(body.inertia, xy=0, xz=0, yz=0),
        )
        for i, body in enumerate(arm.bodies)
    )
    arm = replace(arm, bodies=bodies, gravity=(0, 0, arm.gravity[2]))
    return lower(graph, [("tau", FORMS[form](arm, motion, graph.label))])


def _constants() -> Iterator[Fraction]:
    """Numbers of which no product or sum is 0, 1 or another of them by chance."""
    value = 1009
    while True:
        value = value * 48271 % 2147483647
        yield Fraction(value, 65537)


def form_graph(form: str, n: int, k: int = 1) -> TaskGraph:
    """The task graph of ``form`` for ``n`` joints, ``k`` operations a task."""
    return cut(general_program(form, n), k).graph


class Cost(NamedTuple):
    """``work`` operations, of which ``chain`` one after another."""

    chain: int
    work: int


def cost(form: str, n: int) -> Cost:
    """Operations and longest chain of ``form`` for ``n`` joints."""
    graph = form_graph(form, n)
    return Cost(graph.critical_path, len(graph))


def thesis_chain(n: int) -> int:
    """Operations one after another in the thesis's tasks of three: ``3 (4 n + 3)``."""
    return FLOPS_PER_TASK * (4 * n + 3)


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
    chains: dict[str, dict[int, int]] = {name: {} for name in (*FORMS, "thesis_tasks")}
    for n in range(2, most + 1):
        tell(f"{n} joints")
        costs = {form: cost(form, n) for form in FORMS}
        chains["thesis_tasks"][n] = thesis_chain(n)
        for form, found in costs.items():
            chains[form][n] = found.chain
        each = {form: found._asdict() for form, found in costs.items()}
        rows.append({"joints": n, "thesis_tasks_chain": thesis_chain(n), **each})
    return {
        "titles": dict(TITLES),
        "rows": rows,
        "shorter_from": {
            form: {other: first_shorter(chains[form], chains[other]) for other in (*LINEAR, "thesis_tasks")}
            for form in LOGARITHMIC
        },
    }


def first_shorter(chain: Mapping[int, int], than: Mapping[int, int]) -> int | None:
    """From which number of joints on a chain is shorter, up to the last one; None if it is not there."""
    first = None
    for n in sorted(chain, reverse=True):
        if chain[n] >= than[n]:
            break
        first = n
    return first


def forms_text(comparison: dict[str, Any]) -> str:
    """The comparison for a person."""
    lines = [
        "Operations one after another (chain) and in all (work), revolute arms with right angles, single "
        "operations,",
        "processors being plenty; sines and cosines given. Thesis: its tasks of three, 12 n + 9.",
        "",
        "joints  thesis  " + "  ".join(form.rjust(22) for form in FORMS),
        "                " + "  ".join("chain / work".rjust(22) for _ in FORMS),
    ]
    for row in comparison["rows"]:
        cells = "  ".join(f"{row[form]['chain']:>13} / {row[form]['work']:<6}" for form in FORMS)
        lines.append(f"{row['joints']:>6}  {row['thesis_tasks_chain']:>6}  {cells}".rstrip())
    lines.append("")
    for form, against in comparison["shorter_from"].items():
        crossings = (
            f"{other} {f'from {n} joints on' if n else 'at no number here'}" for other, n in against.items()
        )
        lines.append(f"{form}: a shorter chain than {', '.join(crossings)}")
    last = comparison["rows"][-1]
    for form in LOGARITHMIC:
        times = last[form]["work"] / last["modified newton-euler"]["work"]
        lines.append(
            f"{form}: {times:.2f} times the work of modified newton-euler at {last['joints']} joints"
        )
    lines += ["", *(f"{name}: {title}" for name, title in comparison["titles"].items())]
    return "\n".join(lines) + "\n"
