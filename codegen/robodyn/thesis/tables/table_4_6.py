"""Table 4.6: tasks that zeros of the Stanford arm's position vectors eliminate, link by link."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from robodyn.schedule.elimination import FIRST_LINK, LAST_LINK, Sparsity, sparse_tasks, sparsity
from robodyn.schedule.graph import task_id
from robodyn.thesis.printed_tasks import TABLE_4_6
from robodyn.thesis.tables.table import Column, Row, Table, judged
from robodyn.thesis.tables.table_2_10 import Load, load_quietly
from robodyn.thesis.tables.table_4_4 import ROBOT


def table(load_robot: Load = load_quietly) -> Table:
    """Printed lists beside those that the rule of Table 4.5 gives for the bundled robot."""
    pattern = sparsity(load_robot(ROBOT))
    rows = []
    lists = zip(TABLE_4_6, range(1, len(pattern.s) + 1), strict=False)
    for (s_zeros, p_zeros, numbers, total), link in lists:
        by_rule, physical = sparse_tasks(pattern, link, "own"), sparse_tasks(pattern, link, "before")
        ours = {
            "s_zeros": 3 - len(pattern.s[link - 1]),
            "p_zeros": 3 - len(pattern.p[link - 1]),
            "tasks": [task_id(link, task_number) for task_number in sorted(by_rule)],
            "total": len(by_rule),
        }
        printed = {
            "s_zeros": s_zeros,
            "p_zeros": p_zeros,
            "tasks": [task_id(link, task_number) for task_number in sorted(numbers)],
            "total": total,
        }
        beside: tuple[dict[str, Any], ...] = ()
        if physical != by_rule:
            tasks = [task_id(link, task_number) for task_number in sorted(physical)]
            beside = ({"what": "step 3 by p of the link before", "total": len(tasks), "tasks": tasks},)
        rows.append(
            Row(f"link {link}", printed, ours, judged(printed == ours), _reason(link, printed, ours), beside)
        )
    rows.append(_sum(pattern))
    return Table(
        "4.6",
        "tasks that zeros of the Stanford arm's s and p eliminate",
        (
            Column("printed total", "printed", "total"),
            Column("ours", "ours", "total"),
            Column("printed", "printed", "tasks", below=True),
            Column("ours", "ours", "tasks", below=True),
        ),
        tuple(rows),
        (
            f"Ours: the rule of Table 4.5 on the zeros of the bundled robot {ROBOT}, with p_i of the link "
            "for step 3 as the table has it. Step 3 (T12 to T17) reads p of the link before; what that gives "
            "stands beside where it is something else.",
        ),
    )


def _sum(pattern: Sparsity) -> Row:
    links = range(1, len(pattern.s) + 1)
    ours = {"total": sum(len(sparse_tasks(pattern, link, "own")) for link in links)}
    printed_sum = sum(total for *_, total in TABLE_4_6)
    listed = sum(len(numbers) for _, _, numbers, _ in TABLE_4_6)
    known = FIRST_LINK & set(TABLE_4_6[0][2]), LAST_LINK & set(TABLE_4_6[-1][2])
    return Row(
        "sum",
        {"total": printed_sum},
        ours,
        judged(ours["total"] == printed_sum),
        f"not printed as such: the printed totals add up to {printed_sum}, from which 156 tasks follow as "
        f"231 - 9 - ({printed_sum} - {sum(map(len, known))}); the printed lists have {listed}, and ours "
        f"{ours['total']}",
    )


def _reason(link: int, printed: Mapping[str, Any], ours: Mapping[str, Any]) -> str:
    if printed == ours:
        return "the rule gives the same tasks for the robot's zeros"
    listed = printed["tasks"]
    words = []
    if len(listed) != printed["total"]:
        words.append(f"the printed list has {len(listed)} tasks and not {printed['total']}")
    words += [
        f"{name}_{link} has {ours[key]} zeros in the robot and not {printed[key]}"
        for name, key in (("s", "s_zeros"), ("p", "p_zeros"))
        if printed[key] != ours[key]
    ]
    if listed == ours["tasks"]:
        words.append("the tasks themselves are those of the rule")
    return "; ".join(words) or "not explained"
