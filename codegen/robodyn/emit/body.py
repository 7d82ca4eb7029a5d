"""The lines of a function: its statements with their headings, its sines and cosines, its results."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from robodyn.emit.results import Result, results_after
from robodyn.emit.sines import ANGLES, COSINES, SINES, together
from robodyn.emit.statements import Body, inputs_of
from robodyn.emit.syntax import Syntax


@dataclass(frozen=True, slots=True)
class Lines:
    """A function in lines: ``angles`` with the loop of our sine and cosine, which stands before the body (or
    nothing), the statements, the results at the end, the names that are defined, local arrays with their
    sizes, the arrays that the body reads, whether it reads run-time parameters, and what its loops count with."""

    angles: list[str]
    statements: list[str]
    results: list[str]
    names: list[str]
    arrays: dict[str, int]
    reads: set[str]
    parameters: bool
    counters: Sequence[str] = ()

    @classmethod
    def of(cls, statements: list[str], arrays: dict[str, int], counters: Sequence[str] = ()) -> Lines:
        """Ready lines that need local ``arrays``, and integers as ``counters``."""
        return cls([], statements, [], [], arrays, set(), False, counters)


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
    body = replace(body, inputs=body.inputs.union(inputs_of(*waiting.values())))
    results = results_after(body.statements, body, early_writes=early_writes)
    for k, statement in enumerate(body.statements):
        for read in inputs_of(statement.expression) if waiting else ():
            if sines is not None and read.array in waiting:
                lines += sines.pair(read.array, waiting.pop(read.array))
        lines += syntax.statement(statement)
        for early in results.get(k, ()):
            lines += result(early)
    end = [line for last in results.get(-1, ()) for line in result(last)]
    return Lines(angles, lines, end, names, arrays, body.arrays, body.reads_parameters)
