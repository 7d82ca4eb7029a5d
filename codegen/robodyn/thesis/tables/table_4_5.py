"""Table 4.5: how many tasks of a step are left where its vector has zeros."""

from __future__ import annotations

from typing import Final

from robodyn.schedule.elimination import left_out
from robodyn.schedule.graph import task_id
from robodyn.schedule.task_counts import flops_of_tasks
from robodyn.schedule.tasks import FLOPS_PER_TASK
from robodyn.thesis.printed_tasks import TABLE_4_5
from robodyn.thesis.tables.table import Column, Row, Table, judged

_LINK: Final = 4
_AXES: Final = {1: "yz", 2: "z", 3: ""}


def flops(tasks: tuple[int, ...], zeros: int) -> int:
    """The operations of a link's ``tasks`` where both its vectors have so many zeros."""
    axes = _AXES[zeros]
    by_task = flops_of_tasks(_LINK + 1, s=axes, p=axes)
    return sum(by_task[task_id(_LINK, task_number)] for task_number in tasks)


def table() -> Table:
    """Printed tasks beside as many as the remaining operations fill."""
    rows = []
    for rule in TABLE_4_5:
        for zeros, printed in enumerate(rule.executed, 1):
            needed = flops(rule.tasks, zeros)
            ours = -(-needed // FLOPS_PER_TASK)
            same = len(printed) == ours and left_out(rule.tasks, zeros) + printed == rule.tasks
            spare = FLOPS_PER_TASK * ours - needed
            rows.append(
                Row(
                    f"step {rule.step}, {rule.what}, {zeros} zero{'s' if zeros > 1 else ''}",
                    {"executed": list(printed), "tasks": len(printed)},
                    {"tasks": ours, "flops": needed, "of": flops_without(rule.tasks)},
                    judged(same),
                    "no operation is left"
                    if not needed
                    else f"the operations left fill {ours} task{'s' if ours > 1 else ''} of {FLOPS_PER_TASK}"
                    + (f" with {spare} to spare" if spare else ""),
                )
            )
    return Table(
        "4.5",
        "tasks of a step that are still executed where its vector has zeros",
        (
            Column("printed", "printed", "executed"),
            Column("tasks", "printed", "tasks"),
            Column("ours", "ours", "tasks"),
            Column("flops", "ours", "flops"),
        ),
        tuple(rows),
        (
            "The caption says eliminated; the columns list what is still executed. Ours: the step's tasks "
            "carried out on numbers that only count, with zeros in the vector; the operations that are left, "
            "three a task. Which of the task numbers remain is a matter of naming: the thesis keeps the "
            "last.",
        ),
    )


def flops_without(tasks: tuple[int, ...]) -> int:
    """The operations of a link's ``tasks`` where nothing is zero."""
    by_task = flops_of_tasks(_LINK + 1)
    return sum(by_task[task_id(_LINK, task_number)] for task_number in tasks)
