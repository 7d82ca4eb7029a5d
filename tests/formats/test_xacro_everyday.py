"""Everyday xacro expands to what plain xacro makes of it, element for element: everyday_xacro.yaml has it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

from robodyn.formats.xacro import expanded
from robodyn_testing import representative, require_module
from robodyn_testing.plain_xacro import element_list, plain_expansions
from robodyn_testing.xacro_arms import write

CASES: dict[str, dict[str, Any]] = yaml.safe_load(
    Path(__file__).with_name("everyday_xacro.yaml").read_text(encoding="utf-8")
)


@pytest.fixture(scope="module")
def references(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[Path, str]]:
    """By case its top file and what plain xacro makes of it: one process for all."""
    require_module("xacro")
    tasks = {}
    for name, case in CASES.items():
        folder = tmp_path_factory.mktemp("case") / "ws"
        write(folder, case["files"])
        tasks[name] = (
            folder / case.get("top", "arm.urdf.xacro"),
            case.get("arguments", {}),
            {package: folder / path for package, path in case.get("packages", {}).items()},
        )
    texts = plain_expansions(list(tasks.values()))
    return {name: (task[0], text) for (name, task), text in zip(tasks.items(), texts, strict=True)}


@pytest.mark.parametrize(
    "name",
    representative(
        CASES, "names", "family with arguments", "lists", "scopes", "blocks", "includes", "yaml",
        "arguments stated",
    ),
)  # fmt: skip
def test_the_elements_are_those_of_plain_xacro(name: str, references: dict[str, tuple[Path, str]]) -> None:
    path, reference = references[name]
    assert element_list(expanded(path, CASES[name].get("arguments", {})).text) == element_list(reference)
