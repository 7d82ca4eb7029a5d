"""Sines and cosines of a function for our own sine and cosine: those of the joint angles in one loop."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from robodyn.emit.statements import Apply, Body, Expression, Statement, inputs_of
from robodyn.ir.program import Input
from robodyn.passes.angles import SUMS, is_position

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
    first: dict[Expression, int] = {}
    later: dict[Expression, str] = {}
    needed: set[str] = set()
    statements: list[Statement] = []
    places: dict[str, Expression] = {}
    for statement in body.statements:
        value = statement.expression
        if not (isinstance(value, Apply) and value.op in ("sin", "cos")):
            statements.append(statement)
            continue
        (angle,) = value.args
        names = _of_positions(angle, expressions)
        if names is None:
            pair = Input(later.setdefault(angle, f"later{len(later) + 1}"), int(value.op == "cos"))
        else:
            needed |= names
            place = first.setdefault(angle, len(first))
            places[statement.name] = Input(SINES if value.op == "sin" else COSINES, place)
            continue
        statements.append(statement._replace(expression=pair))
    angles = list(first)
    if lanes > 1 and len(angles) > 2 and len(angles) % 2:
        angles.append(angles[0])
    rest = [s._replace(expression=called(s.expression, places)) for s in statements if s.name not in needed]
    outputs = tuple((array, tuple(called(x, places) for x in elements)) for array, elements in body.outputs)
    read = inputs_of(*(s.expression for s in rest), *(x for _, elements in outputs for x in elements))
    return Together(
        tuple(s for s in body.statements if s.name in needed),
        tuple(angles),
        Body(tuple(rest), outputs, frozenset(read)),
        {name: called(angle, places) for angle, name in later.items()},
    )


def _names(expressions: Sequence[Expression], known: Mapping[str, Expression]) -> set[str]:
    """What ``expressions`` read by name, sines and cosines left out, and what that reads."""
    names: set[str] = set()
    stack = list(expressions)
    while stack:
        expression = stack.pop()
        if isinstance(expression, Apply):
            stack.extend(expression.args)
        elif isinstance(expression, str) and expression not in names:
            names.add(expression)
            below = known[expression]
            if not (isinstance(below, Apply) and below.op in ("sin", "cos")):
                stack.append(below)
    return names


def called(expression: Expression, names: Mapping[str, Expression]) -> Expression:
    """``expression`` with what ``names`` says in place of names."""
    if isinstance(expression, str):
        return names.get(expression, expression)
    if isinstance(expression, Apply):
        return Apply(expression.op, tuple(called(arg, names) for arg in expression.args))
    return expression


def _of_positions(angle: Expression, known: dict[str, Expression]) -> set[str] | None:
    """The statements that ``angle`` needs if it is known from positions and parameters alone."""
    needed: set[str] = set()
    stack = [angle]
    while stack:
        expression = stack.pop()
        if isinstance(expression, str):
            if expression not in needed:
                needed.add(expression)
                stack.append(known[expression])
        elif isinstance(expression, Apply):
            if expression.op not in SUMS:
                return None
            stack.extend(expression.args)
        elif not is_position(expression):
            return None
    return needed
