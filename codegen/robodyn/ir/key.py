"""What a position of a graph is: an operation over positions, as a tuple."""

from __future__ import annotations

from typing import Any

#: ``("mul", i, j)``, ``("add", i, relative sign, j)``, ``("scale", factor, i)``, ``("sqrt", i, sign)``,
#: ``("pow", i, sign, j, sign)``, ``("const", value)``, ``("input", Input)``.
Key = tuple[Any, ...]


def children(key: Key) -> tuple[int, ...]:
    """Positions that ``key`` reads."""
    op = key[0]
    if op == "mul":
        return key[1:]
    if op == "add":
        return (key[1], key[3])
    if op == "scale":
        return (key[2],)
    if op in ("input", "const"):
        return ()
    if op in ("sqrt", "exp"):
        return (key[1],)
    if op == "pow":
        return (key[1], key[3])
    return key[1:]
