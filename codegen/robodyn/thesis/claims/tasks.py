"""The tasks of chapter 4: how many, what they cost, what waits for what."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from robodyn.counts.general import Tally
from robodyn.schedule import (
    FLOPS_PER_TASK,
    TASKS,
    TaskGraph,
    critical_path_order,
    general_graph,
    list_schedule,
    lower_bound,
)
from robodyn.schedule.arithmetic import operations_of_tasks
from robodyn.schedule.elimination import robot_graph
from robodyn.schedule.graph import link_and_number, task_id
from robodyn.thesis.claims import LINKS, STANFORD, Arms, Outcome
from robodyn.thesis.judge import SCHEDULES, UNIT_MS, printed_schedule, rival_graph
from robodyn.thesis.printed import TABLE_4_2, TABLE_4_4, bundled
from robodyn.thesis.slips.frames import component_cost
from robodyn.thesis.tables.tasks import LINK, flops, idle_tasks

SIZES: Final = range(2, 10)
#: Processors of the thesis's layered graph of six joints, and tasks at once of the Stanford arm's.
MOST: Final = 13
MOST_STANFORD: Final = 9


def parallel_cost(arms: Arms) -> Outcome:
    """The longest chain of tasks for 2 to 9 joints."""
    chain = arms.six.critical_path
    figures = {"layers": chain, "flops": FLOPS_PER_TASK * chain, "load": FLOPS_PER_TASK * len(arms.six)}
    linear = all(FLOPS_PER_TASK * general_graph(n).critical_path == 12 * n + 9 for n in SIZES)
    return figures, chain == 27 and linear


def layers(_: Arms) -> Outcome:
    """Layers of the forward and of the backward pass."""
    passes = {n: _passes(general_graph(n)) for n in SIZES}
    forward, backward = passes[LINKS]
    figures = {"forward": forward, "backward": backward, "layers": forward + backward}
    return figures, all(found == (2 * n + 2, 2 * n + 1) for n, found in passes.items())


def _is_forward(task: int) -> bool:
    return TASKS[link_and_number(task)[1] - 1].forward


def _passes(graph: TaskGraph) -> tuple[int, int]:
    """Layers up to the last one that has a task of the forward pass, and those beyond."""
    forward = max(k for k, layer in enumerate(graph.layers(), 1) if any(map(_is_forward, layer)))
    return forward, graph.critical_path - forward


def load(arms: Arms) -> Outcome:
    """Tasks and operations of any six joints on one processor."""
    tasks, flops_of_all = len(arms.six), FLOPS_PER_TASK * len(arms.six)
    entries = printed_schedule("4.3").entries
    figures = {"subtasks": tasks, "flops": flops_of_all, "printed_in_table_4_3": entries}
    holds = all(len(general_graph(n)) == 43 * n - 27 for n in SIZES)
    return figures, holds and (tasks, flops_of_all) == (231, 693)


def stanford_load(arms: Arms) -> Outcome:
    """Tasks and operations of the Stanford arm by the printed zeros and by the robot's."""
    robot = bundled(STANFORD)
    tasks = len(robot_graph(robot, TABLE_4_4, "own"))
    figures = {
        "subtasks": tasks,
        "flops": FLOPS_PER_TASK * tasks,
        "subtasks_by_the_robots_zeros": len(robot_graph(robot, step_3="own")),
        "subtasks_step_3_corrected": len(arms.stanford_by_robot),
        "printed_in_table_4_7": len(arms.stanford_printed),
    }
    return figures, (tasks, FLOPS_PER_TASK * tasks) == (156, 468)


def reduction(arms: Arms) -> Outcome:
    """The share of tasks that the Stanford arm is spared [%], held to "about 25 %"."""
    percent, by_robot = (
        round(100 * (1 - len(graph) / len(arms.six)), 1)
        for graph in (arms.stanford_printed, arms.stanford_by_robot)
    )
    return {"percent": percent, "percent_by_the_robots_zeros": by_robot}, abs(percent - 25) < 1


def reduction_over_a_quarter(arms: Arms) -> Outcome:
    """The same, held to "over 25 %"."""
    figures, _ = reduction(arms)
    return figures, figures["percent"] > 25


def equations_as_tasks(_: Arms) -> Outcome:
    """Tasks of the public set that gives Kasahara and Narita's column of Table 4.8."""
    graph = rival_graph()
    figures = {
        "nine_a_link": 9 * LINKS,
        "tasks": len(graph),
        "edges": sum(map(len, graph.after.values())),
        "shortest_us": round(1e3 * UNIT_MS * min(graph.lengths.values())),
        "longest_ms": round(UNIT_MS * max(graph.lengths.values()), 2),
    }
    return figures, figures["tasks"] == figures["nine_a_link"]


def finer_cut(arms: Arms) -> Outcome:
    """Most speed-up, all work over the longest chain, of coarse and of fine tasks."""
    rivals = rival_graph()
    work, chain = rivals.work * UNIT_MS, lower_bound(rivals, len(rivals)) * UNIT_MS
    figures = {"coarse": round(work / chain, 2), "work_ms": round(work, 2), "chain_ms": round(chain, 2)}
    for name, graph in (("stanford", arms.stanford_printed), ("six", arms.six)):
        figures[name] = round(len(graph) / graph.critical_path, 2)
    return figures, figures["coarse"] < figures["stanford"]


