"""How the recursion of an arm is written: a formulation, and what of it is chosen to save operations.

The programs of a function whose results are approached are made here (start, step and what follows), and the
order of the book: what is worked out on demand comes in the order in which the torques happen to ask for it;
the motion of the links is put first, base to tip, then forces and moments, tip to base.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.functions import Function
from robodyn.dynamics.functions.record import Writing
from robodyn.dynamics.state import Iterative
from robodyn.errors import InputError
from robodyn.ir.copying import rearranged
from robodyn.ir.graph import Graph, Scalar
from robodyn.ir.lowering import needed
from robodyn.ir.program import STATE, Iteration, Program
from robodyn.optimize.variant import Variant
from robodyn.passes.order import before_use

if TYPE_CHECKING:
    from robodyn.dynamics.arm import Arm, Motion
    from robodyn.dynamics.vectors import Mark

_OWN = {"modified_newton_euler": "modified Newton-Euler (lambda matrix)", "newton_euler": "Newton-Euler"}
#: The package that registers further formulations. Its name is all that the generator holds of it.
_FURTHER = "robodyn.thesis.formulations"
#: Formulations of the inverse dynamics, from the description as it stands, and their titles.
FORMULATIONS: dict[str, str] = {**_OWN, **importlib.import_module(_FURTHER).TITLES}


def formulation_named(name: str) -> Callable[[Arm, Motion, Mark], Sequence[Any]]:
    """The function from an arm in motion to its joint torques, imported when it is asked for.

    Raises
    ------
    InputError: there is no such formulation.
    """
    if name not in FORMULATIONS:
        raise InputError(f"unknown formulation {name!r}", expected=f"one of {', '.join(FORMULATIONS)}")
    module = importlib.import_module(f"{'robodyn.dynamics' if name in _OWN else _FURTHER}.{name}")
    function: Callable[[Arm, Motion, Mark], Sequence[Any]] = getattr(module, name)
    return function


@dataclass(frozen=True, slots=True)
class Choice:
    """How the recursion is written: the formulation, and whether base parameters are regrouped (in the
    modified Newton-Euler recursion); then ``chains`` says whether parallel joints turn as one, unless
    ``variant`` says everything."""

    formulation: str = "modified_newton_euler"
    regroup: bool = True
    chains: bool = True
    variant: Variant | None = None


#: Arrays of nodes by name.
Inputs = Mapping[str, Sequence[Any]]
#: Values, one after another, as ``(name, elements)`` of each result.
Split = Callable[[Sequence[Any]], list[tuple[str, Sequence[Any]]]]


def iterated(
    function: Function,
    approach: Iterative,
    n: int,
    written: Callable[[Graph, Inputs, Writing, Split], Program],
) -> Program:
    """The program of ``function`` for ``n`` joints; ``written`` gives what a writing is of inputs in a
    graph, split into its results."""

    def part(writing: Writing, size: int, split: Split) -> Program:
        graph = Graph()
        inputs = function.nodes(graph.input, n)
        if size:
            inputs[STATE] = [graph.input(STATE, i) for i in range(size)]
            inputs["q"] = inputs[STATE][:n]
        return written(graph, inputs, writing, split)

    def state(values: Sequence[Any]) -> list[tuple[str, Sequence[Any]]]:
        return [(STATE, values)]

    start = part(approach.start, 0, state)
    size = len(start.results())
    step = part(approach.step, size // approach.rows, state)
    finish = part(approach.finish, size, lambda values: function.split(values, n))
    return replace(finish, iteration=Iteration(start, step, approach.most))


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
