"""The program as a graph to edit: what an edit saves, what errors it makes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from robodyn.ir.copying import copied
from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.ir.key import children
from robodyn.ir.lowering import lower, needed
from robodyn.ir.program import Program
from robodyn.optimize.prune.bounds import Expansions
from robodyn.optimize.prune.box import Box, draw, functions
from robodyn.passes.replay import grouped

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

COSTLY = frozenset(("add", "mul", "scale", "div"))
#: What takes the place of a position: nothing, or a position before it with a sign.
Edit = tuple[int, int] | None
Edits = Mapping[int, Edit]

#: States at which the effects of edits are estimated.
STATES = 160


class Editor:
    """The graph of ``program``, which stays as it is while edited copies grow beside it; ``budget`` [m] is
    the error that each output may make."""

    def __init__(self, program: Program, box: Box, budget: Sequence[float], seed: int = 1) -> None:
        self.program, self.box, self.budget = program, box, tuple(budget)
        self.graph = Graph()
        self.outputs = self.graph.replay(program)
        self.positions = needed(self.graph, [("", self.outputs)])
        self.expansions = Expansions(self.graph, box)
        self.fixed = self._inside(lambda op: op not in COSTLY)
        #: Angles and what they are made of: nothing to put in a torque's place.
        self.angular = self._inside(lambda op: op in ("sin", "cos")) - {
            p for p in self.positions if self.graph.keys[p][0] in ("sin", "cos")
        }
        self.values: dict[int, Any] = {}
        self._rows = dict(zip(box.inputs, draw(box, STATES, seed), strict=True))
        self._shares: dict[Any, float] = {}

    def _inside(self, kind: Callable[[str], bool]) -> set[int]:
        """Positions of this kind and all that they are made of."""
        keys = self.graph.keys
        inside: set[int] = set()
        for p in reversed(self.positions):
            if p in inside or kind(keys[p][0]):
                inside.add(p)
                inside.update(children(keys[p]))
        return inside

    def edited(self, edits: Edits, graph: Graph | None = None) -> tuple[dict[int, Scalar], list[Scalar]]:
        """Every position's value with ``edits`` made, and the outputs; in ``graph`` if one is given."""
        target = graph or self.graph
        keys, labels = self.graph.keys, self.graph.labels
        copies: dict[int, Scalar] = {}
        for p in self.positions:
            if p in edits:
                edit = edits[p]
                copies[p] = 0 if edit is None else edit[0] * copies[edit[1]]
                continue
            copies[p] = copied(target, keys[p], copies)
            if graph is not None and p in labels:
                graph.label(copies[p], labels[p])
        return copies, [v.sign * copies[v.position] if isinstance(v, Node) else v for v in self.outputs]

    def written(self, edits: Edits) -> Program:
        """The program with ``edits`` made, no pass run."""
        graph = Graph()
        _, outputs = self.edited(edits, graph)
        return lower(graph, grouped(self.program, outputs))

    def cost(self, outputs: Sequence[Scalar]) -> int:
        """Operations that ``outputs`` take."""
        keys = self.graph.keys
        return sum(keys[p][0] in COSTLY for p in needed(self.graph, [("", outputs)]))

    def shares(self, outputs: Sequence[Scalar]) -> list[float] | None:
        """Bounds of the errors of ``outputs`` as shares of the budgets, close only where that matters; None
        if one is above its budget."""
        shares: list[float] = []
        for j, (one, other) in enumerate(zip(outputs, self.outputs, strict=True)):
            share = 0.0 if one == other else self._share(j, one, other)
            if not share <= 1:
                return None
            shares.append(share)
        return shares

    def _share(self, j: int, one: Scalar, other: Scalar) -> float:
        name = (j, one.position, one.sign) if isinstance(one, Node) else (j, one)
        if name not in self._shares:
            budget = self.budget[j]
            error = self.expansions.difference(one, other)
            self._shares[name] = self.expansions.share(error, budget) if budget else float("inf")
        return self._shares[name]

    def sample(self, order: Sequence[int]) -> None:
        """Fill in the values at the states, of positions ``order``."""
        import numpy as np

        keys, values = self.graph.keys, self.values
        of = functions()
        for p in order:
            if p in values:
                continue
            key = keys[p]
            op = key[0]
            if op == "input":
                values[p] = self._rows[key[1]]
            elif op == "const":
                values[p] = np.full(STATES, float(key[1]))
            elif op == "add":
                values[p] = values[key[1]] + key[2] * values[key[3]]
            elif op == "scale":
                values[p] = float(key[1]) * values[key[2]]
            elif op == "mul":
                values[p] = values[key[1]] * values[key[2]]
            else:
                values[p] = of[op](values[key[1]])

    def sensitivities(self, order: Sequence[int], outputs: Sequence[Scalar]) -> dict[int, Any]:
        """Derivatives ``[m, N]`` of the outputs by each position, as shares of the budgets."""
        import numpy as np

        keys, values = self.graph.keys, self.values
        by: dict[int, Any] = {p: np.zeros((len(outputs), STATES)) for p in order}
        for j, v in enumerate(outputs):
            if isinstance(v, Node):
                by[v.position][j] += v.sign / self.budget[j] if self.budget[j] else 1e30
        for p in reversed(order):
            key, own = keys[p], by[p]
            if key[0] == "add":
                by[key[1]] += own
                by[key[3]] += key[2] * own
            elif key[0] == "scale":
                by[key[2]] += float(key[1]) * own
            elif key[0] == "mul":
                by[key[1]] += own * values[key[2]]
                by[key[2]] += own * values[key[1]]
        return by
