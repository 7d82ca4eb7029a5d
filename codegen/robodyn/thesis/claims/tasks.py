"""The tasks of chapter 4: how many, what they cost, what waits for what."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final

from robodyn.counts.general import Tally
from robodyn.schedule import (
    FLOPS_PER_TASK,
    TASKS,
    TaskGraph,
    critical_path_order,
    general_graph,
    list_schedule,
)
from robodyn.schedule.elimination import robot_graph
from robodyn.schedule.graph import link_and_number, task_id
from robodyn.schedule.task_counts import operations_of_tasks
from robodyn.thesis.claims.arms import LINKS, STANFORD, Arms
from robodyn.thesis.claims.claim import Outcome
from robodyn.thesis.judge import printed_schedule
from robodyn.thesis.printed_schedules import TEXTS
from robodyn.thesis.printed_tasks import TABLE_4_2, TABLE_4_4
from robodyn.thesis.rival_tasks import UNIT_MS, rival_graph
from robodyn.thesis.tables.table_4_2 import idle_tasks
from robodyn.thesis.tables.table_4_5 import flops, flops_without

SIZES: Final = range(2, 10)
#: Processors of the thesis's layered graph of six joints, and tasks at once of the Stanford arm's.
MOST: Final = 13
MOST_STANFORD: Final = 9
#: A link amid an arm, so that nothing is spared.
_LINK: Final = 3


def parallel_cost(arms: Arms) -> Outcome:
    """The longest chain of tasks for 2 to 9 joints."""
    layers = {n: general_graph(n).critical_path for n in SIZES}
    chain = arms.six.critical_path
    figures = {
        "layers": chain,
        "flops": FLOPS_PER_TASK * chain,
        "load": FLOPS_PER_TASK * len(arms.six),
        "layers_by_n": {str(n): k for n, k in layers.items()},
    }
    return figures, chain == 27 and all(FLOPS_PER_TASK * k == 12 * n + 9 for n, k in layers.items())


def layers(arms: Arms) -> Outcome:
    """Layers of the forward and of the backward pass, and the forward ones that Table 4.3 prints."""
    forward = {n: _last_forward_layer(general_graph(n)) for n in SIZES}
    whole = {n: general_graph(n).critical_path for n in SIZES}
    figures = {"forward": forward[LINKS], "backward": whole[LINKS] - forward[LINKS], "layers": whole[LINKS]}
    return figures, all(forward[n] == 2 * n + 2 and whole[n] - forward[n] == 2 * n + 1 for n in SIZES)


def _is_forward(task: int) -> bool:
    return TASKS[link_and_number(task)[1] - 1].forward


def _last_forward_layer(graph: TaskGraph) -> int:
    return max(k for k, layer in enumerate(graph.layers(), 1) if any(map(_is_forward, layer)))


def load(arms: Arms) -> Outcome:
    """Tasks and operations of any six joints on one processor."""
    figures = {
        "subtasks": len(arms.six),
        "flops": FLOPS_PER_TASK * len(arms.six),
        "printed_in_table_4_3": printed_schedule("4.3").entries,
    }
    holds = all(len(general_graph(n)) == 43 * n - 27 for n in SIZES)
    return figures, holds and (figures["subtasks"], figures["flops"]) == (231, 693)


def stanford_load(arms: Arms) -> Outcome:
    """Tasks and operations of the Stanford arm by the printed zeros and by the robot's."""
    robot = arms.load_robot(STANFORD)
    by_printed_zeros = robot_graph(robot, TABLE_4_4, "own")
    figures = {
        "subtasks": len(by_printed_zeros),
        "flops": FLOPS_PER_TASK * len(by_printed_zeros),
        "subtasks_by_the_robots_zeros": len(robot_graph(robot, step_3="own")),
        "subtasks_step_3_corrected": len(arms.stanford_by_robot),
        "printed_in_table_4_7": len(arms.stanford_printed),
    }
    return figures, (figures["subtasks"], figures["flops"]) == (156, 468)


