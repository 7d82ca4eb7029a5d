"""The emitted C read back: is it, operation by operation, the program that the bounds are of?

The function's text is parsed by pycparser, which knows nothing of robodyn, and both are written as values:
an input, a number of the type, or an operation on values. Equal outputs are the same operations in the same
grouping, on the same numbers; the order of independent operations rounds nothing differently.
"""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

from robodyn.certify.forward import as_scalar
from robodyn.errors import CheckError
from robodyn.ir.program import Input, Operand, Program
from robodyn.ir.signature import Signature

_BINARY = {"+": "add", "-": "sub", "*": "mul", "/": "div"}
_CALLS = re.compile(r"(sin|cos|fabs)f?\Z")
_NUMBER = re.compile(r"([0-9.]+(?:e[+-]?[0-9]+)?)f?\Z")


class Values:
    """Values as numbers: equal ones are one."""

    def __init__(self, scalar: str) -> None:
        self.scalar = scalar
        self._known: dict[tuple[Any, ...], int] = {}

    def of(self, *key: Any) -> int:
        """The value that ``key`` says: what it is, and of which values."""
        return self._known.setdefault(key, len(self._known))

    def constant(self, value: Fraction) -> int:
        """A number once it is rounded to the type."""
        return self.of("number", as_scalar(value, self.scalar))


def check_read_back(text: str, signature: Signature, program: Program) -> None:
    """Make sure that the function of ``signature`` in the C ``text`` is ``program``.

    Raises
    ------
    CheckError: it is not, or cannot be read.
    """
    values = Values(signature.scalar)
    meant = [value for _, elements in _meant(program, values) for value in elements]
    try:
        outputs = _Reader(text, signature, values).outputs()
    except (ValueError, KeyError, AttributeError, IndexError) as error:
        raise CheckError(f"{signature.symbol} cannot be read back from its C: {error}") from None
    if outputs != meant:
        raise CheckError(f"{signature.symbol}: the C is not the program that the bounds are of")


def _meant(program: Program, values: Values) -> list[tuple[str, list[int]]]:
    nodes: list[int] = []

    def value(operand: Operand) -> int:
        if isinstance(operand, int):
            return nodes[operand]
        if isinstance(operand, Input):
            return values.of("input", operand.array, operand.index)
        return values.constant(operand)

    for op, args, _ in program.operations:
        nodes.append(values.of(op, *map(value, args)))
    return [(name, [value(x) for x in elements]) for name, elements in program.outputs]


