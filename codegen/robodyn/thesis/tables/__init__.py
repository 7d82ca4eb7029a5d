"""The thesis's tables beside ours: the printed figure, ours recomputed, a verdict, and the reason.

>>> make("2.9").row("revolute I, n").verdict                     # doctest: +SKIP
'differs'
"""

from __future__ import annotations

import importlib
import inspect
from typing import Final

from robodyn.errors import InputError
from robodyn.thesis.tables.table import Progress, Row, Table, Verdict
from robodyn.thesis.tables.text import to_text

_HOMES: Final = {
    "1.1": "table_1_1",
    "2.4": "table_2_4",
    "2.6": "table_2_6",
    "2.9": "table_2_9",
    "2.10": "table_2_10",
    "3.1": "table_3_1",
    "3.3": "table_3_3",
    "3.4": "table_3_4",
    "3.5": "table_3_5",
    "4.1": "table_4_1",
    "4.2": "table_4_2",
    "4.4": "table_4_4",
    "4.5": "table_4_5",
    "4.6": "table_4_6",
    "4.8": "table_4_8",
    "equations": "equations",
    "inverse": "program_d_1_3",
    "friction": "friction_tasks",
    "schedules": "schedules",
    "claims": "claims",
    "robots": "robots",
}

#: All tables, by the names that they are asked for.
TABLE_IDS: Final = tuple(_HOMES)

__all__ = ["TABLE_IDS", "Row", "Table", "Verdict", "make", "to_text"]


def make(table_id: str, progress: Progress = lambda _: None) -> Table:
    """The table ``table_id``, recomputed; ``progress`` is told what is being worked on.

    Raises
    ------
    InputError: there is no such table.
    """
    if table_id not in _HOMES:
        raise InputError(
            f"no table {table_id!r}",
            expected=f"one of {', '.join(TABLE_IDS)}",
            remedy="omit the table for all of them",
        )
    build = importlib.import_module(f"robodyn.thesis.tables.{_HOMES[table_id]}").table
    table = build(progress) if "progress" in inspect.signature(build).parameters else build()
    assert isinstance(table, Table)
    return table
