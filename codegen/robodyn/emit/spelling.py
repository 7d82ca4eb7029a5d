"""How a language is written: numbers, operators, statements and long lines."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from robodyn.emit.loops import Run
from robodyn.emit.statements import Apply, Expression, Statement
from robodyn.errors import InputError
from robodyn.ir.program import Input

WIDTH = 100

# Binding strength of the operators, weakest first; a name or a call binds strongest.
_SUM, _PRODUCT, _UNARY, _ATOM = 1, 2, 3, 4
_OPERATORS = {"add": ("+", _SUM), "sub": ("-", _SUM), "mul": ("*", _PRODUCT), "div": ("/", _PRODUCT)}


def elements(
    states: Sequence[str], of_state: str, of_array: str, *, first: int = 0
) -> Callable[[str, int], str]:
    """How a language writes element number ``i`` of an array, from 0.

    ``states`` are the members of ``state``, where a function has one, written as ``of_state`` with the
    member's name; it has the number ``dt`` then. Other arrays are ``of_array``, with the array's name and the
    element's number, counted from ``first``.
    """

    def element(array: str, i: int) -> str:
        if array == "dt":
            return array
        return of_state.format(states[i]) if array == "state" else of_array.format(array, i + first)

    return element


def call(name: str) -> Callable[..., str]:
    """A function that is written as the call of ``name``."""
    return lambda *arguments: f"{name}({', '.join(arguments)})"


def functions_of(pattern: str) -> dict[str, Callable[..., str]]:
    """The functions that mathematical libraries have, each called as ``pattern`` with its name."""
    names = ("sin", "cos", "tanh", "sqrt", "exp", "pow", "atan2", "abs")
    return {name: call(pattern.format(name)) for name in names}


@dataclass(frozen=True, slots=True)
class Spelling:
    """Numbers and operators: how a literal, an input and the functions are written; ``single`` for float."""

    literal: Callable[[str], str]
    element: Callable[[str, int], str]
    member: Callable[[str], str]
    functions: Mapping[str, Callable[..., str]]
    single: bool
    continuation: str = ""
    #: Whether products within sums stand in parentheses, as MISRA C:2012 wants it.
    explicit: bool = False
    #: The sign of a product; that of the others has blanks about it.
    times: str = "*"

    def calling(self, **functions: Callable[..., str]) -> Spelling:
        """The same with other ``functions``."""
        return replace(self, functions={**self.functions, **functions})

    def number(self, value: Fraction) -> str:
        """``value`` rounded once to the scalar type, in the fewest digits that give it back."""
        return self.literal(shortest(value, single=self.single))

    def text(self, expression: Expression) -> str:
        """``expression`` in this language; parentheses keep its grouping, so that its rounding is
        the program's."""
        return self._text(expression)[0]

    def row(self, expressions: Sequence[Expression]) -> str:
        """``expressions`` with commas between them."""
        return ", ".join(map(self.text, expressions))

    def _text(self, expression: Expression) -> tuple[str, int]:
        if isinstance(expression, str):
            return expression, _ATOM
        if isinstance(expression, Apply):
            return self._operation(expression)
        if isinstance(expression, Input):
            if expression.index is None:
                return self.member(expression.array), _ATOM
            return self.element(expression.array, expression.index), _ATOM
        return self.number(expression), (_UNARY if expression.numerator < 0 else _ATOM)

    def _operation(self, expression: Apply) -> tuple[str, int]:
        op, args = expression
        if op == "neg":
            text, strength = self._text(args[0])
            return ("-" + (text if strength == _ATOM else f"({text})")), _UNARY
        if op not in _OPERATORS:
            if op not in self.functions:
                raise InputError(
                    f"this language has no {op}", remedy=f"add {op} to the functions of its Spelling"
                )
            return self.functions[op](*(self._text(arg)[0] for arg in args)), _ATOM
        symbol, own = _OPERATORS[op]
        (left, left_strength), (right, right_strength) = map(self._text, args)
        if left_strength < own or (self.explicit and own < left_strength < _ATOM):
            left = f"({left})"
        explicit = self.explicit and own < right_strength < _ATOM
        if explicit or right_strength <= own or right.startswith("-"):  # Fortran forbids two signs in a row
            right = f"({right})"
        return (f"{left}{self.times}{right}" if op == "mul" else f"{left} {symbol} {right}"), own

    def wrapped(self, line: str, indent: str) -> list[str]:
        """``line`` on as many lines as it needs, broken at blanks."""
        room = WIDTH - len(self.continuation)
        if len(indent) + len(line) <= room:
            return [indent + line]
        lines: list[str] = []
        current = indent
        for word in line.split(" "):
            if current.strip() and len(current) + 1 + len(word) > room:
                lines.append(current + self.continuation)
                current = f"{indent}    {word}"
            else:
                current += f" {word}" if current.strip() else word
        return [*lines, current]


@dataclass(frozen=True, slots=True)
class Sines:
    """How a language calls our sine and cosine: for all angles at once, and for one pair."""

    all: Callable[[Sequence[Expression]], list[str]]
    pair: Callable[[str, Expression], list[str]]
    #: Our arctangent of a run of points in one loop; None where that gains nothing.
    run: Callable[[Run], list[str]] | None = None


