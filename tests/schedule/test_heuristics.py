"""List schedules: levels that the thesis and its review have, and rules that a schedule must keep."""

from __future__ import annotations

import pytest

from robodyn import InputError
from robodyn.schedule import Schedule, TaskGraph, critical_path_order, general_graph, list_schedule
from robodyn.thesis.judge import printed_graph

SIX = general_graph(6)
STANFORD = printed_graph("stanford")

#: Levels at 2, 3, ... processors.
THESIS_ORDER = [116, 77, 58, 47, 39, 34, 32, 31, 30, 29, 28, 27]
CRITICAL_PATH_FIRST = [116, 77, 58, 47, 39, 34, 30, 28, 27, 27, 27, 27]
STANFORD_THESIS_ORDER = [79, 52, 40, 32, 28, 27, 26, 25]
STANFORD_CRITICAL_PATH_FIRST = [78, 52, 40, 32, 27, 25, 25, 25]


def faults(graph: TaskGraph, schedule: Schedule) -> list[str]:
    """What is wrong with a schedule, found without the scheduler's own code."""
    found = []
    level = {}
    for k, slot in enumerate(schedule.slots):
        if len(slot) > schedule.processors:
            found.append(f"level {k}: {len(slot)} tasks")
        for task in slot:
            if task in level:
                found.append(f"{task} twice")
            level[task] = k
    found += [f"{task} missing" for task in graph.tasks if task not in level]
    found += [f"{task} unknown" for task in level if task not in graph.after]
    for task, needed in graph.after.items():
        both = [other for other in needed if task in level and other in level]
        found += [f"{task} not after {other}" for other in both if level[other] >= level[task]]
    return found


@pytest.mark.parametrize("p", range(1, 14))
def test_six_joints(p: int) -> None:
    plain, first = list_schedule(SIX, p), list_schedule(SIX, p, critical_path_order(SIX))
    assert faults(SIX, plain) == faults(SIX, first) == []
    assert plain.levels == ([231, *THESIS_ORDER])[p - 1]
    assert first.levels == ([231, *CRITICAL_PATH_FIRST])[p - 1]
    assert plain.speedup == 231 / plain.levels
    assert plain.efficiency == pytest.approx(231 / plain.levels / p)


@pytest.mark.parametrize("p", range(2, 10))
def test_the_stanford_arm_as_printed(p: int) -> None:
    plain, first = list_schedule(STANFORD, p), list_schedule(STANFORD, p, critical_path_order(STANFORD))
    assert faults(STANFORD, plain) == faults(STANFORD, first) == []
    assert plain.levels == STANFORD_THESIS_ORDER[p - 2]
    assert first.levels == STANFORD_CRITICAL_PATH_FIRST[p - 2]


def test_no_schedule_is_shorter_than_the_longest_chain() -> None:
    assert list_schedule(SIX, 1000).levels == SIX.critical_path == 27


def test_faults_are_found() -> None:
    whole = list_schedule(SIX, 3)
    assert faults(SIX, Schedule(2, whole.slots))
    assert faults(SIX, Schedule(3, whole.slots[::-1]))
    assert "143 missing" in faults(general_graph(6), Schedule(3, (*whole.slots[:-1], (141, 142))))


def test_few_processors_and_few_tasks() -> None:
    with pytest.raises(InputError, match="needs a processor"):
        list_schedule(SIX, 0)
    nothing = list_schedule(TaskGraph({}, {}), 2)
    assert (nothing.levels, nothing.speedup) == (0, 1.0)