def reduction(arms: Arms) -> Outcome:
    """The share of tasks that the Stanford arm is spared [%], held to "about 25 %"."""
    figures = {
        "percent": _spared(arms, arms.stanford_printed),
        "percent_by_rule": _spared(arms, arms.stanford_by_rule),
        "percent_by_the_robots_zeros": _spared(arms, arms.stanford_by_robot),
    }
    return figures, abs(figures["percent"] - 25) < 1


def reduction_over_a_quarter(arms: Arms) -> Outcome:
    """The same, held to "over 25 %"."""
    figures, _ = reduction(arms)
    return figures, figures["percent"] > 25


def _spared(arms: Arms, graph: TaskGraph) -> float:
    return round(100 * (1 - len(graph) / len(arms.six)), 1)


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
    figures = {
        "coarse": round(rivals.work * UNIT_MS / _rival_chain_ms(rivals), 2),
        "work_ms": round(rivals.work * UNIT_MS, 2),
        "chain_ms": round(_rival_chain_ms(rivals), 2),
        "stanford": round(len(arms.stanford_printed) / arms.stanford_printed.critical_path, 2),
        "six": round(len(arms.six) / arms.six.critical_path, 2),
    }
    return figures, figures["coarse"] < figures["stanford"]


def _rival_chain_ms(graph: TaskGraph) -> float:
    """The longest chain in time, which no number of processors beats."""
    from robodyn.schedule import lower_bound

    return lower_bound(graph, len(graph)) * UNIT_MS


def operations_of_equations(_: Arms) -> Outcome:
    """Operations of Table 4.1's tasks by equation; the addition of T3 belongs to the first one."""
    operations = operations_of_tasks(_LINK + 1)
    by_step: dict[str, int] = {}
    for task in TASKS:
        kinds = operations[task_id(_LINK, task.row)]
        if task.step == "1, 2":
            by_step["1"] = by_step.get("1", 0) + kinds["add"]
            by_step["2"] = by_step.get("2", 0) + kinds["mul"]
        else:
            by_step[task.step] = by_step.get(task.step, 0) + sum(kinds.values())
    most = max(by_step.values())
    return {"by_equation": list(by_step.values()), "most": most}, most == 24


def _turned_components(turn: str, ca: int, sa: int) -> list[int]:
    """Operations of the components of R v or R^T v where cos and sin of alpha are as said."""
    costs = []
    for axis in range(3):
        ledger: dict[str, int] = {}
        c, s = Tally(ledger), Tally(ledger)
        v = Tally(ledger), Tally(ledger), Tally(ledger)
        R = ((c, -s, 0), (s * ca, c * ca, -sa), (s * sa, c * sa, ca))
        ledger.clear()
        rows: Any = R if turn == "R" else tuple(zip(*R, strict=True))
        total: Any = 0
        for entry, x in zip(rows[axis], v, strict=True):
            total = total + entry * x
        costs.append(sum(kind for name, kind in ledger.items() if name in ("mul", "add")))
    return costs


def turned_vectors(_: Arms) -> Outcome:
    """Operations of a turned vector, component by component, axes parallel and at right angles."""
    figures = {
        "parallel": _turned_components("R^T", 1, 0),
        "right": _turned_components("R^T", 0, 1),
        "right_R": _turned_components("R", 0, 1),
    }
    return figures, all(sorted(costs) == [0, 3, 3] for costs in figures.values())


def free_component(_: Arms) -> Outcome:
    """Which component of R^T v is free where the axes are at right angles."""
    costs = _turned_components("R^T", 0, 1)
    return {"free": "xyz"[costs.index(0)], "of_R": "xyz"[_turned_components("R", 0, 1).index(0)]}, costs[
        1
    ] == 0


