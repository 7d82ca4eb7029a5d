"""Effects without a reference written by hand: the torque by the equation that their definition prints.

What a definition prints for people is a second statement of what it computes. So an effect for which nobody
has written a reference is still verified: against its own equation as it stands in the documents, whose LaTeX
is read here as mathematics, as far as the catalogue uses it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects.catalogue import effect
from robodyn.effects.effect import Effect
from robodyn.errors import InputError

#: Where in a drive an effect can act that is its printed equation and nothing else.
PLACES = ("link", "bearing", "gear", "motor")


class NoReferenceError(InputError):
    """Nothing independent is known to compare an effect with."""


def _no_reference(known: Effect, why: str) -> NoReferenceError:
    return NoReferenceError(
        f"there is no reference for {known.id}",
        found=why,
        remedy=f"write one for {known.id} in robodyn/verify/effects.py, from its source",
    )


def declared_place(id: str) -> str:
    """Where the effect ``id``, for which there is no reference, acts.

    Raises
    ------
    NoReferenceError: what it does is more than its equation.
    """
    known = effect(id)
    if known.memory is not None or known.coupler is not None:
        raise _no_reference(known, "an effect that remembers")
    if known.place not in (*PLACES, "sensor", "outside"):
        raise _no_reference(known, f"an effect at the place {known.place!r}")
    return known.place


def declared_torque(id: str, p: Mapping[str, Any], site: Mapping[str, Floats]) -> Floats:
    """The torque ``[N]`` [N m or N] by the equation that the effect ``id`` is typeset with, at a ``site``:
    arrays by symbol.

    Raises
    ------
    NoReferenceError: its LaTeX is not of the form ``\\tau = ...``, or cannot be read.
    """
    known = effect(id)
    equation = re.fullmatch(r"\s*\\tau\s*=(.*)", known.latex, re.S)
    if equation is None:
        raise _no_reference(known, f"an equation that is not \\tau = ...: {known.latex}")
    symbols: dict[str, Any] = dict(site)
    for parameter in known.parameters:
        if parameter.symbol and isinstance(p.get(parameter.name), float):
            symbols[parameter.symbol] = p[parameter.name]
    try:
        torque = value(equation[1], symbols)
    except (SyntaxError, KeyError, ValueError) as error:
        raise _no_reference(known, f"an equation that cannot be read: {error}") from error
    return np.asarray(torque + np.zeros_like(site[r"\dot q"]))


#: What is for the eye alone.
_BLANK = re.compile(r"\\(?:[,;!]|(?:left|right|[bB]igg?[lr]|q?quad)(?![A-Za-z]))|&|\s+")


#: Functions over arrays and floats; give others for other scalars.
ARRAYS: dict[str, Any] = {
    "number": float, "pow": np.power, "sqrt": np.sqrt, "exp": np.exp, "sin": np.sin, "cos": np.cos,
    "tanh": np.tanh, "ln": np.log, "abs": lambda x: x * np.sign(np.real(x)), "real": np.real,
}  # fmt: skip


def value(latex: str, symbols: Mapping[str, Any], functions: Mapping[str, Any] = ARRAYS) -> Any:
    """The value of the expression ``latex``; ``symbols`` by their spelling, such as ``F_c^+`` or ``\\dot q``;
    ``functions`` over the scalars of the symbols, in place of those of ``ARRAYS`` with their names.

    Raises
    ------
    SyntaxError: it is none, or has a symbol that is not among them.
    """
    cases = re.fullmatch(r"\s*\\begin\{cases\}(.*)\\end\{cases\}\s*,?\s*", latex, re.S)
    if cases:
        return _by_case(cases[1].split(r"\\"), symbols, functions)
    reader = _Reader(latex, symbols, {**ARRAYS, **functions})
    total = reader.sum()
    if reader.peek():
        raise SyntaxError(f"{latex}: cannot read on at {reader.rest}")
    return total


def _by_case(rows: list[str], symbols: Mapping[str, Any], functions: Mapping[str, Any]) -> Any:
    values, conditions = [], []
    for row in rows:
        then, _, condition = row.partition("&")
        left, relation, right = re.split(r"(\\ge|\\le|<|>)", condition)
        real = functions.get("real", ARRAYS["real"])
        a, b = (real(value(side, symbols, functions)) for side in (left, right))
        conditions.append({"<": a < b, ">": a > b, r"\ge": a >= b, r"\le": a <= b}[relation])
        values.append(value(then, symbols, functions))
    if not any(isinstance(condition, np.ndarray) for condition in conditions):
        for condition, candidate in zip(conditions, values, strict=True):
            if condition:
                return candidate
        raise SyntaxError(f"no case of {rows}")
    if not np.all(np.any(np.broadcast_arrays(*conditions), axis=0)):
        raise SyntaxError(f"no case of {rows}")
    return np.select(np.broadcast_arrays(*conditions), values)


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
        token = self.peek(*texts)
        self.rest = self.rest[len(token) :]
        return token

    def need(self, text: str) -> None:
        if not self.take(text):
            raise SyntaxError(f"{text} is missing before {self.rest!r}")

    def sum(self) -> Any:
        total = -self.product() if self.take("-") else self.product()
        while sign := self.take("+", "-"):
            total = total + (self.product() if sign == "+" else -self.product())
        return total

    def product(self) -> Any:
        product = self.power()
        while True:
            if self.take("/"):
                product = product / self.power()
            elif (
                self.rest.lstrip()
                and not self.peek("+", "-", ")", "]", "}")
                and not (self.bars and self.peek("|"))
            ):
                product = product * self.power()
            else:
                return product

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
        inner = self.sum()
        self.need("}")
        self.bars = bars
        return inner

    def atom(self) -> Any:
        self.peek()
        for name in self.names:
            after = self.rest[len(name) :]
            if self.rest.startswith(name) and not (name.startswith("\\") and after[:1].isalpha()):
                self.rest = after
                return self.symbols[name]
        if digits := re.match(r"\d+(\.\d+)?", self.peek()):
            self.rest = self.rest[digits.end() :]
            return self.functions["number"](digits[0])
        if self.take(r"\frac", r"\tfrac"):
            above = self.group()
            return above / self.group()
        if self.take(r"\sqrt"):
            return self.functions["sqrt"](self.group())
        if self.take("e^"):
            return self.functions["exp"](self.group())
        if name := self.take(r"\sin", r"\cos", r"\tanh", r"\ln"):
            return self.functions[name[1:]](self.atom())
        if opened := self.take("(", "["):
            bars, self.bars = self.bars, 0
            inner = self.sum()
            self.need({"(": ")", "[": "]"}[opened])
            self.bars = bars
            return inner
        if self.take("|"):
            self.bars += 1
            inner = self.sum()
            self.need("|")
            self.bars -= 1
            return self.functions["abs"](inner)
        raise SyntaxError(f"cannot read {self.rest!r}")
