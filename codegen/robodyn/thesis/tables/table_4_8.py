"""Table 4.8: how long the Stanford arm's inverse dynamics takes on p processors."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from robodyn.schedule import Machine, solve
from robodyn.thesis.judge import printed_graph, rule_graph
from robodyn.thesis.printed_tasks import LEVELS_STANFORD, TIMES_OTHERS, TIMES_STANFORD
from robodyn.thesis.tables.table import Column, Row, Table, judged

#: Milliseconds a task: what one processor takes for all of them, divided by their number.
TASK_TIME: Final = TIMES_STANFORD[1] / LEVELS_STANFORD[1]


def table() -> Table:
    """Printed times beside the printed levels times a task's time, and beside shorter schedules."""
    printed, by_rule = printed_graph("stanford"), rule_graph("stanford")
    rows = []
    for p, ms in TIMES_STANFORD.items():
        found = {
            "levels": LEVELS_STANFORD[p],
            "ms": round(LEVELS_STANFORD[p] * TASK_TIME, 3),
        }
        first, ruled = (solve(graph, Machine(p), "critical-path") for graph in (printed, by_rule))
        thesis = solve(printed, Machine(p), "thesis")
        ours: dict[str, Any] = {
            **found,
            "list_levels": thesis.timetable.levels,
            "shorter_levels": first.timetable.levels,
            "shorter_ms": round(first.timetable.levels * TASK_TIME, 3),
            "bound_levels": first.lower_bound,
            "bound_ms": round(first.lower_bound * TASK_TIME, 3),
            "by_rule_levels": ruled.timetable.levels,
            "by_rule_ms": round(ruled.timetable.levels * TASK_TIME, 3),
        }
        rows.append(
            Row(
                f"p = {p}",
                {"ms": ms},
                ours,
                judged(abs(found["ms"] - ms) < 0.01),
                _reason(ours),
                tuple(
                    {"what": who, "ms": times[p]} for who, times in TIMES_OTHERS.items() if p in times
                ),
            )
        )  # fmt: skip
    return Table(
        "4.8",
        "processing time of the Stanford arm on p processors",
        (
            Column("printed ms", "printed", "ms"),
            Column("levels", "ours", "levels"),
            Column("ms", "ours", "ms"),
            Column("critical path first", "ours", "shorter_levels"),
            Column("ms", "ours", "shorter_ms"),
            Column("none below", "ours", "bound_ms"),
            Column("154 tasks", "ours", "by_rule_ms"),
        ),
        tuple(rows),
        (
            f"{TIMES_STANFORD[1]} ms for {LEVELS_STANFORD[1]} tasks are {TASK_TIME:.3f} ms a task, "
            f"{1000 * TASK_TIME / 3:.0f} us an operation; ours are the levels printed in Tables C.9 to "
            f"C.15 times "
            "that, agreement to the printed second digit, rounded or cut off. Critical path first: our "
            "schedule of the "
            "same 156 tasks; none below: what no schedule of them can beat (window bounds); 154 tasks: "
            "those that the "
            "thesis's own rules leave, critical path first.",
        ),
    )


def _reason(ours: Mapping[str, Any]) -> str:
    less = ours["levels"] - ours["shorter_levels"]
    if less > 0:
        return f"{less} level{'s' if less > 1 else ''} fewer critical path first"
    if less < 0:
        return (
            "the printed schedule is a level shorter than critical path first, and not valid as printed "
            "(robodyn schedule --thesis C.11); robodyn schedule stanford --as-printed --method optimal "
            "finds one "
            "as short that is"
        )
    return "critical path first takes as many levels"
