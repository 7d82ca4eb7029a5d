"""How statements are written in a language: the one place where a named value becomes a line of text."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from robodyn.emit.runs import Run
from robodyn.emit.spelling import WIDTH, Spelling
from robodyn.emit.statements import Apply, Expression, Statement
from robodyn.ir.program import Input


@dataclass(frozen=True, slots=True)
class Sines:
    """How a language calls our sine and cosine: for all angles at once, and for one pair."""

    all: Callable[[Sequence[Expression]], list[str]]
    pair: Callable[[str, Expression], list[str]]
    #: Our arctangent of a run of points in one loop; None where that gains nothing.
    run: Callable[[Run], list[str]] | None = None


@dataclass(frozen=True, slots=True)
class Syntax:
    """The statements of a language.

    ``declare(name, text)`` and ``assign(target, text)`` give statements, ``declare_angle`` that of a value
    whose sine and cosine are taken (``declare`` where it is None); ``comment`` has ``%s`` in the text's
    place. ``reread`` are arrays that sines read under another name.
    """

    spelling: Spelling
    comment: str
    declare: Callable[[str, str], str]
    assign: Callable[[str, str], str]
    declare_angle: Callable[[str, str], str] | None = None
    sines: Sines | None = None
    reread: Mapping[str, str] = field(default_factory=dict)
    indent: str = "    "
    #: Where it is not None, no statement is broken: one that does not fit on a line, or with arguments of a
    #: call that are longer, is written in parts, each with a name.
    longest_call: int | None = None

    def statement(self, statement: Statement) -> list[str]:
        """The lines of ``statement``, its heading first."""
        heading = [self.indent + self.comment % statement.heading] if statement.heading else []
        declare = self.declare
        if statement.angle and self.declare_angle is not None:
            declare = self.declare_angle
        expression = self.as_read(statement.expression)
        before: list[str] = []
        if self.longest_call is not None:
            before, expression = self._in_parts(statement.name, expression)
        return [*heading, *before, *self.line(declare(statement.name, self.spelling.text(expression)))]

    def _in_parts(self, name: str, expression: Expression) -> tuple[list[str], Expression]:
        """``expression`` short enough for a line that declares ``name``, and the lines of its parts: as long
        as it does not fit, the longest part that does gets a name."""
        before: list[str] = []
        while not self._fits(name, expression):
            part = f"{name}_p{len(before) + 1}"
            fitting = [x for x in _proper_parts(expression) if self._fits(part, x)]
            if not fitting:
                break
            longest = max(fitting, key=lambda x: len(self.spelling.text(x)))
            before += self.line(self.declare(part, self.spelling.text(longest)))
            expression = _replaced(expression, longest, part)
        return before, expression

    def _fits(self, name: str, expression: Expression) -> bool:
        text = self.spelling.text(expression)
        return len(self.indent + self.declare(name, text)) <= WIDTH and self._calls_fit(expression)

    def _calls_fit(self, expression: Expression) -> bool:
        if not isinstance(expression, Apply) or self.longest_call is None:
            return True
        if expression.op in self.spelling.functions:
            texts = [self.spelling.text(x) for x in expression.args]
            if len(", ".join(texts)) > self.longest_call:
                return False
        return all(map(self._calls_fit, expression.args))

    def result(self, target: str, expression: Expression) -> list[str]:
        """The lines of ``target = expression``."""
        return self.line(self.assign(target, self.spelling.text(expression)))

    def line(self, text: str) -> list[str]:
        """A ready statement, on as many lines as it needs."""
        if self.longest_call is not None and len(self.indent + text) > WIDTH:
            target, _, value = text.partition(" = ")
            return [f"{self.indent}{target} =", f"{self.indent}    {value}"]
        return self.spelling.wrapped(text, self.indent)

    def rereads(self, expression: Expression) -> bool:
        """Whether ``expression`` is a sine that reads an input under another name."""
        return self.as_read(expression) != expression

    def as_read(self, expression: Expression) -> Expression:
        """``expression`` with the angle that a sine reads under the name that it has there."""
        if isinstance(expression, Apply) and expression.op == "sin":
            (angle,) = expression.args
            if isinstance(angle, Input) and angle.index is not None and angle.array in self.reread:
                return Apply("sin", (Input(self.reread[angle.array], angle.index),))
        return expression


def _proper_parts(expression: Expression) -> list[Apply]:
    """The operations within ``expression``, itself left out."""
    if not isinstance(expression, Apply):
        return []
    inner = [arg for arg in expression.args if isinstance(arg, Apply)]
    return inner + [part for arg in inner for part in _proper_parts(arg)]


def _replaced(expression: Expression, part: Apply, name: str) -> Expression:
    if expression == part:
        return name
    if isinstance(expression, Apply):
        return Apply(expression.op, tuple(_replaced(arg, part, name) for arg in expression.args))
    return expression
