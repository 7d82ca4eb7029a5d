"""Programs of a few lines, written by hand."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction

from robodyn.ir import Input, Operand, Operation, Program


def by_hand(
    operations: str, outputs: str | None = None, names: Mapping[str, Operand] | None = None, result: str = "t"
) -> Program:
    """The program of ``operations``, ``mul x %0, neg %1``, with ``outputs`` or else the last of them.

    Operands are ``%k`` of operation k, fractions, ``q[0]``, what ``names`` says, or else run-time parameters.
    """

    def operand(word: str) -> Operand:
        if names is not None and word in names:
            return names[word]
        if match := re.fullmatch(r"(\w+)\[(\d+)\]", word):
            return Input(match[1], int(match[2]))
        if word.startswith("%"):
            return int(word[1:])
        return Input(word, None) if word[0].isalpha() else Fraction(word)

    parts = [text.split() for text in operations.split(",") if text]
    lines = tuple(Operation(op, tuple(map(operand, words))) for op, *words in parts)
    elements = (len(lines) - 1,) if outputs is None else tuple(map(operand, outputs.split()))
    return Program(lines, ((result, elements),))
