"""What no test may do."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

TESTS = Path(__file__).parent
CLOCKS = {"monotonic", "monotonic_ns", "perf_counter", "perf_counter_ns", "process_time", "process_time_ns"}
MAY_READ_CLOCKS = {"robodyn_testing/waiting.py"}
FILES = [path.relative_to(TESTS).as_posix() for path in sorted(TESTS.rglob("*.py"))]


def clock_readings(text: str) -> list[int]:
    """The lines that read a clock of the machine."""
    calls = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Call)]
    return [call.lineno for call in calls if isinstance(f := call.func, ast.Attribute) and f.attr in CLOCKS]


@pytest.mark.thorough
def test_nothing_depends_on_the_speed_of_the_machine() -> None:
    """What takes too long is told by its calls or a clock of the test's own (robodyn_testing.clocks)."""
    places = [
        f"{file}:{line}"
        for file in FILES
        if file not in MAY_READ_CLOCKS
        for line in clock_readings((TESTS / file).read_text(encoding="utf-8"))
    ]
    assert not places, "these lines read a clock: " + ", ".join(places)
    assert len(FILES) > 400
