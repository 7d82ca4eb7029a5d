"""``python -m benchmarks.functions``: what tools are given is right, what they make is counted as ours is,
and the documents have the figures of functions.json."""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from benchmarks.functions.__main__ import DOCUMENT, PEERS, REACH, RESULTS, _fewest, of_robot, peers_text
from benchmarks.functions.answers import Answers
from benchmarks.functions.counting import Uncounted, of_python
from benchmarks.functions.natural import NATURAL
from benchmarks.functions.state import Rows, State, Values
from benchmarks.functions.tables import in_document, markdown
from benchmarks.peers.ours import values_of

from robodyn.bench.peers.numbers import numbers_of
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.kernels.generate import Options, program
from robodyn.robot import load


class NoDerivatives(Exception):
    """Floats have none."""


class Numerically:
    """A tool that computes with floats; it differentiates nothing."""

    def sin(self, x: Any) -> Any:
        return math.sin(x)

    def cos(self, x: Any) -> Any:
        return math.cos(x)

    def jacobian(self, values: Sequence[Any], by: Sequence[Any]) -> Rows:
        raise NoDerivatives

    def substituted(self, values: Sequence[Any], symbols: Sequence[Any], by: Sequence[Any]) -> Values:
        raise NoDerivatives

    def solved(self, matrix: Rows, right: Rows) -> Rows:
        return np.linalg.solve(np.array(matrix, float), np.array(right, float)).tolist()  # type: ignore[no-any-return]


@pytest.mark.parametrize("name", ["puma560", "stanford"])
def test_what_tools_are_given_has_our_values(name: str) -> None:
    robot = load(name, warn=lambda _: None)
    random = np.random.default_rng(2)
    states = np.array([random.uniform(-reach, reach, (2, robot.n)) for reach in REACH])
    arm, compared = numbers_of(robot), set()
    for function in NATURAL.keys() & FUNCTIONS.keys():
        own = program(robot, function, Options((function,), optimize="none"))
        expected = values_of(own, states)
        for write in NATURAL[function]:
            try:
                rows = [write(State(arm, Numerically(), *state.tolist())) for state in states.swapaxes(0, 1)]
            except NoDerivatives:
                continue
            assert np.array(rows, float) == pytest.approx(expected, rel=1e-9, abs=1e-9), (function, write)
            compared.add(function)
    differentiated = {"coriolis_matrix", "momentum_observer_term"} | {
        f for f in NATURAL if "derivatives" in f
    }
    assert compared == (NATURAL.keys() & FUNCTIONS.keys()) - differentiated


def test_operations_of_python() -> None:
    text = """
import numpy
def f(x: numpy.ndarray) -> numpy.ndarray:
    a = -x[0, 0] + numpy.sin(x[1, 0]) * 2 - 1 / x[2, 0]
    b = a**2 + a**5 / numpy.sqrt(a) - a**-1
    return numpy.array([a, b]).reshape(2, 1)
"""
    counted = of_python(text).to_dict()
    assert counted == {
        "mul": 1 + 1 + 3, "add": 2 + 2, "div": 1 + 1 + 1, "sqrt": 1, "neg": 1, "sincos": 1, "other": 0,
        "total": 5 + 4 + 3 + 1,
    }  # fmt: skip
    with pytest.raises(Uncounted, match="tan"):
        of_python("def f(x):\n    return math.tan(x)\n")


def test_only_our_values_count_and_the_fewest_operations_of_them() -> None:
    ours = np.array([[1.0, 2.0], [3.0, 4.0]])
    right, wrong = ours.tolist(), (ours + 1e-6).tolist()
    ways = (({"total": 5}, wrong), ({"total": 9}, right), ({"total": 7}, right))
    assert _fewest("tool", Answers("gravity", ways), ours) == {"total": 7}
    assert _fewest("tool", Answers("gravity", ways[:1]), ours)["why"].startswith("refused: ")
    assert _fewest("tool", Answers("gravity", (), "too slow"), ours) == {"why": "too slow"}


def test_of_an_arm_without_masses_and_with_a_tool(tmp_path: Path, figures: Any) -> None:
    """What has no operations is not compared, and what the tool changes is not asked of the others."""
    options = argparse.Namespace(work=str(tmp_path), seconds=1)
    functions = ["inverse_dynamics", "forward_kinematics", "link_poses"]
    table = of_robot("puma560_3dof_d13", functions, [], options)
    assert list(table) == ["forward_kinematics", "link_poses"]
    committed = figures["robots"]["puma560_3dof_d13"]
    assert "without its tool" in committed["forward_kinematics"]["casadi"]["why"]
    assert committed["link_poses"]["casadi"]["total"] > table["link_poses"]["fast"]["total"]


@pytest.fixture
def figures() -> Any:
    return json.loads((RESULTS / "functions.json").read_text(encoding="utf-8"))


def test_the_documents_are_made_of_the_committed_figures(figures: Any) -> None:
    assert (RESULTS / "functions.md").read_text(encoding="utf-8") == markdown(figures)
    document = DOCUMENT.read_text(encoding="utf-8")
    assert in_document(figures, document) == document
    assert PEERS.read_text(encoding="utf-8") == peers_text(figures)
