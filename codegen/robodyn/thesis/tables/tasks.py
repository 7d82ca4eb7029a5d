"""Tables 4.1, 4.2, 4.4, 4.5 and 4.6: the tasks of a link, and which of them an arm does not need."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import groupby
from typing import Any, Final

from robodyn.schedule.arithmetic import flops_of_tasks, operations_of_tasks
from robodyn.schedule.elimination import FIRST_LINK, LAST_LINK, Sparsity, left_out, sparse_tasks, sparsity
from robodyn.schedule.graph import link_and_number, task_id
from robodyn.schedule.tasks import FLOPS_PER_TASK, TASKS, Task
from robodyn.thesis.printed import (
    TABLE_4_1_MISPRINTS,
    TABLE_4_2,
    TABLE_4_4,
    TABLE_4_4_ZEROS,
    TABLE_4_5,
    TABLE_4_6,
    bundled,
)
from robodyn.thesis.tables.table import Row, verdict_of, words_of

#: A link amid an arm, so that nothing is spared.
LINK: Final = 3

# --- 4.1 --------------------------------------------------------------------------------------------------


def table_4_1() -> Iterator[Row]:
    """Each task as we schedule it, beside what is printed of it where that is something else."""
    operations = operations_of_tasks(LINK + 1)
    for task in TASKS:
        ours = {
            "step": task.step,
            "pass": "forward" if task.forward else "backward",
            "layer": task.layer,
            "operations": sum(operations[task_id(LINK, task.row)].values()),
            "does": task.does,
            "after": predecessors(task) or "nothing",
        }
        slip = TABLE_4_1_MISPRINTS.get(task.row)
        if slip is None:
            same = {"what": "the same", "spelled": None}
            yield Row(f"T{task.row}", same, ours, "reproduced", "as printed, in our words")
        else:
            printed = {"what": slip.what, slip.what: slip.printed, "spelled": f"{slip.what}: {slip.printed}"}
            yield Row(f"T{task.row}", printed, ours, "differs", f"misprinted: {slip.why}")


def predecessors(task: Task) -> str:
    """What a task waits for, ranges put together: ``T9 to T11 before, T12``."""
    spelled = []
    for place, pairs in groupby(task.after, key=lambda pair: pair[0]):
        for _, run in groupby(enumerate(row for _, row in pairs), key=lambda pair: pair[1] - pair[0]):
            rows = [row for _, row in run]
            text = f"T{rows[0]}" if len(rows) == 1 else f"T{rows[0]} to T{rows[-1]}"
            spelled.append(text + {-1: " before", 0: "", 1: " beyond"}[place])
    return ", ".join(spelled)


# --- 4.2 --------------------------------------------------------------------------------------------------

_JOINTS: Final = 5


def idle_tasks() -> dict[str, frozenset[int]]:
    """The tasks that do no arithmetic, by the table's rows: carried out on an arm of which nothing else is
    special, of five joints, the third of which slides or not."""
    general, sliding = (
        {link_and_number(task): cost for task, cost in flops_of_tasks(_JOINTS, prismatic).items()}
        for prismatic in ((), (LINK,))
    )
    return {
        name: frozenset(task_number for (at, task_number), cost in flops.items() if at == link and not cost)
        for name, flops, link in (
            ("prismatic_joint", sliding, LINK), ("first_link", general, 1), ("last_link", general, _JOINTS)
        )
    }  # fmt: skip


def table_4_2() -> tuple[Iterator[Row], dict[str, int]]:
    """Printed lists beside the tasks that turn out to do nothing; how many of a link between are full."""
    middle = [flops for task, flops in flops_of_tasks(_JOINTS).items() if link_and_number(task)[0] == LINK]
    figures = {"full": sum(flops == FLOPS_PER_TASK for flops in middle), "tasks": len(middle)}
    return _idle_rows(), figures


def _idle_rows() -> Iterator[Row]:
    idle, reasons = idle_tasks(), words_of("4.2")["reasons"]
    for name, (printed, total) in TABLE_4_2.items():
        ours = idle[name]
        reason = "the same tasks do no arithmetic: no force and no moment come from beyond"
        if ours != printed:
            lists = (("idle besides", ours - printed), ("not idle", printed - ours))
            words = (f"{what}: {' '.join(map(str, sorted(tasks)))}" for what, tasks in lists if tasks)
            reason = f"{'; '.join(words)}. {reasons.get(name, 'Not explained')}"
        yield Row(
            name,
            {"tasks": sorted(printed), "total": total},
            {"tasks": sorted(ours), "total": len(ours)},
            verdict_of(ours == printed and len(printed) == total),
            reason,
        )


# --- 4.4 --------------------------------------------------------------------------------------------------


def table_4_4() -> Iterator[Row]:
    """Printed components beside those of the bundled robot."""
    sparse = sparsity(bundled("stanford"))
    for link, (printed, ours) in enumerate(zip(_vectors(TABLE_4_4), _vectors(sparse), strict=False), 1):
        wrong = [name for name in ("s", "p") if printed[name] != ours[name]]
        reason = "the robot's numbers say the same"
        if wrong:
            reason = "; ".join(
                f"{name}_{link} is {' '.join(ours[name]) or 'zero'} by the robot's numbers, printed "
                f"{' '.join(printed[name]) or 'zero'}"
                for name in wrong
            )
        if (link, wrong, ours["s"]) == (5, ["s"], ["y"]):
            reason += ": the thesis's own Table 2.7 has z = 0 there"
        yield Row(f"link {link}", printed, ours, verdict_of(not wrong), reason)
    zeros, of = TABLE_4_4_ZEROS
    ours_zeros = {"zeros": sparse.zeros, "of": 6 * len(sparse.s)}
    reason = "the printed lists have as many" if TABLE_4_4.zeros == zeros else "not what the lists add up to"
    if sparse.zeros != zeros:
        more = "more" if sparse.zeros > zeros else "fewer"
        reason += f"; ours has {abs(sparse.zeros - zeros)} {more}, of the rows that differ"
    same = ours_zeros == {"zeros": zeros, "of": of}
    yield Row("zeros", {"zeros": zeros, "of": of}, ours_zeros, verdict_of(same), reason)


def _vectors(pattern: Sparsity) -> list[dict[str, list[str]]]:
    return [{"s": list(s), "p": list(p)} for s, p in zip(pattern.s, pattern.p, strict=True)]


# --- 4.5 --------------------------------------------------------------------------------------------------


def flops(tasks: tuple[int, ...], zeros: int) -> int:
    """The operations of a link's ``tasks`` where both its vectors have so many zeros."""
    axes, link = "xyz"[zeros:], LINK + 1  # of which the link before has a full lambda, too
    by_task = flops_of_tasks(link + 1, s=axes, p=axes)
    return sum(by_task[task_id(link, task_number)] for task_number in tasks)


