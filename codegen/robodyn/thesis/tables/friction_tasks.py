"""Friction as tasks of three operations (section 4.5): what it does to tasks, layers and schedules.

The thesis counts friction in operations (24 a joint) and prints no tasks of it. Here are tasks, cut by us, of
any six joints and of the case study's arm, scheduled on 2 to 13 processors, beside the same without friction.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any, Final

from robodyn.schedule import FLOPS_PER_TASK, Machine, TaskGraph, general_graph, robot_graph, solve
from robodyn.schedule.friction_tasks import Friction, friction_tasks
from robodyn.thesis.case_arm import robots
from robodyn.thesis.tables.table import Column, Progress, Row, Table, judged

PROCESSORS: Final = range(2, 14)
#: Operations that the thesis says friction adds to a joint, with and without that of the joint itself.
PRINTED_FLOPS: Final = {"both": 24, "transmission": 4}
#: Span of the case study's bearings [m], which makes no difference to its tasks.
_SPAN: Final = 0.2
#: Nodes of a search, so that the table is the same on every machine.
_NODES: Final = 20_000

_KINDS: Final[Mapping[str, Friction | None]] = {
    "no friction": None,
    "joint": Friction("journal"),
    "transmission": Friction(None, "linear"),
    "both": Friction("journal", "linear"),
}


def table(progress: Progress = lambda _: None) -> Table:
    """Tasks of a joint, then arms with and without friction."""
    rows = [_joint(kind, flops) for kind, flops in PRINTED_FLOPS.items()]
    plain: TaskGraph | None = None
    for kind, friction in _KINDS.items():
        progress(f"six joints, {kind}")
        graph = general_graph(6, friction)
        plain = plain or graph
        rows.append(_arm(f"six joints, {kind}", graph, plain))
    arms = robots(0.0, _SPAN)
    rigid = robot_graph(arms.rigid)
    for name, robot in (
        ("no friction", arms.rigid), ("joint", arms.with_bearings), ("both", arms.complete)
    ):  # fmt: skip
        progress(f"case study, {name}")
        rows.append(_arm(f"case study, {name}", robot_graph(robot), rigid))
    return Table(
        "friction",
        "friction as tasks of three operations (section 4.5)",
        (
            Column("printed", "printed", "flops"),
            Column("tasks", "ours", "tasks"),
            Column("chain", "ours", "critical_path"),
            Column("S_p at 6", "ours", "speedup_6"),
            Column("for 2 to 13 processors", "ours", "levels_spelled", below=True),
        ),
        tuple(rows),
        (
            "A joint's friction follows the last tasks of its link, and no link waits for it: whatever the "
            "number of joints, it makes the longest chain longer by the same few levels, while its tasks run "
            "beside those of other links. Friction of the first joint puts T26 back, the force of the first "
            "link, which Table 4.2 leaves out. Journals and an efficiency on a straight line; the case "
            "study's transmissions have a cubic. Schedules by df-ihs, each judged by the validator.",
        ),
    )


def _joint(kind: str, printed: int) -> Row:
    friction = _KINDS[kind]
    assert friction is not None
    tasks = len(friction_tasks(friction))
    filled = -(-printed // FLOPS_PER_TASK)
    return Row(
        f"tasks a joint, {kind}",
        {"flops": f"{printed} operations", "tasks": filled},
        {"tasks": tasks},
        judged(tasks == filled),
        f"{printed} operations fill {filled} tasks of {FLOPS_PER_TASK}; ours are cut at what waits for what, "
        "with 0.5 d and mu r/d formed beforehand",
    )


def _arm(name: str, graph: TaskGraph, plain: TaskGraph) -> Row:
    solved = {p: solve(graph, Machine(p), "df-ihs", seconds=1e6, nodes=_NODES) for p in PROCESSORS}
    unproven = [p for p, one in solved.items() if not one.optimal]
    levels = {p: one.timetable.levels for p, one in solved.items()}
    own: dict[str, Any] = {
        "tasks": len(graph),
        "critical_path": graph.critical_path,
        "levels": {str(p): count for p, count in levels.items()},
        "bounds": {str(p): one.lower_bound for p, one in solved.items()},
        "speedup_6": round(float(Fraction(len(graph), levels[6])), 3),
        "levels_spelled": " ".join(str(count) for count in levels.values()) + " levels",
    }
    more = (len(graph) - len(plain), graph.critical_path - plain.critical_path)
    reason = (
        f"{more[0]} tasks and {more[1]} levels of the chain more than without friction; " if any(more) else ""
    )
    reason += (
        f"{len(solved) - len(unproven)} of {len(solved)} schedules proven to be the shortest"
        if unproven
        else "every schedule is proven to be the shortest"
    )
    return Row(name, {}, own, None, reason)
