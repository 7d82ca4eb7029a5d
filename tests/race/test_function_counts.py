"""``python -m benchmarks.functions``: what tools are given is right, what they make is counted as ours is,
and the documents have the figures of functions.json."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from benchmarks.functions.__main__ import DOCUMENT, PEERS, RESULTS, _fewest, peers_text
from benchmarks.functions.answers import Answers
from benchmarks.functions.counting import Uncounted, of_python
from benchmarks.functions.tables import in_document, markdown


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


@pytest.fixture
def figures() -> Any:
    return json.loads((RESULTS / "functions.json").read_text(encoding="utf-8"))


def test_the_documents_are_made_of_the_committed_figures(figures: Any) -> None:
    assert (RESULTS / "functions.md").read_text(encoding="utf-8") == markdown(figures)
    document = DOCUMENT.read_text(encoding="utf-8")
    assert in_document(figures, document) == document
    assert PEERS.read_text(encoding="utf-8") == peers_text(figures)
