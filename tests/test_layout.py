"""The rooms of the library: each imports only rooms above it in the list, and nothing from beyond the wall
between the houses; sympy and its like come late."""

from __future__ import annotations

import ast
import fnmatch
import graphlib
import importlib
import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1] / "codegen"


def rooms() -> list[str]:
    """The rooms in their order, which stands in one place: the table of docs/architecture.md."""
    return re.findall(r"(?m)^\| `(\w+)` \|", section("Rooms"))


def section(title: str) -> str:
    """What docs/architecture.md has under the heading ``title``."""
    text = (ROOT.parent / "docs" / "architecture.md").read_text(encoding="utf-8")
    return text.partition(f"\n## {title}\n")[2].partition("\n## ")[0]


def houses() -> dict[str, tuple[list[str], list[str]]]:
    """By house the patterns of its rooms and modules, and of the rooms that it imports nothing of."""
    table = {}
    for row in re.findall(r"(?m)^\| (.*) \|$", section("Houses"))[1:]:
        house, _, within, barred = (cell.strip() for cell in f"{row} ".split("|"))
        table[house] = (re.findall(r"`([\w.*]+)`", within), re.findall(r"`(\w+)`", barred))
    return table


ROOMS = rooms()
HOUSES = houses()
#: Beyond which wall each house lies for another.
BARRED = {"generator": {"log side"}, "log side": {"thesis"}, "thesis": set[str]()}
LATE = {"sympy", "numpy", "scipy", "matplotlib"}
LEAN = {"ir", "robot", "dynamics", "passes", "counts", "optimize", "emit"}
FACADE = {"__init__", "__main__"}
#: Folders whose files are held to a length, and that length.
TOPS, LINES = ("codegen", "cli", "docs", "tests", "benchmarks"), 350
FILES = sorted(path.relative_to(ROOT) for path in ROOT.rglob("*.py"))
COMMANDS = ROOT.parent / "cli"


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


def house_of(parts: Sequence[str]) -> str:
    """The house of a module of the library, by the ``parts`` of its name below ``robodyn``."""
    for house, (patterns, _) in HOUSES.items():
        for pattern in patterns:
            names = pattern.split(".")
            if len(parts) >= len(names) and all(map(fnmatch.fnmatch, parts, names)):
                return house
    return "generator"


def beyond_the_wall(names: Iterable[str], file: Path) -> Iterator[str]:
    """Which of the imported ``names`` lie in a house that the house of ``file`` knows nothing of."""
    if file.stem in FACADE:
        return
    house = house_of(file.with_suffix("").parts[1:])
    for parts in (name.split(".") for name in sorted(names)):
        if parts[0] != "robodyn" or len(parts) < 2:
            continue
        if house_of(parts[1:]) in BARRED[house] or parts[1] in HOUSES[house][1]:
            yield f"{file}: the {house} imports {'.'.join(parts)}, which is beyond the wall"


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


@cache
def tree_of(file: Path) -> ast.Module:
    root = COMMANDS if file.parts[0] == "robodyn_cli" else ROOT
    return ast.parse((root / file).read_text(encoding="utf-8"))


def out_of_order(tree: ast.Module, file: Path) -> Iterator[str]:
    """What of the imports of ``file`` goes against the order of the rooms, or comes too early."""
    room = room_of(file)
    if room not in FACADE:
        names = {name for statement in ast.walk(tree) for name in imported(statement, file)}
        above = ROOMS[: ROOMS.index(room) + 1]
        for parts in (name.split(".") for name in sorted(names)):
            if parts[0] == "robodyn" and "".join(parts[1:2]) not in above:
                yield f"{file}: {room} imports {'.'.join(parts)}, which is not above it"
            if parts[0] == "robodyn_cli":
                yield f"{file} imports the command line"
        yield from beyond_the_wall(names, file)
    early = {name for statement in at_module_level(tree) for name in imported(statement, file)}
    packages = {name.partition(".")[0] for name in early}
    if "robodyn_cli" in packages:
        yield f"{file} imports the command line"
    if room in LEAN | FACADE:
        yield from (f"{file} imports {name}: do so in the function that needs it" for name in packages & LATE)


@pytest.mark.thorough
def test_imports_only_rooms_above() -> None:
    """All files in one test, which takes as long as it takes to read them."""
    places = [place for file in FILES for place in out_of_order(tree_of(file), file)]
    assert not places, "\n".join(places)


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


@pytest.mark.thorough
def test_no_file_imports_itself_through_others() -> None:
    """No circle of files, of library and command line, wherever they import; packages' faces, which only hand
    names on, are left out."""
    commands = (path.relative_to(COMMANDS) for path in COMMANDS.rglob("*.py"))
    files = [file for file in (*FILES, *commands) if file.stem not in FACADE]
    modules = {".".join(file.with_suffix("").parts): file for file in files}
    graph: dict[str, set[str]] = {}
    for module, file in modules.items():
        names = {name for statement in ast.walk(tree_of(file)) for name in imported(statement, file)}
        graph[module] = {m for name in names for m in (name, name.rpartition(".")[0]) if m in modules}
    with_circles = graphlib.TopologicalSorter(graph)
    with_circles.prepare()  # raises CycleError, which names the files
    assert len(modules) > 300
