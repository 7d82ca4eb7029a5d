"""Arctangents that stand one after another in a function, for our own: each run of them in one loop."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace

from robodyn.emit.sines import called
from robodyn.emit.statements import Apply, Body, Expression, Statement, inputs_of
from robodyn.ir.program import Input


@dataclass(frozen=True, slots=True)
class Run:
    """Arctangents that do not need each other: ``angles[k] = atan2(ups[k], alongs[k])``, where ``arrays`` are
    what the local arrays of ``ups``, ``alongs`` and ``angles`` are called."""

    arrays: tuple[str, str, str]
    ups: tuple[Expression, ...]
    alongs: tuple[Expression, ...]

    @property
    def inputs(self) -> list[Input]:
        """The inputs that it reads."""
        return inputs_of(*self.ups, *self.alongs)


@dataclass(frozen=True, slots=True)
class InRuns:
    """A body without the statements that are runs of two arctangents or more; ``runs`` are these, by the
    place in the body before which they stand, and ``names`` says what their values are called there."""

    body: Body
    runs: dict[int, list[Run]]
    names: dict[str, Expression]


def in_runs(body: Body, lanes: int) -> InRuns:
    """``body`` with its arctangents in runs; from three on an even number of them if there are ``lanes``, as
    with sines (:func:`~robodyn.emit.sines.together`)."""
    groups: list[list[Statement]] = []
    for statement in body.statements:
        before = groups[-1] if groups and _is_arctangent(groups[-1][0]) else []
        needed = _reads(statement.expression, {s.name for s in before})
        if before and _is_arctangent(statement) and not needed:
            before.append(statement)
        else:
            groups.append([statement])
    statements: list[Statement] = []
    runs: dict[int, list[Run]] = {}
    count = 0
    names: dict[str, Expression] = {}
    for group in groups:
        values = [called(s.expression, names) for s in group]
        if len(group) == 1:
            statements.append(group[0]._replace(expression=values[0]))
            continue
        count += 1
        # No value of a program is called so.
        arrays = f"ups{count}", f"alongs{count}", f"arctangents{count}"
        names |= {s.name: Input(arrays[2], k) for k, s in enumerate(group)}
        if lanes > 1 and len(group) > 2 and len(group) % 2:
            values.append(values[0])
        ups, alongs = zip(*[value.args for value in values if isinstance(value, Apply)], strict=True)
        runs.setdefault(len(statements), []).append(Run(arrays, ups, alongs))
    outputs = tuple((array, tuple(called(x, names) for x in elements)) for array, elements in body.outputs)
    return InRuns(replace(body, statements=tuple(statements), outputs=outputs), runs, names)


def _is_arctangent(statement: Statement) -> bool:
    return isinstance(statement.expression, Apply) and statement.expression.op == "atan2"


def _reads(expression: Expression, names: Collection[str]) -> bool:
    if isinstance(expression, Apply):
        return any(_reads(arg, names) for arg in expression.args)
    return expression in names
