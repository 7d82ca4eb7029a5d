"""The lines of a function: its statements with their headings, its sines and cosines, its results."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from robodyn.dynamics.functions import INPUTS
from robodyn.emit.loops import ANGLES, COSINES, SINES, Run, called, in_runs, together
from robodyn.emit.spelling import Syntax
from robodyn.emit.statements import Body, Expression, inputs_of
from robodyn.ir.program import Input

#: Inputs in whose place results may be written.
_IN_PLACE = frozenset(array.name for array in INPUTS)


@dataclass(frozen=True, slots=True)
class Lines:
    """A function in lines: the statements with the results, local arrays with their sizes, ``angles`` with
    the loop of our sine and cosine, which stands before the body (or nothing), the names that are defined,
    the inputs that the body reads, and counters of loops."""

    statements: list[str]
    arrays: dict[str, int]
    angles: Sequence[str] = ()
    names: Sequence[str] = ()
    inputs: frozenset[Input] = frozenset()
    counters: Sequence[str] = ()


def body_lines(body: Body, syntax: Syntax, *, builtin: bool, lanes: int, early_writes: bool) -> Lines:
    """``body`` in lines of ``syntax``.

    ``builtin``: sines, cosines and arctangents are our own, those of ``lanes`` angles at a time;
    ``early_writes``: results are written as soon as they are there, among the statements.
    """
    angles: list[str] = []
    lines: list[str] = []
    names = [statement.name for statement in body.statements]
    arrays: dict[str, int] = {}
    waiting: dict[str, Expression] = {}
    runs: dict[int, list[Run]] = {}
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
            body, runs, values = in_runs(body, lanes)
            waiting = {array: called(angle, values) for array, angle in waiting.items()}
            arrays |= {array: len(run.ups) for row in runs.values() for run in row for array in run.arrays}
        names = list(dict.fromkeys(s.name for s in (*joined.sums, *body.statements)))
    read_by_runs = [x for row in runs.values() for run in row for x in run.inputs]
    body = replace(body, inputs=body.inputs.union(inputs_of(*waiting.values()), read_by_runs))
    results = _results(body, syntax, early_writes=early_writes)

    def pairs(inputs: Iterable[Input]) -> list[str]:
        """Sines and cosines that are read for the first time."""
        first = dict.fromkeys(read.array for read in inputs if sines is not None and read.array in waiting)
        return [line for array in first if sines for line in sines.pair(array, waiting.pop(array))]

    def before(place: int) -> list[str]:
        """The runs of arctangents that stand before statement ``place``."""
        every = runs.get(place, ()) if sines is not None and sines.run is not None else ()
        return [line for run in every if sines and sines.run for line in pairs(run.inputs) + sines.run(run)]

    for k, statement in enumerate(body.statements):
        lines += before(k)
        if waiting:
            lines += pairs(inputs_of(statement.expression))
        lines += syntax.statement(statement) + results.get(k, [])
    lines += before(len(body.statements)) + results.get(-1, [])
    return Lines(lines, arrays, angles, names, body.inputs)


def _results(body: Body, syntax: Syntax, *, early_writes: bool) -> dict[int, list[str]]:
    """The lines of results to write after each statement; those that wait for the end stand at -1.

    Written soon, they need no register to wait in, and a compiler that has to reckon with ``tau`` being one
    of the inputs reads inputs afresh instead of keeping them. So an element is written no sooner than the
    inputs of its index have been read for the last time: ``tau`` may be the very array ``q``, ``qd`` or
    ``qdd``. What a function remembers is written at the end.
    """
    last: dict[int, int] = {}
    position: dict[str, int] = {}
    for k, statement in enumerate(body.statements if early_writes else ()):
        position[statement.name] = k
        for read in inputs_of(statement.expression):
            if read.index is not None and read.array in _IN_PLACE:
                last[read.index] = k
    results: dict[int, list[str]] = {}
    for array, elements in body.outputs:
        for i, expression in enumerate(elements):
            place = -1
            if early_writes and array != "state" and isinstance(expression, str):
                place = max(position.get(expression, -1), last.get(i, -1))
            lines = syntax.result(syntax.spelling.element(array, i), expression)
            results.setdefault(place, []).extend(lines)
    return results
