"""Table 4.2: tasks that the first link, the last one and prismatic joints do not need."""

from __future__ import annotations

from typing import Final

from robodyn.schedule.graph import link_and_number
from robodyn.schedule.task_counts import flops_of_tasks
from robodyn.schedule.tasks import FLOPS_PER_TASK
from robodyn.thesis.printed_tasks import TABLE_4_2
from robodyn.thesis.tables.table import Column, Row, Table, judged

#: Links of the arm that the tasks are carried out on, and which of its joints slides.
JOINTS: Final = 5
SLIDING: Final = 3

WHY: Final = {
    "first_link": (
        "the first axis is upright: T10 (lambda_21 is qdd itself), T19 (gravity stays on z), T22 and T25 "
        "(lambda's last row is zero) and T28 (N_y is zero like N_x) do nothing; but T8 squares qd, and T26 "
        "is "
        "needed where the link has mass; Tables 4.3 and 4.7 drop T19 and keep T26 and T27 against this table"
    ),
    "prismatic_joint": (
        "R is constant and right-angled, so that T18 and T19 only rename components; and so do T30, T31, T39 "
        "and T40 of the link before, which turn f and n back"
    ),
}


def idle_tasks() -> dict[str, frozenset[int]]:
    """The tasks that do no arithmetic, by the table's rows: carried out on an arm of which nothing else is
    special."""
    general, sliding = flops_of_tasks(JOINTS), flops_of_tasks(JOINTS, {SLIDING})

    def idle(flops: dict[int, int], link: int) -> frozenset[int]:
        return frozenset(
            task_number
            for at, task_number in map(link_and_number, flops)
            if at == link and not flops[100 * at + task_number]
        )

    return {
        "prismatic_joint": idle(sliding, SLIDING),
        "first_link": idle(general, 1),
        "last_link": idle(general, JOINTS),
    }


def table() -> Table:
    """Printed lists beside the tasks that turn out to do nothing."""
    idle = idle_tasks()
    rows = []
    for name, (printed, total) in TABLE_4_2.items():
        ours = idle[name]
        rows.append(
            Row(
                name,
                {"tasks": sorted(printed), "total": total},
                {"tasks": sorted(ours), "total": len(ours)},
                judged(ours == printed and len(printed) == total),
                _reason(name, printed, ours),
            )
        )
    middle = [flops for task, flops in flops_of_tasks(JOINTS).items() if link_and_number(task)[0] == SLIDING]
    full = sum(flops == FLOPS_PER_TASK for flops in middle)
    return Table(
        "4.2",
        "tasks of Table 4.1 eliminated for the first link, the last link and prismatic joints",
        (
            Column("printed total", "printed", "total"),
            Column("ours", "ours", "total"),
            Column("printed", "printed", "tasks", below=True),
            Column("ours", "ours", "tasks", below=True),
        ),
        tuple(rows),
        (
            "Ours: all tasks carried out on numbers that only count, on an arm of which nothing is zero but "
            "that the base is at rest and nothing is carried; those that do no arithmetic. Of the tasks of a "
            f"link between, {full} of {len(middle)} take {FLOPS_PER_TASK} operations.",
        ),
    )


def _reason(name: str, printed: frozenset[int], ours: frozenset[int]) -> str:
    if ours == printed:
        return "the same tasks do no arithmetic: no force and no moment come from beyond"
    more, fewer = sorted(ours - printed), sorted(printed - ours)
    words = []
    if more:
        words.append(f"idle besides: {' '.join(map(str, more))}")
    if fewer:
        words.append(f"not idle: {' '.join(map(str, fewer))}")
    return f"{'; '.join(words)}. {WHY.get(name, 'Not explained')}"
