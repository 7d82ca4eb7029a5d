"""An effect is known by its definition: its id stands in no code outside effects/, save the references."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from robodyn.effects.catalogue import CATALOGUE

ROOT = Path(__file__).parents[2]
HOME = ROOT / "codegen" / "robodyn" / "effects"
#: References that are written by hand on purpose, effect by effect. They refuse what they do not know
#: (tests/verify/test_declared.py).
BY_HAND = tuple(
    ROOT / "codegen" / "robodyn" / "verify" / name
    for name in ("effects.py", "free_bodies.py", "reference.py", "stateful.py")
)
SOURCES = sorted(
    path
    for folder in ("codegen", "cli")
    for path in (ROOT / folder).rglob("*.py")
    if HOME not in path.parents
)


def ids_in(source: str) -> list[tuple[int, str]]:
    """Lines and ids of the strings in ``source`` that are an effect's id; docstrings are words."""
    tree = ast.parse(source)
    words = {
        node.body[0].value
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef)
        and node.body
        and isinstance(node.body[0], ast.Expr)
    }
    return sorted(
        (node.lineno, node.value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and node not in words and node.value in CATALOGUE
    )


@pytest.mark.thorough
def test_no_code_knows_an_effect_by_name() -> None:
    known = [
        f"{path.relative_to(ROOT)}:{line}: {id!r}: ask for a trait of its definition (effects/traits.py)"
        for path in SOURCES
        if path not in BY_HAND
        for line, id in ids_in(path.read_text(encoding="utf-8"))
    ]
    assert not known, "\n".join(known)
