"""Tables as text: aligned columns, reasons as numbered remarks beneath."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from typing import Any

from robodyn.thesis.tables.table import Column, Row, Table

WIDTH = 110


def to_text(table: Table) -> str:
    """``table`` for a person, no line beyond 110 columns if words allow it."""
    above = [column for column in table.columns if not column.below]
    remarks: dict[str, int] = {}
    for row in table.rows:
        if row.reason:
            remarks.setdefault(row.reason, len(remarks) + 1)
    heads = ("", *(column.head for column in above), "verdict", "")
    cells = [
        (row.name, *(shown(_figure(row, c)) for c in above), row.verdict or "-", _mark(row, remarks))
        for row in table.rows
    ]
    lines = [_heading(table), ""]
    widths = [max(len(line[k]) for line in (heads, *cells)) for k in range(len(heads))]
    lines.append(_aligned(heads, widths))
    for row, line in zip(table.rows, cells, strict=True):
        lines.append(_aligned(line, widths))
        for column in table.columns:
            figure = _figure(row, column)
            if column.below and figure is not None:
                lines += _wrapped(f"{column.head}: ", shown(figure), "    ")
        if row.beside:
            lines += _wrapped("beside: ", "; ".join(map(_beside, row.beside)), "    ")
    lines.append("")
    for reason, reference in remarks.items():
        lines += _wrapped(f"[{reference}] ", reason, "")
    for note in table.notes:
        lines += _wrapped("", note, "")
    return "\n".join(lines).rstrip() + "\n"


def _heading(table: Table) -> str:
    return f"Table {table.id}: {table.title}" if table.id[0].isdigit() else f"{table.id}: {table.title}"


def _figure(row: Row, column: Column) -> Any:
    if column.part == "row":
        return getattr(row, column.key)
    return (row.printed if column.part == "printed" else row.ours).get(column.key)


def _mark(row: Row, remarks: Mapping[str, int]) -> str:
    return f"[{remarks[row.reason]}]" if row.reason else ""


def _aligned(cells: Sequence[str], widths: Sequence[int]) -> str:
    return "  ".join(cell.ljust(width) for cell, width in zip(cells, widths, strict=True)).rstrip()


def _wrapped(head: str, text: str, indent: str) -> list[str]:
    return textwrap.wrap(
        text,
        WIDTH,
        initial_indent=indent + head,
        subsequent_indent=indent + " " * (len(head) or 2),
        break_on_hyphens=False,
        break_long_words=False,
    )


def shown(figure: Any) -> str:
    """A figure for a person: ``92/76 = 168`` for operations, ``-`` for none."""
    if figure is None:
        return "-"
    if isinstance(figure, Mapping) and figure.keys() >= {"mul", "add", "total"}:
        text = f"{figure['total']}"
        if figure["mul"] is not None:
            text = f"{figure['mul']}/{figure['add']} = {figure['total']}"
        for kind, name in (("div", "div"), ("sqrt", "sqrt")):
            if figure.get(kind):
                text += f", {figure[kind]} {name}"
        return text
    if isinstance(figure, Mapping):
        return ", ".join(f"{key}: {shown(value)}" for key, value in figure.items())
    if isinstance(figure, list | tuple):
        return " ".join(shown(x) for x in figure) if figure else "none"
    if isinstance(figure, float):
        return f"{figure:.6g}"
    return str(figure)


def _beside(other: Mapping[str, Any]) -> str:
    what = str(other.get("tool") or other.get("what"))
    figures = {key: value for key, value in other.items() if key not in ("tool", "what", "source")}
    if figures.keys() >= {"mul", "add", "total"}:
        return f"{what} {shown(figures)}"
    return f"{what}: {shown(figures)}"
