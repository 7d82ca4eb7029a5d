"""A table that stands beside a printed one: for every row the printed figure, ours, a verdict, a reason; and
its text, aligned, reasons as numbered remarks beneath."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

from robodyn.counts import Count
from robodyn.draw.tables import aligned
from robodyn.thesis.printed import data

Verdict = Literal["reproduced", "differs", "not recoverable"]
WIDTH = 110


@dataclass(frozen=True, slots=True)
class Row:
    """A row: figures by name, as JSON holds them, printed and ours.

    ``verdict`` is None where nothing is printed. ``beside``: what else is to be seen there, another tool's
    count or ours by another convention.
    """

    name: str
    printed: Mapping[str, Any]
    ours: Mapping[str, Any]
    verdict: Verdict | None
    reason: str
    beside: tuple[Mapping[str, Any], ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """As ``tables --json`` prints it."""
        return {
            "row": self.name,
            "printed": dict(self.printed),
            "ours": dict(self.ours),
            "verdict": self.verdict,
            "reason": self.reason,
            "beside": [dict(other) for other in self.beside],
        }


@dataclass(frozen=True, slots=True)
class Column:
    """A column of the text: a heading, and ``place`` of its figure: ``printed.``, ``ours.`` or ``row.`` and a
    name."""

    head: str
    place: str

    def figure(self, row: Row) -> Any:
        """Its figure in ``row``."""
        part, _, key = self.place.partition(".")
        if part == "row":
            return getattr(row, key)
        return (row.printed if part == "printed" else row.ours).get(key)


@dataclass(frozen=True, slots=True)
class Table:
    """A table with its rows; columns ``below`` stand on lines of their own, ``notes`` hold for all of it."""

    id: str
    title: str
    columns: tuple[Column, ...]
    below: tuple[Column, ...]
    rows: tuple[Row, ...]
    notes: tuple[str, ...]

    def row(self, name: str) -> Row:
        """The row of that name; :class:`KeyError` if there is none."""
        for row in self.rows:
            if row.name == name:
                return row
        raise KeyError(name)

    def to_dict(self) -> dict[str, Any]:
        """As ``tables --json`` prints it."""
        rows = [row.to_dict() for row in self.rows]
        return {"id": self.id, "title": self.title, "rows": rows, "notes": list(self.notes)}


def words_of(table: str) -> dict[str, Any]:
    """What ``data/tables.yaml`` has of a table."""
    words: dict[str, Any] = data("tables")[table]
    return words


def table_of(rows: Iterable[Row], words: Mapping[str, Any], table_id: str, **figures: Any) -> Table:
    """The table of those rows and words, ``figures`` put into its title and notes."""
    columns, below = (
        tuple(Column(*pair) for column in words.get(key, ()) for pair in column.items())
        for key in ("columns", "below")
    )
    notes = tuple(note.format_map(figures) for note in words["notes"])
    return Table(table_id, words["title"].format_map(figures), columns, below, tuple(rows), notes)


# --- figures ----------------------------------------------------------------------------------------------


def pair(mul: int, add: int) -> dict[str, int]:
    """Multiplications and additions as JSON holds them."""
    return {"mul": mul, "add": add, "total": mul + add}


def count_data(count: Count) -> dict[str, int]:
    """A count as JSON holds it; divisions and square roots only where there are any."""
    extra = {"div": count.div, "sqrt": count.sqrt}
    return {**pair(count.mul, count.add), **{kind: amount for kind, amount in extra.items() if amount}}


def summed(counts: Iterable[Count]) -> Count:
    """The sum of counts, their operations kind by kind."""
    kinds = [(count.mul, count.add, count.div, count.sqrt) for count in counts]
    return Count(*map(sum, zip(*kinds, strict=True)))


def compared_count(
    name: str,
    printed: tuple[int, int],
    ours: Count,
    reasons: Mapping[str, str],
    same: str,
    beside: tuple[Mapping[str, Any], ...] = (),
) -> Row:
    """A row of operations: ``same`` is the reason where ours are the printed ones, else the one that
    ``reasons`` has for this difference."""
    mul, add = ours.mul - printed[0], ours.add - printed[1]
    reason = reasons.get(f"{name}: {mul} {add}", "not explained" if mul or add else same)
    if mul or add:
        reason = f"{difference_in_words(printed, ours)}: {reason}"
    operations = {"operations": pair(*printed)}, {"operations": count_data(ours)}
    return Row(name, *operations, verdict_of(not (mul or add)), reason, beside)


def difference_in_words(printed: tuple[int, int], ours: Count) -> str:
    """How ours stands to a printed pair, in words."""
    words = [
        f"{abs(x)} {'more' if x > 0 else 'fewer'} {what}"
        for x, what in ((ours.mul - printed[0], "multiplications"), (ours.add - printed[1], "additions"))
        if x
    ]
    return "ours has " + " and ".join(words) if words else "the same operations"


def verdict_of(same: bool) -> Verdict:
    """``reproduced`` or ``differs``."""
    return "reproduced" if same else "differs"


# --- text -------------------------------------------------------------------------------------------------


def to_text(table: Table) -> str:
    """``table`` for a person, no line beyond 110 columns if words allow it."""
    remarks: dict[str, int] = {}
    for row in table.rows:
        if row.reason:
            remarks.setdefault(row.reason, len(remarks) + 1)
    cells = [("", *(column.head for column in table.columns), "verdict", "")]
    for row in table.rows:
        figures = (figure_text(column.figure(row)) for column in table.columns)
        mark = f"[{remarks[row.reason]}]" if row.reason else ""
        cells.append((row.name, *figures, row.verdict or "-", mark))
    head, *lines = aligned(cells, left=range(len(cells[0])))
    text = [f"{'Table ' if table.id[0].isdigit() else ''}{table.id}: {table.title}", "", head]
    for row, line in zip(table.rows, lines, strict=True):
        text.append(line)
        for column in table.below:
            figure = column.figure(row)
            if figure is not None:
                text += _wrapped(f"{column.head}: ", figure_text(figure), "    ")
        if row.beside:
            text += _wrapped("beside: ", "; ".join(map(_beside, row.beside)), "    ")
    text.append("")
    for reason, reference in remarks.items():
        text += _wrapped(f"[{reference}] ", reason)
    for note in table.notes:
        text += _wrapped("", note)
    return "\n".join(text).rstrip() + "\n"


def _wrapped(head: str, text: str, indent: str = "") -> list[str]:
    beneath = indent + " " * (len(head) or 2)
    return textwrap.wrap(
        text, WIDTH, initial_indent=indent + head, subsequent_indent=beneath,
        break_on_hyphens=False, break_long_words=False,
    )  # fmt: skip


def figure_text(figure: Any) -> str:
    """A figure for a person: ``92/76 = 168`` for operations, ``-`` for none."""
    if figure is None:
        return "-"
    if isinstance(figure, Mapping) and figure.keys() >= {"mul", "add", "total"}:
        operations = "" if figure["mul"] is None else f"{figure['mul']}/{figure['add']} = "
        others = (f", {figure[kind]} {kind}" for kind in ("div", "sqrt") if figure.get(kind))
        return f"{operations}{figure['total']}{''.join(others)}"
    if isinstance(figure, Mapping):
        return ", ".join(f"{key}: {figure_text(value)}" for key, value in figure.items())
    if isinstance(figure, list | tuple):
        return " ".join(figure_text(x) for x in figure) if figure else "none"
    return f"{figure:.6g}" if isinstance(figure, float) else str(figure)


def _beside(other: Mapping[str, Any]) -> str:
    figures = {key: value for key, value in other.items() if key not in ("tool", "what", "source")}
    gap = " " if figures.keys() >= {"mul", "add", "total"} else ": "
    return f"{other.get('tool') or other.get('what')}{gap}{figure_text(figures)}"
