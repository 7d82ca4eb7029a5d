"""Operations as lines of C, one at a time, in whatever order a schedule has."""

from __future__ import annotations

import textwrap
from collections.abc import Collection, Sequence

from robodyn.emit.render import comment
from robodyn.emit.spelling import WIDTH, Spelling
from robodyn.emit.statements import Apply, Expression, unique
from robodyn.ir.program import Operand, Program
from robodyn.robot.model import Robot


class Writer:
    """Writes operations of ``program`` as statements of C, and keeps in mind what they are called.

    A value that is used once, by an operation of the same task, is written where it is used. ``again``: sines
    read the angles a second time (without it gcc joins sine and cosine into sincos, which not every libm
    has).
    """

    def __init__(self, program: Program, spelling: Spelling, real: str) -> None:
        self.program = program
        self.spelling = spelling
        self.real = real
        self.again = False
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
        # C writes the argument of a sign twice.
        self._whole = self._angles | {
            arg for operation in program.operations if operation.op == "sign" for arg in operation.args
            if isinstance(arg, int)
        }  # fmt: skip
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
        return [f"    const {self.real} {name} = {source};"]

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
        kind = f"const volatile {self.real}" if i in self._angles else f"const {self.real}"
        text = self.spelling.text(expression, self._second)
        return self.spelling.wrapped(f"{kind} {name} = {text};", "    ")

    def assigned(self, target: str, operand: Operand) -> list[str]:
        """``target = operand``."""
        return self.spelling.wrapped(f"{target} = {self.text(operand)};", "    ")

    def text(self, operand: Operand) -> str:
        """An operand as C."""
        return self.spelling.text(self._operand(operand))

    def _operand(self, operand: Operand) -> Expression:
        return self._names[operand] if isinstance(operand, int) else operand

    def _second(self, argument: Expression) -> str:
        if isinstance(argument, str):
            return argument
        text = self.spelling.text(argument)
        if "q[" in text:
            self.again = True
        return text.replace("q[", "again[", 1)

    def _named(self, i: int) -> str:
        label = self.program.operations[i].label
        return unique(f"t{i}" if label is None else str(label), self._taken)


def head_of(robot: Robot, told: Sequence[str]) -> list[str]:
    """The comment at the top of a file: whose dynamics, and what is ``told`` of it."""
    lines: list[str] = []
    for text in (f"{robot.name}: {robot.title or 'a serial arm'}", *told):
        lines.extend(textwrap.wrap(comment(text), WIDTH - 4, subsequent_indent="  ") or [""])
    lines.append("Written by robodyn; do not edit, generate again.")
    return lines
