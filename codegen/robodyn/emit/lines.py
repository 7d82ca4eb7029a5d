"""Operations as statements, one at a time, in whatever order a schedule has."""

from __future__ import annotations

import textwrap
from collections.abc import Collection, Sequence

from robodyn.emit.render import comment
from robodyn.emit.spelling import WIDTH
from robodyn.emit.statements import Apply, Expression, Statement, inputs_of, unique
from robodyn.emit.syntax import Syntax
from robodyn.ir.program import Input, Operand, Program
from robodyn.robot.account import account_lines
from robodyn.robot.model import Robot


class Writer:
    """Writes operations of ``program`` as statements, and keeps in mind what they are called.

    A value that is used once, by an operation of the same task, is written where it is used. ``again``: sines
    read angles under another name; ``inputs`` are those that have been read, under the names that stand
    there.
    """

    def __init__(self, program: Program, syntax: Syntax) -> None:
        self.program = program
        self.syntax = syntax
        self.again = False
        self.inputs: set[Input] = set()
        self._uses = program.uses()
        self._users: dict[int, set[int]] = {}
        self._names: dict[int, Expression] = {}
        self._taken: set[str] = set()
        self._angles = {
            arg
            for operation in program.operations
            if operation.op in ("sin", "cos")
            for arg in operation.args
            if isinstance(arg, int)
        }
        # C writes the argument of a sign twice, and a choice without branches where both sides are there.
        self._whole = self._angles | {
            arg
            for operation in program.operations
            if operation.op in ("sign", "select")
            for arg in operation.args
            if isinstance(arg, int)
        }
        self._results = {operand for operand in program.results() if isinstance(operand, int)}
        for i, operation in enumerate(program.operations):
            for arg in operation.args:
                if isinstance(arg, int):
                    self._users.setdefault(arg, set()).add(i)

    def known(self, i: int) -> bool:
        """Whether the value of operation ``i`` has been written or bound."""
        return i in self._names

    def name(self, i: int) -> str:
        """What the value of operation ``i`` is called; it has been written with ``keep``, or bound."""
        name = self._names[i]
        assert isinstance(name, str)
        return name

    def bound(self, i: int, source: str) -> list[str]:
        """Call the value of operation ``i``, which stands in ``source``, by its name from here on."""
        name = self._named(i)
        self._names[i] = name
        return self.syntax.line(self.syntax.declare(name, source))

    def called(self, i: int, text: str) -> None:
        """From here on the value of operation ``i`` is what ``text`` says."""
        self._names[i] = text

    def written(self, i: int, inside: Collection[int], *, keep: bool = False) -> list[str]:
        """Operation ``i``: a statement, or none where it is written into its only use, which is in
        ``inside``; ``keep``: it needs a name."""
        op, args, label = self.program.operations[i]
        expression = Apply(op, tuple(self._operand(arg) for arg in args))
        single = self._uses[i] == 1 and self._users.get(i, set()) <= set(inside) and i not in self._results
        if single and not keep and label is None and i not in self._whole and op not in ("sin", "cos"):
            self._names[i] = expression
            return []
        name = self._named(i)
        self._names[i] = name
        self.again |= self.syntax.rereads(expression)
        self.inputs.update(inputs_of(self.syntax.as_read(expression)))
        return self.syntax.statement(Statement(name, expression, angle=i in self._angles))

    def assigned(self, target: str, operand: Operand) -> list[str]:
        """``target = operand``."""
        expression = self._operand(operand)
        self.inputs.update(inputs_of(expression))
        return self.syntax.result(target, expression)

    def text(self, operand: Operand) -> str:
        """An operand in the language."""
        expression = self._operand(operand)
        self.inputs.update(inputs_of(expression))
        return self.syntax.spelling.text(expression)

    def _operand(self, operand: Operand) -> Expression:
        return self._names[operand] if isinstance(operand, int) else operand

    def _named(self, i: int) -> str:
        label = self.program.operations[i].label
        return unique(f"t{i}" if label is None else str(label), self._taken)


def head_of(robot: Robot, notes: Sequence[str]) -> list[str]:
    """The comment at the top of a file: whose dynamics, what is ``notes`` of it, and what is known of the
    robot's numbers."""
    lines: list[str] = []
    for text in (f"{robot.name}: {robot.title or 'a serial arm'}", *notes, *account_lines(robot)):
        lines.extend(textwrap.wrap(comment(text), WIDTH - 4, subsequent_indent="  ") or [""])
    lines.append("Written by robodyn; do not edit, generate again.")
    return lines