@dataclass(frozen=True, slots=True)
class Syntax:
    """The statements of a language: the one place where a named value becomes a line of text.

    ``declare(name, text)`` and ``assign(target, text)`` give statements; ``comment`` has ``%s`` in the text's
    place.
    """

    spelling: Spelling
    comment: str
    declare: Callable[[str, str], str]
    assign: Callable[[str, str], str]
    sines: Sines | None = None
    indent: str = "    "
    #: Where it is not None, no statement is broken: one that does not fit on a line, or with arguments of a
    #: call that are longer, is written in parts, each with a name.
    longest_call: int | None = None

    def statement(self, statement: Statement) -> list[str]:
        """The lines of ``statement``, its heading first."""
        heading = [self.indent + self.comment % statement.heading] if statement.heading else []
        expression = statement.expression
        before: list[str] = []
        while self.longest_call is not None and not self._fits(statement.name, expression):
            # The longest part that fits on a line gets a name.
            name = f"{statement.name}_p{len(before) + 1}"
            fitting = [part for part in _proper_parts(expression) if self._fits(name, part)]
            if not fitting:
                break
            longest = max(fitting, key=lambda part: len(self.spelling.text(part)))
            before += self.line(self.declare(name, self.spelling.text(longest)))
            expression = _replaced(expression, longest, name)
        return [*heading, *before, *self.line(self.declare(statement.name, self.spelling.text(expression)))]

    def _fits(self, name: str, expression: Expression) -> bool:
        text = self.spelling.text(expression)
        return len(self.indent + self.declare(name, text)) <= WIDTH and self._calls_fit(expression)

    def _calls_fit(self, expression: Expression) -> bool:
        if not isinstance(expression, Apply) or self.longest_call is None:
            return True
        is_call = expression.op in self.spelling.functions
        if is_call and len(self.spelling.row(expression.args)) > self.longest_call:
            return False
        return all(map(self._calls_fit, expression.args))

    def result(self, target: str, expression: Expression) -> list[str]:
        """The lines of ``target = expression``."""
        return self.line(self.assign(target, self.spelling.text(expression)))

    def line(self, text: str) -> list[str]:
        """A ready statement, on as many lines as it needs."""
        if self.longest_call is not None and len(self.indent + text) > WIDTH:
            target, _, value = text.partition(" = ")
            return [f"{self.indent}{target} =", f"{self.indent}    {value}"]
        return self.spelling.wrapped(text, self.indent)


def _proper_parts(expression: Expression) -> list[Apply]:
    """The operations within ``expression``, itself left out."""
    inner = (
        [arg for arg in expression.args if isinstance(arg, Apply)] if isinstance(expression, Apply) else []
    )
    return inner + [part for arg in inner for part in _proper_parts(arg)]


def _replaced(expression: Expression, part: Apply, name: str) -> Expression:
    if expression == part:
        return name
    if isinstance(expression, Apply):
        return Apply(expression.op, tuple(_replaced(arg, part, name) for arg in expression.args))
    return expression


#: The smallest normal numbers: below them digits are lost, and compilers complain.
_SMALLEST = {True: 2.0**-126, False: 2.0**-1022}


def shortest(value: Fraction, *, single: bool) -> str:
    """The shortest decimal that reads back as ``value`` rounded to double or float.

    :class:`InputError` where the type has no normal number near it.
    """
    try:
        numerator, denominator = value.as_integer_ratio()
        rounded = nearest_float(value) if single else numerator / denominator
        if value and abs(rounded) <= _SMALLEST[single] and abs(value) < _SMALLEST[single]:
            raise OverflowError("below the smallest normal number")
    except OverflowError:
        kind = "float" if single else "double"
        raise InputError(
            f"a number that follows from the robot's does not fit into a {kind}",
            found=f"about 1e{len(str(abs(value.numerator))) - len(str(value.denominator))}",
            expected=f"its size between {'1.2e-38 and 3.4e38' if single else '2.3e-308 and 1.7e308'}",
            remedy="check the units of the robot file" + (" or use --scalar double" if single else ""),
        ) from None
    for digits in range(1, 10) if single else ():
        text = f"{rounded:.{digits}g}"
        try:
            if nearest_float(Fraction(text)) == rounded:
                return repr(float(text))
        except OverflowError:  # fewer digits may lie beyond the largest float
            continue
    return repr(rounded)


def nearest_float(value: Fraction) -> float:
    """``value`` rounded once to IEEE single precision, ties to even; :class:`OverflowError` beyond it."""
    if not value:
        return 0.0
    size = abs(value)
    exponent = size.numerator.bit_length() - size.denominator.bit_length()  # size is near 2**exponent
    if size < Fraction(2) ** exponent:
        exponent -= 1
    step = Fraction(2) ** (max(exponent, -126) - 23)  # of the 24 digits, or of the subnormal numbers
    rounded = round(size / step) * step  # Python rounds halves to even
    if rounded >= Fraction(2) ** 128:
        raise OverflowError("beyond the largest float")
    return float(rounded if value > 0 else -rounded)
