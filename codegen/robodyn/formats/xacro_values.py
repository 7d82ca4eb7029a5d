"""Values of expressions in xacro files: plain data whose size is bounded, operators on them, and what they
can call: functions and methods from data to data.

Each is either of Python's own that cannot do more than its result (whose size is bounded), or is bounded here
before it works. What xacro has beyond that (``vars``, ``hash``, ...) is a name that refuses.
"""

from __future__ import annotations

import ast
import itertools
import math
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
STEPS: Final = 3 * LARGEST
"""[steps] Work for one expression: nodes evaluated, and values and characters produced."""
BITS: Final = 4096
"""[bits] Largest whole number; the largest float has 1024."""
WIDEST: Final = 100
"""[characters] Widest field, and most decimals, of a number in a text."""
_FIELD: Final = re.compile(r"%(?:\(\w*\))?[#0\- +]*(\d*)(?:\.(\d*))?[hlL]?[diouxXeEfFgGcrsa%]")


class Refused(Exception):
    """An expression, or a file, that is not taken; the message says why."""


@dataclass(frozen=True, slots=True, eq=False)
class Function:
    """What an expression can call; ``kind`` is the type that it stands for in ``isinstance``."""

    name: str
    body: Callable[..., Any]
    kind: type | None = None

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        spend(1)
        return bounded(self.body(*arguments, **options))

    def __repr__(self) -> str:
        return f"<function {self.name}>"


@dataclass(frozen=True, slots=True, eq=False)
class Names:
    """A namespace: ``lookup`` gives the value of a name, or raises KeyError."""

    lookup: Callable[[str], Any]


class Budget:
    """The work that was done for an expression, and for those that it needs, in this process."""

    steps = 0


def spend(steps: int) -> None:
    """Count ``steps`` of work.

    Raises
    ------
    Refused: more than :data:`STEPS`.
    """
    Budget.steps += steps
    if Budget.steps > STEPS:
        raise Refused(f"more than {STEPS} steps of work")


def bounded(value: Any) -> Any:
    """``value``, a new one, once it is no larger than values may be."""
    if type(value) not in DATA and not isinstance(value, Function | Names):
        raise Refused(f"a value of the type {type(value).__name__}")
    spend(size_of(value))
    return value


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

_DIGITS: Final = 500
"""[decimal places] Most that a number is rounded to."""


def _list(value: Any = ()) -> list[Any]:
    return list(checked_data(value))


def _range(*ends: int) -> range:
    numbers = range(*ends)
    check_count(len(numbers))
    return numbers


def _round(value: Any, digits: int | None = None) -> Any:
    if digits is None:
        return round(value)
    if abs(digits) > _DIGITS:
        raise Refused(f"more than {_DIGITS} digits")
    return round(value, digits)


def _sum(values: Any, start: Any = 0) -> Any:
    if type(start) is not list:
        return sum(checked_data(values), start)
    if any(type(part) is not list for part in values):
        raise Refused("only a list can be added to a list")
    return [*start, *itertools.chain.from_iterable(values)]


def _zip(*sources: Any) -> list[Any]:
    lists = [_list(source) for source in sources]
    check_count(len(lists) * min(map(len, lists), default=0))
    return list(zip(*lists, strict=False))


def _is_instance(value: Any, kinds: Any) -> bool:
    functions = kinds if type(kinds) is tuple else (kinds,)
    if not all(isinstance(function, Function) and function.kind for function in functions):
        raise Refused("isinstance knows the types bool, int, float, str, list, tuple, dict and set")
    return isinstance(value, tuple(function.kind for function in functions))


def _type(value: Any) -> Function:
    for function in PYTHON.values():
        if function.kind is type(value):
            return function
    raise Refused("a type that is not known")


def _join(separator: str, source: Any) -> str:
    parts = _list(source)
    check_count(size_of(parts) + len(separator) * len(parts))
    return separator.join(parts)


def _replace(text: str, old: str, new: str, count: int = -1) -> str:
    check_count(len(text) + text.count(old) * len(new))
    return text.replace(old, new, count)


