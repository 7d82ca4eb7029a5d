"""The program of a kernel cut into tasks of at most k operations.

Operations that cost nothing (by the thesis's convention a change of sign, a sine and a cosine) belong to the
task that makes their argument; those whose argument is there from the start are done before all tasks.

First trees are cut: a value that is used once stays with its use while the task is no longer than k. Then,
level by level, small tasks of the same link and then of the same level are put together. Both keep the graph
free of circles, the first because nothing lies between a value and its only use, the second because nothing
lies between tasks of the same level.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from graphlib import TopologicalSorter
from typing import Final

from robodyn.errors import InputError
from robodyn.ir.program import ARITY, Program
from robodyn.schedule.graph import TaskGraph, TaskId

#: What operations cost where nothing else is said: the thesis's convention.
COSTS: Final[Mapping[str, int]] = {op: 0 if op in ("neg", "sin", "cos") else 1 for op in ARITY}

#: More than this in a task is no cutting any more.
MOST_OPERATIONS: Final = 100_000


@dataclass(frozen=True, slots=True)
class Cut:
    """A program and its tasks (numbered from 1): ``task_of[i]`` is the task of operation ``i``, 0 for what
    is done before all tasks."""

    program: Program
    graph: TaskGraph
    task_of: tuple[TaskId, ...]

    def operations(self) -> dict[TaskId, list[int]]:
        """The operations of each task in the program's order; those before all tasks under 0."""
        operations: dict[TaskId, list[int]] = {task: [] for task in (0, *self.graph.tasks)}
        for i, task in enumerate(self.task_of):
            operations[task].append(i)
        return operations


def parse_costs(text: str) -> dict[str, int]:
    """``mul=1,div=14`` as costs of operations, over :data:`COSTS`; ``sincos`` stands for both.

    Raises
    ------
    InputError: not of that form, an unknown operation, a negative cost.
    """
    costs = dict(COSTS)
    for part in text.split(","):
        name, sign, value = (piece.strip() for piece in part.partition("="))
        names = ("sin", "cos") if name == "sincos" else (name,)
        if not sign or not value.isdecimal() or len(value) > 6 or any(one not in COSTS for one in names):
            raise InputError(
                "costs of operations cannot be read",
                found=repr(part.strip()),
                expected="OPERATION=N with a whole number, e.g. mul=1,add=1,div=14,sincos=40",
                remedy=f"operations are {', '.join(COSTS)}",
            )
        costs.update(dict.fromkeys(names, int(value)))
    return costs


def cut(program: Program, k: int = 3, costs: Mapping[str, int] | None = None) -> Cut:
    """``program`` in tasks of at most ``k`` operations that cost something; each is as long as its
    operations cost by ``costs``, but where all cost 1 (or nothing) and with ``costs`` None a task is one
    unit long, as the thesis's are.

    Raises
    ------
    InputError: ``k`` is less than one, or ``program`` repeats a step.
    """
    program.straight("tasks are")
    if not 1 <= k <= MOST_OPERATIONS:
        raise InputError("a task has operations", found=f"{k}", expected=f"1 to {MOST_OPERATIONS} of them")
    price = COSTS if costs is None else costs
    groups = _merge_levels(program, price, _trees(program, _homes(program, price), k), k)
    return _finished(program, price, groups, costs is not None)


def _homes(program: Program, price: Mapping[str, int]) -> list[int]:
    """Of each operation the one that it belongs to: itself if it costs something, else the one that makes
    its argument, -1 where nothing that costs something is before it."""
    home: list[int] = []
    for i, operation in enumerate(program.operations):
        if price[operation.op]:
            home.append(i)
            continue
        # A free operation on two values that are not free goes with the later one.
        home.append(max((home[arg] for arg in operation.args if isinstance(arg, int)), default=-1))
    return home


def _trees(program: Program, home: list[int], k: int) -> list[int]:
    """The group of each operation, named by its last member; -1 before all."""
    needs = _between(program, home)
    users: dict[int, set[int]] = {i: set() for i in needs}
    for i, needed in needs.items():
        for other in needed:
            users[other].add(i)
    group = {i: i for i in users}
    size = dict.fromkeys(users, 1)
    if k > 1:
        for i in sorted(users):  # values before their uses: trees grow from the leaves
            for other in sorted(needs[i], key=lambda other: (-size[other], other)):
                alone = users[other] == {i} and group[other] == other
                if alone and size[i] + size[other] <= k:
                    size[i] += size[other]
                    group[other] = i

    def top(i: int) -> int:
        while group[i] != i:
            i = group[i]
        return i

    return [-1 if own < 0 else top(own) for own in home]


def _merge_levels(program: Program, price: Mapping[str, int], groups: list[int], k: int) -> list[int]:
    """Groups of the same level put together, those of the same link first."""
    if k == 1:
        return groups
    size: dict[int, int] = {}
    for i, group in enumerate(groups):
        if group >= 0:
            size[group] = size.get(group, 0) + (price[program.operations[i].op] > 0)
    level = _levels(_between(program, groups))
    links = _links(program, groups)
    merged: dict[int, int] = {}
    filling: dict[int, int] = {}
    for group in sorted(size, key=lambda group: (level[group], links[group], group)):
        target = filling.get(level[group])
        if target is not None and size[target] + size[group] <= k:
            size[target] += size[group]
            merged[group] = target
        else:
            filling[level[group]] = group
    return [merged.get(group, group) for group in groups]


def _between(program: Program, groups: Sequence[int]) -> dict[int, set[int]]:
    """Which groups each group needs."""
    needs: dict[int, set[int]] = {group: set() for group in groups if group >= 0}
    for i, operation in enumerate(program.operations):
        own = groups[i]
        if own >= 0:
            needs[own] |= {groups[arg] for arg in operation.args if isinstance(arg, int)} - {-1, own}
    return needs


def _levels(needs: Mapping[int, set[int]]) -> dict[int, int]:
    level: dict[int, int] = {}
    for group in TopologicalSorter(needs).static_order():
        level[group] = 1 + max((level[other] for other in needs[group]), default=0)
    return level


def _links(program: Program, groups: Sequence[int]) -> dict[int, int]:
    """The link of each group: that of its last labelled operation, else of the group that needs it first."""
    successors: dict[int, int] = {}
    for i, operation in enumerate(program.operations):
        if groups[i] >= 0 and operation.label is not None:
            successors[groups[i]] = operation.label.link
    for i in reversed(range(len(program.operations))):
        if groups[i] in successors:
            for arg in program.operations[i].args:
                if isinstance(arg, int) and groups[arg] >= 0:
                    successors.setdefault(groups[arg], successors[groups[i]])
    return {group: max(1, successors.get(group, 1)) for group in groups if group >= 0}


def _finished(program: Program, price: Mapping[str, int], groups: list[int], priced: bool) -> Cut:
    needs, links = _between(program, groups), _links(program, groups)
    level = _levels(needs)
    order = {group: k for k, group in enumerate(sorted(needs, key=lambda group: (level[group], group)), 1)}
    lengths: dict[TaskId, int] = {}
    if priced:
        lengths = dict.fromkeys(order.values(), 0)
        for i, group in enumerate(groups):
            if group >= 0:
                lengths[order[group]] += price[program.operations[i].op]
    graph = TaskGraph(
        {order[group]: frozenset(order[other] for other in needs[group]) for group in order},
        {order[group]: level[group] for group in order},
        lengths,
        {order[group]: links[group] for group in order},
    )
    return Cut(program, graph, tuple(0 if group < 0 else order[group] for group in groups))
