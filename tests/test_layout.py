"""The rooms of the library: each imports only rooms above it in the list; sympy and its like come late."""

from __future__ import annotations

import ast
import graphlib
import importlib
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1] / "codegen"


def rooms() -> list[str]:
    """The rooms in their order, which stands in one place: the table of docs/architecture.md."""
    text = (ROOT.parent / "docs" / "architecture.md").read_text(encoding="utf-8")
    table = text.partition("\n## Rooms\n")[2].partition("\n## ")[0]
    return re.findall(r"(?m)^\| `(\w+)` \|", table)


ROOMS = rooms()
LATE = {"sympy", "numpy", "scipy", "matplotlib"}
LEAN = {"ir", "robot", "dynamics", "passes", "counts", "optimize", "emit"}
FACADE = {"__init__", "__main__"}
#: Folders whose files are held to a length, and that length.
TOPS, LINES = ("codegen", "cli", "docs", "tests", "benchmarks"), 350
FILES = sorted(path.relative_to(ROOT) for path in ROOT.rglob("*.py"))


def room_of(file: Path) -> str:
    """The room that a file of the library is in; a file beside the rooms is one itself."""
    return file.with_suffix("").parts[1]


def imported(statement: ast.AST, file: Path) -> Iterator[str]:
    """The modules that an import statement may load, by absolute names."""
    if isinstance(statement, ast.Import):
        yield from (alias.name for alias in statement.names)
    elif isinstance(statement, ast.ImportFrom):
        base = file.parts[: len(file.parts) - statement.level] if statement.level else ()
        module = ".".join([*base, *([statement.module] if statement.module else [])])
        yield from (f"{module}.{alias.name}" for alias in statement.names)


def at_module_level(node: ast.AST) -> Iterator[ast.AST]:
    """What runs when the module is imported: no bodies of functions, nothing only for type checkers."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.If) and ast.unparse(child.test).endswith("TYPE_CHECKING"):
            continue
        if not isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            yield child
            yield from at_module_level(child)


def test_the_table_of_rooms_is_the_package() -> None:
    package = ROOT / "robodyn"
    there = {
        path.stem for path in package.iterdir() if path.suffix == ".py" or (path / "__init__.py").is_file()
    }
    assert len(ROOMS) == len(set(ROOMS))
    assert set(ROOMS) == there - FACADE


def test_what_the_map_names_is_there() -> None:
    """Folders, modules and types in docs/architecture.md."""
    text = (ROOT.parent / "docs" / "architecture.md").read_text(encoding="utf-8")
    for path in re.findall(r"(?<![\w/])(?:docs|tests|benchmarks|cli)/[\w/.-]*[\w]", text):
        assert (ROOT.parent / path).exists(), path
    types = text.partition("\n## Key types\n")[2].partition("\n## ")[0]
    for module, name in re.findall(r"`(\w+\.\w+)\.(\w+)`", types):
        assert hasattr(importlib.import_module(f"robodyn.{module}"), name), f"{module}.{name}"


@pytest.mark.parametrize("file", FILES, ids=str)
def test_imports_only_rooms_above(file: Path) -> None:
    tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
    room = room_of(file)
    if room not in FACADE:
        assert room in ROOMS, f"{file}: {room} is not in the table of docs/architecture.md"
        names = {name for statement in ast.walk(tree) for name in imported(statement, file)}
        for parts in (name.split(".") for name in sorted(names)):
            assert parts[0] != "robodyn_cli", f"{file} imports the command line"
            if parts[0] == "robodyn":
                above = ROOMS[: ROOMS.index(room) + 1]
                assert "".join(parts[1:2]) in above, f"{room} imports {'.'.join(parts)}, not above it"
    early = {name for statement in at_module_level(tree) for name in imported(statement, file)}
    packages = {name.partition(".")[0] for name in early}
    assert "robodyn_cli" not in packages
    if room in LEAN | FACADE:
        assert not packages & LATE, "import it in the function that needs it"


SOURCES = sorted(path.relative_to(ROOT.parent) for top in TOPS for path in (ROOT.parent / top).rglob("*.py"))


@pytest.mark.parametrize("top", TOPS)
def test_no_file_is_long(top: str) -> None:
    """What does not fit on some screens is two things."""
    long = {
        str(file): lines
        for file in SOURCES
        if file.parts[0] == top
        and (lines := len((ROOT.parent / file).read_text(encoding="utf-8").splitlines())) > LINES
    }
    assert not long, f"split along a seam what has more than {LINES} lines"


def test_no_file_imports_itself_through_others() -> None:
    """No circle of files, wherever they import; packages' faces, which only hand names on, are left out."""
    modules = {".".join(file.with_suffix("").parts): file for file in FILES if file.stem not in FACADE}
    graph: dict[str, set[str]] = {}
    for module, file in modules.items():
        tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
        names = {name for statement in ast.walk(tree) for name in imported(statement, file)}
        graph[module] = {m for name in names for m in (name, name.rpartition(".")[0]) if m in modules}
    with_circles = graphlib.TopologicalSorter(graph)
    with_circles.prepare()  # raises CycleError, which names the files
    assert len(modules) > 300