def tokenize(text: str, sep: str = ",; ", skip_empty: bool = True) -> list[str]:
    """The parts of ``text`` between the characters of ``sep``.

    Raises
    ------
    Refused: ``sep`` is more than characters (xacro takes it for a class of a regular expression).
    """
    if not sep or sep[0] == "^" or set(sep) & set("[]\\") or "-" in sep[1:-1]:
        raise Refused("xacro.tokenize takes plain characters as separators")
    return [part for part in re.split(f"[{re.escape(sep)}]", text) if part or not skip_empty]


def _table(functions: Mapping[str, Callable[..., Any]]) -> dict[str, Function]:
    return {name: Function(name, function) for name, function in functions.items()}


_KINDS: Final[Mapping[type, Callable[..., Any]]] = {
    bool: lambda value=False: bool(checked_data(value)),
    int: int,
    float: float,
    str: lambda value="": str(checked_data(value)),
    list: _list,
    tuple: lambda value=(): tuple(checked_data(value)),
    dict: lambda *pairs, **entries: dict(*map(checked_data, pairs), **entries),
    set: lambda value=(): set(checked_data(value)),
}
#: xacro's namespace ``python``.
PYTHON: Final[Mapping[str, Function]] = {
    **{kind.__name__: Function(kind.__name__, call, kind=kind) for kind, call in _KINDS.items()},
    **_table(
        {
            "map": lambda function, *sources: list(itertools.starmap(function, _zip(*sources))),
            "filter": lambda function, source: list(filter(function, _list(source))),
            "sorted": lambda source, **order: sorted(checked_data(source), **order),
            "min": lambda *values, **options: min(*map(checked_data, values), **options),
            "max": lambda *values, **options: max(*map(checked_data, values), **options),
            "len": lambda value: len(checked_data(value)),
            "abs": abs,
            "all": lambda values: all(checked_data(values)),
            "any": lambda values: any(checked_data(values)),
            "divmod": divmod,
            "enumerate": lambda values, start=0: list(enumerate(checked_data(values), start)),
            "isinstance": _is_instance,
            "ord": ord,
            "range": _range,
            "repr": lambda value: repr(checked_data(value)),
            "reversed": lambda values: list(reversed(_list(values))),
            "round": _round,
            "sum": _sum,
            "type": _type,
            "zip": _zip,
        }
    ),
}
_PLAIN_MATH: Final = (
    "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "cbrt", "ceil", "copysign", "cos",
    "cosh", "degrees", "dist", "erf", "erfc", "exp", "exp2", "expm1", "fabs", "floor", "fma", "fmod",
    "frexp", "fsum", "gamma", "gcd", "hypot", "isclose", "isfinite", "isinf", "isnan", "isqrt", "ldexp",
    "lgamma", "log", "log10", "log1p", "log2", "modf", "nextafter", "pow", "radians", "remainder", "sin",
    "sinh", "sqrt", "sumprod", "tan", "tanh", "trunc", "ulp",
)  # fmt: skip

#: xacro's namespace ``math``.
MATH: Final[Mapping[str, Any]] = {
    **{name: getattr(math, name) for name in ("e", "inf", "nan", "pi", "tau")},
    **_table({name: getattr(math, name) for name in _PLAIN_MATH if hasattr(math, name)}),
}
_TEXT: Final = (
    "capitalize", "casefold", "count", "endswith", "find", "index", "isalnum", "isalpha", "isascii",
    "isdecimal", "isdigit", "isidentifier", "islower", "isnumeric", "isspace", "istitle", "isupper",
    "lower", "lstrip", "partition", "removeprefix", "removesuffix", "rfind", "rindex", "rpartition",
    "rsplit", "rstrip", "split", "splitlines", "startswith", "strip", "swapcase", "title", "upper",
)  # fmt: skip

#: The methods of values, by type; no others are there.
METHODS: Final[Mapping[type, Mapping[str, Function]]] = {
    str: {
        **_table({name: getattr(str, name) for name in _TEXT}),
        **_table({"join": _join, "replace": _replace}),
    },
    list: _table({name: getattr(list, name) for name in ("copy", "count", "index")}),
    tuple: _table({name: getattr(tuple, name) for name in ("count", "index")}),
    dict: _table(
        {
            "copy": dict.copy,
            "get": dict.get,
            "items": lambda entries: list(entries.items()),
            "keys": lambda entries: list(entries),
            "values": lambda entries: list(entries.values()),
        }
    ),
    float: _table({"is_integer": float.is_integer}),
}
