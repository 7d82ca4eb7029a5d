"""Table 2.9: operations of the two Newton-Euler methods, a joint and a step."""

from __future__ import annotations

from typing import Any, Final

from robodyn.counts import Count
from robodyn.counts.general import general_count
from robodyn.dynamics.modified_newton_euler import modified_newton_euler
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.thesis.method_steps import Method
from robodyn.thesis.printed_counts import TABLE_2_9, Pair
from robodyn.thesis.steps import STEPS, Rotation, step_counts
from robodyn.thesis.tables.table import Column, Row, Table, apart, counted, judged, pair, summed

#: The rows in which the table takes a prismatic joint's R for a full matrix; in the others it is free.
FULL_R: Final[dict[Method, frozenset[str]]] = {
    "I": frozenset(("a", "f_rotated")),
    "II": frozenset(("a", "f", "n")),
}

#: Why a printed figure is not ours, by heading, step, and what ours has more: read only where it is so.
WHY: Final[dict[tuple[str, str, int, int], str]] = {
    ("revolute_I", "n", 0, 6): (
        "the 6 additions of R n are left out although its 9 multiplications are counted: 15 is the figure of "
        "a prismatic joint, whose R n is free; the 129 flops of Table 4.1's 43 tasks have room for 21, not 15"
    ),
    ("revolute_I", "total", 0, 6): "as row n: the printed column adds up",
    ("revolute_II", "n", 0, -3): (
        "s x F, p x f and R n are 6 + 6 + 9 multiplications, to which belong 3 + 3 + 6 additions within and "
        "9 to join four terms: 21; 24 would be five terms"
    ),
    ("revolute_II", "total", 0, -13): (
        "the printed column adds up to 113 and not to the 123 printed beneath it (248 flops, not the 258 of "
        "the text), and 3 of the 113 are row n's"
    ),
    ("prismatic_II", "a", 0, 2): (
        "3 + 3 + 3 within the cross products, 9 to join terms, 6 of R, and for the slide 3 within the cross "
        "product and 4 to join it and z qdd: 28; where 26 comes from is not recoverable"
    ),
    ("prismatic_II", "n", 0, -3): "as for the revolute joint",
    ("prismatic_II", "total", 0, -1): "rows a and n: 2 more and 3 fewer",
}


def counts(method: Method, revolute: bool) -> dict[str, Count]:
    """Ours by step, R of a prismatic joint full or free as the table has it in that row."""
    full = step_counts(method, revolute=revolute, rotation="full")
    if revolute:
        return full
    free = step_counts(method, revolute=False, rotation="right-angled")
    return {step: (full if step in FULL_R[method] else free)[step] for step in STEPS}


def consistent_total(method: Method, revolute: bool, rotation: Rotation) -> Count:
    """All steps of a joint with R the same in all of them."""
    return summed(*step_counts(method, revolute=revolute, rotation=rotation).values())


def table() -> Table:
    """Printed and recomputed operations, step by step, of both methods and kinds of joints."""
    rows: list[Row] = []
    for heading, printed in TABLE_2_9.items():
        rows += _rows(heading, printed)
    return Table(
        "2.9",
        "operations a joint of methods I (lambda matrix) and II (cross products), step by step",
        (Column("printed", "printed", "operations"), Column("ours", "ours", "operations")),
        tuple(rows),
        (
            "Multiplications/additions = total. Ours: the steps of the thesis's Tables 2.3 and 2.4 carried "
            "out on numbers that only count, by the table's convention: R a full matrix (9/6), tensors of "
            "inertia "
            "diagonal in I and full in II, doubling free. Behind a prismatic joint the table takes R for "
            "free, R being right-angled, in some rows and for a full matrix in others; ours does as the row "
            "does, and what either gives throughout stands beside the totals.",
        ),
    )


def _rows(heading: str, printed: dict[str, Pair]) -> list[Row]:
    kind, _, column = heading.partition("_")
    method: Method = "I" if column == "I" else "II"
    revolute = kind == "revolute"
    ours = counts(method, revolute)
    ours["total"] = summed(*ours.values())
    rows = []
    for step, figure in printed.items():
        count = ours[step]
        same = figure == (count.mul, count.add)
        beside = _beside(method, revolute) if step == "total" else ()
        reason = _agreement(method, revolute, step) if same else _reason(heading, step, figure, count)
        rows.append(
            Row(
                f"{kind} {method}, {step}",
                {"operations": pair(*figure)},
                {"operations": counted(count)},
                judged(same),
                reason,
                beside,
            )
        )
    return rows


def _agreement(method: Method, revolute: bool, step: str) -> str:
    if revolute or (step in ("a_c", "F", "N", "f") and step not in FULL_R[method]):
        return "the step, carried out, takes as many"
    if step == "total":
        return "the sum of rows that treat R differently"
    return f"the step, carried out, takes as many with R {'full' if step in FULL_R[method] else 'free'}"


def _reason(heading: str, step: str, printed: Pair, count: Count) -> str:
    ours = (count.mul, count.add)
    known = WHY.get((heading, step, ours[0] - printed[0], ours[1] - printed[1]), "not explained")
    return f"{apart(printed, ours)}: {known}"


def _beside(method: Method, revolute: bool) -> tuple[dict[str, Any], ...]:
    if not revolute:
        return tuple(
            {"what": f"R {rotation} throughout", **counted(consistent_total(method, False, rotation))}
            for rotation in ("full", "right-angled")
        )
    run = modified_newton_euler if method == "I" else newton_euler
    fewer, more = (general_count(run, n) for n in (3, 4))
    joint = Count(mul=more.mul - fewer.mul, add=more.add - fewer.add)
    return ({"what": "robodyn's recursion, a joint, DH's R in two turns, full tensor", **counted(joint)},)
