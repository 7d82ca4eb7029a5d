"""Schedules on p processors: Table 4.8, how long the Stanford arm's inverse dynamics takes, and friction as
tasks of three operations (section 4.5).

The thesis counts friction in operations (24 a joint) and prints no tasks of it. Here are tasks, cut by us, of
any six joints and of the case study's arm, scheduled on 2 to 13 processors, beside the same without friction.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any, Final

from robodyn.schedule import (
    FLOPS_PER_TASK,
    Machine,
    TaskGraph,
    general_graph,
    lower_bound,
    robot_graph,
    solve,
)
from robodyn.schedule.friction_tasks import Friction, friction_tasks
from robodyn.schedule.methods import Method
from robodyn.thesis.case_arm import robots
from robodyn.thesis.judge import UNIT_MS, printed_graph, rival_graph, rule_graph
from robodyn.thesis.printed import LEVELS_STANFORD, TASK_MS, TIMES_OTHERS, TIMES_STANFORD
from robodyn.thesis.tables.table import Row, verdict_of, words_of

#: Whose column is recomputed, and by which method; the others are quoted.
_RIVALS: Final[dict[str, Method]] = {"Kasahara and Narita 1985": "df-ihs", "Chen, Lee and Hou 1988": "a-star"}
#: Nodes of a search, so that the tables are the same on every machine.
_NODES: Final = 20_000

# --- 4.8 --------------------------------------------------------------------------------------------------


def table_4_8() -> Iterator[Row]:
    """Printed times beside the printed levels times a task's time, and beside shorter schedules."""
    printed, by_rule = printed_graph("stanford"), rule_graph("stanford")
    for p, ms in TIMES_STANFORD.items():
        first, ruled = (solve(graph, Machine(p), "critical-path") for graph in (printed, by_rule))
        levels = {
            "": LEVELS_STANFORD[p],
            "shorter_": first.timetable.levels,
            "bound_": first.lower_bound,
            "by_rule_": ruled.timetable.levels,
        }
        ours: dict[str, Any] = {}
        for name, count in levels.items():
            ours |= {f"{name}levels": count, f"{name}ms": round(count * TASK_MS, 3)}
            if not name:
                ours["list_levels"] = solve(printed, Machine(p), "thesis").timetable.levels
        less = levels[""] - levels["shorter_"]
        kind = "fewer" if less > 0 else "more" if less else "as many"
        reason = words_of("4.8")["reasons"][kind].format(less=f"{less} level{'s' if less > 1 else ''}")
        others = tuple({"what": who, "ms": times[p]} for who, times in TIMES_OTHERS.items() if p in times)
        yield Row(f"p = {p}", {"ms": ms}, ours, verdict_of(abs(ours["ms"] - ms) < 0.01), reason, others)
    yield from _rivals()


@functools.cache  # seconds, and always the same
def _rivals() -> tuple[Row, ...]:
    return tuple(_rival(who, p, ms) for who, times in TIMES_OTHERS.items() for p, ms in times.items())


def _rival(who: str, p: int, ms: float) -> Row:
    """A figure of another column, recomputed on that column's tasks."""
    name = f"p = {p}, {who.partition(' ')[0].strip(',')}"
    graph = rival_graph()
    if who not in _RIVALS and p == 1:
        work, reason = graph.work * UNIT_MS, "all tasks one after another, to the printed digit"
        return Row(name, {"ms": ms}, {"ms": round(work, 2)}, verdict_of(abs(work - ms) < 0.05), reason)
    if who not in _RIVALS:
        bound = round(lower_bound(graph, p) * UNIT_MS, 2)
        reason = "quoted: one processor a joint, and which joint a task belongs to is not known"
        return Row(name, {"ms": ms}, {"bound_ms": bound}, "not recoverable", reason)
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
    return Row(name, {"ms": ms}, {"ms": time, "bound_ms": bound}, verdict_of(time == ms), reason)


# --- friction as tasks ------------------------------------------------------------------------------------

PROCESSORS: Final = range(2, 14)
#: Operations that the thesis says friction adds to a joint, with and without that of the joint itself.
PRINTED_FLOPS: Final = {"both": 24, "transmission": 4}
#: Span of the case study's bearings [m], which makes no difference to its tasks.
_SPAN: Final = 0.2

_KINDS: Final[Mapping[str, Friction | None]] = {
    "no friction": None,
    "joint": Friction("journal"),
    "transmission": Friction(None, "linear"),
    "both": Friction("journal", "linear"),
}


def table_of_friction() -> Iterator[Row]:
    """Tasks of a joint, then arms with and without friction."""
    for kind, flops in PRINTED_FLOPS.items():
        friction = _KINDS[kind]
        assert friction is not None
        tasks, filled = len(friction_tasks(friction)), -(-flops // FLOPS_PER_TASK)
        yield Row(
            f"tasks a joint, {kind}",
            {"flops": f"{flops} operations", "tasks": filled},
            {"tasks": tasks},
            verdict_of(tasks == filled),
            f"{flops} operations fill {filled} tasks of {FLOPS_PER_TASK}; ours are cut at what waits for "
            "what, with 0.5 d and mu r/d formed beforehand",
        )
    plain = general_graph(6)
    for kind, friction in _KINDS.items():
        yield _arm(f"six joints, {kind}", general_graph(6, friction), plain)
    arms = robots(0.0, _SPAN)
    plain = robot_graph(arms.rigid)
    for kind, robot in (("no friction", arms.rigid), ("joint", arms.with_bearings), ("both", arms.complete)):
        yield _arm(f"case study, {kind}", robot_graph(robot), plain)


def _arm(name: str, graph: TaskGraph, plain: TaskGraph) -> Row:
    solved = {p: solve(graph, Machine(p), "df-ihs", seconds=1e6, nodes=_NODES) for p in PROCESSORS}
    levels = {p: one.timetable.levels for p, one in solved.items()}
    ours: dict[str, Any] = {
        "tasks": len(graph),
        "critical_path": graph.critical_path,
        "levels": {str(p): count for p, count in levels.items()},
        "bounds": {str(p): one.lower_bound for p, one in solved.items()},
        "speedup_6": round(float(Fraction(len(graph), levels[6])), 3),
        "levels_spelled": " ".join(map(str, levels.values())) + " levels",
    }
    tasks, chain = len(graph) - len(plain), graph.critical_path - plain.critical_path
    more = f"{tasks} tasks and {chain} levels of the chain more than without friction; "
    proven = sum(one.optimal for one in solved.values())
    shortest = "every schedule is proven to be the shortest"
    if proven < len(solved):
        shortest = f"{proven} of {len(solved)} schedules proven to be the shortest"
    return Row(name, {}, ours, None, (more if tasks or chain else "") + shortest)
