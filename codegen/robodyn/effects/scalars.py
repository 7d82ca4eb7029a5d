"""Functions of scalars of any kind that arithmetic alone does not have."""

from __future__ import annotations

import math
from typing import Any

from robodyn.ir.graph import Node


def root(x: Any) -> Any:
    """Square root: of a float, a node, an expression of sympy, or of what has a ``sqrt`` of its own."""
    if isinstance(x, Node):
        return x.graph.sqrt(x)
    if hasattr(x, "free_symbols"):
        import sympy

        return sympy.sqrt(x)
    return x.sqrt() if hasattr(x, "sqrt") else math.sqrt(x)


def magnitude(x: Any) -> Any:
    """``|x|``; of a node ``x sgn x``."""
    return x * x.graph.sign(x) if isinstance(x, Node) else abs(x)
