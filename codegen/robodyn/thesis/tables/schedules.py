"""Tables 4.3, 4.7 and C.1 to C.15: the printed schedules, judged, beside ours."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Any, Final

from robodyn.errors import InputError
from robodyn.schedule import Machine, solve
from robodyn.schedule.validate import Fault
from robodyn.thesis.judge import SCHEDULES, Judgement, judge, printed_graph, printed_schedule, rule_graph
from robodyn.thesis.tables.table import Row, Table, table_of, verdict_of, words_of

#: The tables that can be asked for, Table 4.8 last.
THESIS: Final = (*SCHEDULES, "4.8")
#: Kinds of faults in a line, and what each means.
_KINDS: Final = {
    "missing": ("missing", "not printed, though the rules keep it"),
    "unknown": ("not by rule", "printed, though the rules eliminate it"),
    "twice": ("twice", "printed twice"),
    "crowded": ("crowded", "more tasks than processors"),
}


def table_of_schedules() -> Iterator[Row]:
    """All of them, one a row."""
    for name in SCHEDULES:
        judgement = judge(printed_schedule(name))
        reason = "; ".join(_words(judgement)) or "no fault found"
        yield Row(name, *_figures(judgement), verdict_of(not judgement.faults), reason)


def one_table(name: str) -> Table:
    """One printed schedule in full, ``"4.8"`` too.

    Raises
    ------
    InputError: there is no such table.
    """
    if name == "4.8":
        from robodyn.thesis.tables.processors import table_4_8

        return table_of(table_4_8(), words_of("4.8"), "4.8")
    try:
        printed = printed_schedule(name)
    except InputError:
        expected = f"one of {', '.join(THESIS)}, or all"
        raise InputError(f"no printed schedule {name!r}", expected=expected) from None
    arm = "any six-joint arm" if printed.arm == "six-link" else "Stanford arm"
    rows = _rows_of_one(judge(printed))
    return table_of(rows, words_of("one schedule"), name, arm=arm, processors=printed.processors)


def _rows_of_one(judgement: Judgement) -> Iterator[Row]:
    printed, ours = _figures(judgement)
    longer = (
        "by section 4.3.3, every predecessor respected; critical path first takes "
        f"{ours['critical_path_first']}, and nothing less than {ours['lower_bound']}"
    )
    for what, figure, our_figure, reason in (
        ("levels", printed["levels"], ours["thesis"], longer),
        ("tasks", printed["distinct"], ours["tasks"], ""),
    ):
        yield Row(what, {"figure": figure}, {"figure": our_figure}, verdict_of(figure == our_figure), reason)
    for kind, (_, meaning) in _KINDS.items():
        tasks = [fault.task for fault in judgement.of(kind)]
        if tasks:
            yield Row(kind, {"figure": len(tasks), "tasks": tasks}, {"figure": 0}, "differs", meaning)
    for one in judgement.misprints:
        yield Row(
            f"{one.printed} in level {one.level}",
            {"figure": one.printed},
            {"figure": one.meant},
            "differs",
            "probably a misprint: the task that is missing fits here, a digit apart",
        )
    order = judgement.of("precedence")
    for (task, level), group in groupby(order, key=lambda fault: (fault.task, fault.level)):
        figures = {"figure": level, "tasks": [fault.other for fault in group]}
        reason = "beside or before the tasks that it reads"
        yield Row(f"{task} in level {level}", figures, {"figure": None}, "differs", reason)
    if judgement.shared:
        tasks = [fault.task for fault in judgement.shared]
        figures = {"figure": len(tasks), "tasks": tasks}
        reason = "beside 110, which they read, as in all tables"
        yield Row("the shared slip", figures, {"figure": 0}, "differs", reason)


#: Violations that are told one by one in a line.
_MOST: Final = 12


def _words(judgement: Judgement) -> Iterator[str]:
    """The faults of a printed schedule, the shared slip left out, a few words each."""
    for kind, (verb, _) in _KINDS.items():
        tasks = sorted(fault.task for fault in judgement.of(kind))
        if tasks:
            yield f"{verb}: {' '.join(map(str, tasks))}"
    if judgement.misprints:
        yield "probably misprinted: " + ", ".join(map(str, judgement.misprints))
    order = judgement.of("precedence")
    if order:
        told = (f"{fault.other} before {fault.task} (level {fault.level})" for fault in order[:_MOST])
        more = f" and {len(order) - _MOST} more" if order[_MOST:] else ""
        yield f"not kept: {', '.join(told)}{more}"


def _figures(judgement: Judgement) -> tuple[dict[str, Any], dict[str, Any]]:
    printed = judgement.printed
    graph, machine = printed_graph(printed.arm), Machine(printed.processors)
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
            "faults": _faults(judgement.faults),
            "shared": _faults(judgement.shared),
            "misprints": [
                {"printed": one.printed, "meant": one.meant, "level": one.level}
                for one in judgement.misprints
            ],
        },
    )


def _faults(faults: Sequence[Fault]) -> list[dict[str, Any]]:
    return [
        {"kind": fault.kind, "task": fault.task, "level": fault.level}
        | ({} if fault.other is None else {"needs": fault.other})
        for fault in faults
    ]