def operations_of_equations(_: Arms) -> Outcome:
    """Operations of Table 4.1's tasks by equation; the addition of T3 belongs to the first one."""
    operations = operations_of_tasks(LINK + 1)
    by_step: dict[str, int] = {}
    for task in TASKS:
        kinds = operations[task_id(LINK, task.row)]
        shares = {task.step: sum(kinds.values())}
        if task.step == "1, 2":
            shares = {"1": kinds["add"], "2": kinds["mul"]}
        for step, share in shares.items():
            by_step[step] = by_step.get(step, 0) + share
    most = max(by_step.values())
    return {"by_equation": list(by_step.values()), "most": most}, most == 24


def _turned_components(ca: int, sa: int, *, back: bool = True) -> list[int]:
    """Operations of the components of R^T v, or of R v, where cos and sin of alpha are as said."""
    ledger: dict[str, int] = {}
    c, s = Tally(ledger), Tally(ledger)
    R = ((c, -s, 0), (s * ca, c * ca, -sa), (s * sa, c * sa, ca))
    return [component_cost(row, ledger) for row in (zip(*R, strict=True) if back else R)]


def turned_vectors(_: Arms) -> Outcome:
    """Operations of a turned vector, component by component, axes parallel and at right angles."""
    figures = {"parallel": _turned_components(1, 0), "right": _turned_components(0, 1)}
    every = (*figures.values(), _turned_components(0, 1, back=False))
    return figures, all(sorted(costs) == [0, 3, 3] for costs in every)


def free_component(_: Arms) -> Outcome:
    """Which component of R^T v is free where the axes are at right angles."""
    free, of_R = ("xyz"[_turned_components(0, 1, back=back).index(0)] for back in (True, False))
    return {"free": free, "of_R": of_R}, free == "y"


def tasks_of_a_link(_: Arms) -> Outcome:
    """Tasks of a link, those of three operations, and those of each pass."""
    operations = operations_of_tasks(LINK + 1)
    full = sum(sum(operations[task_id(LINK, task.row)].values()) == FLOPS_PER_TASK for task in TASKS)
    forward = sum(task.forward for task in TASKS)
    figures = {"tasks": len(TASKS), "full": full, "forward": forward, "backward": len(TASKS) - forward}
    return figures, (len(TASKS), full, forward) == (43, 43, 25)


def pass_of_steps_5_and_6(_: Arms) -> Outcome:
    """The pass to which Table 4.1 counts steps 5 and 6, which chapter 2 has in the forward one."""
    passes = sorted({"forward" if task.forward else "backward" for task in TASKS if task.step in ("5", "6")})
    return {"passes": ", ".join(passes)}, passes == ["forward"]


def forward_first(arms: Arms) -> Outcome:
    """How many schedules of appendix C begin the backward pass before the forward one is done, and levels if
    that were not allowed."""
    early = 0
    for name in SCHEDULES:
        if name.startswith("C.") and "restored" not in name:
            levels = [
                [_is_forward(task) for task in level if 1 <= link_and_number(task)[1] <= len(TASKS)]
                for level in printed_schedule(name).levels  # misprints aside
            ]
            back = min(k for k, level in enumerate(levels) if not all(level))
            early += back < max(k for k, level in enumerate(levels) if any(level))
    graph = arms.six
    forward = frozenset(filter(_is_forward, graph.tasks))
    after = {task: needed if task in forward else needed | forward for task, needed in graph.after.items()}
    ours, barred = (
        [list_schedule(one, p, critical_path_order(one)).levels for p in (3, 4, 6, 7, 9, 10)]
        for one in (graph, replace(graph, after=after))
    )
    return {"early_as_printed": early, "levels": ours, "levels_barred": barred}, not early


def spared_tasks(_: Arms) -> Outcome:
    """Tasks that do no arithmetic at a prismatic joint, the first link and the last."""
    totals = {name: len(tasks) for name, tasks in idle_tasks().items()}
    return totals, all(totals[name] == total for name, (_, total) in TABLE_4_2.items())


def _widest(table: str) -> tuple[list[int], list[int]]:
    """Tasks in the levels of a printed schedule, and which levels have most."""
    sizes = [len(level) for level in printed_schedule(table).levels]
    return sizes, [k for k, size in enumerate(sizes, 1) if size == max(sizes)]


def layers_of_table_4_3(_: Arms) -> Outcome:
    """Tasks in the first, the last and the widest levels of Table 4.3."""
    sizes, widest = _widest("4.3")
    ends = {"levels": len(sizes), "first": sizes[0], "last": sizes[-1]}
    holds = (sizes[0], sizes[-1], widest) == (6, 3, [5, 7, 9])
    return {**ends, "most": max(sizes), "widest": widest}, holds


def concurrency_of_stanford(_: Arms) -> Outcome:
    """The widest levels of Table 4.7."""
    sizes, widest = _widest("4.7")
    return {"stanford": max(sizes), "levels": widest}, max(sizes) == MOST_STANFORD


def zeros_of_p(_: Arms) -> Outcome:
    """Tasks of step 3 that one, two and three zeros spare."""
    step = tuple(range(12, 18))
    spared = [(flops(step, 0) - flops(step, zeros)) // FLOPS_PER_TASK for zeros in (1, 2, 3)]
    return {"spared": spared}, spared == [2, 4, 6]


def levels_are_no_operations(arms: Arms) -> Outcome:
    """Levels and operations of the longest chain."""
    levels = arms.six.critical_path
    return {"levels": levels, "operations": FLOPS_PER_TASK * levels}, FLOPS_PER_TASK * levels == 4 * LINKS + 3
