"""How statements are written in a language: the one place where a named value becomes a line of text."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from robodyn.emit.spelling import Spelling
from robodyn.emit.statements import Apply, Expression, Statement
from robodyn.ir.program import Input


@dataclass(frozen=True, slots=True)
class Sines:
    """How a language calls our sine and cosine: for all angles at once, and for one pair."""

    all: Callable[[Sequence[Expression]], list[str]]
    pair: Callable[[str, Expression], list[str]]


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

    def statement(self, statement: Statement) -> list[str]:
        """The lines of ``statement``, its heading first."""
        heading = [self.indent + self.comment % statement.heading] if statement.heading else []
        declare = self.declare
        if statement.angle and self.declare_angle is not None:
            declare = self.declare_angle
        text = self.spelling.text(self.as_read(statement.expression))
        return [*heading, *self.line(declare(statement.name, text))]

    def result(self, target: str, expression: Expression) -> list[str]:
        """The lines of ``target = expression``."""
        return self.line(self.assign(target, self.spelling.text(expression)))

    def line(self, text: str) -> list[str]:
        """A ready statement, on as many lines as it needs."""
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
