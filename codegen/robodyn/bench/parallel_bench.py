"""When threads lose to serial code on this machine, and from what size of task they would win.

Everything is measured in one run: the serial kernel, the same bits on p threads by the best schedule, and
the packed form. The cost of a barrier is measured by a kernel without arithmetic: the same schedule of empty
tasks. From these follows how long a task would have to be for threads to break even:

    serial(s) = s W t,   parallel(s) = s C t + S,   s* = S / ((W - C) t)

with W operations in all, C of them on the critical path of the schedule, t the time of one, S the time of
waiting, all tasks being s times as long.
"""

from __future__ import annotations

import itertools
import os
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final, get_args

from robodyn.emit.parallel import schedule_files
from robodyn.errors import CheckError
from robodyn.ir.signature import Signature
from robodyn.robot.model import Robot
from robodyn.schedule import Machine, Timetable, solve
from robodyn.schedule.cutting import COSTS, Cut
from robodyn.schedule.lanes import Waiting, lanes
from robodyn.toolchain.compiler import find_c
from robodyn.toolchain.program import THREADED_FLAGS, cores, run_program

#: Operations a task for which the speed-up is predicted.
SIZES: Final = (3, 30, 300, 3_000, 30_000, 300_000)

#: States of a measurement, and of one whose threads outnumber the cores: there a wait may take milliseconds.
STATES, CROWDED = 20_000, 500
#: States that the packed form computes at once.
_LANES: Final = 4


@dataclass(frozen=True, slots=True)
class Measured:
    """A kernel on ``processors`` threads: nanoseconds a call, and what the schedule asks for."""

    processors: int
    waiting: Waiting
    levels: int
    meetings: int
    serial_ns: float
    parallel_ns: float
    operations: int
    chain: int
    tasks: int

    @property
    def operation_ns(self) -> float:
        """The serial kernel's time an operation, its share of sines and cosines included."""
        return self.serial_ns / self.operations

    @property
    def waiting_ns(self) -> float:
        """What a parallel call takes beyond its longest lane: starting, meeting, passing values."""
        return max(0.0, self.parallel_ns - self.chain * self.operation_ns)

    @property
    def break_even(self) -> float | None:
        """How many times as long tasks would have to be for threads to take no longer; None: never."""
        gain = (self.operations - self.chain) * self.operation_ns
        return self.waiting_ns / gain if gain > 0 else None

    @property
    def wins(self) -> bool:
        """Whether several threads take less time than the serial kernel."""
        return self.processors > 1 and self.parallel_ns < self.serial_ns

    def speedup_at(self, size: int) -> float:
        """The speed-up to be expected of the same schedule, were its tasks ``size`` operations long."""
        longer = size * self.tasks / self.operations
        parallel = longer * self.chain * self.operation_ns + self.waiting_ns
        return longer * self.operations * self.operation_ns / parallel

    @property
    def break_even_sizes(self) -> dict[str, float] | None:
        """The operations of each task and of all tasks at :attr:`break_even`."""
        if self.break_even is None:
            return None
        whole = self.break_even * self.operations
        return {"operations_a_task": whole / self.tasks, "operations_in_all": whole}

    def to_dict(self) -> dict[str, Any]:
        """As ``bench --json`` prints it."""
        return {
            "processors": self.processors,
            "sync": self.waiting,
            **{key: getattr(self, key) for key in ("levels", "meetings", "parallel_ns", "waiting_ns")},
            "ns_a_meeting": self.waiting_ns / self.meetings if self.meetings else None,
            "wins": self.wins,
            "speedup": self.serial_ns / self.parallel_ns,
            "schedule_speedup": self.operations / self.chain,
            "speedup_at": {str(size): self.speedup_at(size) for size in SIZES},
            "break_even": self.break_even_sizes,
        }


@dataclass(frozen=True, slots=True)
class Bench:
    """All of it, on this machine; ``load``: how many processes want a core, on average over a minute."""

    robot: str
    function: str
    cores: int
    compiler: str
    packed_lanes: int
    packed_ns: float
    load: float | None
    rows: tuple[Measured, ...]

    @property
    def serial_ns(self) -> float:
        """The serial kernel's best time."""
        return min(row.serial_ns for row in self.rows)

    def to_dict(self) -> dict[str, Any]:
        """As ``bench --json`` prints it."""
        packed = {"lanes": self.packed_lanes, "ns": self.packed_ns, "wins": self.packed_ns < self.serial_ns}
        return {
            **{key: getattr(self, key) for key in ("robot", "function", "cores", "compiler")},
            "operations": self.rows[0].operations,
            "serial_ns": self.serial_ns,
            "packed": packed,
            "threads": [row.to_dict() for row in self.rows],
        }


def bench(
    robot: Robot,
    signature: Signature,
    cut: Cut,
    processors: Sequence[int],
    *,
    states: int | None = None,
    tell: Callable[[str], None] = lambda _: None,
) -> Bench:
    """Measure the kernel of ``cut`` on so many ``processors``, with barriers and with counters.

    Raises
    ------
    ToolError: no compiler, or no threads.
    CheckError: bits differ.
    """
    rows, packed = [], []
    for p, waiting in itertools.product(processors, get_args(Waiting)):
        tell(f"{p} threads, {waiting}")
        table = solve(cut.graph, Machine(p), "critical-path").timetable
        files = schedule_files(robot, signature, cut, table, waiting=waiting, vector=_LANES)
        is_crowded = p > cores()
        flags = (*THREADED_FLAGS, *([f"-D{signature.robot}_spins=1u"] if is_crowded else []))
        code, output = run_program(files, [str(states or (CROWDED if is_crowded else STATES))], flags=flags)
        times = {name: float(value) for name, value in re.findall(r"(\w+) ([\d.]+)", output)}
        if code != 0 or times.get("differing") != 0:
            raise CheckError(
                f"{p} threads do not give the serial kernel's bits",
                found=output.strip() or f"exit code {code}",
            )
        packed.append(times["packed_ns"])
        rows.append(_measured(cut, table, waiting, times))
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else None
    compiler, function = find_c(None).version, signature.function
    return Bench(robot.name, function, cores(), compiler, _LANES, min(packed), load, tuple(rows))


def _measured(cut: Cut, table: Timetable, waiting: Waiting, times: dict[str, float]) -> Measured:
    plan = lanes(cut, table, waiting)
    price = [COSTS[operation.op] for operation in cut.program.operations]
    weight = {task: sum(price[i] for i in own) for task, own in cut.operations().items()}
    return Measured(
        table.machine.processors,
        waiting,
        table.levels,
        len(plan.barriers) or sum(len(step.waits) for lane in plan.steps for step in lane),
        times["serial_ns"],
        times["parallel_ns"],
        sum(price),
        sum(max(weight[task] for task in row if task is not None) for row in table.slots),
        len(cut.graph),
    )
