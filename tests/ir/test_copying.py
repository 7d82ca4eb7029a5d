"""Graphs put into another order: what a copy made operation by operation would be."""

from __future__ import annotations

import random

from hypothesis import given, reject, settings
from hypothesis import strategies as st

from ir.programs import EVERYTHING, programs
from robodyn.ir import Graph, Node, Program
from robodyn.ir.copying import copied, rearranged
from robodyn.ir.graph import Scalar
from robodyn.passes.order import before_use


@settings(max_examples=40)
@given(programs(EVERYTHING), st.randoms(use_true_random=False), st.booleans())
def test_rearranged_is_copied_in_that_order(program: Program, chance: random.Random, fold: bool) -> None:
    graph = Graph(fold=fold)
    try:
        outputs = graph.replay(program)
    except ZeroDivisionError:
        reject()
    roots = list(range(len(graph.keys)))
    chance.shuffle(roots)
    order = before_use(roots, graph.reads)

    target = Graph(fold=fold)
    copies: dict[int, Scalar] = {}
    for p in order:
        copies[p] = copied(target, graph.keys[p], copies)
        if p in graph.labels:
            target.label(copies[p], graph.labels[p])
    wanted = [copies[v.position] * v.sign if isinstance(v, Node) else v for v in outputs]

    other, values = rearranged(graph, order, outputs)
    assert (other.keys, other.reads, other.labels) == (target.keys, target.reads, target.labels)
    assert [_place(v) for v in values] == [_place(v) for v in wanted]
    # It grows like any other graph: what is there already is not made again.
    assert [_place(v) for v in other.replay(program)] == [_place(v) for v in target.replay(program)]
    assert other.keys == target.keys


def _place(value: object) -> object:
    return (value.position, value.sign) if isinstance(value, Node) else value
