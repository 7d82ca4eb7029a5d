"""What expressions of xacro files can call: functions and methods from data to data.

Each is either of Python's own that cannot do more than its result (whose size the evaluator bounds), or is
bounded here before it works. What xacro has beyond that (``vars``, ``hash``, ...) is a name that refuses.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from itertools import chain
from typing import Any, Final

from robodyn.formats.xacro_expressions import Evaluator
from robodyn.formats.xacro_values import Function, Refused, check_count, checked_data, size_of

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
    return [*start, *chain.from_iterable(values)]


def _zip(*sources: Any) -> list[Any]:
    lists = [_list(source) for source in sources]
    check_count(len(lists) * min(map(len, lists), default=0))
    return list(zip(*lists, strict=False))


def _map(evaluator: Evaluator, function: Any, *sources: Any) -> list[Any]:
    return [evaluator.call(function, *arguments) for arguments in _zip(*sources)]


def _filter(evaluator: Evaluator, function: Any, source: Any) -> list[Any]:
    values = _list(source)
    return [value for value in values if (value if function is None else evaluator.call(function, value))]


def _key(evaluator: Evaluator, key: Any) -> Callable[[Any], Any] | None:
    return None if key is None else lambda value: evaluator.call(key, value)


def _sorted(evaluator: Evaluator, source: Any, key: Any = None, reverse: Any = False) -> list[Any]:
    return sorted(checked_data(source), key=_key(evaluator, key), reverse=bool(reverse))


def _extremum(choose: Any) -> Callable[..., Any]:
    def bounded(evaluator: Evaluator, *values: Any, key: Any = None, **default: Any) -> Any:
        return choose(*map(checked_data, values), key=_key(evaluator, key), **default)

    return bounded


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


def _table(functions: Mapping[str, Callable[..., Any]], **options: Any) -> dict[str, Function]:
    return {name: Function(name, function, **options) for name, function in functions.items()}


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
        {"map": _map, "filter": _filter, "sorted": _sorted, "min": _extremum(min), "max": _extremum(max)},
        higher=True,
    ),
    **_table(
        {
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
