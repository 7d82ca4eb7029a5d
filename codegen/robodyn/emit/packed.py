"""The files of a schedule: the serial kernel, its parallel form, and its packed form, which has the
independent operations of a level as lanes of one core's vectors.

Vectors are those of gcc and clang (``vector_size``), which every target has, by instructions or one by one;
each lane is rounded as the operation alone is, so the bits are those of the serial kernel.
"""

from __future__ import annotations

from typing import Any

from robodyn.emit import Unit, render
from robodyn.emit.c_syntax import c_spelling, c_syntax
from robodyn.emit.lines import Writer, head_of
from robodyn.emit.parallel import Parallel, parallel_files
from robodyn.emit.render import environment
from robodyn.emit.results import check_one_result
from robodyn.errors import InputError
from robodyn.ir.signature import Signature
from robodyn.robot.model import Robot
from robodyn.schedule.cutting import Cut
from robodyn.schedule.lanes import Waiting
from robodyn.schedule.machine import Timetable
from robodyn.schedule.packing import Packing, pack

_SIGNS = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


def packed_files(robot: Robot, signature: Signature, packing: Packing) -> dict[str, str]:
    """``NAME_packed.h`` and ``NAME_packed.c``: text by file name; they include the serial ``NAME.h``.

    Raises
    ------
    InputError: the function remembers between calls, or has several results.
    """
    check_one_result(signature, "packed")
    if signature.states:
        raise InputError(
            f"{signature.symbol} remembers between calls, and is not emitted packed",
            remedy="leave out the effects with memory, or take another function",
        )
    name = signature.robot
    body = _Body(signature, packing)
    read = body.writer.inputs
    notes = (
        f"{signature.function} with {packing.lanes} lanes: {packing.vectors} vector operations, "
        f"{100 * packing.filling:.0f} % of their lanes filled, and "
        f"{len(packing.groups) - packing.vectors} single "
        "ones. The bits are those of the serial kernel."
    )
    ((output, size),) = signature.outputs
    context: dict[str, Any] = {
        "name": name,
        "guard": f"{name.upper()}_PACKED_H",
        "function": signature.function,
        "symbol": signature.symbol,
        "lanes": packing.lanes,
        "inputs": [{"name": array, "size": length} for array, length in signature.inputs],
        "output": output,
        "size": size,
        "parameters": signature.parameters,
        "head": head_of(robot, [notes]),
        "lines": body.lines,
        "again": body.writer.again,
        "unused": [array for array, _ in signature.inputs if not any(x.is_of(array) for x in read)]
        + (["p"] if signature.parameters and not any(x.index is None for x in read) else []),
    }
    return {
        f"{name}_packed.h": environment().get_template("c/packed.h.j2").render(context),
        f"{name}_packed.c": environment().get_template("c/packed.c.j2").render(context),
    }


class _Body:
    """The lines of the packed function."""

    def __init__(self, signature: Signature, packing: Packing) -> None:
        self.name = signature.robot
        self.packing = packing
        spelling = c_spelling(single=signature.scalar == "float")
        self.writer = Writer(packing.program, c_syntax(spelling, f"{self.name}_real"))
        self.vector = c_syntax(spelling, f"{self.name}_lanes")
        self.lines: list[str] = []
        self.vectors: dict[tuple[str, ...], str] = {}
        for group_index, group in enumerate(packing.groups):
            if len(group) == 1:
                self.lines += self.writer.written(group[0], (), keep=True)
            else:
                self._vector(group_index, group)
        for array, elements in packing.program.outputs:
            for i, operand in enumerate(elements):
                self.lines += [
                    f"    {line.strip()}" for line in self.writer.assigned(f"{array}[{i}]", operand)
                ]

    def _vector(self, group_index: int, group: tuple[int, ...]) -> None:
        operations = [self.packing.program.operations[i] for i in group]
        left, right = (
            self._operand([self.writer.text(operation.args[side]) for operation in operations])
            for side in (0, 1)
        )
        name = f"lanes_{group_index}"
        text = f"{left} {_SIGNS[operations[0].op]} {right}"
        self.lines += self.vector.line(self.vector.declare(name, text))
        elements = [f"{name}[{k}]" for k in range(len(group))]
        for i, element in zip(group, elements, strict=True):
            self.writer.called(i, element)
        self.vectors[tuple(elements)] = name

    def _operand(self, elements: list[str]) -> str:
        """A vector of ``elements``, that of an earlier operation where it is the same; lanes that are not
        needed hold the first element again."""
        known = self.vectors.get(tuple(elements))
        if known is not None:
            return known
        filled = elements + elements[:1] * (self.packing.lanes - len(elements))
        return f"({self.name}_lanes){{{', '.join(filled)}}}"


def schedule_files(
    robot: Robot,
    signature: Signature,
    cut: Cut,
    timetable: Timetable,
    *,
    waiting: Waiting | None = None,
    lanes: int | None = None,
    notes: tuple[str, ...] = (),
) -> dict[str, str]:
    """All files of a schedule of ``cut``: text by file name; with ``lanes`` the packed form too.

    ``waiting``: barriers where the timetable has levels, counters where it has none, unless told.

    Raises
    ------
    InputError: the function remembers between calls, or barriers are asked for where there are no levels.
    """
    how = waiting or ("barrier" if timetable.machine.synchronised else "counters")
    unit = Unit(robot, ((signature, cut.program),), notes=notes)
    files = render(unit, ("c",)) | parallel_files(
        Parallel(robot, signature, cut, timetable, how, notes, lanes is not None)
    )
    if lanes is not None:
        files |= packed_files(robot, signature, pack(cut.program, lanes))
    return files
