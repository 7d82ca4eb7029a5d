"""The lines of a function: its statements with their headings, its sines and cosines, its results."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from robodyn.emit.results import Result, results_after
from robodyn.emit.runs import Run, in_runs
from robodyn.emit.sines import ANGLES, COSINES, SINES, called, together
from robodyn.emit.statements import Body, inputs_of
from robodyn.emit.syntax import Syntax
from robodyn.ir.program import Input


@dataclass(frozen=True, slots=True)
class Lines:
    """A function in lines: ``angles`` with the loop of our sine and cosine, which stands before the body (or
    nothing), the statements, the results at the end, the names that are defined, local arrays with their
    sizes, the arrays that the body reads, whether it reads run-time parameters, and counters of loops."""

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

    ``builtin``: sines, cosines and arctangents are our own, those of ``lanes`` angles at a time;
    ``early_writes``: results are written as soon as they are there, among the statements.
    """
    angles: list[str] = []
    lines: list[str] = []
    names = [statement.name for statement in body.statements]
    arrays: dict[str, int] = {}
    waiting = {}
    runs: dict[int, list[Run]] = {}

    def result(it: Result) -> list[str]:
        return syntax.result(syntax.spelling.element(it.array, it.place), it.expression)

    sines = syntax.sines
    if builtin and sines is not None:
        joined = together(body, lanes)
        body, waiting = joined.body, dict(joined.later)
        if joined.angles:
            angles = [line for statement in joined.sums for line in syntax.statement(statement)]
            angles += sines.all(joined.angles)
            arrays |= dict.fromkeys((ANGLES, SINES, COSINES), len(joined.angles))
        arrays |= dict.fromkeys(joined.later, 2)
        if sines.run is not None:
            separate = in_runs(body, lanes)
            body, runs = separate.body, separate.runs
            waiting = {array: called(angle, separate.names) for array, angle in waiting.items()}
            arrays |= {array: len(run.ups) for row in runs.values() for run in row for array in run.arrays}
        names = list(dict.fromkeys(s.name for s in (*joined.sums, *body.statements)))
    read_by_runs = [x for row in runs.values() for run in row for x in run.inputs]
    body = replace(body, inputs=body.inputs.union(inputs_of(*waiting.values()), read_by_runs))
    results = results_after(body.statements, body, early_writes=early_writes)

    def pairs(inputs: Iterable[Input]) -> list[str]:
        """Sines and cosines that are read for the first time."""
        return [
            line
            for read in inputs
            if sines is not None and read.array in waiting
            for line in sines.pair(read.array, waiting.pop(read.array))
        ]

    def arctangents(place: int) -> list[str]:
        """The runs that stand before statement ``place``."""
        return [
            line
            for run in runs.get(place, ())
            if sines is not None and sines.run is not None
            for line in pairs(run.inputs) + sines.run(run)
        ]

    for k, statement in enumerate(body.statements):
        lines += arctangents(k)
        if waiting:
            lines += pairs(inputs_of(statement.expression))
        lines += syntax.statement(statement)
        for early in results.get(k, ()):
            lines += result(early)
    lines += arctangents(len(body.statements))
    end = [line for last in results.get(-1, ()) for line in result(last)]
    return Lines(angles, lines, end, names, arrays, body.arrays, body.reads_parameters)
