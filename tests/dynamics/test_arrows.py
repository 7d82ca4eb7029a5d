"""The order of the modules of ``dynamics``, which its docstring states: no import runs upwards."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from robodyn import dynamics

FOLDER = Path(dynamics.__file__).parent
ORDER = " ".join(re.findall(r"(?m)^- .*: ``(.+)``$", dynamics.__doc__ or "")).split()


def upward_imports(unit: str, text: str) -> Iterator[str]:
    """What ``text``, a file of ``unit``, imports of this room that does not stand before it in the order."""
    before = ORDER[: ORDER.index(unit) + 1]
    for node in ast.walk(ast.parse(text)):
        names: list[str] = []
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, "imports within the library are absolute"
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        for name in names:
            match = re.match(r"robodyn\.dynamics\.(\w+)", name)
            if match and match[1] not in before:
                yield f"{unit} imports {match[1]}, which does not stand before it"


def test_the_order_has_every_module_once() -> None:
    units = {path.relative_to(FOLDER).with_suffix("").parts[0] for path in FOLDER.rglob("*.py")}
    assert sorted(ORDER) == sorted(units - {"__init__"})


def test_no_import_runs_upwards() -> None:
    files = [path for path in FOLDER.rglob("*.py") if path != FOLDER / "__init__.py"]
    units = [path.relative_to(FOLDER).with_suffix("").parts[0] for path in files]
    upward = [
        arrow
        for unit, path in zip(units, files, strict=True)
        for arrow in upward_imports(unit, path.read_text(encoding="utf-8"))
    ]
    assert not upward, "\n".join(upward)
