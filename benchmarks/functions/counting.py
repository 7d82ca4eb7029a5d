"""Operations of what a tool has made: of CasADi's instructions, and of the Python that others write.

As we count our own: every binary ``*`` is a multiplication, every binary ``+`` or ``-`` an addition,
divisions and square roots are one each; unary minus, sines and cosines are free. ``x**2`` is one ``*``.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import Any

from robodyn.counts import Count


class Uncounted(Exception):
    """An operation that there is no rule for."""


# --- CasADi -----------------------------------------------------------------------------------------------

_CASADI = {
    "OP_ADD": "add", "OP_SUB": "add", "OP_MUL": "mul", "OP_SQ": "mul", "OP_TWICE": "mul", "OP_DIV": "div",
    "OP_INV": "div", "OP_SQRT": "sqrt", "OP_NEG": "neg", "OP_SIN": "sincos", "OP_COS": "sincos",
    "OP_CONST": None, "OP_INPUT": None, "OP_OUTPUT": None, "OP_ASSIGN": None,
}  # fmt: skip


def of_casadi(function: Any) -> Count:
    """The operations of a function of SX.

    Raises
    ------
    Uncounted: it has others than arithmetic, sine, cosine and square root.
    """
    import casadi

    kinds = {getattr(casadi, name): kind for name, kind in _CASADI.items()}
    totals: dict[str, int] = {}
    for k in range(function.n_instructions()):
        operation = function.instruction_id(k)
        if operation not in kinds:
            raise Uncounted(f"operation {operation} of CasADi")
        kind = kinds[operation]
        if kind is not None:
            totals[kind] = totals.get(kind, 0) + 1
    return Count(**totals)


# --- Python text ------------------------------------------------------------------------------------------

_BINARY = {ast.Add: "add", ast.Sub: "add", ast.Mult: "mul", ast.Div: "div"}
_CALLS = {"sin": "sincos", "cos": "sincos", "sqrt": "sqrt"}
_FREE = {"float64", "array", "reshape", "zeros", "asarray", "IndexError", "format"}


def of_python(text: str) -> Count:
    """The operations of the one function that ``text`` defines.

    Raises
    ------
    Uncounted: it has others than arithmetic, sine, cosine and square root.
    """
    (function,) = (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef))
    totals: dict[str, int] = {}
    for node in ast.walk(function):
        for kind, amount in _kinds(node):
            totals[kind] = totals.get(kind, 0) + amount
    return Count(**totals)


def _kinds(node: ast.AST) -> Iterator[tuple[str, int]]:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
        yield from _power(node)
    elif isinstance(node, ast.BinOp):
        yield _BINARY[type(node.op)], 1
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        if not isinstance(node.operand, ast.Constant):
            yield "neg", 1
    elif isinstance(node, ast.Call):
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "?")
        if name in _CALLS:
            yield _CALLS[name], 1
        elif name not in _FREE:
            raise Uncounted(f"a call of {name}")


def _power(node: ast.BinOp) -> Iterator[tuple[str, int]]:
    """By a whole number, as repeated squaring has it; a division more where it is negative."""
    exponent = ast.literal_eval(node.right)
    if not isinstance(exponent, int) or exponent == 0:
        raise Uncounted(f"a power of {exponent}")
    size = abs(exponent)
    products = size.bit_length() - 1 + size.bit_count() - 1
    if products:
        yield "mul", products
    if exponent < 0:
        yield "div", 1
