"""Tables 4.3, 4.7 and C.1 to C.15: the printed schedules, judged, beside ours."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import Any, Final

from robodyn.errors import InputError
from robodyn.schedule import Machine, solve
from robodyn.schedule.validate import Fault
from robodyn.thesis.judge import Judgement, judge, printed_graph, printed_schedule, rule_graph
from robodyn.thesis.printed_schedules import TEXTS
from robodyn.thesis.tables.table import Column, Row, Table, Verdict, judged

#: The tables that can be asked for, Table 4.8 last.
SCHEDULES: Final = tuple(TEXTS)
THESIS: Final = (*SCHEDULES, "4.8")
_ARMS: Final = {"six-link": "any six-joint arm", "stanford": "Stanford arm"}


def table() -> Table:
    """All of them, one a row."""
    rows = []
    for name in SCHEDULES:
        judgement = judge(printed_schedule(name))
        printed, ours = _figures(judgement)
        rows.append(
            Row(name, printed, ours, _verdict(judgement), "; ".join(words(judgement)) or "no fault found")
        )
    return Table(
        "schedules",
        "the printed schedules, Tables 4.3, 4.7 and C.1 to C.15",
        (
            Column("p", "printed", "processors"),
            Column("levels", "printed", "levels"),
            Column("entries", "printed", "entries"),
            Column("tasks", "printed", "distinct"),
            Column("by rule", "ours", "tasks"),
            Column("list", "ours", "thesis"),
            Column("critical path", "ours", "critical_path_first"),
            Column("none below", "ours", "lower_bound"),
        ),
        tuple(rows),
        _NOTES,
    )


_NOTES: Final = (
    "Every printed schedule is read and judged by robodyn.schedule.validate: against the tasks that the "
    "rules of "
    "Tables 4.2, 4.4 and 4.5 leave (missing, not in the set, done twice), and against what each printed "
    "task reads, "
    "tasks that are not printed passing their inputs through; a sum of products waits for those of its "
    "own component. "
    "List, critical path: our schedules of the tasks by rule (six joints) and of the printed 156 "
    "(Stanford); none "
    "below: what no schedule of them can beat.",
    "All printed tables put T10 of link 1 beside some of T20 to T22 (110 beside 120, 121, 122), which "
    "read it: that "
    "slip is told apart.",
)


def one_table(name: str) -> Table:
    """One printed schedule in full, ``"4.8"`` too.

    Raises
    ------
    InputError: there is no such table.
    """
    if name == "4.8":
        from robodyn.thesis.tables.table_4_8 import table as table_4_8

        return table_4_8()
    try:
        judgement = judge(printed_schedule(name))
    except InputError:
        raise InputError(
            f"no printed schedule {name!r}", expected=f"one of {', '.join(THESIS)}, or all"
        ) from None
    printed, ours = _figures(judgement)
    kinds = {
        "missing": "not printed, though the rules keep it",
        "unknown": "printed, though the rules eliminate it",
        "twice": "printed twice",
        "crowded": "more tasks than processors",
    }
    rows = [
        _compared("levels", printed["levels"], ours["thesis"], _longer(ours)),
        _compared("tasks", printed["distinct"], ours["tasks"], ""),
    ]
    for kind, meaning in kinds.items():
        faults = judgement.of(kind)
        if faults:
            tasks = [fault.task for fault in faults]
            rows.append(Row(kind, {"figure": len(tasks), "tasks": tasks}, {"figure": 0}, "differs", meaning))
    for one in judgement.misprints:
        rows.append(
            Row(
                f"{one.printed} in level {one.level}",
                {"figure": one.printed},
                {"figure": one.meant},
                "differs",
                "probably a misprint: the task that is missing fits here, a digit apart",
            )
        )
    for (task, level), group in groupby(
        judgement.of("precedence"), key=lambda fault: (fault.task, fault.level)
    ):
        others = [fault.other for fault in group]
        rows.append(
            Row(
                f"{task} in level {level}",
                {"figure": level, "tasks": others},
                {"figure": None},
                "differs",
                "beside or before the tasks that it reads",
            )
        )
    if judgement.shared:
        rows.append(
            Row(
                "the shared slip",
                {"figure": len(judgement.shared), "tasks": [fault.task for fault in judgement.shared]},
                {"figure": 0},
                "differs",
                "beside 110, which they read, as in all tables",
            )
        )
    return Table(
        name,
        f"schedule of {_ARMS[judgement.printed.arm]} on {printed['processors']} processors, as printed",
        (
            Column("printed", "printed", "figure"),
            Column("ours", "ours", "figure"),
            Column("tasks", "printed", "tasks", below=True),
        ),
        tuple(rows),
        _NOTES[:1],
    )


#: Violations that are told one by one in a line.
_MOST: Final = 12


def words(judgement: Judgement) -> list[str]:
    """The faults of a printed schedule, the shared slip left out, a few words each."""
    sentences = []
    for kind, verb in (
        ("missing", "missing"),
        ("unknown", "not by rule"),
        ("twice", "twice"),
        ("crowded", "crowded"),
    ):
        tasks = [fault.task for fault in judgement.of(kind)]
        if tasks:
            sentences.append(f"{verb}: {_spelled(tasks)}")
    if judgement.misprints:
        sentences.append("probably misprinted: " + ", ".join(map(str, judgement.misprints)))
    order = [
        f"{fault.other} before {fault.task} (level {fault.level})" for fault in judgement.of("precedence")
    ]
    if order:
        sentences.append(
            "not kept: " + ", ".join(order[:12]) + (f" and {len(order) - 12} more" if order[12:] else "")
        )
    return sentences


def _spelled(tasks: Sequence[int]) -> str:
    return " ".join(map(str, sorted(tasks)))


def _figures(judgement: Judgement) -> tuple[dict[str, Any], dict[str, Any]]:
    printed = judgement.printed
    graph = printed_graph(printed.arm)
    machine = Machine(printed.processors)
    thesis, first = solve(graph, machine, "thesis"), solve(graph, machine, "critical-path")
    return (
        {
            "processors": printed.processors,
            "levels": len(printed.levels),
            "entries": printed.entries,
            "distinct": len(printed.tasks),
        },
        {
            "tasks": len(rule_graph(printed.arm)),
            "scheduled": len(graph),
            "thesis": thesis.timetable.levels,
            "critical_path_first": first.timetable.levels,
            "lower_bound": first.lower_bound,
            "faults": [_fault(fault) for fault in judgement.faults],
            "shared": [_fault(fault) for fault in judgement.shared],
            "misprints": [
                {"printed": one.printed, "meant": one.meant, "level": one.level}
                for one in judgement.misprints
            ],
        },
    )


def _fault(fault: Fault) -> dict[str, Any]:
    data: dict[str, Any] = {"kind": fault.kind, "task": fault.task, "level": fault.level}
    return data if fault.other is None else {**data, "needs": fault.other}


def _verdict(judgement: Judgement) -> Verdict:
    return judged(not judgement.faults)


def _compared(what: str, printed: int, ours: int, reason: str) -> Row:
    return Row(what, {"figure": printed}, {"figure": ours}, judged(printed == ours), reason)


def _longer(ours: dict[str, Any]) -> str:
    return (
        f"by section 4.3.3, every predecessor respected; critical path first takes "
        f"{ours['critical_path_first']}, "
        f"and nothing less than {ours['lower_bound']}"
    )
