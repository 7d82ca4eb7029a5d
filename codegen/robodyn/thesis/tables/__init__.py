"""The thesis's tables beside ours: the printed figure, ours recomputed, a verdict, and the reason.

>>> make("2.9").row("revolute I, n").verdict                     # doctest: +SKIP
'differs'
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Final

from robodyn.errors import InputError
from robodyn.thesis.printed import data
from robodyn.thesis.tables.table import Row, Table, Verdict, table_of, to_text, words_of

#: All tables, by the names that they are asked for.
TABLE_IDS: Final = tuple(name for name, words in data("tables").items() if "by" in words)

__all__ = ["TABLE_IDS", "Row", "Table", "Verdict", "make", "to_text"]


def make(table_id: str, progress: Callable[[str], None] = lambda _: None) -> Table:
    """The table ``table_id``, recomputed; ``progress`` is told the names of the rows that are done.

    Raises
    ------
    InputError: there is no such table.
    """
    if table_id not in TABLE_IDS:
        raise InputError(
            f"no table {table_id!r}",
            expected=f"one of {', '.join(TABLE_IDS)}",
            remedy="omit the table for all of them",
        )
    words = words_of(table_id)
    module, _, function = words["by"].partition(".")
    made = getattr(importlib.import_module(f"{__package__}.{module}"), function)()
    rows, figures = made if isinstance(made, tuple) else (made, {})
    done = []
    for row in rows:
        progress(row.name)
        done.append(row)
    return table_of(done, words, table_id, **figures)
