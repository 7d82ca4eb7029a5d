"""Where results are written: at the end, or as soon as they are there.

Written soon, they need no register to wait in, and a compiler that has to reckon with ``tau`` being one of
the inputs reads inputs afresh instead of keeping them. So an element is written no sooner than the inputs of
its index have been read for the last time: ``tau`` may be the very array ``q``, ``qd`` or ``qdd``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from robodyn.dynamics.functions import INPUTS
from robodyn.emit.statements import Body, Expression, Statement, inputs_of
from robodyn.errors import InputError
from robodyn.ir.signature import Signature

#: Inputs in whose place results may be written.
_IN_PLACE = tuple(array.name for array in INPUTS)


class Result(NamedTuple):
    """``array[place] = expression``."""

    array: str
    place: int
    expression: Expression


def results_after(
    statements: Sequence[Statement], body: Body, *, early_writes: bool
) -> dict[int, list[Result]]:
    """The results to write after statement k of ``statements``; those that wait for the end stand at -1.

    What a function remembers is written at the end.
    """
    last: dict[int, int] = {}
    position: dict[str, int] = {}
    for k, statement in enumerate(statements if early_writes else ()):
        position[statement.name] = k
        for read in inputs_of(statement.expression):
            if read.index is not None and read.array in _IN_PLACE:
                last[read.index] = k
    results: dict[int, list[Result]] = {}
    for array, elements in body.outputs:
        for i, expression in enumerate(elements):
            place = -1
            if early_writes and array != "state" and isinstance(expression, str):
                place = max(position.get(expression, -1), last.get(i, -1))
            results.setdefault(place, []).append(Result(array, i, expression))
    return results


def check_one_result(signature: Signature, how: str) -> None:
    """:class:`InputError` where a function that is to be emitted ``how`` has several results."""
    if len(signature.outputs) > 1:
        raise InputError(
            f"{signature.symbol} has several results, and is not emitted {how}",
            found=", ".join(array for array, _ in signature.outputs),
            expected="a function with one",
        )
