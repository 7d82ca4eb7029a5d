"""Several functions in one, which share what they have in common."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

from robodyn.dynamics.functions.arguments import INPUTS
from robodyn.dynamics.functions.record import Function, Pair, lengths_of
from robodyn.dynamics.state import Dynamics, ReferenceDynamics, Vector
from robodyn.errors import InputError

#: What stands between the names of functions that are fused.
AND = "_and_"

Writing = Callable[[Dynamics], Sequence[Any]]


def fused(functions: Sequence[Function]) -> Function:
    """One function with all results of ``functions``, called after them: ``bias_and_mass_matrix``.

    Raises
    ------
    InputError: there is one only, or two have the same result.
    """
    return _fused(tuple(functions))


@cache
def _fused(functions: tuple[Function, ...]) -> Function:
    if len(functions) < 2:
        raise InputError("one function alone cannot be fused", remedy="name two or more, as in --fuse a,b")
    of_pose = next((function for function in functions if function.of_pose), None)
    of_state = next((function for function in functions if not function.of_pose), None)
    if of_pose is not None and of_state is not None:
        raise InputError(
            f"{of_pose.name} and {of_state.name} cannot be fused",
            found="one is of a pose, the other of joint positions: they have no work in common",
            remedy="leave one of them out",
        )
    results: dict[str, str] = {}
    for function in functions:
        for array in function.results:
            if array.name in results:
                raise InputError(
                    f"{results[array.name]} and {function.name} cannot be fused",
                    found=f"both give {array.name}",
                    remedy="leave one of them out",
                )
            results[array.name] = function.name
    for function in functions:
        for array in function.inputs:
            if array.name in results:
                raise InputError(
                    f"{results[array.name]} and {function.name} cannot be fused",
                    found=f"{array.name} is a result of one and an input of the other",
                    remedy="leave one of them out",
                )
    known = [array for array in INPUTS if any(array in function.inputs for function in functions)]
    more = {array: None for function in functions for array in function.inputs if array not in known}
    unconditional = all(f.expected is not None and f.condition is None for f in functions)
    *before, last = (function.words for function in functions)
    return Function(
        AND.join(function.name for function in functions),
        f"{', '.join(before)} and {last}, which share their work",
        (*known, *more),
        tuple(array for function in functions for array in function.results),
        one_after_another([function.outputs for function in functions]),
        expected=one_after_another([f.expected for f in functions if f.expected]) if unconditional else None,
        condition=None if unconditional or of_pose else _compared(functions),
        solves=any(function.solves for function in functions),
        geometric=all(function.geometric for function in functions),
        answers=None if of_pose is None else of_pose.answers,
        fuses=functions,
    )


def one_after_another(writings: Sequence[Writing], order: Sequence[int] = ()) -> Writing:
    """What ``writings`` give, one after another. In the ``order`` of these numbers each chooses what takes
    the fewest operations beside what others have chosen."""

    def written(at: Dynamics) -> list[Any]:
        values = {k: writings[k](at) for k in order or range(len(writings))}
        return [x for k in range(len(writings)) for x in values[k]]

    return written


def _compared(functions: Sequence[Function]) -> Callable[[ReferenceDynamics, Sequence[Any], Vector], Pair]:
    def compared(at: ReferenceDynamics, result: Sequence[Any], anywhere: Vector) -> Pair:
        one: list[Any] = []
        other: list[Any] = []
        for function, elements in parts_of(functions, result, len(anywhere)):
            left, right = function.compared(at, elements, anywhere)
            one += left
            other += right
        return one, other

    return compared


def parts_of(
    functions: Sequence[Function], elements: Sequence[Any], n: int
) -> list[tuple[Function, Sequence[Any]]]:
    """Each function with its part of ``elements``, one after another, for ``n`` joints."""
    parts, start, lengths = [], 0, lengths_of(functions, len(elements), n)
    for function in functions:
        end = start + function.size_at(n, *lengths)
        parts.append((function, elements[start:end]))
        start = end
    return parts
