"""Which cases of a test over all robots, effects, functions ... stay in ``make test``."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest

__all__ = ["representative"]


def representative(cases: Iterable[Any], *few: Any, ids: Iterable[str] | None = None) -> list[Any]:
    """Return `cases` for ``pytest.mark.parametrize``, all but `few` of them marked ``thorough``.

    A case may be a tuple of several arguments or a ``pytest.param`` with an id; it is among `few` if it
    equals one of them, or if its id or its first argument does. With `ids`, one a case, the cases get them.

    Raises ``ValueError`` for one of `few` that is no case: a renamed robot must not empty ``make test``.
    """
    marked: list[Any] = []
    missing = list(few)
    names = list(ids) if ids is not None else None
    for index, case in enumerate(cases):
        is_param = isinstance(case, type(pytest.param()))
        values = tuple(case.values) if is_param else case if isinstance(case, tuple) else (case,)
        id = names[index] if names is not None else case.id if is_param else None
        keys = [key for key in (case, values, values[0] if values else None, id) if key is not None]
        chosen = [one for one in few if any(_equal(one, key) for key in keys)]
        missing = [one for one in missing if not any(_equal(one, other) for other in chosen)]
        marks = [*(case.marks if is_param else ()), *([] if chosen else [pytest.mark.thorough])]
        marked.append(pytest.param(*values, marks=marks, id=id))
    if missing:
        raise ValueError(f"no such case: {', '.join(map(repr, missing))}")
    return marked


def _equal(one: Any, other: Any) -> bool:
    return type(one) is type(other) and bool(one == other)