def table_4_5() -> Iterator[Row]:
    """Printed tasks beside as many as the remaining operations fill."""
    for rule in TABLE_4_5:
        for zeros, printed in enumerate(rule.executed, 1):
            needed = flops(rule.tasks, zeros)
            ours = -(-needed // FLOPS_PER_TASK)
            same = len(printed) == ours and left_out(rule.tasks, zeros) + printed == rule.tasks
            reason = "no operation is left"
            if needed:
                reason = f"the operations left fill {ours} task{'s' if ours > 1 else ''} of {FLOPS_PER_TASK}"
                spare = FLOPS_PER_TASK * ours - needed
                reason += f" with {spare} to spare" if spare else ""
            yield Row(
                f"step {rule.step}, {rule.what}, {zeros} zero{'s' if zeros > 1 else ''}",
                {"executed": list(printed), "tasks": len(printed)},
                {"tasks": ours, "flops": needed, "of": flops(rule.tasks, 0)},
                verdict_of(same),
                reason,
            )


# --- 4.6 --------------------------------------------------------------------------------------------------


def table_4_6() -> Iterator[Row]:
    """Printed lists beside those that the rule of Table 4.5 gives for the bundled robot."""
    pattern = sparsity(bundled("stanford"))
    totals = []
    for link, (s_zeros, p_zeros, numbers, total) in enumerate(TABLE_4_6, 1):
        by_rule, physical = sparse_tasks(pattern, link, "own"), sparse_tasks(pattern, link, "before")
        ours = {
            "s_zeros": 3 - len(pattern.s[link - 1]),
            "p_zeros": 3 - len(pattern.p[link - 1]),
            "tasks": [task_id(link, task) for task in sorted(by_rule)],
            "total": len(by_rule),
        }
        tasks = [task_id(link, task) for task in sorted(numbers)]
        printed = {"s_zeros": s_zeros, "p_zeros": p_zeros, "tasks": tasks, "total": total}
        beside: tuple[Mapping[str, Any], ...] = ()
        if physical != by_rule:
            tasks = [task_id(link, task) for task in sorted(physical)]
            beside = ({"what": "step 3 by p of the link before", "total": len(tasks), "tasks": tasks},)
        reason = _difference(link, printed, ours)
        yield Row(f"link {link}", printed, ours, verdict_of(printed == ours), reason, beside)
        totals.append((total, len(numbers), len(by_rule)))
    printed_sum, listed, our_sum = map(sum, zip(*totals, strict=True))
    both = len(FIRST_LINK & set(TABLE_4_6[0][2])) + len(LAST_LINK & set(TABLE_4_6[-1][2]))
    yield Row(
        "sum",
        {"total": printed_sum},
        {"total": our_sum},
        verdict_of(our_sum == printed_sum),
        f"not printed as such: the printed totals add up to {printed_sum}, from which 156 tasks follow as "
        f"231 - 9 - ({printed_sum} - {both}); the printed lists have {listed}, and ours "
        f"{our_sum}",
    )


def _difference(link: int, printed: Mapping[str, Any], ours: Mapping[str, Any]) -> str:
    if printed == ours:
        return "the rule gives the same tasks for the robot's zeros"
    listed = printed["tasks"]
    words = []
    if len(listed) != printed["total"]:
        words.append(f"the printed list has {len(listed)} tasks and not {printed['total']}")
    words += [
        f"{name}_{link} has {ours[f'{name}_zeros']} zeros in the robot and not {printed[f'{name}_zeros']}"
        for name in "sp"
        if printed[f"{name}_zeros"] != ours[f"{name}_zeros"]
    ]
    if listed == ours["tasks"]:
        words.append("the tasks themselves are those of the rule")
    return "; ".join(words) or "not explained"
