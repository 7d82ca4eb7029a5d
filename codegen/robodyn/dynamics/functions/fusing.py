"""Several functions in one, which share what they have in common."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

from robodyn.dynamics.functions.record import INPUTS, Function, Pair, Writing, cut, lengths_of
from robodyn.dynamics.state import Dynamics, ReferenceDynamics, Vector
from robodyn.errors import InputError

#: What stands between the names of functions that are fused.
AND = "_and_"


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

    def refusal(one: str, other: str, found: str) -> InputError:
        return InputError(f"{one} and {other} cannot be fused", found=found, remedy="leave one of them out")

    of_pose = next((function for function in functions if function.of_pose), None)
    of_state = next((function for function in functions if not function.of_pose), None)
    if of_pose is not None and of_state is not None:
        found = "one is of a pose, the other of joint positions: they have no work in common"
        raise refusal(of_pose.name, of_state.name, found)
    results: dict[str, str] = {}
    for function in functions:
        for array in function.results:
            if array.name in results:
                raise refusal(results[array.name], function.name, f"both give {array.name}")
            results[array.name] = function.name
    for function in functions:
        for array in function.inputs:
            if array.name in results:
                found = f"{array.name} is a result of one and an input of the other"
                raise refusal(results[array.name], function.name, found)
    inputs = {array for function in functions for array in function.inputs}
    unconditional = all(f.expected is not None and f.condition is None for f in functions)
    *before, last = (function.words for function in functions)
    return Function(
        AND.join(function.name for function in functions),
        f"{', '.join(before)} and {last}, which share their work",
        tuple(array for array in INPUTS if array in inputs),
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
        for function, elements in parts_of(functions, result, len(anywhere), at.link_count):
            left, right = function.compared(at, elements, anywhere)
            one += left
            other += right
        return one, other

    return compared


def parts_of(
    functions: Sequence[Function], elements: Sequence[Any], n: int, links: int = 0
) -> list[tuple[Function, Sequence[Any]]]:
    """Each function with its part of ``elements``, one after another, for ``n`` joints and so many ``links``,
    by default as many."""
    lengths = lengths_of(functions, len(elements), n, links)
    sizes = [function.size_at(n, *lengths, links) for function in functions]
    return list(zip(functions, cut(elements, sizes), strict=True))