class _Reader:
    """The statements of one function, run on values."""

    def __init__(self, text: str, signature: Signature, values: Values) -> None:
        from pycparser import CParser, c_ast

        self.c = c_ast
        self.signature, self.values = signature, values
        self.names: dict[str, int] = {}
        self.places: dict[tuple[str, int], int] = {
            (array, i): values.of("input", array, i) for array, size in signature.inputs for i in range(size)
        }
        self.plain = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
        self.parse = CParser().parse
        if signature.parameters:
            raise ValueError("run-time parameters")
        self._enter(signature.symbol)

    def outputs(self) -> list[int]:
        """The values of all outputs, one after another."""
        return [self.places[array, i] for array, size in self.signature.outputs for i in range(size)]

    def _enter(self, symbol: str, arguments: list[str] | None = None) -> None:
        """Run a function; a second one, on the arrays ``arguments``, calls them as the first does."""
        bodies = re.findall(rf"^(?:\w+ )?(void {symbol}\(.*?^}})", self.plain, re.M | re.S)
        if len(bodies) != 1:
            raise ValueError(f"there is no function {symbol}, or more than one")
        real = f"typedef {self.signature.scalar} {self.signature.robot}_real;\n"
        function = self.parse(real + bodies[0]).ext[-1]
        if arguments is not None and arguments != [p.name for p in function.decl.type.args.params]:
            raise ValueError(f"{symbol} calls its arrays otherwise")
        outside, self.names = self.names, {}
        for statement in function.body.block_items or []:
            self._run(statement)
        self.names = outside

    def _run(self, statement: Any) -> None:
        c = self.c
        if isinstance(statement, c.Decl):
            self._declare(statement)
        elif isinstance(statement, c.Assignment):
            self.places[self._place(statement.lvalue)] = self._value(statement.rvalue)
        elif isinstance(statement, c.For):  # sine and cosine of each angle
            for i in range(int(statement.cond.right.value)):
                self.names["i"] = i
                for inner in statement.stmt.block_items:
                    self._run(inner)
        elif isinstance(statement, c.FuncCall):
            if statement.name.name == f"{self.signature.symbol}_given_":
                self._enter(statement.name.name, [x.name for x in statement.args.exprs])
                return
            angle, sine, cosine = statement.args.exprs
            if not statement.name.name.endswith("_sincos_"):
                raise ValueError(f"a call of {statement.name.name}")
            value = self._value(angle)
            self.places[self._place(sine.expr)] = self.values.of("sin", value)
            self.places[self._place(cosine.expr)] = self.values.of("cos", value)
        elif not isinstance(statement, c.Cast):  # (void)unused
            raise ValueError(f"a statement of kind {type(statement).__name__}")

    def _declare(self, statement: Any) -> None:
        initial = statement.init
        if isinstance(initial, self.c.InitList):
            for i, expression in enumerate(initial.exprs):
                self.places[statement.name, i] = self._value(expression)
        elif initial is not None:
            self.names[statement.name] = self._value(initial)

    def _place(self, expression: Any) -> tuple[str, int]:
        index = expression.subscript
        i = int(index.value) if isinstance(index, self.c.Constant) else self.names[index.name]
        return expression.name.name, i

    def _value(self, expression: Any) -> int:
        c, values = self.c, self.values
        if isinstance(expression, c.Constant):
            match = _NUMBER.match(expression.value)
            if match is None:
                raise ValueError(f"the number {expression.value}")
            return values.constant(Fraction(match[1]))
        if isinstance(expression, c.ID):
            return self.names[expression.name]
        if isinstance(expression, c.ArrayRef):
            return self.places[self._place(expression)]
        if isinstance(expression, c.BinaryOp):
            return values.of(
                _BINARY[expression.op], self._value(expression.left), self._value(expression.right)
            )
        if isinstance(expression, c.UnaryOp) and expression.op == "-":
            if isinstance(expression.expr, c.Constant):
                return values.constant(-Fraction(expression.expr.value.removesuffix("f")))
            return values.of("neg", self._value(expression.expr))
        if isinstance(expression, c.FuncCall):
            match = _CALLS.match(expression.name.name)
            own = expression.name.name == f"{self.signature.robot}_abs_"
            if match is None and not own:
                raise ValueError(f"a call of {expression.name.name}")
            name = "abs" if match is None or match[1] == "fabs" else match[1]
            return values.of(name, self._value(expression.args.exprs[0]))
        if isinstance(expression, c.TernaryOp):
            return self._sign(expression)
        raise ValueError(f"an expression of kind {type(expression).__name__}")

    def _sign(self, expression: Any) -> int:
        """``x > 0 ? 1 : (x < 0 ? -1 : 0)``, and nothing else."""
        inner = expression.iffalse
        x, again = expression.cond.left, inner.cond.left
        parts = (expression.cond.right, expression.iftrue, inner.cond.right, inner.iftrue, inner.iffalse)
        numbers = [self._value(part) for part in parts]
        wanted = [self.values.constant(Fraction(k)) for k in (0, 1, 0, -1, 0)]
        shape = (expression.cond.op, inner.cond.op)
        if shape != (">", "<") or numbers != wanted or self._value(x) != self._value(again):
            raise ValueError("a choice that is no sign")
        return self.values.of("sign", self._value(x))
