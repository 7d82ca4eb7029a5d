"""The validator finds every kind of fault, each where it is, and no other."""

from __future__ import annotations

import ast
from pathlib import Path

from robodyn.schedule import validate
from robodyn.schedule.validate import Fault, faults_of_levels, faults_of_times, summary

AFTER = {1: set[int](), 2: {1}, 3: {1}, 4: {2, 3}}


def test_a_good_schedule_has_no_faults() -> None:
    assert faults_of_levels(AFTER, 2, [(1,), (2, 3), (4, None)]) == []


def test_each_fault_in_levels() -> None:
    assert faults_of_levels(AFTER, 2, [(1, 2), (3,), (4,)]) == [Fault("precedence", 2, 1, 1)]
    assert faults_of_levels(AFTER, 1, [(1,), (2, 3), (4,)]) == [Fault("crowded", 3, 2)]
    assert faults_of_levels(AFTER, 2, [(1,), (2, 3), (4, 2)]) == [Fault("twice", 2, 3)]
    assert faults_of_levels(AFTER, 2, [(1,), (2, 9), (3,), (4,)]) == [Fault("unknown", 9, 2)]
    assert faults_of_levels(AFTER, 2, [(1,), (2,), (4,)]) == [Fault("missing", 3, 0)]  # 4 is not blamed
    assert faults_of_levels(AFTER, 2, [(4,), (1,), (2, 3)]) == [
        Fault("precedence", 4, 1, 2),
        Fault("precedence", 4, 1, 3),
    ]


def test_each_fault_in_times() -> None:
    good = [(1, 0, 0, 1), (2, 0, 1, 2), (3, 1, 3, 4), (4, 1, 4, 5)]
    assert faults_of_times(AFTER, {}, 2, 2, good) == []
    late = [Fault("early", 3, 3, 1), Fault("early", 4, 4, 2)]
    assert faults_of_times(AFTER, {}, 2, 3, good) == late  # values come later
    assert faults_of_times(AFTER, {3: 2}, 2, 2, good) == [Fault("length", 3, 3)]
    assert Fault("overlap", 3, 3, 2) in faults_of_times(
        AFTER, {2: 3}, 2, 0, [(1, 0, 0, 1), (2, 1, 1, 4), (3, 1, 3, 4), (4, 0, 4, 5)]
    )
    assert Fault("crowded", 3, 3) in faults_of_times(AFTER, {}, 1, 2, good)
    assert faults_of_times(AFTER, {}, 2, 2, good[:3]) == [Fault("missing", 4, 0)]
    assert Fault("twice", 4, 6) in faults_of_times(AFTER, {}, 2, 2, [*good, (4, 0, 6, 7)])
    assert Fault("unknown", 8, 6) in faults_of_times(AFTER, {}, 2, 2, [*good, (8, 0, 6, 7)])
    assert summary(faults_of_times(AFTER, {}, 2, 3, good[:3])) == {"missing": 1, "early": 1}


def test_levels_begin_together() -> None:
    levels = [(1, None), (2, 3), (4, None)]
    good = [(1, 0, 0, 1), (2, 0, 1, 2), (3, 1, 1, 2), (4, 0, 2, 3)]
    assert faults_of_times(AFTER, {}, 2, 0, good, levels=levels) == []
    late = [*good[:2], (3, 1, 2, 3), (4, 0, 3, 4)]
    assert Fault("levels", 3, 2) in faults_of_times(AFTER, {}, 2, 0, late, levels=levels)


def test_it_shares_no_code_with_the_schedulers() -> None:
    tree = ast.parse(Path(validate.__file__).read_text(encoding="utf-8"))
    named = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    assert not {name for name in named if name and name.startswith("robodyn")}
