"""What a position of a graph is: an operation over positions, as a tuple."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

#: ``("mul", i, j)``, ``("add", i, relative sign, j)``, ``("scale", factor, i)``, ``("sqrt", i, sign)``,
#: ``("pow", i, sign, j, sign)``, ``("const", value)``, ``("input", Input)``.
Key = tuple[Any, ...]

#: Operations whose keys have a sign behind every operand.
SIGNED = frozenset(("sqrt", "exp", "pow", "atan2", "select"))
#: Those of them that change sign with these operands (from 0), all together; the first of these has the
#: sign 1 in a key.
ODD = {"atan2": (0,), "select": (1, 2)}


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
    if op in SIGNED:
        return key[1::2]
    return key[1:]


def signed_operands(key: Key, own: int = 1) -> tuple[tuple[int, int], ...]:
    """The positions that ``key``, one of ``SIGNED``, reads, each with the sign it is read with where
    the value is wanted with the sign ``own``, -1 only of :data:`ODD` operations."""
    operands = tuple(zip(key[1::2], key[2::2], strict=True))
    if own > 0:
        return operands
    odd = ODD[key[0]]
    return tuple([(p, -s if k in odd else s) for k, (p, s) in enumerate(operands)])


#: What may be a value plus a constant.
_OFFSET = ("add", "const")


def plain_sum(keys: Sequence[Key], i: int, j: int) -> bool:
    """Whether a sum of what stands at two positions of ``keys`` is an addition, and nothing simpler: no
    multiple of one value, no sum of two constants."""
    one, other = keys[i], keys[j]
    if one[0] == "scale" or other[0] == "scale":
        return multiple(one, i)[1] != multiple(other, j)[1]
    if one[0] in _OFFSET and other[0] in _OFFSET:
        return i != j and not (_has_constant(keys, one) and _has_constant(keys, other))
    return i != j


def multiple(key: Key, position: int) -> tuple[Fraction | int, int]:
    """What stands at ``position`` as a factor times a position."""
    return (key[1], key[2]) if key[0] == "scale" else (1, position)


def _has_constant(keys: Sequence[Key], key: Key) -> bool:
    """Whether the constant or sum ``key`` has a constant in it."""
    return bool(key[0] == "const" or keys[key[1]][0] == "const" or keys[key[3]][0] == "const")
