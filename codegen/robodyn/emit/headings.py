"""Headings of groups of intermediate results: what each quantity of the recursion is."""

from __future__ import annotations

import re

from robodyn.ir.program import Label
from robodyn.resources import data_dir

#: What a quantity is, and its unit, for headings.
_LINES = (data_dir("templates") / "quantities.txt").read_text(encoding="utf-8").splitlines()
QUANTITIES: dict[str, str] = {name: meaning for name, _, meaning in (x.partition(": ") for x in _LINES)}
#: Quantities that stand under the heading of another.
_UNDER: dict[str, str] = {
    **dict.fromkeys(("ipivot", "u", "ud"), "pivot"),
    **dict.fromkeys(("ibx", "iby", "ibz", "im"), "ia"),
    **dict.fromkeys(("ebx", "eby", "ebz", "em"), "ea"),
}

#: Where the explanation of a quantity begins, behind its name.
_EXPLANATION = re.compile(r": |, | \[")


def heading_of(label: Label | None) -> str | None:
    """What stands above a value with ``label``; None where nothing is to be said."""
    if label is None:
        return None
    if label.quantity.removesuffix("to").rstrip("0123456789") in ("c", "s", "angle"):
        return QUANTITIES["sc"]
    family = _UNDER.get(label.quantity, label.quantity)
    meaning = QUANTITIES.get(family)
    return meaning if meaning is None or family == "pivot" else f"link {label.link}: {meaning}"


def explained_once(heading: str, explained: set[str]) -> str:
    """``heading`` (``link 3: what it is, of which, in which unit``) in full where the quantity is not among
    those ``explained`` yet, else by its name."""
    place, colon, meaning = heading.partition(": ")
    if not place.startswith("link ") or not colon:
        place, colon, meaning = "", "", heading
    if meaning not in explained:
        explained.add(meaning)
        return heading
    return f"{place}{colon}{_EXPLANATION.split(meaning)[0]}"
