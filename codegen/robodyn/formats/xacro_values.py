"""Values of expressions in xacro files: plain data whose size is bounded, and the operators on them."""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Final

#: Values that an expression may have, by their exact types: none of them has code of the file's.
DATA: Final = frozenset({bool, int, float, str, type(None), list, tuple, dict, set, range})
_MANY: Final = (list, tuple, set)
LARGEST: Final = 100_000
"""[values and characters] Largest value, what it holds included; the tables of a large robot have 5000."""
BITS: Final = 4096
"""[bits] Largest whole number; the largest float has 1024."""
WIDEST: Final = 100
"""[characters] Widest field, and most decimals, of a number in a text."""
_FIELD: Final = re.compile(r"%(?:\(\w*\))?[#0\- +]*(\d*)(?:\.(\d*))?[hlL]?[diouxXeEfFgGcrsa%]")


class Refused(Exception):
    """An expression, or a file, that is not taken; the message says why."""


@dataclass(frozen=True, slots=True, eq=False)
class Function:
    """What an expression can call. ``call`` gets the arguments, and before them the evaluator if ``higher``,
    since it calls functions itself; ``kind`` is the type that it stands for in ``isinstance``."""

    name: str
    call: Callable[..., Any]
    higher: bool = False
    kind: type | None = None

    def __repr__(self) -> str:
        return f"<function {self.name}>"


@dataclass(frozen=True, slots=True, eq=False)
class Names:
    """A namespace: ``lookup`` gives the value of a name, or raises KeyError."""

    lookup: Callable[[str], Any]


def shown(text: str) -> str:
    """The start of ``text`` for a message, in quotes."""
    return repr(text[:80])


def checked_data(value: Any) -> Any:
    """``value`` itself, one of :data:`DATA`; what else an expression may have is refused."""
    if type(value) not in DATA:
        raise Refused("a function is not a value")
    return value


def size_of(value: Any) -> int:
    """How many values and characters ``value`` has; what it holds twice counts twice.

    Raises
    ------
    Refused: more than :data:`LARGEST`, or a number of more than :data:`BITS`.
    """
    size, left = 0, [value]
    while left:
        item = left.pop()
        size += 1
        if type(item) is str:
            size += len(item)
        elif type(item) is int and item.bit_length() > BITS:
            raise Refused(f"a whole number of more than {BITS} bits")
        elif type(item) is dict:
            left.extend(item)
            left.extend(item.values())
        elif type(item) in _MANY:
            left.extend(item)
        elif type(item) is range:
            size += len(item)
        if size + len(left) > LARGEST:
            raise Refused(f"a value of more than {LARGEST} elements or characters")
    return size


def check_count(count: int) -> None:
    """Refuse a result that would have ``count`` values or characters, before there is one.

    Raises
    ------
    Refused: more than :data:`LARGEST`.
    """
    if count > LARGEST:
        raise Refused(f"a value of more than {LARGEST} elements or characters")


def _multiply(left: Any, right: Any) -> Any:
    for value, count in ((left, right), (right, left)):
        if type(value) in (str, list, tuple) and isinstance(count, int):
            check_count((len(value) if type(value) is str else size_of(value)) * max(count, 0))
    return left * right


def _power(left: Any, right: Any) -> Any:
    whole = isinstance(left, int) and isinstance(right, int) and abs(left) > 1
    if whole and left.bit_length() * right > 2 * BITS:
        raise Refused(f"a whole number of more than {BITS} bits")
    return left**right


def _remainder(left: Any, right: Any) -> Any:
    if type(left) is str:
        fields = list(_FIELD.finditer(left))
        widths = [int(digits or 0) for field in fields for digits in field.group(1, 2)]
        if "%" in _FIELD.sub("", left) or max(widths, default=0) > WIDEST:
            raise Refused("a field of a text that is not known, or too wide")
        check_count((WIDEST + size_of(right)) * len(fields))
    return left % right


Operator = Callable[..., Any]
BINARY: Final[Mapping[type, Operator]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: _multiply,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: _remainder,
    ast.Pow: _power,
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
}
UNARY: Final[Mapping[type, Operator]] = {
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
    ast.Not: operator.not_,
    ast.Invert: operator.invert,
}
COMPARISONS: Final[Mapping[type, Operator]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.In: lambda left, right: left in right,
    ast.NotIn: lambda left, right: left not in right,
}
