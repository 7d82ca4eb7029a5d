"""The functions that kernels may have: every file of this folder lists some in ``FUNCTIONS``.

Nothing else knows a function by name. To add one is to add a file (CONTRIBUTING.md, "Add a function").
"""

from __future__ import annotations

import importlib
from collections.abc import Collection, Iterable, Sequence
from pathlib import Path
from typing import Any

from robodyn.dynamics.functions.fusing import AND, fused
from robodyn.dynamics.functions.record import INPUTS, SC, WITH_WRENCH, Array, Function, Pair
from robodyn.dynamics.state import Dynamics, Moving, NoSuchFunction, Rotor
from robodyn.effects.scalars import is_zero
from robodyn.errors import InputError

__all__ = [
    "FUNCTIONS",
    "INPUTS",
    "Array",
    "Dynamics",
    "Function",
    "Moving",
    "NoSuchFunction",
    "Pair",
    "Rotor",
    "array_named",
    "arrays",
    "by_default",
    "emitted_name",
    "function_named",
    "pushed",
    "recursion",
    "registered",
    "torques_at",
]


def registered(functions: Iterable[Function]) -> dict[str, Function]:
    """``functions`` by name, those that are written by default first.

    Raises
    ------
    ValueError: two have one name, two results of one name are not the same, or a part is missing.
    """
    table: dict[str, Function] = {}
    arrays = {array.name: array for array in (*INPUTS, SC)}
    for function in sorted(functions, key=lambda function: not function.by_default):
        if function.name in table:
            raise ValueError(f"two functions are called {function.name!r}")
        table[function.name] = function
        for result in function.results:
            if arrays.setdefault(result.name, result) != result:
                raise ValueError(
                    f"function {function.name!r}: the array {result.name!r} is {arrays[result.name].text!r} "
                    "elsewhere; choose another name"
                )
    for function in table.values():
        missing = [part for part in function.parts if part not in table]
        if missing:
            raise ValueError(f"function {function.name!r}: no such parts: {', '.join(missing)}")
        for _, name, array, *_ in function.derivatives:
            if name not in table or array not in {result.name for result in table[name].results}:
                raise ValueError(f"function {function.name!r}: its derivative {array!r} is not in {name!r}")
    return table


def _records() -> Iterable[Function]:
    for file in sorted(Path(__file__).parent.glob("[!_]*.py")):
        yield from getattr(importlib.import_module(f"{__name__}.{file.stem}"), "FUNCTIONS", ())


#: Every function by its name, those that are written by default first.
FUNCTIONS: dict[str, Function] = registered(_records())


def function_named(name: str) -> Function:
    """The function called ``name``; ``a_and_b`` is ``a`` and ``b`` in one.

    Raises
    ------
    InputError: there is none; says which there are.
    """
    function = FUNCTIONS.get(name)
    if function is None and AND in name:
        return fused([function_named(part) for part in name.split(AND)])
    if function is None:
        import difflib

        close = difflib.get_close_matches(name, FUNCTIONS, n=1)
        raise InputError(
            f"unknown function {name!r}",
            expected=f"one of {', '.join(FUNCTIONS)}",
            remedy=f"did you mean {close[0]!r}?" if close else "choose one of those",
        )
    return function


def arrays() -> dict[str, Array]:
    """Every array of an interface by its name."""
    results = (result for function in FUNCTIONS.values() for result in function.results)
    return {array.name: array for array in (*INPUTS, SC, *results)}


def array_named(name: str) -> Array:
    """The array of an interface that is called ``name``.

    Raises
    ------
    InputError: no function has one.
    """
    table = arrays()
    if name not in table:
        raise InputError(f"unknown array {name!r}", expected=f"one of {', '.join(table)}")
    return table[name]


def torques_at(qd: Sequence[Any], qdd: Sequence[Any]) -> Function:
    """The function that gives the recursion's torques for these velocities and accelerations ``[n]``, some of
    which are zero throughout."""
    zeros = tuple(name for name, x in (("qd", qd), ("qdd", qdd)) if all(map(is_zero, x)))
    functions = {function.zeros: function for function in FUNCTIONS.values()}
    return functions.get(zeros, functions[()])


def recursion() -> Function:
    """The inverse dynamics, which formulations and ways of writing are of."""
    return next(function for function in FUNCTIONS.values() if function.is_recursion)


def pushed(name: str) -> str:
    """The function like ``name`` that has a wrench on the tool as a further input; ``name`` where there is
    none."""
    other = name + WITH_WRENCH
    return other if other in FUNCTIONS else name


def emitted_name(name: str, others: Collection[str]) -> str:
    """What the function ``name`` is called in code that has functions called ``others``: one with a wrench
    like the one without, unless that is there as well; one that stands behind another of its name, as the
    record says."""
    if name in FUNCTIONS and FUNCTIONS[name].emitted:
        return FUNCTIONS[name].emitted
    without = AND.join(part.removesuffix(WITH_WRENCH) for part in name.split(AND))
    return name if without in others else without


def by_default() -> tuple[str, ...]:
    """Names of the functions that are written unless others are named."""
    return tuple(name for name, function in FUNCTIONS.items() if function.by_default)
