"""The lines of a function: its statements with their headings, its sines and cosines, its results."""

from __future__ import annotations

from dataclasses import dataclass

from robodyn.emit.results import Result, inputs_of, results_after
from robodyn.emit.sines import ANGLES, COSINES, SINES, together
from robodyn.emit.statements import Body, Expression
from robodyn.emit.syntax import Syntax
from robodyn.ir.program import Input


@dataclass(frozen=True, slots=True)
class Lines:
    """A function in lines: ``angles`` with the loop of our sine and cosine, which stands before the body (or
    nothing), the statements, the results at the end, the names that are defined, local arrays with their
    sizes, the arrays that the body reads, and whether it reads run-time parameters."""

    angles: list[str]
    statements: list[str]
    results: list[str]
    names: list[str]
    arrays: dict[str, int]
    reads: set[str]
    parameters: bool


def body_lines(body: Body, syntax: Syntax, *, builtin: bool, lanes: int, early_writes: bool) -> Lines:
    """``body`` in lines of ``syntax``.

    ``builtin``: sines and cosines are our own, those of ``lanes`` angles at a time; ``early_writes``: results
    are written as soon as they are there, among the statements.
    """
    angles: list[str] = []
    lines: list[str] = []
    names = [statement.name for statement in body.statements]
    arrays: dict[str, int] = {}
    waiting = {}

    def result(it: Result) -> list[str]:
        return syntax.result(syntax.spelling.element(it.array, it.place), it.expression)

    sines = syntax.sines
    if builtin and sines is not None:
        joined = together(body, lanes)
        body, waiting = joined.body, dict(joined.later)
        names = list(dict.fromkeys(s.name for s in (*joined.sums, *body.statements)))
        if joined.angles:
            angles = [line for statement in joined.sums for line in syntax.statement(statement)]
            angles += sines.all(joined.angles)
            arrays |= dict.fromkeys((ANGLES, SINES, COSINES), len(joined.angles))
        arrays |= dict.fromkeys(joined.later, 2)
    expressions = [*_expressions(body), *waiting.values()]
    inputs = [x for expression in expressions for x in inputs_of(expression)]
    reads = {x.array for x in inputs if x.index is not None}
    parameters = any(x.index is None for x in inputs)
    results = results_after(body.statements, body, early_writes=early_writes)
    for k, statement in enumerate(body.statements):
        for read in (x.array for x in inputs_of(statement.expression)):
            if sines is not None and read in waiting:
                lines += sines.pair(read, waiting.pop(read))
        lines += syntax.statement(statement)
        for early in results.get(k, ()):
            lines += result(early)
    end = [line for last in results.get(-1, ()) for line in result(last)]
    return Lines(angles, lines, end, names, arrays, reads, parameters)


def _expressions(body: Body) -> list[Expression]:
    return [s.expression for s in body.statements] + [e for _, es in body.outputs for e in es]


def arrays_read(body: Body) -> set[str]:
    """Names of the arrays that the statements and results read."""
    return {x.array for x in _inputs(body) if x.index is not None}


def reads_parameters(body: Body) -> bool:
    """Whether a run-time parameter is read; it may be called like an array."""
    return any(x.index is None for x in _inputs(body))


def _inputs(body: Body) -> list[Input]:
    return [x for expression in _expressions(body) for x in inputs_of(expression)]
