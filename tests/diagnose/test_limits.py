"""The numbers that a diagnosis goes by stand in one place a room, each with its unit and meaning."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import robodyn

ROOT = Path(robodyn.__file__).parent
ROOMS = ("gate", "identify", "diagnose")
FILES = sorted(path.relative_to(ROOT).as_posix() for room in ROOMS for path in (ROOT / room).rglob("*.py"))
LIMITS = [file for file in FILES if Path(file).name == "limits.py"]


def constants(tree: ast.Module) -> Iterator[tuple[str, ast.expr]]:
    """Names and values that a module gives to its own names, part by part."""
    for statement in tree.body:
        if isinstance(statement, ast.AnnAssign) and statement.value is not None:
            yield ast.unparse(statement.target), statement.value
        elif isinstance(statement, ast.Assign):
            (target,) = statement.targets
            if isinstance(target, ast.Tuple) and isinstance(statement.value, ast.Tuple):
                yield from zip(map(ast.unparse, target.elts), statement.value.elts, strict=True)
            else:
                yield ast.unparse(target), statement.value


def is_number(value: ast.expr) -> bool:
    """Whether a value is a number, arithmetic of numbers, or a list or table of them."""
    if isinstance(value, ast.Constant):
        return isinstance(value.value, int | float) and not isinstance(value.value, bool)
    if isinstance(value, ast.UnaryOp):
        return is_number(value.operand)
    if isinstance(value, ast.BinOp):
        return is_number(value.left) or is_number(value.right)
    if isinstance(value, ast.Tuple | ast.List | ast.Set):
        return any(map(is_number, value.elts))
    return isinstance(value, ast.Dict) and any(map(is_number, value.values))


def test_no_number_stands_elsewhere() -> None:
    for file in set(FILES) - set(LIMITS):
        tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
        assert [name for name, value in constants(tree) if is_number(value)] == [], file


@pytest.mark.parametrize("file", LIMITS)
def test_every_number_has_its_unit_and_meaning(file: str) -> None:
    _, *body = ast.parse((ROOT / file).read_text(encoding="utf-8")).body
    body = [statement for statement in body if not isinstance(statement, ast.ImportFrom)]
    assert len(body) > 2
    for number, text in zip(body[::2], body[1::2], strict=True):
        assert isinstance(number, ast.AnnAssign), ast.unparse(number)
        assert isinstance(text, ast.Expr), f"{ast.unparse(number)} has no text below it"
        assert number.value is not None
        assert is_number(number.value)
        meaning = ast.literal_eval(text.value)
        assert re.match(r"\[[^]]+\] .*\w", meaning), f"{ast.unparse(number)}: a unit in brackets, a sentence"


def test_numbers_are_seen() -> None:
    text = (
        "A, b = 1, 'x'\nC: Final = 1 << 4\nD = {'q': -2.5}\nE = ('f', (2,))\nF = other(1)\nG = ('a', 'b')\n"
    )
    assert [name for name, value in constants(ast.parse(text)) if is_number(value)] == ["A", "C", "D", "E"]
