"""The printed schedules are read, and the validator finds in them what a review by hand found."""

from __future__ import annotations

import pytest

from robodyn import InputError
from robodyn.schedule import Machine, general_graph, solve
from robodyn.thesis.judge import (
    SCHEDULES,
    PrintedSchedule,
    judge,
    printed_graph,
    printed_schedule,
    rival_graph,
    rule_graph,
)
from robodyn.thesis.printed import TIMES_OTHERS
from robodyn.thesis.tables import to_text
from robodyn.thesis.tables.schedules import THESIS, one_table
from robodyn_testing import representative
from thesis.recomputed import table as recomputed

#: Table: processors, levels, entries, distinct tasks, as counted on paper.
SIZES = {
    "4.3": (13, 27, 240, 240), "4.7": (9, 27, 156, 156), "C.1": (2, 116, 231, 214),
    "C.1 restored": (2, 116, 231, 230), "C.2": (3, 78, 232, 230), "C.3": (4, 58, 230, 230),
    "C.4": (5, 47, 230, 230), "C.5": (6, 39, 230, 230), "C.6": (7, 34, 231, 229), "C.7": (8, 31, 236, 230),
    "C.8": (9, 30, 232, 232), "C.9": (2, 79, 156, 156), "C.10": (3, 52, 156, 156),
    "C.11": (4, 39, 155, 155), "C.12": (5, 32, 156, 155), "C.13": (6, 29, 156, 156),
    "C.14": (7, 27, 156, 156), "C.15": (8, 27, 156, 156),
}  # fmt: skip

#: Table: pairs (task, what it needs and does not come after), beside the slip that all tables share.
NOT_KEPT = {
    "C.4": {(203, 202), (401, 303), (501, 403), (601, 503)},
    "C.5": {(401, 303)},
    "C.6": {(126, 123), (126, 124), (126, 125)},
    "C.7": {(306, 305), (418, 417), (419, 417)},
    "C.8": {(320, 311), (321, 311)},
    "C.11": {(401, 303), (402, 303)},
    "C.12": {(401, 303), (526, 523)},
}
TWICE = {
    "C.1 restored": {226}, "C.2": {526, 527}, "C.6": {336, 529}, "C.12": {428},
    "C.7": {126, 129, 226, 227, 228, 229},
}  # fmt: skip
#: Tasks of the rules that are not printed; all tables but Table 4.3 and C.8 lack 119 and 128.
MISSING = {
    "4.3": {119}, "C.8": {119}, "C.6": {119, 128, 329}, "C.11": {119, 128, 132}, "C.12": {119, 128, 429},
    "C.15": {119, 128, 243},
}  # fmt: skip


@pytest.mark.parametrize("table", SIZES)
def test_the_validator_finds_what_the_review_found(table: str) -> None:
    printed = printed_schedule(table)
    size = (printed.processors, len(printed.levels), printed.entries, len(printed.tasks))
    assert size == SIZES[table]
    if table == "C.1":  # see the copied column
        return
    found = judge(printed)
    assert {(fault.task, fault.other) for fault in found.of("precedence")} == NOT_KEPT.get(table, set())
    assert {fault.task for fault in found.of("twice")} == TWICE.get(table, set())
    six = {119, 128} if printed.arm == "six-link" else {119, 128, 129}
    assert {fault.task for fault in found.of("missing")} == MISSING.get(table, six)
    assert found.of("crowded") == ()
    assert {fault.task for fault in found.shared} <= {120, 121, 122}
    assert found.shared


def test_the_copied_column_of_c_1() -> None:
    found = judge(printed_schedule("C.1"))
    assert len(found.of("twice")) == 17
    assert {fault.level for fault in found.of("precedence")} <= set(range(1, 20))
    restored = judge(printed_schedule("C.1 restored"))
    assert {fault.task for fault in restored.of("twice")} == {226}


def test_tasks_that_are_none_by_rule_are_told() -> None:
    assert set(SIZES) == set(SCHEDULES)
    unknown = {
        name: {fault.task for fault in judge(printed_schedule(name)).of("unknown")}
        for name in ("C.15", "4.3", "4.7")
    }
    assert 245 in unknown["C.15"]
    assert unknown["4.3"] == {126, 127, *range(630, 636), 639, 640}
    assert unknown["4.7"] == {120, 121, 126, 127, 233}


