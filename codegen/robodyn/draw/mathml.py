"""Equations as MathML, which browsers typeset themselves.

They come from the LaTeX of the catalogue of effects, and from the statements of a program.

The LaTeX is the part of it that equations of this project need; what it does not know is an error, and a test
holds it to every effect.
"""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Final

from robodyn.emit.statements import Expression
from robodyn.ir.program import Input

_TOKEN: Final = re.compile(r"\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|\s+|.", re.DOTALL)

_GREEK: Final = {
    "Delta": "Δ", "Lambda": "Λ", "alpha": "α", "delta": "δ", "epsilon": "ϵ", "eta": "η", "lambda": "λ",
    "mu": "μ", "omega": "ω", "rho": "ρ", "sigma": "σ", "tau": "τ", "theta": "θ", "varphi": "φ",
}  # fmt: skip
_SIGNS: Final = {"ge": "≥", "le": "≤", "leftarrow": "←", "\\,": "", "\\ ": " "}
_OPERATORS: Final = {"-": "−", "<": "&lt;"}
_SPACES: Final = {"quad": "1em", "qquad": "2em", ",": "0.17em", " ": "0.33em"}
_FUNCTIONS: Final = frozenset({"cos", "sin", "tanh", "exp", "max", "min", "sgn"})
_ACCENTS: Final = {"dot": "˙", "ddot": "¨"}
_MATH: Final = {True: '<math display="block">', False: "<math>"}
#: A function and the thin space before what it is of.
_APPLIED: Final = '<mi>{}</mi><mo>&#x2061;</mo><mspace width="0.17em"></mspace>'
_SIZES: Final = frozenset({"left", "right", "bigl", "bigr", "Bigl", "Bigr"})


def of_latex(text: str, *, display: bool = True) -> str:
    """The equation ``text`` in LaTeX as a ``math`` element; ``display``: on a line of its own.

    Raises
    ------
    ValueError: it holds what this reader does not know.
    """
    reader = _Reader(text)
    return _MATH[display] + reader.row(()) + "</math>"


