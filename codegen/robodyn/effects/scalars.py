"""Functions of scalars of any kind that arithmetic alone does not have.

A scalar is a float, a ``Fraction``, a node of a graph, a sympy expression, a numpy array (of many states), or
anything that has a method of the function's name.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from robodyn.ir.evaluate import selected
from robodyn.ir.graph import Node

# Exact where there is nothing to round.
_AT_ZERO = {"sqrt": 0, "exp": 1, "tanh": 0, "sin": 0, "cos": 1, "sign": 0}
_PLAIN: dict[str, Callable[[Any], Any]] = {
    "sqrt": math.sqrt,
    "exp": math.exp,
    "log": math.log,
    "tanh": math.tanh,
    "sin": math.sin,
    "cos": math.cos,
    "sign": lambda x: (x > 0) - (x < 0),
}


def _call(name: str, x: Any) -> Any:
    graph = getattr(x, "graph", None)  # of a node, or of what stands in for one
    if graph is not None:
        return getattr(graph, name)(x)
    if hasattr(x, "free_symbols"):
        import sympy

        return getattr(sympy, name)(x)
    if hasattr(x, "dtype"):
        import numpy as np

        return getattr(np, name)(x)
    if hasattr(x, "context"):  # mpmath's numbers
        return getattr(x.context, name)(x)
    if hasattr(x, name):
        return getattr(x, name)()
    return _AT_ZERO[name] if x == 0 and name in _AT_ZERO else _PLAIN[name](x)


def quotient(x: Any, y: Any) -> Any:
    """``x / y``; of integers a fraction."""
    return Fraction(x, y) if isinstance(x, int) and isinstance(y, int) else x / y


def root(x: Any) -> Any:
    """Square root."""
    return _call("sqrt", x)


def exponential(x: Any) -> Any:
    """``e^x``."""
    return _call("exp", x)


def tangent(x: Any) -> Any:
    """Hyperbolic tangent."""
    return _call("tanh", x)


def sine(x: Any) -> Any:
    """Sine of ``x`` [rad]."""
    return _call("sin", x)


def cosine(x: Any) -> Any:
    """Cosine of ``x`` [rad]."""
    return _call("cos", x)


def arctangent(y: Any, x: Any) -> Any:
    """The angle of the point (``x``, ``y``) [rad], within [-pi, pi]; 0 of two zeros."""
    for each in (y, x):
        if hasattr(each, "graph"):
            return each.graph.atan2(y, x)
    for each in (y, x):
        if hasattr(each, "free_symbols"):
            import sympy

            return sympy.atan2(y, x) if y != 0 or x != 0 else 0
        if hasattr(each, "dtype"):
            import numpy as np

            of_y, of_x = (z if hasattr(z, "dtype") else float(z) for z in (y, x))
            return np.arctan2(of_y, of_x)
        if hasattr(each, "context"):  # mpmath's numbers
            return each.context.atan2(y, x)
    if hasattr(y, "atan2"):
        return y.atan2(x)
    if hasattr(x, "atan2"):
        return (y + 0 * x).atan2(x)
    return 0 if y == 0 <= x else math.atan2(y, x)


def choose(condition: Any, a: Any, b: Any) -> Any:
    """``a`` where ``condition`` is more than 0, else (also where that is no number) ``b``."""
    if hasattr(condition, "graph"):
        return condition.graph.select(condition, a, b)
    if hasattr(condition, "free_symbols"):
        import sympy

        return sympy.Piecewise((a, condition > 0), (b, True))
    if hasattr(condition, "select"):
        return condition.select(a, b)
    return selected(condition, a, b)


def sign(x: Any) -> Any:
    """-1, 0 or 1; 0 of what is no number, in every language and for every scalar."""
    value = _call("sign", x)
    if hasattr(x, "dtype"):
        import numpy as np

        return np.nan_to_num(value)
    return value


def magnitude(x: Any) -> Any:
    """``|x|``."""
    if isinstance(x, Node):
        return x.graph.abs(x)
    return abs(x)


def power(x: Any, exponent: Any) -> Any:
    """``x^exponent`` for ``x`` of 0 or more; small whole powers are products."""
    if not isinstance(exponent, Node) and not hasattr(exponent, "dtype") and exponent in (1, 2, 3, 4):
        square = x if exponent == 1 else x * x
        return square if exponent <= 2 else square * (x if exponent == 3 else square)
    graph = next((each.graph for each in (x, exponent) if isinstance(each, Node)), None)
    if graph is not None:
        return graph.pow(x, exponent)
    if hasattr(x, "free_symbols") or hasattr(exponent, "free_symbols"):
        import sympy

        return sympy.Pow(x, exponent)
    if hasattr(x, "dtype") or hasattr(exponent, "dtype"):
        import numpy as np

        return np.power(x, exponent if hasattr(exponent, "dtype") else float(exponent))
    return math.pow(x, exponent)


def positive_part(x: Any) -> Any:
    """The greater of ``x`` and 0."""
    return (x + magnitude(x)) / 2


def clamped(x: Any, low: Any, high: Any) -> Any:
    """``x``, or the nearest of ``low`` and ``high``."""
    return low + positive_part(x - low) - positive_part(x - high)


# --- what keeps a state whole where a sample is infinite or no number ---------------------------------------
# Of all that programs have, only sgn(nan) = 0 and nan^0 = 1 (C99 F.9.4.4, IEEE 754 9.2.1) are numbers again.


def is_positive(x: Any) -> Any:
    """1 where ``x`` is more than 0, else 0; 0 of what is no number."""
    return positive_part(sign(x))


def is_finite(x: Any) -> Any:
    """1, or 0 where ``x`` is infinite or no number."""
    return sign(1 / (1 + magnitude(x)))


def is_duration(dt: Any) -> Any:
    """1 where ``dt`` is 0 or more, 0 where it is negative, infinite or no number."""
    return is_finite(dt) * (1 - is_positive(-dt))


def updated_if(good: Any, new: Any, old: Any) -> Any:
    """``new`` where ``good`` is 1, bit for bit, and ``old`` where it is 0, whatever ``new`` is then."""
    return power(new, good) * good + old * (1 - good)


def is_zero(value: Any) -> bool:
    """Whether ``value`` is the number zero (a node, an expression or an array is not)."""
    if isinstance(value, Node) or hasattr(value, "free_symbols") or getattr(value, "shape", None):
        return False
    return bool(value == 0)


def logarithm(x: Any) -> Any:
    """Natural logarithm; not of a node."""
    return _call("log", x)
