"""A program of arctangents and choices, and its kernels."""

from __future__ import annotations

import dataclasses
from fractions import Fraction
from functools import cache
from typing import Any, Final

import numpy as np

from robodyn.effects.scalars import arctangent, choose, magnitude, root, sine
from robodyn.ir import Graph, Program
from robodyn.ir.lowering import lower
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.passes.order import arctangents_together
from robodyn.robot import load

SCALARS: Final = ("double", "float")
TYPES: Final[dict[str, type[np.floating[Any]]]] = {"double": np.float64, "float": np.float32}
#: The robot and the function whose name the kernels have.
NAME: Final = "stanford_3dof"
FUNCTION: Final = f"{NAME}_gravity"


@cache
def program() -> Program:
    """Angles of points, of points that depend on angles, and choices between them; of q [3]."""
    graph = Graph()
    q = [graph.input("q", i) for i in range(3)]
    first = [arctangent(q[i], q[(i + 1) % 3]) for i in range(3)]
    second = [arctangent(root(1 + a * a) / 2 - 1, a * first[(i + 1) % 3]) for i, a in enumerate(first)]
    chosen = [choose(b - a / 2, a, -b * q[i]) for i, (a, b) in enumerate(zip(first, second, strict=True))]
    results = [
        chosen[0] + choose(-chosen[0], sine(second[0]), 2),
        chosen[1] * arctangent(chosen[2], Fraction(1, 3)) + arctangent(Fraction(-1, 7), q[0]),
        magnitude(chosen[2]) + arctangent(0, q[0]) - choose(q[1], 3, magnitude(q[2])),
    ]
    return lower(graph, [("tau", results)])


def of_program(program: Program, scalar: str, trig: str = "builtin") -> Generated:
    """Kernels whose only function is ``program``."""
    options = Options(trig=trig, scalar=scalar, functions=("gravity",))  # type: ignore[arg-type]
    generated = generate(load(NAME, warn=lambda _: None), options)
    ((signature, _),) = generated.unit.functions
    in_runs = arctangents_together(program) if trig == "builtin" else program
    return dataclasses.replace(
        generated, unit=dataclasses.replace(generated.unit, functions=((signature, in_runs),))
    )
