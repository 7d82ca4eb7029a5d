"""What expressions of xacro files can call: functions and methods from data to data.

Each is either of Python's own that cannot do more than its result (whose size the evaluator bounds), or is
bounded here before it works. What xacro has beyond that (``vars``, ``hash``, ...) is a name that refuses.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from functools import reduce
from itertools import chain
from typing import Any, Final

from robodyn.formats.xacro_expressions import Evaluator
from robodyn.formats.xacro_values import BITS, DATA, Function, Refused, check_count, size_of

_MOST: Final = 500
"""Largest argument of factorials and binomials; 500! has 3768 bits."""


def _data(value: Any) -> Any:
    if type(value) not in DATA:
        raise Refused("a function is not a value")
    return value


def _list(value: Any = ()) -> list[Any]:
    return list(_data(value))


def _range(*ends: int) -> range:
    numbers = range(*ends)
    check_count(len(numbers))
    return numbers


def _round(value: Any, digits: int | None = None) -> Any:
    if digits is None:
        return round(value)
    if abs(digits) > _MOST:
        raise Refused(f"more than {_MOST} digits")
    return round(value, digits)


def _sum(values: Any, start: Any = 0) -> Any:
    if type(start) is not list:
        return sum(_data(values), start)
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
    return sorted(_data(source), key=_key(evaluator, key), reverse=bool(reverse))


def _least(evaluator: Evaluator, *values: Any, key: Any = None, **default: Any) -> Any:
    return min(*map(_data, values), key=_key(evaluator, key), **default)


def _greatest(evaluator: Evaluator, *values: Any, key: Any = None, **default: Any) -> Any:
    return max(*map(_data, values), key=_key(evaluator, key), **default)


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


def _factorial(function: Callable[..., int]) -> Callable[..., int]:
    def bounded(*arguments: int) -> int:
        if any(argument > _MOST for argument in arguments):
            raise Refused(f"math.{function.__name__} of more than {_MOST}")
        return function(*arguments)

    return bounded


def _whole(value: Any) -> Any:
    if type(value) is int and value.bit_length() > BITS:
        raise Refused(f"a whole number of more than {BITS} bits")
    return value


def _product(values: Any, start: Any = 1) -> Any:
    return reduce(lambda so_far, factor: _whole(math.prod((so_far, factor))), values, start)


def _common_multiple(*numbers: int) -> int:
    return reduce(lambda so_far, factor: int(_whole(math.lcm(so_far, factor))), numbers, 1)


def _join(separator: str, source: Any) -> str:
    parts = _list(source)
    check_count(size_of(parts) + len(separator) * len(parts))
    return separator.join(parts)


def _replace(text: str, old: str, new: str, count: int = -1) -> str:
    check_count(len(text) + text.count(old) * len(new))
    return text.replace(old, new, count)


def _padded(method: Callable[..., str]) -> Callable[..., str]:
    def bounded(text: str, width: int, *fill: str) -> str:
        check_count(width)
        return method(text, width, *fill)

    return bounded


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
    bool: lambda value=False: bool(_data(value)),
    int: int,
    float: float,
    str: lambda value="": str(_data(value)),
    list: _list,
    tuple: lambda value=(): tuple(_data(value)),
    dict: lambda *pairs, **entries: dict(*map(_data, pairs), **entries),
    set: lambda value=(): set(_data(value)),
}
#: xacro's namespace ``python``.
PYTHON: Final[Mapping[str, Function]] = {
    **{kind.__name__: Function(kind.__name__, call, kind=kind) for kind, call in _KINDS.items()},
    **_table(
        {"map": _map, "filter": _filter, "sorted": _sorted, "min": _least, "max": _greatest}, higher=True
    ),
    **_table(
        {
            "len": lambda value: len(_data(value)),
            "abs": abs,
            "all": lambda values: all(_data(values)),
            "any": lambda values: any(_data(values)),
            "divmod": divmod,
            "enumerate": lambda values, start=0: list(enumerate(_data(values), start)),
            "isinstance": _is_instance,
            "ord": ord,
            "range": _range,
            "repr": lambda value: repr(_data(value)),
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
    **_table({name: _factorial(getattr(math, name)) for name in ("factorial", "comb", "perm")}),
    **_table({"prod": _product, "lcm": _common_multiple}),
}
_TEXT: Final = (
    "capitalize", "casefold", "count", "endswith", "find", "index", "isalnum", "isalpha", "isascii",
    "isdecimal", "isdigit", "isidentifier", "islower", "isnumeric", "isspace", "istitle", "isupper",
    "lower", "lstrip", "partition", "removeprefix", "removesuffix", "rfind", "rindex", "rpartition",
    "rsplit", "rstrip", "split", "splitlines", "startswith", "strip", "swapcase", "title", "upper",
)  # fmt: skip

_PADDED: Final = ("center", "ljust", "rjust", "zfill")
#: The methods of values, by type; no others are there.
METHODS: Final[Mapping[type, Mapping[str, Function]]] = {
    str: {
        **_table({name: getattr(str, name) for name in _TEXT}),
        **_table({name: _padded(getattr(str, name)) for name in _PADDED}),
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
