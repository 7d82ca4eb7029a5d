"""Parallel C from a schedule: a team of threads, pinned if asked, that spin and never allocate.

Every value is the same operation on the same operands as in the serial kernel, so the bits are the same; only
who computes it is decided by the schedule. A value that another processor reads is written once, into the
team's
memory, and read after a barrier or after its maker's counter has passed it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from robodyn.dynamics.functions import array_named
from robodyn.emit.c_syntax import c_spelling, c_syntax
from robodyn.emit.lines import Writer, head_of
from robodyn.emit.render import environment
from robodyn.emit.results import check_one_result
from robodyn.errors import InputError
from robodyn.ir.program import Program
from robodyn.ir.signature import Signature
from robodyn.robot.model import Robot
from robodyn.schedule.cutting import Cut
from robodyn.schedule.lanes import Lanes, Step, Waiting, lanes
from robodyn.schedule.machine import Timetable

#: Looks at a counter before a thread lets others run; with a core a thread it hardly comes to that.
SPINS = 200


@dataclass(frozen=True, slots=True)
class Parallel:
    """What is emitted: a function of a robot, cut, with its schedule; ``notes`` are lines for the head;
    ``packed``: the check runs the packed form too."""

    robot: Robot
    signature: Signature
    cut: Cut
    timetable: Timetable
    waiting: Waiting = "barrier"
    notes: tuple[str, ...] = ()
    packed: bool = False


def parallel_files(parallel: Parallel) -> dict[str, str]:
    """``NAME_parallel.h``, ``NAME_parallel.c`` and ``NAME_parallel_check.c``: text by file name. The serial
    kernel ``NAME.h`` and ``NAME.c``, which they include, is :func:`robodyn.emit.render`'s.

    Raises
    ------
    InputError: the function remembers between calls, which is not for threads, or has several results.
    """
    signature = parallel.signature
    check_one_result(signature, "in parallel")
    if signature.states:
        raise InputError(
            f"{signature.symbol} remembers between calls, and is not emitted in parallel",
            found=", ".join(signature.states),
            remedy="leave out the effects with memory, or schedule another function",
        )
    plan = lanes(parallel.cut, parallel.timetable, parallel.waiting)
    context = _context(parallel, plan)
    name = signature.robot
    return {
        f"{name}_parallel.h": environment().get_template("c/parallel.h.j2").render(context),
        f"{name}_parallel.c": environment().get_template("c/parallel.c.j2").render(context),
        f"{name}_parallel_check.c": environment().get_template("c/parallel_check.c.j2").render(context),
    }


def _context(parallel: Parallel, plan: Lanes) -> dict[str, Any]:
    signature = parallel.signature
    p = parallel.timetable.machine.processors
    ((output, size),) = signature.outputs
    arrays = [array for array, _ in (*signature.inputs, *signature.outputs)]
    return {
        "name": signature.robot,
        "guard": f"{signature.robot.upper()}_PARALLEL_H",
        "symbol": signature.symbol,
        "function": signature.function,
        "processors": p,
        "inputs": [{"name": array, "size": length} for array, length in signature.inputs],
        "output": output,
        "size": size,
        "arrays": [{"name": array, "what": array_named(array).text} for array in arrays],
        "parameters": signature.parameters,
        "shared": max(1, len(plan.shared)),
        "packed": parallel.packed,
        "barrier": bool(plan.barriers),
        "spins": SPINS,
        "stride": 1 + max(map(len, plan.steps)),
        "lanes": [_lane(parallel, plan, k) for k in range(p)],
        "head": head_of(parallel.robot, _notes(parallel, plan)),
    }


def _notes(parallel: Parallel, plan: Lanes) -> list[str]:
    table = parallel.timetable
    waits = sum(len(step.waits) for lane in plan.steps for step in lane)
    meet = (
        f"{len(plan.barriers)} barriers"
        if parallel.waiting == "barrier"
        else f"{waits} waits for another processor's counter"
    )
    return [
        f"{parallel.signature.function} on {table.machine.processors} processors: {len(parallel.cut.graph)} "
        f"tasks in {table.levels} {'levels' if table.machine.synchronised else 'units of time'}, "
        f"{len(plan.shared)} values "
        f"that pass between processors, {meet}. The bits are those of the serial kernel.",
        *parallel.notes,
    ]


def _lane(parallel: Parallel, plan: Lanes, k: int) -> dict[str, Any]:
    """The function of processor ``k``: its lines, and what it reads."""
    spelling = c_spelling(single=parallel.signature.scalar == "float")
    slot = {i: n for n, i in enumerate(plan.shared)}
    writer = Writer(parallel.cut.program, c_syntax(spelling, f"{parallel.signature.robot}_real"))
    lines: list[str] = []
    barriers = list(plan.barriers)
    level = 0
    for step in plan.steps[k]:
        while barriers and barriers[0] <= step.level:
            lines.append(_meet(parallel.signature.robot, barriers.pop(0)))
        if step.task and step.level != level:
            level = step.level
            kind = "level" if parallel.timetable.machine.synchronised else "time"
            lines.append(f"    /* {kind} {level} */")
        lines += [
            f"    {parallel.signature.robot}_await(&team->done[{j}], base + {n}u);" for j, n in step.waits
        ]
        lines += _step(parallel.cut, step, plan, k, writer, slot)
        if step.publishes:
            done = plan.steps[k].index(step) + 1
            lines.append(
                f"    atomic_store_explicit(&team->done[{k}].value, base + {done}u, memory_order_release);"
            )
    lines += [_meet(parallel.signature.robot, where) for where in barriers]
    written = _results(parallel.cut.program, plan, k, writer)
    lines += written
    text = "\n".join(lines)
    arrays = [array for array, _ in parallel.signature.inputs if any(x.is_of(array) for x in writer.inputs)]
    parameters = any(x.index is None for x in writer.inputs)
    return {
        "number": k,
        "lines": lines,
        "arrays": arrays,
        "parameters": parameters,
        "again": writer.again,
        "base": any(step.waits or step.publishes for step in plan.steps[k]),
        "quiet": not ("team" in text or arrays or parameters or writer.again or written),
        "results": bool(written),
    }


def _meet(name: str, level: int) -> str:
    return f"    {name}_meet(team); /* before level {level} */"


def _step(cut: Cut, step: Step, plan: Lanes, k: int, writer: Writer, slot: dict[int, int]) -> list[str]:
    lines: list[str] = []
    inside = set(step.operations)
    for i in step.operations:
        for arg in cut.program.operations[i].args:
            if isinstance(arg, int) and plan.processor_of[arg] != k and not writer.known(arg):
                lines += writer.bound(arg, f"team->v[{slot[arg]}]")
        lines += writer.written(i, inside, keep=i in slot)
        if i in slot:
            lines.append(f"    team->v[{slot[i]}] = {writer.name(i)};")
    return lines


def _results(program: Program, plan: Lanes, k: int, writer: Writer) -> list[str]:
    """What this processor made of the results; the first one also writes what nobody computes."""
    lines = []
    for _, elements in program.outputs:
        for place, operand in enumerate(elements):
            owner = plan.processor_of[operand] if isinstance(operand, int) else 0
            if owner == k:
                lines += writer.assigned(f"out[{place}]", operand)
    return lines
