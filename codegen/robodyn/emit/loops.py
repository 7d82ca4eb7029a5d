"""Our own sines, cosines and arctangents in loops: those of the joint angles first, arctangents in runs."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

from robodyn.emit.statements import Apply, Body, Expression, Statement, inputs_of
from robodyn.ir.program import Input
from robodyn.passes.order import SUMS, is_position

#: Names of the local arrays, as arrays of inputs; no value of a program is called so.
ANGLES, SINES, COSINES = "angles", "sines", "cosines"


@dataclass(frozen=True, slots=True)
class Together:
    """A body whose sines and cosines of joint angles come first.

    ``sums`` are the statements that the angles need (the body has those again that it needs), ``angles`` the
    distinct angles, as many as the loop has turns; ``body`` reads ``sines[k]`` and ``cosines[k]``. ``later``
    are the arguments of the other sines, known only as the body goes on: a pair ``later1[0..1]`` each.
    """

    sums: tuple[Statement, ...]
    angles: tuple[Expression, ...]
    body: Body
    later: dict[str, Expression]


def together(body: Body, lanes: int) -> Together:
    """``body`` with one call a distinct angle; from three angles on an even number of them if there are
    ``lanes``, so that no compiler leaves one alone: it takes four at a time and two for the rest,
    or two. What is added repeats an angle: gcc puts constants beside angles through memory, where a
    wide load waits for narrow stores, and zeros cost a quarter of a Jacobian's time."""
    expressions = {s.name: s.expression for s in body.statements}
    places: dict[Expression, int] = {}
    later: dict[Expression, str] = {}
    needed: set[str] = set()
    statements: list[Statement] = []
    names: dict[str, Expression] = {}
    for statement in body.statements:
        value = statement.expression
        if not (isinstance(value, Apply) and value.op in ("sin", "cos")):
            statements.append(statement)
            continue
        (angle,) = value.args
        terms = _of_positions(angle, expressions)
        if terms is None:
            pair = Input(later.setdefault(angle, f"later{len(later) + 1}"), int(value.op == "cos"))
            statements.append(statement._replace(expression=pair))
        else:
            needed |= terms
            place = places.setdefault(angle, len(places))
            names[statement.name] = Input(SINES if value.op == "sin" else COSINES, place)
    rest = [s._replace(expression=called(s.expression, names)) for s in statements if s.name not in needed]
    outputs = tuple((array, tuple(called(x, names) for x in elements)) for array, elements in body.outputs)
    read = inputs_of(*(s.expression for s in rest), *(x for _, elements in outputs for x in elements))
    return Together(
        tuple(s for s in body.statements if s.name in needed),
        _evenly(tuple(places), lanes),
        Body(tuple(rest), outputs, frozenset(read)),
        {name: called(angle, names) for angle, name in later.items()},
    )


def _evenly(values: tuple[Expression, ...], lanes: int) -> tuple[Expression, ...]:
    """``values``, the first of them again where an odd number of three or more is taken in ``lanes``."""
    return values + values[:1] if lanes > 1 and len(values) > 2 and len(values) % 2 else values


def called(expression: Expression, names: Mapping[str, Expression]) -> Expression:
    """``expression`` with what ``names`` says in place of names."""
    if isinstance(expression, str):
        return names.get(expression, expression)
    if isinstance(expression, Apply):
        return Apply(expression.op, tuple(called(arg, names) for arg in expression.args))
    return expression


def _of_positions(angle: Expression, expressions: Mapping[str, Expression]) -> set[str] | None:
    """The statements that ``angle`` needs if it is known from positions and parameters alone."""
    needed: set[str] = set()
    stack = [angle]
    while stack:
        expression = stack.pop()
        if isinstance(expression, str):
            if expression not in needed:
                needed.add(expression)
                stack.append(expressions[expression])
        elif isinstance(expression, Apply):
            if expression.op not in SUMS:
                return None
            stack.extend(expression.args)
        elif not is_position(expression):
            return None
    return needed


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


def in_runs(body: Body, lanes: int) -> tuple[Body, dict[int, list[Run]], dict[str, Expression]]:
    """``body`` without the statements that are runs of two arctangents or more; these, by the place in the
    body before which they stand, and what their values are called there. Runs of three and more have an even
    number if there are ``lanes``, as with sines (:func:`together`)."""
    groups: list[list[Statement]] = []
    for statement in body.statements:
        before = groups[-1] if groups and _is_arctangent(groups[-1][0]) else []
        if (
            before
            and _is_arctangent(statement)
            and not _reads(statement.expression, {s.name for s in before})
        ):
            before.append(statement)
        else:
            groups.append([statement])
    statements: list[Statement] = []
    runs: dict[int, list[Run]] = {}
    count = 0
    names: dict[str, Expression] = {}
    for group in groups:
        values = tuple(called(s.expression, names) for s in group)
        if len(group) == 1:
            statements.append(group[0]._replace(expression=values[0]))
            continue
        count += 1
        # No value of a program is called so.
        arrays = f"ups{count}", f"alongs{count}", f"arctangents{count}"
        names |= {s.name: Input(arrays[2], k) for k, s in enumerate(group)}
        ups, alongs = zip(*[x.args for x in _evenly(values, lanes) if isinstance(x, Apply)], strict=True)
        runs.setdefault(len(statements), []).append(Run(arrays, ups, alongs))
    outputs = tuple((array, tuple(called(x, names) for x in elements)) for array, elements in body.outputs)
    return replace(body, statements=tuple(statements), outputs=outputs), runs, names


def _is_arctangent(statement: Statement) -> bool:
    return isinstance(statement.expression, Apply) and statement.expression.op == "atan2"


def _reads(expression: Expression, names: Collection[str]) -> bool:
    if isinstance(expression, Apply):
        return any(_reads(arg, names) for arg in expression.args)
    return expression in names