class _Reader:
    """A reader of ``text``, token by token."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens: list[str] = _TOKEN.findall(text)
        self.place = 0

    def row(self, ends: tuple[str, ...]) -> str:
        """What stands before one of ``ends``, which is not taken; before the end of the text without any."""
        parts: list[str] = []
        while self.place < len(self.tokens) and self.tokens[self.place] not in ends:
            if self.tokens[self.place].isspace():
                self.place += 1
            else:
                parts.append(self._with_scripts())
        if ends and self.place == len(self.tokens):
            raise ValueError(f"no {' or '.join(ends)} in the equation {self.text!r}")
        return _row(parts)

    def _with_scripts(self) -> str:
        base = self._atom()
        scripts: dict[str, str] = {}
        while self.place < len(self.tokens) and self.tokens[self.place] in "_^":
            mark = self._take()
            scripts[mark] = self._atom()
        return _scripted(base, scripts.get("_", ""), scripts.get("^", ""))

    def _take(self) -> str:
        """The next token that is no space."""
        while self.tokens[self.place].isspace():
            self.place += 1
        self.place += 1
        return self.tokens[self.place - 1]

    def _atom(self) -> str:
        """A group in braces, a command or a sign."""
        token = self._take()
        if token == "{":
            body = self.row(("}",))
            self.place += 1
            return body
        if token.startswith("\\"):
            return self._command(token[1:])
        if token[0].isdigit():
            return f"<mn>{token}</mn>"
        if token.isalpha():
            return f"<mi>{token}</mi>"
        if token in "()[]|":
            return f'<mo stretchy="false">{token}</mo>'
        if token in "+-=,<:/":
            return f"<mo>{_OPERATORS.get(token, token)}</mo>"
        raise ValueError(f"{token!r} in the equation {self.text!r}")

    def _command(self, name: str) -> str:
        if name in _GREEK:
            return f"<mi>{_GREEK[name]}</mi>"
        if name in _FUNCTIONS:
            return _APPLIED.format(name)
        if name in _SPACES:
            return f'<mspace width="{_SPACES[name]}"></mspace>'
        if name in _ACCENTS:
            return _accented(self._atom(), _ACCENTS[name])
        if name in ("frac", "tfrac"):
            return f"<mfrac>{self._atom()}{self._atom()}</mfrac>"
        if name == "sqrt":
            return f"<msqrt>{self._atom()}</msqrt>"
        if name == "text":
            return f"<mtext>{self._name().replace(' ', chr(160))}</mtext>"
        if name == "operatorname":
            return _APPLIED.format(self._name())
        if name == "mathrel":
            return self._atom()
        if name in _SIZES:
            token = self._take()
            sign = "" if token == "." else token.removeprefix("\\")
            return f"<mo>{sign}</mo>" if sign else ""
        if name == "begin":
            return self._rows(self._name())
        if name in _SIGNS:
            return f"<mo>{_SIGNS[name]}</mo>"
        raise ValueError(f"\\{name} in the equation {self.text!r}")

    def _name(self) -> str:
        """The text of the group in braces that follows."""
        end = self.tokens.index("}", self.place)
        text = "".join(self.tokens[self.place + 1 : end])
        self.place = end + 1
        return text

    def _rows(self, kind: str) -> str:
        """``cases`` or ``aligned``: rows of cells."""
        rows: list[list[str]] = [[]]
        while True:
            rows[-1].append(self.row(("&", "\\\\", "\\end")))
            token = self._take()
            if token == "\\\\":
                rows.append([])
            elif token == "\\end":
                break
        self._name()
        filled = [row for row in rows if any(cell != "<mrow></mrow>" for cell in row)]
        cells = ["".join(f"<mtd>{cell}</mtd>" for cell in row) for row in filled]
        lines = "".join(f"<mtr>{line}</mtr>" for line in cells)
        table = f'<mtable class="{kind}">{lines}</mtable>'
        return f"<mrow><mo>{{</mo>{table}</mrow>" if kind == "cases" else table


def _scripted(base: str, below: str, above: str) -> str:
    """``base`` with what stands below and above it, if anything does."""
    kind = f"m{'sub' * bool(below)}{'sup' * bool(above)}"
    return f"<{kind}>{base}{below}{above}</{kind}>" if below or above else base


def _row(parts: list[str]) -> str:
    return parts[0] if len(parts) == 1 else "<mrow>" + "".join(parts) + "</mrow>"


def _accented(symbol: str, accent: str) -> str:
    # Not accent="true": without a font for mathematics such dots touch their letter.
    return f'<mover>{symbol}<mo stretchy="false">{accent}</mo></mover>'


# --- statements of a program ------------------------------------------------------------------------------

#: Quantities of the recursion as the book writes them; others by their own letters.
_QUANTITIES: Final = {
    "w": "ω", "ww": "ωω", "alpha": "α", "lam": "Λ", "fc": "F", "nc": "N", "tau": "τ", "ac": "a", "m": "M",
}  # fmt: skip
_ACCENTED: Final = {"qd": ("q", "˙"), "qdd": ("q", "¨")}
_NAME: Final = re.compile(r"(neg_)?([A-Za-z]+)(\d+(?:to\d+)?)?(?:_([A-Za-z]+|\d+))?(?:_(\d+))?\Z")
_PART: Final = re.compile(r"(.*)_part(\d+)\Z")
#: How strongly parts of an expression bind; what has a sign in front may begin a sum or product.
_SUM, _SIGNED, _PRODUCT, _ATOM = 1, 2, 3, 4


def equation(left: str, right: str) -> str:
    """``left = right``, both MathML."""
    return f'<math display="block"><mrow>{left}<mo>=</mo>{right}</mrow></math>'


def of_name(name: str) -> str:
    """A value's name as a symbol: ``w2_x`` is an omega with 2x below, ``neg_`` its opposite."""
    part = _PART.match(name)
    above = ""
    if part:
        name, above = part[1], f"<mrow><mo>(</mo><mn>{part[2]}</mn><mo>)</mo></mrow>"
    match = _NAME.match(name)
    if match is None:
        return f"<mi>{name}</mi>"
    opposite, letters, index, axis, again = match.groups()
    symbol = _QUANTITIES.get(letters, letters)
    marks = [f"<mn>{mark}</mn>" for mark in (index or "").split("to") if mark]
    if axis:
        marks += [f"<mi>{axis}</mi>"] if axis.isalpha() else ["<mo>,</mo>", f"<mn>{axis}</mn>"]
    marks += ["<mo>′</mo>"] * (int(again) - 1 if again else 0)
    below = f"<mrow>{''.join(marks)}</mrow>" if marks else ""
    text = _scripted(f"<mi>{symbol}</mi>", below, above)
    return f"<mrow><mo>−</mo>{text}</mrow>" if opposite else text


