"""The files of a schedule: the serial kernel, its parallel form, and its packed form, which has the
independent operations of a level as lanes of one core's vectors.

Parallel C is for a team of threads, pinned if asked, that spin and never allocate. A value that another
processor reads is written once, into the team's memory, and read after a barrier or after its maker's counter
has passed it. Vectors are those of gcc and clang (``vector_size``), which every target has, by instructions
or one by one. In both, every value is the same operation on the same operands as in the serial kernel, so the
bits are the same; only who computes it is decided by the schedule.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from robodyn.dynamics.functions import array_named
from robodyn.emit.c_syntax import c_spelling, c_syntax
from robodyn.emit.head import head_of
from robodyn.emit.render import environment, render
from robodyn.emit.spelling import Syntax
from robodyn.emit.statements import Apply, Expression, Statement, inputs_of, unique
from robodyn.emit.unit import Unit
from robodyn.errors import InputError
from robodyn.ir.program import Input, Operand, Program
from robodyn.ir.signature import Signature
from robodyn.robot.model import Robot
from robodyn.schedule.cutting import Cut
from robodyn.schedule.lanes import Lanes, Packing, Step, Waiting, lanes, pack
from robodyn.schedule.machine import Timetable

#: Looks at a counter before a thread lets others run; with a core a thread it hardly comes to that.
SPINS = 200

_SIGNS = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


def schedule_files(
    robot: Robot,
    signature: Signature,
    cut: Cut,
    timetable: Timetable,
    *,
    waiting: Waiting | None = None,
    vector: int | None = None,
) -> dict[str, str]:
    """All files of a schedule of ``cut``: text by file name; with lanes in a ``vector`` the packed form too.

    ``waiting``: barriers where the timetable has levels, counters where it has none, unless told.

    Raises
    ------
    InputError: the function remembers between calls or has several results, or barriers are asked for where
        there are no levels.
    """
    if len(signature.outputs) > 1:
        raise InputError(
            f"{signature.symbol} has several results, and is not emitted in parallel",
            found=", ".join(array for array, _ in signature.outputs),
            expected="a function with one",
        )
    if signature.states:
        raise InputError(
            f"{signature.symbol} remembers between calls, and is not emitted in parallel",
            found=", ".join(signature.states),
            remedy="leave out the effects with memory, or schedule another function",
        )
    ((output, size),) = signature.outputs
    common: dict[str, Any] = {
        "name": signature.robot,
        "symbol": signature.symbol,
        "function": signature.function,
        "inputs": [{"name": array, "size": length} for array, length in signature.inputs],
        "output": output,
        "size": size,
        "parameters": signature.parameters,
        "packed": vector is not None,
    }
    how = waiting or ("barrier" if timetable.machine.synchronised else "counters")
    contexts = {"parallel": _parallel(robot, signature, cut, timetable, how)}
    if vector is not None:
        contexts["packed"] = _packed(robot, signature, pack(cut.program, vector))
    files = render(Unit(robot, ((signature, cut.program),)), ("c",))
    for form, context in contexts.items():
        for part in (f"{form}.h", f"{form}.c", *(["parallel_check.c"] if form == "parallel" else [])):
            template = environment().get_template(f"c/{part}.j2")
            files[f"{signature.robot}_{part}"] = template.render(common, **context)
    return files


class _Writer:
    """Writes operations of ``program`` as statements, one at a time, in whatever order a schedule has, and
    keeps in mind what they are called.

    A value that is used once, by an operation of the same task, is written where it is used. ``inputs`` are
    those that have been read; ``names`` are the expressions of what has been written or bound.
    """

    def __init__(self, program: Program, syntax: Syntax) -> None:
        self.program = program
        self.syntax = syntax
        self.inputs: set[Input] = set()
        self.names: dict[int, Expression] = {}
        self._uses = program.uses()
        self._users: dict[int, set[int]] = {}
        self._taken: set[str] = set()
        #: Values with names: angles, results, and those that C writes twice or chooses without a branch.
        self._whole = {operand for operand in program.results() if isinstance(operand, int)}
        for i, (op, args, _) in enumerate(program.operations):
            for arg in args:
                if isinstance(arg, int):
                    self._users.setdefault(arg, set()).add(i)
                    if op in ("sin", "cos", "sign", "select"):
                        self._whole.add(arg)

    def bound(self, i: int, source: str) -> list[str]:
        """Call the value of operation ``i``, which stands in ``source``, by its name from here on."""
        return self.syntax.line(self.syntax.declare(self._named(i), source))

    def written(self, i: int, inside: Collection[int], *, keep: bool = False) -> list[str]:
        """Operation ``i``: a statement, or none where it is written into its only use, which is in
        ``inside``; ``keep``: it needs a name."""
        op, args, label = self.program.operations[i]
        expression = Apply(op, tuple(self._operand(arg) for arg in args))
        alone = self._uses[i] == 1 and self._users.get(i, set()) <= set(inside) and i not in self._whole
        if alone and not keep and label is None and op not in ("sin", "cos"):
            self.names[i] = expression
            return []
        self.inputs.update(inputs_of(expression))
        return self.syntax.statement(Statement(self._named(i), expression))

    def assigned(self, target: str, operand: Operand) -> list[str]:
        """``target = operand``."""
        return self.syntax.line(self.syntax.assign(target, self.text(operand)))

    def text(self, operand: Operand) -> str:
        """An operand in the language."""
        expression = self._operand(operand)
        self.inputs.update(inputs_of(expression))
        return self.syntax.spelling.text(expression)

    def reads(self, array: str) -> bool:
        """Whether an element of ``array`` has been read, or a run-time parameter (``p``)."""
        return any(x.index is None if array == "p" else x.is_of(array) for x in self.inputs)

    def _operand(self, operand: Operand) -> Expression:
        return self.names[operand] if isinstance(operand, int) else operand

    def _named(self, i: int) -> str:
        label = self.program.operations[i].label
        self.names[i] = name = unique(f"t{i}" if label is None else str(label), self._taken)
        return name


def _parallel(
    robot: Robot, signature: Signature, cut: Cut, timetable: Timetable, waiting: Waiting
) -> dict[str, Any]:
    plan = lanes(cut, timetable, waiting)
    machine = timetable.machine
    waits = sum(len(step.waits) for lane in plan.steps for step in lane)
    meet = f"{waits} waits for another processor's counter"
    if waiting == "barrier":
        meet = f"{len(plan.barriers)} barriers"
    note = (
        f"{signature.function} on {machine.processors} processors: {len(cut.graph)} "
        f"tasks in {timetable.levels} {'levels' if machine.synchronised else 'units of time'}, "
        f"{len(plan.shared)} values that pass between processors, {meet}. The bits are those of the serial "
        "kernel."
    )
    arrays = [array for array, _ in (*signature.inputs, *signature.outputs)]
    kind = "level" if machine.synchronised else "time"
    return {
        "head": head_of(robot, [note]),
        "processors": machine.processors,
        "arrays": [{"name": array, "what": array_named(array).text} for array in arrays],
        "shared": max(1, len(plan.shared)),
        "barrier": bool(plan.barriers),
        "spins": SPINS,
        "stride": 1 + max(map(len, plan.steps)),
        "lanes": [_lane(signature, cut, plan, k, kind) for k in range(machine.processors)],
    }


def _lane(signature: Signature, cut: Cut, plan: Lanes, k: int, kind: str) -> dict[str, Any]:
    """The function of processor ``k``: its lines, and what it reads."""
    spelling = c_spelling(single=signature.scalar == "float")
    slot = {i: n for n, i in enumerate(plan.shared)}
    writer = _Writer(cut.program, c_syntax(spelling, f"{signature.robot}_real"))
    lines: list[str] = []
    meeting = f"    {signature.robot}_meet(team); /* before level {{}} */"
    barriers = list(plan.barriers)
    level = 0
    for done, step in enumerate(plan.steps[k], 1):
        while barriers and barriers[0] <= step.level:
            lines.append(meeting.format(barriers.pop(0)))
        if step.task and step.level != level:
            level = step.level
            lines.append(f"    /* {kind} {level} */")
        lines += [f"    {signature.robot}_await(&team->done[{j}], base + {n}u);" for j, n in step.waits]
        lines += _step(cut, step, plan, k, writer, slot)
        if step.publishes:
            lines.append(
                f"    atomic_store_explicit(&team->done[{k}].value, base + {done}u, memory_order_release);"
            )
    lines += map(meeting.format, barriers)
    # What this processor made of the results; the first one also writes what nobody computes.
    results = [
        line
        for _, elements in cut.program.outputs
        for place, operand in enumerate(elements)
        if k == (plan.processor_of[operand] if isinstance(operand, int) else 0)
        for line in writer.assigned(f"out[{place}]", operand)
    ]
    lines += results
    arrays = [array for array, _ in signature.inputs if writer.reads(array)]
    parameters = writer.reads("p")
    return {
        "number": k,
        "lines": lines,
        "arrays": arrays,
        "parameters": parameters,
        "base": any(step.waits or step.publishes for step in plan.steps[k]),
        "quiet": not (any("team" in line for line in lines) or arrays or parameters or results),
        "results": bool(results),
    }


def _step(cut: Cut, step: Step, plan: Lanes, k: int, writer: _Writer, slot: dict[int, int]) -> list[str]:
    lines: list[str] = []
    for i in step.operations:
        for arg in cut.program.operations[i].args:
            if isinstance(arg, int) and plan.processor_of[arg] != k and arg not in writer.names:
                lines += writer.bound(arg, f"team->v[{slot[arg]}]")
        lines += writer.written(i, step.operations, keep=i in slot)
        if i in slot:
            lines.append(f"    team->v[{slot[i]}] = {writer.names[i]};")
    return lines


def _packed(robot: Robot, signature: Signature, packing: Packing) -> dict[str, Any]:
    name, program = signature.robot, packing.program
    spelling = c_spelling(single=signature.scalar == "float")
    writer = _Writer(program, c_syntax(spelling, f"{name}_real"))
    vectors = c_syntax(spelling, f"{name}_lanes")
    lines: list[str] = []
    written: dict[tuple[str, ...], str] = {}

    def operand(elements: tuple[str, ...]) -> str:
        """A vector of ``elements``, that of an earlier operation where it is the same; lanes that are not
        needed hold the first element again."""
        filled = elements + elements[:1] * (packing.lanes - len(elements))
        return written.get(elements) or f"({name}_lanes){{{', '.join(filled)}}}"

    for number, group in enumerate(packing.groups):
        if len(group) == 1:
            lines += writer.written(group[0], (), keep=True)
            continue
        operations = [program.operations[i] for i in group]
        left, right = (operand(tuple(writer.text(each.args[side]) for each in operations)) for side in (0, 1))
        vector = f"lanes_{number}"
        lines += vectors.line(vectors.declare(vector, f"{left} {_SIGNS[operations[0].op]} {right}"))
        elements = [f"{vector}[{k}]" for k in range(len(group))]
        writer.names.update(zip(group, elements, strict=True))
        written[tuple(elements)] = vector
    for array, results in program.outputs:
        for i, result in enumerate(results):
            lines += [f"    {line.strip()}" for line in writer.assigned(f"{array}[{i}]", result)]
    note = (
        f"{signature.function} with {packing.lanes} lanes: {packing.vectors} vector operations, "
        f"{100 * packing.filling:.0f} % of their lanes filled, and {len(packing.groups) - packing.vectors} "
        "single ones. The bits are those of the serial kernel."
    )
    names = [*(array for array, _ in signature.inputs), *(["p"] if signature.parameters else [])]
    return {
        "head": head_of(robot, [note]),
        "lanes": packing.lanes,
        "lines": lines,
        "unused": [array for array in names if not writer.reads(array)],
    }
