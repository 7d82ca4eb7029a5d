"""The order of the book: quantities that were worked out on demand, written base to tip.

What is worked out on demand comes in the order in which the torques happen to ask for it. Here the motion of
the links is put first, base to tip, then forces and moments, tip to base; the rest follows as it came.
"""

from __future__ import annotations

from collections.abc import Sequence

from robodyn.ir.copying import rearranged
from robodyn.ir.graph import Graph, Scalar
from robodyn.ir.lowering import needed
from robodyn.passes.order import before_use

#: Quantities of the forward and the backward pass, in order within a link.
FORWARD = ("w", "alpha", "ww", "lam", "a")
BACKWARD = ("fc", "nc", "f", "n", "f0", "n0", "tau")


def in_reading_order(graph: Graph, outputs: Sequence[Scalar]) -> tuple[Graph, list[Scalar]]:
    """What ``outputs`` need of ``graph`` in a graph of its own, made in the order of the book; and the
    outputs there."""
    positions = needed(graph, [("", outputs)])
    labels = graph.labels
    named = [(labels[p].link, labels[p].quantity, p) for p in positions if p in labels]
    forward = [(link, FORWARD.index(quantity), p) for link, quantity, p in named if quantity in FORWARD]
    back = [(-link, BACKWARD.index(quantity), p) for link, quantity, p in named if quantity in BACKWARD]
    roots = [p for _, _, p in (*sorted(forward), *sorted(back))]
    return rearranged(graph, before_use((*roots, *positions), graph.reads), outputs)
