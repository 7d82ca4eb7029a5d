"""Table 4.8: how long the Stanford arm's inverse dynamics takes on p processors."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from typing import Any, Final

from robodyn.schedule import Machine, lower_bound, solve
from robodyn.schedule.methods import Method
from robodyn.thesis.judge import printed_graph, rule_graph
from robodyn.thesis.printed_tasks import LEVELS_STANFORD, TIMES_OTHERS, TIMES_STANFORD
from robodyn.thesis.rival_tasks import UNIT_MS, rival_graph
from robodyn.thesis.tables.table import Column, Row, Table, judged

#: Milliseconds a task: what one processor takes for all of them, divided by their number.
TASK_TIME: Final = TIMES_STANFORD[1] / LEVELS_STANFORD[1]

#: Whose column is recomputed, and by which method; the others are quoted.
_RIVALS: Final[dict[str, Method]] = {
    "Kasahara and Narita 1985": "df-ihs",
    "Chen, Lee and Hou 1988": "a-star",
}
#: Nodes of a search, so that the table is the same on every machine.
_NODES: Final = 20_000


def table() -> Table:
    """Printed times beside the printed levels times a task's time, and beside shorter schedules."""
    printed, by_rule = printed_graph("stanford"), rule_graph("stanford")
    rows = []
    for p, ms in TIMES_STANFORD.items():
        recomputed = {
            "levels": LEVELS_STANFORD[p],
            "ms": round(LEVELS_STANFORD[p] * TASK_TIME, 3),
        }
        first, ruled = (solve(graph, Machine(p), "critical-path") for graph in (printed, by_rule))
        thesis = solve(printed, Machine(p), "thesis")
        ours: dict[str, Any] = {
            **recomputed,
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
                judged(abs(recomputed["ms"] - ms) < 0.01),
                _reason(ours),
                tuple(
                    {"what": who, "ms": times[p]} for who, times in TIMES_OTHERS.items() if p in times
                ),
            )
        )  # fmt: skip
    rows += _rivals()
    return Table(
        "4.8",
        "processing time of the Stanford arm on p processors",
        (
            Column("printed ms", "printed", "ms"),
            Column("levels", "ours", "levels"),
            Column("ms", "ours", "ms"),
            Column("chain first", "ours", "shorter_levels"),
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
            "The columns of others are of another task set: 88 tasks of 10 us to 1.11 ms (robot.stg of the "
            "Standard Task Graph Set), which begin as soon as they can, without levels. Kasahara and "
            f"Narita's is recomputed by df-ihs, Chen's by a-star, {_NODES} nodes each; none below: window "
            "bounds, or the end of the search.",
        ),
    )


@functools.cache  # seconds, and always the same
def _rivals() -> tuple[Row, ...]:
    return tuple(_rival(who, p, ms) for who, times in TIMES_OTHERS.items() for p, ms in times.items())


def _rival(who: str, p: int, ms: float) -> Row:
    """A figure of another column, recomputed on that column's tasks."""
    name = f"p = {p}, {who.partition(' ')[0].strip(',')}"
    graph = rival_graph()
    if who not in _RIVALS:
        same = p == 1 and abs(graph.work * UNIT_MS - ms) < 0.05
        if p == 1:
            ours = {"ms": round(graph.work * UNIT_MS, 2)}
            return Row(
                name, {"ms": ms}, ours, judged(same), "all tasks one after another, to the printed digit"
            )
        return Row(
            name, {"ms": ms}, {"bound_ms": round(lower_bound(graph, p) * UNIT_MS, 2)}, "not recoverable",
            "quoted: one processor a joint, and which joint a task belongs to is not known",
        )  # fmt: skip
    solved = solve(graph, Machine(p, synchronised=False), _RIVALS[who], seconds=1e6, nodes=_NODES)
    time, bound = (round(units * UNIT_MS, 2) for units in (solved.timetable.span, solved.lower_bound))
    if ms < bound:
        reason = f"printed is less than any schedule of these tasks can take: the longest chain is {bound} ms"
    elif time < ms:
        reason = f"a schedule {round(ms - time, 2)} ms shorter exists"
    elif time > ms:
        reason = f"{round(time - ms, 2)} ms longer, where the search gave up; nothing below {bound} ms"
    else:
        reason = "the same length"
    reason += ", proven to be the shortest" if solved.optimal and ms >= bound else ""
    return Row(name, {"ms": ms}, {"ms": time, "bound_ms": bound}, judged(time == ms), reason)


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
