"""Functions are records: nothing but their own folder asks which function it has by a name."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from robodyn.dynamics.functions import FUNCTIONS, INPUTS, array_named, function_named, torques_at
from robodyn.dynamics.functions.record import Array
from robodyn.errors import InputError

ROOT = Path(__file__).parents[2]
OWN = ROOT / "codegen" / "robodyn" / "dynamics" / "functions"
#: But for the rooms in which gravity is a key of YAML.
FILES = sorted(
    path
    for place in ("codegen", "cli")
    for path in (ROOT / place).rglob("*.py")
    if OWN not in path.parents and not {"robot", "diagnose"} & set(path.parts)
)


def names_asked_for(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Names of functions that something is compared with, by line."""
    for node in ast.walk(tree):
        compared: list[ast.AST] = []
        if isinstance(node, ast.Compare):
            compared = [node.left, *node.comparators]
        elif isinstance(node, ast.match_case):
            compared = [node.pattern]
        for inner in (part for side in compared for part in ast.walk(side)):
            if isinstance(inner, ast.Constant) and inner.value in FUNCTIONS:
                yield inner.lineno, inner.value


@pytest.mark.thorough
def test_nobody_asks_for_a_name() -> None:
    places = [
        f"{file.relative_to(ROOT)}:{line}: {name}: ask its record (robodyn.dynamics.functions) instead"
        for file in FILES
        for line, name in names_asked_for(ast.parse(file.read_text(encoding="utf-8")))
    ]
    assert not places, "\n".join(places)
    assert len(FILES) > 600


def test_such_a_question_is_found() -> None:
    tree = ast.parse('if f == "gravity":\n    pass\nmatch f:\n    case "bias" | "tau":\n        pass\n')
    assert sorted(names_asked_for(tree)) == [(1, "gravity"), (4, "bias")]


def test_what_is_unknown_is_an_error_that_says_what_there_is() -> None:
    with pytest.raises(InputError, match=r"unknown function 'bais'; expected one of .*mean 'bias'\?"):
        function_named("bais")
    with pytest.raises(InputError, match="unknown array 'Z'; expected one of q, qd, qdd, tau, w, pi"):
        array_named("Z")


def test_torques_by_what_is_zero() -> None:
    rest, moving = [0, 0], [0, 1]
    assert torques_at(moving, moving).name == "inverse_dynamics"
    assert torques_at(moving, rest).name == "bias"
    assert torques_at(rest, rest).name == "gravity"
    assert torques_at(rest, moving).name == "inverse_dynamics"


@pytest.mark.parametrize("array", [*INPUTS, *(a for f in FUNCTIONS.values() for a in f.results)], ids=str)
def test_shapes_come_back_from_sizes(array: Array) -> None:
    for n in (1, 2, 6, 30):
        assert array.shape_of(array.size_at(n, 7, 8), n) == array.shape_at(n, 7, 8)
        if not {"p", "b"} & set(array.shape):
            assert array.shape_of(array.size_at(n)) == array.shape_at(n)


def test_shapes_of_other_kinds() -> None:
    assert Array("J", "Jacobian", "m, 1", shape=(6, "n")).shape_of(42) == (6, 7)
    assert Array("T", "tool frame", "m", shape=(3, 4)).shape_of(12) == (3, 4)
    assert Array("E", "energy", "J", shape=()).shape_of(1) == ()
    with pytest.raises(ValueError, match=r"M is \['n', 'n'\], and not of 5 numbers"):
        array_named("M").shape_of(5)
