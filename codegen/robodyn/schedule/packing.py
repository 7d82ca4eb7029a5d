"""A program for one core whose lanes all do the same: independent operations of a kind, together.

That is a schedule on a machine of as many processors as there are lanes, on which all processors of a level
must
do the same kind of operation: list scheduling, the operation with the longest remaining chain first, and as
many of its kind beside it as are ready.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from robodyn.errors import InputError
from robodyn.ir.program import Program

#: Kinds that there are vector operations for, with the same rounding as one by one.
VECTOR: Final = frozenset(("add", "sub", "mul", "div"))
LANES: Final = (2, 4, 8)


@dataclass(frozen=True, slots=True)
class Packing:
    """``groups`` of operations of one kind, in an order in which each uses only what stands before."""

    program: Program
    lanes: int
    groups: tuple[tuple[int, ...], ...]

    @property
    def vectors(self) -> int:
        """Groups that are one vector operation."""
        return sum(len(group) > 1 for group in self.groups)

    @property
    def filling(self) -> float:
        """The share of lanes that vector operations fill."""
        packed = [len(group) for group in self.groups if len(group) > 1]
        return sum(packed) / (self.lanes * len(packed)) if packed else 0.0


def pack(program: Program, lanes: int = 4) -> Packing:
    """``program`` in groups of at most ``lanes`` operations.

    Raises
    ------
    InputError: vectors have 2, 4 or 8 lanes.
    """
    if lanes not in LANES:
        raise InputError("vectors have 2, 4 or 8 lanes", found=f"{lanes}")
    operations = program.operations
    needs = [{arg for arg in operation.args if isinstance(arg, int)} for operation in operations]
    later: list[list[int]] = [[] for _ in operations]
    for i, needed in enumerate(needs):
        for other in needed:
            later[other].append(i)
    tail = [1] * len(operations)
    for i in reversed(range(len(operations))):
        tail[i] = 1 + max((tail[j] for j in later[i]), default=0)
    waiting = [len(needed) for needed in needs]
    ready = [i for i, count in enumerate(waiting) if not count]
    groups: list[tuple[int, ...]] = []
    while ready:
        ready.sort(key=lambda i: (-tail[i], i))
        kind = operations[ready[0]].op
        most = lanes if kind in VECTOR else 1
        group = [i for i in ready if operations[i].op == kind][:most]
        groups.append(tuple(sorted(group)))
        ready = [i for i in ready if i not in group]
        for i in group:
            for follower in later[i]:
                waiting[follower] -= 1
                if not waiting[follower]:
                    ready.append(follower)
    return Packing(program, lanes, tuple(groups))