def of_input(array: str, place: int | None) -> str:
    """An element of an input, counted from 1; a run-time parameter (None) by its name."""
    letter, accent = _ACCENTED.get(array, (array, ""))
    if place is None:
        return f"<mi>{array}</mi>"
    symbol = f"<mi>{_QUANTITIES.get(letter, letter)}</mi>"
    symbol = _accented(symbol, accent) if accent else symbol
    return f"<msub>{symbol}<mn>{place + 1}</mn></msub>"


def of_expression(expression: Expression) -> str:
    """``expression`` as MathML."""
    return _of(expression)[0]


def _of(expression: Expression) -> tuple[str, int]:
    if isinstance(expression, str):
        # The value is minus the quantity.
        strength = _SIGNED if expression.startswith("neg_") else _ATOM
        return of_name(expression), strength
    if isinstance(expression, Input):
        return of_input(expression.array, expression.index), _ATOM
    if isinstance(expression, Fraction):
        return of_number(expression), _ATOM if expression >= 0 else _SIGNED
    op, args = expression
    parts = [_of(arg) for arg in args]
    if op in ("add", "sub"):
        second = _bracketed(parts[1], _PRODUCT)
        sign = "+" if op == "add" else "−"
        return f"<mrow>{parts[0][0]}<mo>{sign}</mo>{second}</mrow>", _SUM
    if op == "mul":
        left, right = _bracketed(parts[0], _SIGNED), _bracketed(parts[1], _PRODUCT)
        times = "·" if isinstance(args[1], Fraction) else "&#x2062;"
        return f"<mrow>{left}<mo>{times}</mo>{right}</mrow>", min(_PRODUCT, max(_SIGNED, parts[0][1]))
    if op == "div":
        return f"<mfrac>{parts[0][0]}{parts[1][0]}</mfrac>", _ATOM
    if op == "neg":
        return f"<mrow><mo>−</mo>{_bracketed(parts[0], _PRODUCT)}</mrow>", _SIGNED
    if op == "sqrt":
        return f"<msqrt>{parts[0][0]}</msqrt>", _ATOM
    if op == "abs":
        return f"<mrow><mo>|</mo>{parts[0][0]}<mo>|</mo></mrow>", _ATOM
    if op == "pow":
        return f"<msup>{_bracketed(parts[0], _ATOM)}{parts[1][0]}</msup>", _ATOM
    if op == "atan2" or op == "select":
        inside = "<mo>,</mo>".join(text for text, _ in parts)
        return f"<mrow>{_APPLIED.format(op)}<mo>(</mo>{inside}<mo>)</mo></mrow>", _ATOM
    name = {"sign": "sgn"}.get(op, op)
    return f"<mrow>{_APPLIED.format(name)}{_bracketed(parts[0], _ATOM)}</mrow>", _PRODUCT


def _bracketed(part: tuple[str, int], least: int) -> str:
    text, strength = part
    return text if strength >= least else f"<mrow><mo>(</mo>{text}<mo>)</mo></mrow>"


def of_number(value: Fraction) -> str:
    """A constant: an integer as it is, else six digits."""
    size = abs(value)
    text = str(size.numerator) if size.denominator == 1 and size < 10**6 else f"{float(size):.6g}"
    mantissa, _, power = text.partition("e")
    digits = f"<mn>{mantissa}</mn>"
    if power:
        exponent = int(power)
        sign = "<mo>−</mo>" if exponent < 0 else ""
        ten = f"<msup><mn>10</mn><mrow>{sign}<mn>{abs(exponent)}</mn></mrow></msup>"
        digits = f"<mrow>{digits}<mo>·</mo>{ten}</mrow>"
    return digits if value >= 0 else f"<mrow><mo>−</mo>{digits}</mrow>"
