"""The value of an equation as it is typeset: LaTeX read as mathematics, as far as the catalogue uses it."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any

from robodyn.effects.catalogue import CATALOGUE

#: What is for the eye alone.
_BLANK = re.compile(r"\\(?:[,;!]|(?:left|right|[bB]igg?[lr]|q?quad)(?![A-Za-z]))|&|\s+")


#: Functions over floats; give others for other scalars.
PLAIN: dict[str, Any] = {
    "number": float, "pow": math.pow, "sqrt": math.sqrt, "exp": math.exp, "sin": math.sin,
}  # fmt: skip


def typeset(id: str, p: Mapping[str, Any]) -> str:
    """The right side of the equation for what the effect adds, out of its LaTeX."""
    latex = CATALOGUE[id].latex
    if id == "load_dependent_friction":
        kind = "radial" if p["bearing"] == "journal" and "span" not in p else p["bearing"]
        found = re.search(rf"\\text\{{{kind}: \}}\s*&?\s*\\tau =(.*?)(\\\\|, \\quad|\\end)", latex)
    elif id == "motor_coupling":
        found = re.search(r"T =(.*?), \\quad", latex)
    elif id == "transmission_loss":
        found = re.search(r"\\tau_\{in\} =(.*?\\end\{cases\})", latex)
    else:
        found = re.fullmatch(r"\\tau =(.*)", latex)
    assert found, latex
    return found[1]


def value(latex: str, symbols: Mapping[str, Any], functions: Mapping[str, Any] = PLAIN) -> Any:
    """The value of the expression ``latex``; ``symbols`` by their spelling, such as ``F_c^+`` or ``\\dot q``;
    ``functions`` (``number pow sqrt exp sin``) over the scalars of the symbols.

    Raises
    ------
    SyntaxError: it is none, or has a symbol that is not among them.
    """
    cases = re.fullmatch(r"\s*\\begin\{cases\}(.*)\\end\{cases\}\s*,?\s*", latex, re.S)
    if cases:
        for row in cases[1].split(r"\\"):
            then, _, condition = row.partition("&")
            left, relation, right = re.split(r"(\\ge|\\le|<|>)", condition)
            a, b = value(left, symbols, functions), value(right, symbols, functions)
            if {"<": a < b, ">": a > b, r"\ge": a >= b, r"\le": a <= b}[relation]:
                return value(then, symbols, functions)
        raise SyntaxError(f"no case of {latex}")
    reader = _Reader(latex, symbols, functions)
    found = reader.sum()
    if reader.peek():
        raise SyntaxError(f"{latex}: cannot read on at {reader.rest}")
    return found


class _Reader:
    def __init__(self, latex: str, symbols: Mapping[str, Any], functions: Mapping[str, Any]) -> None:
        self.rest = _BLANK.sub(" ", latex).strip()
        self.names = sorted(symbols, key=len, reverse=True)
        self.symbols, self.functions = symbols, functions
        self.bars = 0

    def peek(self, *texts: str) -> str:
        self.rest = self.rest.lstrip()
        return next((text for text in texts if self.rest.startswith(text)), "") if texts else self.rest

    def take(self, *texts: str) -> str:
        found = self.peek(*texts)
        self.rest = self.rest[len(found) :]
        return found

    def need(self, text: str) -> None:
        if not self.take(text):
            raise SyntaxError(f"{text} is missing before {self.rest!r}")

    def sum(self) -> Any:
        total = -self.product() if self.take("-") else self.product()
        while sign := self.take("+", "-"):
            total += self.product() if sign == "+" else -self.product()
        return total

    def product(self) -> Any:
        found = self.power()
        while True:
            if self.take("/"):
                found /= self.power()
            elif (
                self.rest.lstrip()
                and not self.peek("+", "-", ")", "]", "}")
                and not (self.bars and self.peek("|"))
            ):
                found *= self.power()
            else:
                return found

    def power(self) -> Any:
        base = self.atom()
        return self.functions["pow"](base, self.group()) if self.take("^") else base

    def group(self) -> Any:
        """An argument: in braces, or the next thing alone."""
        if not self.take("{"):
            digit = re.match(r"\d", self.peek())
            if digit:
                self.rest = self.rest[1:]
                return self.functions["number"](digit[0])
            return self.atom()
        bars, self.bars = self.bars, 0
        found = self.sum()
        self.need("}")
        self.bars = bars
        return found

    def atom(self) -> Any:
        self.peek()
        for name in self.names:
            after = self.rest[len(name) :]
            if self.rest.startswith(name) and not (name.startswith("\\") and after[:1].isalpha()):
                self.rest = after
                return self.symbols[name]
        if number := re.match(r"\d+(\.\d+)?", self.peek()):
            self.rest = self.rest[number.end() :]
            return self.functions["number"](number[0])
        if self.take(r"\frac", r"\tfrac"):
            above = self.group()
            return above / self.group()
        if self.take(r"\sqrt"):
            return self.functions["sqrt"](self.group())
        if self.take("e^"):
            return self.functions["exp"](self.group())
        if self.take(r"\sin"):
            return self.functions["sin"](self.atom())
        if opened := self.take("(", "["):
            bars, self.bars = self.bars, 0
            found = self.sum()
            self.need({"(": ")", "[": "]"}[opened])
            self.bars = bars
            return found
        if self.take("|"):
            self.bars += 1
            found = self.sum()
            self.need("|")
            self.bars -= 1
            return abs(found)
        raise SyntaxError(f"cannot read {self.rest!r}")
