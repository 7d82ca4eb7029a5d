"""Inverse dynamics in a time that grows with the logarithm of the joints, what it costs, and from how many
joints on it pays: task graphs of any arm of n joints.

Along the base's axes the Newton-Euler recursions are running products and running sums: of rotations, of
``z_i qd_i``, of accelerations, of forces, of moments. What runs can be had by *recursive doubling*, in
``log2 n`` stages on many processors. Sources: Lathrop 1985 (sums and products by trees); Lee and Chang 1986
(homogeneous linear recurrences by recursive doubling, after Kogge and Stone 1973). Their papers are not at
hand: the two ways of running are theirs, how the recursion between is written is ours.

All forms run on the same arm, of which nothing is special, and are cut into single operations, so that
their longest chains and their work compare. Constants of the model are numbers, what depends on them alone is
formed beforehand, and sines and cosines are given.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any, Final, NamedTuple, TypeVar

from robodyn.counts.general import general_arm
from robodyn.dynamics.arm import Arm, Motion, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.modified_newton_euler import modified_newton_euler
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.transforms import Matrix, product, rotation, transposed, turned
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, dot, named, plus, scaled, unmarked
from robodyn.errors import InputError
from robodyn.ir.graph import Graph, Node
from robodyn.ir.lowering import lower
from robodyn.ir.program import Program
from robodyn.schedule.cutting import cut
from robodyn.schedule.graph import TaskGraph
from robodyn.schedule.tasks import FLOPS_PER_TASK

Item = TypeVar("Item")
#: Joins two neighbours, the earlier first.
Join = Callable[[Item, Item], Item]
#: Makes all running totals of a row.
Running = Callable[[Sequence[Any], Join[Any]], list[Any]]


def doubling(items: Sequence[Item], join: Join[Item]) -> list[Item]:
    """All running totals of ``items``: every stage joins each with the one twice as far before it.

    ``ceil(log2 n)`` stages, about ``n log2 n`` joins (Kogge and Stone 1973).
    """
    prefixes = list(items)
    reach = 1
    while reach < len(prefixes):
        prefixes = [item if i < reach else join(prefixes[i - reach], item) for i, item in enumerate(prefixes)]
        reach *= 2
    return prefixes


def tree(items: Sequence[Item], join: Join[Item]) -> list[Item]:
    """All running totals of ``items``: pairs are joined, their totals run, and each second one is made
    from its neighbour. About ``2 log2 n`` stages, fewer than ``2 n`` joins (Brent and Kung 1982)."""
    if len(items) < 2:
        return list(items)
    pairs = [join(items[i], items[i + 1]) for i in range(0, len(items) - 1, 2)]
    totals = tree(pairs, join)
    prefixes = [items[0]]
    for i in range(1, len(items)):
        prefixes.append(totals[i // 2] if i % 2 else join(totals[i // 2 - 1], items[i]))
    return prefixes


def logarithmic(arm: Arm, motion: Motion, mark: Mark = unmarked, *, run: Running = doubling) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    bodies, n = arm.bodies, len(arm.bodies)

    def forward(vectors: Sequence[Vector]) -> list[Vector]:
        return run(vectors, plus)

    def backward(vectors: Sequence[Vector]) -> list[Vector]:
        return run(vectors[::-1], lambda later, own: plus(own, later))[::-1]

    turns = [rotation(body, motion.c[i], motion.s[i]) for i, body in enumerate(bodies)]
    R: list[Matrix] = run(turns, product)
    z = [(turn[0][2], turn[1][2], turn[2][2]) for turn in R]
    rates: list[Vector] = [
        scaled(motion.qd[i], z[i]) if body.revolute else ZERO for i, body in enumerate(bodies)
    ]
    w = forward(rates)
    before = [ZERO, *w[:-1]]
    alpha = forward(
        [
            plus(scaled(motion.qdd[i], z[i]), cross(before[i], rates[i])) if body.revolute else ZERO
            for i, body in enumerate(bodies)
        ]
    )
    origins = [origin(body, motion.d[i]) for i, body in enumerate(bodies)]
    p = [turned(R[i - 1], u) if i else u for i, u in enumerate(origins)]
    gx, gy, gz = arm.gravity
    steps: list[Vector] = []
    for i, body in enumerate(bodies):
        step = _relative(before[i], alpha[i - 1] if i else ZERO, p[i])
        if not body.revolute:
            qd, qdd = motion.qd[i], motion.qdd[i]
            step = plus(step, plus(scaled(qdd, z[i]), scaled(2 * qd, cross(before[i], z[i]))))
        steps.append(plus((-gx, -gy, -gz), step) if i == 0 else step)
    a = forward(steps)

    forces, moments = [], []
    for i, body in enumerate(bodies):
        s = turned(R[i], body.com)
        force = scaled(body.mass, plus(a[i], _relative(w[i], alpha[i], s)))
        back = transposed(R[i])
        own_w, own_alpha = turned(back, w[i]), turned(back, alpha[i])
        own = plus(body.inertia.times(own_alpha), cross(own_w, body.inertia.times(own_w)))
        forces.append(named(mark, force, i + 1, "fc"))
        moments.append(plus(turned(R[i], own), cross(s, force)))
    f = backward(forces)
    passed_on = [plus(moments[i], cross(p[i + 1], f[i + 1])) if i + 1 < n else moments[i] for i in range(n)]
    moment = backward(passed_on)
    return [
        joint_torque(arm, i, motion, dot(z[i], moment[i] if body.revolute else f[i]), mark)
        for i, body in enumerate(bodies)
    ]


def _relative(w: Vector, alpha: Vector, r: Vector) -> Vector:
    """``alpha x r + w x (w x r)``."""
    return plus(cross(alpha, r), cross(w, cross(w, r)))


# --- what the forms cost ----------------------------------------------------------------------------------

#: The forms by name: the recursions from link to link, and those by running totals.
FORMS: Final[dict[str, Callable[..., list[Any]]]] = {
    "newton-euler": newton_euler,
    "modified-newton-euler": modified_newton_euler,
    "lee-chang": partial(logarithmic, run=doubling),
    "lathrop": partial(logarithmic, run=tree),
}
LINEAR: Final = ("newton-euler", "modified-newton-euler")
LOGARITHMIC: Final = ("lee-chang", "lathrop")
MOST_JOINTS: Final = 48
TITLES: Final = {
    "newton-euler": "Newton-Euler, link by link (Luh, Walker and Paul 1980)",
    "modified-newton-euler": "modified Newton-Euler, link by link (the thesis)",
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
            body, cos_alpha=int(i == 0), sin_alpha=int(i > 0), inertia=replace(body.inertia, xy=0, xz=0, yz=0)
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


def compare_forms(most: int, tell: Callable[[str], None] = lambda _: None) -> dict[str, Any]:
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
        times = last[form]["work"] / last["modified-newton-euler"]["work"]
        lines.append(
            f"{form}: {times:.2f} times the work of modified-newton-euler at {last['joints']} joints"
        )
    lines += ["", *(f"{name}: {title}" for name, title in comparison["titles"].items())]
    return "\n".join(lines) + "\n"