def test_single_digits_are_guessed_where_nothing_else_would_do() -> None:
    found = {name: [str(one) for one in judge(printed_schedule(name)).misprints] for name in SIZES}
    assert {name: told for name, told in found.items() if told} == {
        "C.6": ["529 for 329 (level 20)"],
        "C.12": ["428 for 429 (level 19)"],
        "C.15": ["245 for 243 (level 25)"],
    }
    assert "529 in level 20" in {row.name for row in one_table("C.6").rows}


def test_a_schedule_of_ours_is_without_fault_and_a_spoilt_one_is_not() -> None:
    made = solve(general_graph(6), Machine(5)).timetable
    slots = tuple(tuple(task for task in row if task is not None) for row in made.slots)
    assert judge(PrintedSchedule("ours", "six-link", 5, slots)).faults == ()
    spoilt = (slots[1], slots[0], *slots[2:])
    assert judge(PrintedSchedule("ours", "six-link", 5, spoilt)).of("precedence")


def test_tasks_by_rule_and_as_printed() -> None:
    assert (len(rule_graph("six-link")), rule_graph("six-link").critical_path) == (231, 27)
    assert (len(rule_graph("stanford")), rule_graph("stanford").critical_path) == (154, 25)
    assert (len(printed_graph("stanford")), printed_graph("stanford").critical_path) == (156, 25)


@pytest.mark.thorough
def test_table_4_8_from_levels() -> None:
    rows = [row for row in recomputed("4.8").rows if "," not in row.name]
    assert [row.ours["ms"] for row in rows] == [21.06, 10.665, 7.02, 5.265, 4.32, 3.915, 3.645, 3.645]
    assert [row.printed["ms"] for row in rows] == [21.06, 10.67, 7.02, 5.26, 4.32, 3.92, 3.65, 3.65]
    assert {row.verdict for row in rows} == {"reproduced"}
    shorter = {row.name: row.ours["shorter_ms"] for row in rows if row.ours["shorter_ms"] < row.ours["ms"]}
    assert shorter == {"p = 2": 10.53, "p = 6": 3.645, "p = 7": 3.375, "p = 8": 3.375}


def test_the_tasks_of_the_other_columns() -> None:
    """88 tasks, 131 edges, 24.83 ms of work and a longest chain of 5.69 ms, as the set's own file says."""
    graph = rival_graph()
    assert (len(graph), sum(map(len, graph.after.values()))) == (88, 131)
    assert (graph.work, graph.critical_time) == (2483, 569)


@pytest.mark.thorough
def test_the_other_columns_of_table_4_8() -> None:
    """Recomputed on their tasks; p = 7 is printed shorter than the longest chain; Luh and Lin's is quoted."""
    found = {row.name: row for row in recomputed("4.8").rows if "," in row.name}
    assert len(found) == sum(map(len, TIMES_OTHERS.values()))
    kasahara = {p: found[f"p = {p}, Kasahara"] for p in range(1, 8)}
    assert [p for p, row in kasahara.items() if row.verdict == "reproduced"] == [1, 2, 3]
    assert [kasahara[p].ours["ms"] for p in (2, 3, 5, 6, 7)] == [12.42, 8.43, 5.69, 5.69, 5.69]
    assert "less than any schedule" in kasahara[7].reason
    assert "gave up" in kasahara[4].reason
    assert kasahara[4].ours["bound_ms"] < kasahara[4].printed["ms"] <= kasahara[4].ours["ms"]
    chen = {p: found[f"p = {p}, Chen"] for p in range(1, 7)}
    assert [chen[p].ours["ms"] for p in (2, 3, 5, 6)] == [12.42, 8.43, 5.69, 5.69]
    assert found["p = 6, Luh"].verdict == "not recoverable"
    assert "quoted" in found["p = 6, Luh"].reason


@pytest.mark.parametrize("table", representative(THESIS, "C.4", "4.7", rest="slow"))
def test_each_table_alone(table: str) -> None:
    found = one_table(table)
    assert found.id == table
    assert to_text(found)
    if table != "4.8":
        printed = SIZES[table]
        assert [found.row(name).printed["figure"] for name in ("levels", "tasks")] == [printed[1], printed[3]]
    if table == "C.4":
        violations = {"203 in level 2", "401 in level 6", "501 in level 11", "601 in level 16"}
        assert violations <= {row.name for row in found.rows}


@pytest.mark.parametrize("name", ["C.16", ""])
def test_an_unknown_table(name: str) -> None:
    with pytest.raises(InputError, match="no printed schedule"):
        one_table(name)
