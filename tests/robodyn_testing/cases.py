"""Which cases of a test over all robots, effects, functions ... stay in ``make test``."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from typing import Any

import pytest

__all__ = ["covering", "representative", "sampled"]

_Param = type(pytest.param())


def representative(cases: Iterable[Any], *few: Any, rest: str = "thorough") -> list[Any]:
    """Return `cases` for ``pytest.mark.parametrize``, all but `few` of them marked with `rest`.

    A case may be a tuple of several arguments or a ``pytest.param`` with an id; it is among `few` if it
    equals one of them, or if its id or its first argument does.

    Raises ``ValueError`` for one of `few` that is no case: a renamed robot must not empty ``make test``.
    """
    marked: list[Any] = []
    missing = list(few)
    for param in map(_param, cases):
        keys = [key for key in (param.values, param.values[0], param.id) if key is not None]
        chosen = [one for one in few if any(_equal(one, key) for key in keys)]
        missing = [one for one in missing if not any(_equal(one, other) for other in chosen)]
        marked.append(param if chosen else _marked(param, rest))
    if missing:
        raise ValueError(f"no such case: {', '.join(map(repr, missing))}")
    return marked


def sampled(cases: Iterable[Any], every: int, rest: str = "thorough") -> list[Any]:
    """Return `cases` for ``pytest.mark.parametrize``, all but the first of `every` so many marked `rest`."""
    params = map(_param, cases)
    return [_marked(param, rest) if k % every else param for k, param in enumerate(params)]


def covering(*axes: Iterable[Any], rest: str = "slow") -> list[Any]:
    """Return all combinations of `axes` for ``pytest.mark.parametrize``, all but a few marked with `rest`.

    Every value of every axis is in one of the few at least, unless it is marked itself
    (:func:`representative`): they take the values of each axis in turn.
    """
    rows = [[_param(value) for value in axis] for axis in axes]
    quick = [[k for k, param in enumerate(row) if not param.marks] for row in rows]
    turns = max(map(len, quick)) if all(quick) else 0
    few = {tuple(row[turn % len(row)] for row in quick) for turn in range(turns)}
    marked: list[Any] = []
    for places in itertools.product(*(range(len(row)) for row in rows)):
        parts = [row[k] for row, k in zip(rows, places, strict=True)]
        values = [value for part in parts for value in part.values]
        param = pytest.param(*values, marks=[mark for part in parts for mark in part.marks])
        marked.append(param if places in few else _marked(param, rest))
    return marked


def _param(case: Any) -> Any:
    if isinstance(case, _Param):
        return case
    return pytest.param(*case) if isinstance(case, tuple) else pytest.param(case)


def _marked(param: Any, mark: str) -> Any:
    marks: Sequence[Any] = [*param.marks, getattr(pytest.mark, mark)]
    return pytest.param(*param.values, marks=marks, id=param.id)


def _equal(one: Any, other: Any) -> bool:
    return type(one) is type(other) and bool(one == other)
