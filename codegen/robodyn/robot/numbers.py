"""The small number parser: numbers, ``pi``, ``+ - * / ( )`` and nothing else.

Text from a robot file is read here and nowhere else; it never reaches ``eval``. Results are exact
rationals. Where names are allowed a number may be affine in run-time parameters (``m_tool``,
``0.35 + i_rotor``); anything else of a name is refused.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

from robodyn.errors import InputError
from robodyn.robot.names import PARAMETER_NAME_EXPECTED, parameter_name_fault, shown
from robodyn.robot.values import PI, Affine, Value, parameter

#: Longest text of a number.
LENGTH = 200
#: Deepest nesting of brackets: far below Python's recursion limit.
NESTING = 30
# 10**400 is beyond double either way; a larger power would only cost time.
_EXPONENT = 400

_TOKEN = re.compile(
    r"(?P<space>[ \t\r\n]+)"
    r"|(?P<number>(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
    r"|(?P<word>[A-Za-z_][A-Za-z0-9_]*)"
    r"|(?P<sign>[-+*/()])"
    r"|(?P<other>.)",  # the grammar meets it in its turn, so that the first fault is the one named
    re.DOTALL,
)
_NOT_FINITE = re.compile(r"[-+]?\s*\.?(nan|inf|infinity)\Z", re.IGNORECASE)
_EXPECTED = "a number, or arithmetic of numbers and pi with + - * / ( )"
_DEGREES = ("deg", "degree", "degrees")
# What people write instead, and what to write.
_HINTS = {
    ",": "write the decimal point as '.'",
    "^": "powers are not supported: write the product",
    "°": "angles are in rad: write 30*pi/180 for 30 degrees",
    "π": "write pi",
    "−": "write a plain hyphen '-' for minus",
    "–": "write a plain hyphen '-' for minus",
    "×": "write * for times",
    "·": "write * for times",
    "÷": "write / for divided by",
}


class NumberError(InputError):
    """Text that is not a number; ``position`` counts characters of the text from 0."""

    def __init__(
        self, what: str, position: int, *, found: str, expected: str | None = None, remedy: str | None = None
    ) -> None:
        self.position = position
        super().__init__(what, found=found, expected=expected, remedy=remedy)


@dataclass(frozen=True, slots=True)
class Number:
    """A number as it was written: its exact value, whether ``pi`` is in it, its names and where they are.

    ``pi`` counts as the rational :data:`~robodyn.robot.values.PI`, right to 75 digits.
    """

    value: Value
    has_pi: bool
    names: tuple[tuple[str, int], ...]


def shortest(x: float) -> Fraction:
    """The rational that ``repr(x)`` writes: it rounds to the double ``x`` and has a short text.

    Raises
    ------
    ValueError, OverflowError: ``x`` is not finite.
    """
    return Fraction(repr(float(x)))


def rounded(value: Value) -> Value:
    """``value`` with every rational in it replaced by the shortest decimal that is the same double.

    Raises
    ------
    OverflowError: it is beyond double.
    """
    if isinstance(value, Fraction):
        return shortest(float(value))
    total: Value = shortest(float(value.constant))
    for name, coefficient in value.terms:
        total = total + parameter(name) * shortest(float(coefficient))
    return total


def brief(value: Fraction) -> str:
    """``value`` for a message, six digits."""
    try:
        return f"{float(value):.6g}"
    except OverflowError:
        return "more than 1e308" if value > 0 else "less than -1e308"


def parse(text: str, *, names: bool = False) -> Number:
    """Read ``text``; ``names`` says whether run-time parameters may stand in it.

    Raises
    ------
    NumberError: the text is anything else than a number, too long, or its value is not a double.
    """
    if len(text) > LENGTH:
        what, most = f"a number of {len(text)} characters is too long", f"at most {LENGTH} characters"
        raise NumberError(what, 0, found=shown(text), expected=most)
    if _NOT_FINITE.match(text.strip()):
        raise NumberError("not a finite number", 0, found=shown(text), expected="a finite number")
    read = _Parser(text, names).number()
    value = read.value
    parts = [value] if isinstance(value, Fraction) else [value.constant, *(c for _, c in value.terms)]
    for part in parts:
        try:
            lost = part != 0 and float(part) == 0.0
        except OverflowError:
            raise NumberError("the number is too large for a double", 0, found=shown(text)) from None
        if lost:
            what, remedy = "the number is too small for a double", "write 0 if 0 is meant"
            raise NumberError(what, 0, found=shown(text), remedy=remedy)
    return read


def parse_number(text: str) -> Fraction:
    """The exact rational that ``text`` says; with ``pi`` in it, the shortest decimal of its double.

    Raises
    ------
    NumberError: the text is not a number.
    """
    read = parse(text)
    assert isinstance(read.value, Fraction)
    return shortest(float(read.value)) if read.has_pi else read.value


class _Parser:
    """Recursive descent over the tokens of one text, one method a rule of the grammar.

    sum: term (('+' | '-') term)*;  term: factor (('*' | '/') factor)*;
    factor: ('+' | '-')* (number | word | '(' sum ')')
    """

    def __init__(self, text: str, names: bool) -> None:
        self.text = text
        self.names = names
        self.expected = _EXPECTED + ", or a name" * names
        self.has_pi = False
        self.seen: list[tuple[str, int]] = []
        self.depth = 0
        found = ((match.lastgroup or "", match.group(), match.start()) for match in _TOKEN.finditer(text))
        end = ("end", "", len(text.rstrip()))
        self.tokens = [*(token for token in found if token[0] != "space"), end]
        self.next = 0

    def _error(self, what: str, position: int, *more: str | None, found: str = "") -> NumberError:
        """``more``: what is expected, and the remedy."""
        expected, remedy = (*more, None, None)[:2]
        return NumberError(what, position, found=found or shown(self.text), expected=expected, remedy=remedy)

    def _unexpected(self, token: str, position: int) -> NumberError:
        before = self.text[:position].rstrip()
        if token == "" and before:
            return self._error("the number breaks off", position, self.expected)
        if token == "":
            return self._error("there is no number", position, self.expected, found="nothing")
        remedy = _HINTS.get(token)
        if token == "*" and before.endswith("*"):
            remedy = "powers are not supported: write the product"
        elif token == "(" and before[-1:].isalnum():
            remedy = "functions are not supported, and a product needs its *"
        elif token.lower() in _DEGREES:
            remedy = _HINTS["°"]
        elif token.startswith("_"):
            remedy = "write the digits without underscores"
        elif token[0] in "xXbBoO" and before.endswith("0"):
            remedy = "write the number in decimal"
        elif token[0].isalnum() and before:
            remedy = "units are not written, and a product needs its *"
        return self._error(f"unexpected {shown(token)} in a number", position, self.expected, remedy)

    def number(self) -> Number:
        value = self._sum()
        kind, token, position = self.tokens[self.next]
        if kind != "end":
            raise self._unexpected(token, position)
        return Number(value, self.has_pi, tuple(self.seen))

    def _take(self, *signs: str) -> str | None:
        """The next token if it is one of ``signs``, consumed."""
        kind, token, _ = self.tokens[self.next]
        if kind == "sign" and token in signs:
            self.next += 1
            return token
        return None

    def _sum(self) -> Value:
        total = self._term()
        while sign := self._take("+", "-"):
            term = self._term()
            total = total + (term if sign == "+" else -term)
        return total

    def _term(self) -> Value:
        product = self._factor()
        while sign := self._take("*", "/"):
            position = self.tokens[self.next][2]
            factor = self._factor()
            if isinstance(factor, Affine) and (sign == "/" or isinstance(product, Affine)):
                what = "division by a name" if sign == "/" else "a product of names"
                affine = "a name, or sums of numbers and numbers times names"
                remedy = "give the result a name of its own and compute it at run time"
                raise self._error(f"{what} is not supported", position, affine, remedy)
            if sign == "/" and factor == 0:
                raise self._error("division by zero", position)
            if isinstance(factor, Affine):
                assert isinstance(product, Fraction)
                product = factor * product
            else:
                product = product * (factor if sign == "*" else 1 / factor)
        return product

    def _factor(self) -> Value:
        negative = False
        while sign := self._take("+", "-"):
            negative ^= sign == "-"
        kind, token, position = self.tokens[self.next]
        value: Value
        if kind == "number":
            self.next += 1
            value = self._literal(token, position)
        elif kind == "word":
            value = self._word(token, position)
        elif self._take("("):
            value = self._bracket(position)
        else:
            raise self._unexpected(token, position)
        return -value if negative else value

    def _bracket(self, position: int) -> Value:
        if self.depth == NESTING:
            raise self._error("brackets are nested too deep", position, f"at most {NESTING} levels")
        self.depth += 1
        value = self._sum()
        self.depth -= 1
        if not self._take(")"):
            _, token, position = self.tokens[self.next]
            if token:
                raise self._unexpected(token, position)
            raise self._error("a closing ')' is missing", position)
        return value

    def _literal(self, token: str, position: int) -> Fraction:
        mantissa, _, exponent = token.lower().partition("e")
        whole, _, decimals = mantissa.partition(".")
        # The length of the text bounds the digits of the exponent: int() is cheap.
        power = int(exponent) if exponent else 0
        if abs(power) > _EXPONENT:
            expected = "a number between 1e-308 and 1e308, or 0"
            raise self._error("the exponent is out of range", position, expected, found=shown(token))
        power -= len(decimals)
        digits = int(whole + decimals)
        return Fraction(digits * 10**power) if power >= 0 else Fraction(digits, 10**-power)

    def _word(self, token: str, position: int) -> Value:
        if self.tokens[self.next + 1][1] == "(":
            remedy = "write the value of it"
            raise self._error("functions are not supported", position, self.expected, remedy)
        if token == "pi":
            self.next += 1
            self.has_pi = True
            return PI
        if not self.names or token.lower() == "pi":
            hint = "write pi" if token.lower() == "pi" else None
            raise self._error("a name cannot stand here", position, _EXPECTED, hint, found=shown(token))
        if token.lower() in _DEGREES and position:
            raise self._unexpected(token, position)
        fault = parameter_name_fault(token)
        if fault:
            raise self._error(f"{shown(token)} {fault}", position, PARAMETER_NAME_EXPECTED)
        self.next += 1
        self.seen.append((token, position))
        return parameter(token)
