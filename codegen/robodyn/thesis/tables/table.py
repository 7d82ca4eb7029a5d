"""A table that stands beside a printed one: for every row the printed figure, ours, a verdict, a reason."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

from robodyn.counts import Count

Verdict = Literal["reproduced", "differs", "not recoverable"]
Part = Literal["printed", "ours", "row"]
#: Told what is being worked on.
Progress = Callable[[str], None]


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
    """A column of the text: a heading, and where its figure is, among printed ones, ours, or the row's own
    fields. ``below``: on a line of its own, being long."""

    head: str
    part: Part
    key: str
    below: bool = False


@dataclass(frozen=True, slots=True)
class Table:
    """A table with its rows; ``notes`` hold for all of it."""

    id: str
    title: str
    columns: tuple[Column, ...]
    rows: tuple[Row, ...]
    notes: tuple[str, ...] = ()

    def row(self, name: str) -> Row:
        """The row of that name; :class:`KeyError` if there is none."""
        for row in self.rows:
            if row.name == name:
                return row
        raise KeyError(name)

    def to_dict(self) -> dict[str, Any]:
        """As ``tables --json`` prints it."""
        return {
            "id": self.id,
            "title": self.title,
            "rows": [row.to_dict() for row in self.rows],
            "notes": list(self.notes),
        }


def pair(mul: int, add: int) -> dict[str, int]:
    """Multiplications and additions as JSON holds them."""
    return {"mul": mul, "add": add, "total": mul + add}


def counted(count: Count) -> dict[str, int]:
    """A count as JSON holds it; divisions and square roots only where there are any."""
    extra = {"div": count.div, "sqrt": count.sqrt}
    return {**pair(count.mul, count.add), **{kind: amount for kind, amount in extra.items() if amount}}


def summed(*counts: Count) -> Count:
    """The sum of counts, their operations kind by kind."""
    return Count(
        mul=sum(c.mul for c in counts),
        add=sum(c.add for c in counts),
        div=sum(c.div for c in counts),
        sqrt=sum(c.sqrt for c in counts),
    )


def apart(printed: tuple[int, int], ours: tuple[int, int]) -> str:
    """How ours stands to a printed pair, in words."""
    words = [
        f"{abs(x)} {'more' if x > 0 else 'fewer'} {what}"
        for x, what in ((ours[0] - printed[0], "multiplications"), (ours[1] - printed[1], "additions"))
        if x
    ]
    return "ours has " + " and ".join(words) if words else "the same operations"


def judged(same: bool) -> Verdict:
    """``reproduced`` or ``differs``."""
    return "reproduced" if same else "differs"
