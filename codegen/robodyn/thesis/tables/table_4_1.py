"""Table 4.1: the 43 tasks of a link, with what of them is misprinted."""

from __future__ import annotations

from itertools import groupby
from typing import Final

from robodyn.schedule.graph import task_id
from robodyn.schedule.task_counts import operations_of_tasks
from robodyn.schedule.tasks import FLOPS_PER_TASK, TASKS, Task
from robodyn.thesis.printed_tasks import TABLE_4_1_MISPRINTS
from robodyn.thesis.tables.table import Column, Row, Table

#: A link amid an arm, so that nothing is spared.
_LINK: Final = 3
_PLACES: Final = {-1: "before", 0: "", 1: "beyond"}


def table() -> Table:
    """Each task as we schedule it, beside what is printed of it where that is something else."""
    operations = operations_of_tasks(_LINK + 1)
    return Table(
        "4.1",
        f"the {len(TASKS)} tasks of a link, {FLOPS_PER_TASK} operations each",
        (
            Column("step", "ours", "step"),
            Column("pass", "ours", "pass"),
            Column("layer", "ours", "layer"),
            Column("operations", "ours", "operations"),
            Column("does", "ours", "does", below=True),
            Column("after", "ours", "after", below=True),
            Column("printed", "printed", "spelled", below=True),
        ),
        tuple(_row(task, sum(operations[task_id(_LINK, task.row)].values())) for task in TASKS),
        (
            "What each task does and waits for, as robodyn schedules it; before and beyond are the link "
            "before and the link after. Operations are those that the task does on an arm of which no "
            "component is zero, counted by carrying it out (schedule/arithmetic.py), where changes of sign "
            "are free. Of each step all tasks together are the recursion, exactly, which tests hold it to.",
        ),
    )


def _row(task: Task, operations: int) -> Row:
    ours = {
        "step": task.step,
        "pass": "forward" if task.forward else "backward",
        "layer": task.layer,
        "operations": operations,
        "does": task.does,
        "after": predecessors(task) or "nothing",
    }
    slip = TABLE_4_1_MISPRINTS.get(task.row)
    if slip is None:
        same = {"what": "the same", "spelled": None}
        return Row(f"T{task.row}", same, ours, "reproduced", "as printed, in our words")
    return Row(
        f"T{task.row}",
        {"what": slip.what, slip.what: slip.printed, "spelled": f"{slip.what}: {slip.printed}"},
        ours,
        "differs",
        f"misprinted: {slip.why}",
    )


def predecessors(task: Task) -> str:
    """What a task waits for, ranges put together: ``T9 to T11 before, T12``."""
    spelled = []
    for place, pairs in groupby(task.after, key=lambda pair: pair[0]):
        rows = [row for _, row in pairs]
        for _, run in groupby(enumerate(rows), key=lambda pair: pair[1] - pair[0]):
            these = [row for _, row in run]
            text = f"T{these[0]}" if len(these) == 1 else f"T{these[0]} to T{these[-1]}"
            spelled.append(f"{text} {_PLACES[place]}".rstrip())
    return ", ".join(spelled)
