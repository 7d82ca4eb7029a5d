"""Names say what a thing is, and not that it was found, made or given."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
VAGUE = frozenset({"asked", "found", "given", "made", "number", "said", "soon", "told"})
#: The dialect that the code once spoke, for which the field has terms (held-out error, prior penalty, ...).
DIALECT = frozenset(
    {
        "bends", "bent", "bristles", "doubts", "enough", "flown", "glance", "shaken", "strain", "swing",
        "swung", "told_about", "told_of",
    }
)  # fmt: skip
#: Vague as the name of a class or a type, too.
VAGUE_TYPES = frozenset({"Found", "Given", "Made", "Said", "Told"})
#: Vague even where an underscore keeps it inside a module or a class.
PRIVATE = frozenset({"found", "given", "made", "said", "told"})
ROOTS = ("codegen", "cli", "benchmarks", "docs", "tests/robodyn_testing")
FILES = sorted(path for root in ROOTS for path in (ROOT / root).rglob("*.py"))
#: What no identifier of C and C++ is called: the engines, the peers' runners, the templates of both.
VAGUE_IN_C = VAGUE - {"number", "soon"} | {"taken"}
C_FILES = sorted(
    path
    for root in ("codegen", "benchmarks", "templates", "tests")
    for path in (ROOT / root).rglob("*")
    if re.search(r"\.(c|h|cpp|hpp)(\.j2)?$", path.name) and path.parent.name != "fmi"  # the standard's own
)
#: Comments, texts, and what a template fills in.
_NO_NAMES = re.compile(
    r"""/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|\{\{.*?\}\}|\{%.*?%\}|\{\#.*?\#\}""",
    re.DOTALL,
)


def vague_names(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """The line and name of each variable, argument, field and function with a vague name.

    What an error calls ``found`` stands beside what it ``expected``: there it is the word of the message. A
    method may be called ``number`` if a number is what it returns.
    """
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and node.id in VAGUE:
            yield node.lineno, node.id
        elif isinstance(node, ast.FunctionDef):
            arguments = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
            of_error = "expected" in {argument.arg for argument in arguments}
            allowed = {"found"} if of_error else set()
            yield from ((a.lineno, a.arg) for a in arguments if a.arg in VAGUE - allowed)
            if node.name in VAGUE - {"number"}:
                yield node.lineno, node.name
        elif isinstance(node, ast.Lambda):
            yield from ((a.lineno, a.arg) for a in node.args.args if a.arg in VAGUE)
        elif (
            isinstance(node, ast.Attribute)
            and isinstance(node.ctx, ast.Store)
            and node.attr in VAGUE - {"found"}
        ):
            yield node.lineno, node.attr


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("found = 1", ["found"]),
        ("def f(given): made, x = given", ["given", "made"]),
        ("class C:\n    told: int\n    def number(self): self.said = 1", ["said", "told"]),
        ("def error(what, found, expected): pass", []),
        ("sort(key=lambda made: made)", ["made"]),
    ],
)
def test_vague_names_are_noticed(text: str, names: list[str]) -> None:
    assert sorted(name for _, name in vague_names(ast.parse(text))) == names


def vague_names_in_c(text: str) -> Iterator[tuple[int, str]]:
    """The line and name of each vague identifier in a text in C or C++, or a template of one."""
    code = _NO_NAMES.sub(lambda match: "\n" * match[0].count("\n"), text)
    for line, words in enumerate(code.splitlines(), start=1):
        yield from ((line, word) for word in re.findall(r"[A-Za-z_]\w*", words) if word in VAGUE_IN_C)


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("int found = 0; /* given */ // made", [(1, "found")]),
        ("/* told\n */\nx->made[1] = 'a';", [(3, "made")]),
        ('puts("taken \\" found"); int n_found;', []),
        ("{% if given %}int asked;{% endif %} {{ said }}", [(1, "asked")]),
    ],
)
def test_vague_names_in_c_are_noticed(text: str, names: list[tuple[int, str]]) -> None:
    assert list(vague_names_in_c(text)) == names


def test_no_name_in_c_is_vague() -> None:
    places = [
        f"{path.relative_to(ROOT)}:{line}: {name}"
        for path in C_FILES
        for line, name in vague_names_in_c(path.read_text(encoding="utf-8"))
    ]
    assert len(C_FILES) > 50
    assert not places, "\n".join(places)


def dialect(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """The line and name of whatever is defined under a word of the dialect, with or without underscores."""
    for node in ast.walk(tree):
        name, line = "", 0
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            name, line = node.name, node.lineno
        elif isinstance(node, ast.arg):
            name, line = node.arg, node.lineno
        elif isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store):
            name, line = node.id if isinstance(node, ast.Name) else node.attr, node.lineno
        plain = name.strip("_")
        if plain.lower() in DIALECT or plain in VAGUE_TYPES or (name.startswith("_") and plain in PRIVATE):
            yield line, name


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("class Found: strain: float", ["Found", "strain"]),
        ("def _bristles(enough): self.shaken = 1", ["_bristles", "enough", "shaken"]),
        ("Given = tuple[str, float]", ["Given"]),
        ("def _told(): self._made = {}", ["_made", "_told"]),
        ("def found(): held = 1", []),
        ("x = swing", []),
    ],
)
def test_the_dialect_is_noticed(text: str, names: list[str]) -> None:
    assert sorted(name for _, name in dialect(ast.parse(text))) == names


@pytest.mark.thorough
def test_no_name_is_vague_or_dialect() -> None:
    """Both in one test: reading all files is what takes time."""
    places = []
    for path in FILES:
        tree = ast.parse(path.read_text(encoding="utf-8"))
        names = {*vague_names(tree), *dialect(tree)}
        places += [f"{path.relative_to(ROOT)}:{line}: {name}" for line, name in sorted(names)]
    assert len(FILES) > 800
    assert not places, "\n".join(places)