def tasks_of_a_link(_: Arms) -> Outcome:
    """Tasks of a link, those of three operations, and those of each pass."""
    operations = operations_of_tasks(_LINK + 1)
    full = [sum(operations[task_id(_LINK, task.row)].values()) == FLOPS_PER_TASK for task in TASKS]
    forward = sum(task.forward for task in TASKS)
    figures = {"tasks": len(TASKS), "full": sum(full), "forward": forward, "backward": len(TASKS) - forward}
    return figures, (len(TASKS), sum(full), forward) == (43, 43, 25)


def pass_of_steps_5_and_6(_: Arms) -> Outcome:
    """The pass to which Table 4.1 counts steps 5 and 6, which chapter 2 has in the forward one."""
    passes = sorted({"forward" if task.forward else "backward" for task in TASKS if task.step in ("5", "6")})
    return {"passes": ", ".join(passes)}, passes == ["forward"]


def forward_first(arms: Arms) -> Outcome:
    """Schedules of appendix C that begin the backward pass before the forward one is done, and levels if that
    were not allowed."""
    early = []
    for name in TEXTS:
        if name.startswith("C."):
            levels = [
                [task for task in level if 1 <= link_and_number(task)[1] <= len(TASKS)]  # misprints aside
                for level in printed_schedule(name).levels
            ]
            back = min(k for k, level in enumerate(levels) if not all(map(_is_forward, level)))
            last = max(k for k, level in enumerate(levels) if any(map(_is_forward, level)))
            early += [name] if back < last else []
    graph = arms.six
    forward = frozenset(filter(_is_forward, graph.tasks))
    after = {task: needed if task in forward else needed | forward for task, needed in graph.after.items()}
    barred = replace(graph, after=after)
    processors = (3, 4, 6, 7, 9, 10)
    figures = {
        "early": [name for name in early if name != "C.1"],
        "early_as_printed": sum("restored" not in name for name in early),
        "levels": [list_schedule(graph, p, critical_path_order(graph)).levels for p in processors],
        "levels_barred": [list_schedule(barred, p, critical_path_order(barred)).levels for p in processors],
    }
    return figures, not early


def spared_tasks(_: Arms) -> Outcome:
    """Tasks that do no arithmetic at a prismatic joint, the first link and the last."""
    totals = {name: len(tasks) for name, tasks in idle_tasks().items()}
    return totals, all(totals[name] == total for name, (_, total) in TABLE_4_2.items())


def layers_of_table_4_3(_: Arms) -> Outcome:
    """Tasks in the first, the last and the widest levels of Table 4.3."""
    sizes = [len(level) for level in printed_schedule("4.3").levels]
    widest = [k for k, size in enumerate(sizes, 1) if size == max(sizes)]
    figures = {
        "levels": len(sizes),
        "first": sizes[0],
        "last": sizes[-1],
        "most": max(sizes),
        "widest": widest,
    }
    return figures, (sizes[0], sizes[-1], widest) == (6, 3, [5, 7, 9])


def concurrency_of_stanford(_: Arms) -> Outcome:
    """The widest levels of Table 4.7."""
    sizes = [len(level) for level in printed_schedule("4.7").levels]
    figures = {"stanford": max(sizes), "levels": [k for k, size in enumerate(sizes, 1) if size == max(sizes)]}
    return figures, max(sizes) == MOST_STANFORD


def zeros_of_p(_: Arms) -> Outcome:
    """Tasks of step 3 that one, two and three zeros spare."""
    step = tuple(range(12, 18))
    spared = [(flops_without(step) - flops(step, zeros)) // FLOPS_PER_TASK for zeros in (1, 2, 3)]
    return {"spared": spared}, spared == [2, 4, 6]


def levels_are_no_operations(arms: Arms) -> Outcome:
    """Levels and operations of the longest chain."""
    levels = arms.six.critical_path
    return {"levels": levels, "operations": FLOPS_PER_TASK * levels}, FLOPS_PER_TASK * levels == 4 * LINKS + 3
