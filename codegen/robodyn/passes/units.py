"""Units: compute sums as multiples of themselves where fewer values have to be multiplied by constants then.

``c (a x + b y) + s (a z + d w)`` takes one operation fewer as ``a (c (x + b/a y) + s (z + d/a w))``: both
sums are computed in units of ``a``, products carry units on, and the sum of them is in units of ``a`` as well
until it is needed in others. Any sum may be in any unit. What is multiplied is a value that is needed in
another unit than it is in, once for all who need it in the same one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.ir.copying import copied
from robodyn.ir.field import Vanishes
from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.ir.key import children
from robodyn.ir.lowering import lower, needed
from robodyn.ir.program import Program
from robodyn.passes.factor import factor
from robodyn.passes.replay import as_graph
from robodyn.passes.unit_descent import ONE, Descent, Multiple, allowed

#: Positions of a graph at most: of longer programs this saves an operation in some hundreds, and takes long.
_LONGEST = 1300
#: Positions of a graph at most that is started from twice: of longer ones the second start saves little.
_TWICE = 400
#: What counts, as :mod:`robodyn.counts` has it, but for what no unit changes.
_COUNTED = frozenset(("add", "mul", "scale", "div"))

Outputs = Sequence[tuple[str, Sequence[Scalar]]]


def units(program: Program) -> Program:
    """``program`` with its sums in units that save operations, and factored again, while that saves any."""
    while True:
        rescaled = _rescaled(program)
        if rescaled is program:
            return program
        program = factor(rescaled)
        if program is rescaled:
            return program


def _rescaled(program: Program) -> Program:
    """``program`` with its sums in units that save operations; itself if there are none."""
    graph, outputs = as_graph(program, fold=True)
    positions = needed(graph, outputs)
    if len(positions) > _LONGEST:
        return program
    needs = _Needs(graph, outputs, positions)
    best, least = None, _operations(graph, positions)
    try:
        for descent in needs.descents():
            # Values that differed by a factor may be one now: only what is built can be counted.
            target, results = needs.rebuilt(descent.units)
            operations = _operations(target, needed(target, results))
            if operations < least:
                best, least = (target, results), operations
    except Vanishes:
        return program
    return program if best is None else lower(*best)


def _operations(graph: Graph, positions: Iterable[int]) -> int:
    return sum(graph.keys[p][0] in _COUNTED for p in positions)


class _Needs:
    """What the values of a graph are multiples of, and in which units they are needed."""

    def __init__(self, graph: Graph, outputs: Outputs, positions: Sequence[int]) -> None:
        self.graph, self.outputs, self.positions = graph, outputs, positions
        keys = graph.keys
        factors = {q for p in positions if keys[p][0] in ("mul", "div") for q in keys[p][1:3]}
        #: Multiples that are factors of products, with their constants: like sums they may be in any unit.
        self.multiples = {p: keys[p][1] for p in positions if keys[p][0] == "scale" and p in factors}
        #: The value at each position.
        self.values: dict[int, Multiple] = {}
        self.needs: list[Multiple] = []
        for p in positions:
            self.values[p] = self._value(p)
        for _, values in outputs:
            for value in values:
                if isinstance(value, Node):
                    self._need(value.position)

    def _value(self, p: int) -> Multiple:
        """What the value at ``p`` is; and what it needs."""
        key = self.graph.keys[p]
        op = key[0]
        if op == "scale":
            if p not in self.multiples:
                return self.values[key[2]].times(key[1])
            self._need(key[2], p, key[1])
            return Multiple(p, ONE, {p: 1})
        if op == "add":
            self._need(key[1], p)
            self._need(key[3], p)
            return Multiple(p, ONE, {p: 1})
        if op in ("mul", "div"):
            one, other = (self.values[q] for q in key[1:3])
            return one.combined(other, 1 if op == "mul" else -1, p)
        for child in children(key):
            self._need(child)
        return Multiple(p, ONE, {})

    def _need(self, p: int, owner: int | None = None, times: Fraction = ONE) -> None:
        """That ``times`` the value at ``p`` is needed, in the unit of ``owner``."""
        value = self.values[p].times(times)
        if self.graph.keys[value.base][0] != "const":  # which is there in any unit
            self.needs.append(value if owner is None else value.in_unit_of(owner))

    def descents(self) -> Iterator[Descent]:
        """From where constants are multiplied as in the graph, and from where products carry them on."""
        free = [p for p in self.positions if p in self.multiples or self.graph.keys[p][0] == "add"]
        yield Descent(self.needs, free, {})
        if len(self.positions) <= _TWICE:
            carried = {p: constant for p, constant in self.multiples.items() if allowed(constant)}
            yield Descent(self.needs, [p for p in free if p not in carried], carried)

    def rebuilt(self, units: Mapping[int, Fraction]) -> tuple[Graph, Outputs]:
        """The graph with its sums in ``units``, and its outputs."""
        keys, labels, target = self.graph.keys, self.graph.labels, Graph()
        computed: dict[int, Any] = {}

        def value(p: int, unit: Fraction = ONE) -> Any:
            multiple = self.values[p]
            factor, base = multiple.factor(units), computed[multiple.base]
            return base if factor is unit or factor == unit else factor / unit * base

        for p in self.positions:
            key = keys[p]
            own = units.get(p, ONE)
            if key[0] == "add":
                computed[p] = value(key[1], own) + key[2] * value(key[3], own)
            elif key[0] in ("mul", "div"):
                one, other = (computed[self.values[q].base] for q in key[1:3])
                computed[p] = one * other if key[0] == "mul" else one / other
            elif p in self.multiples:
                computed[p] = key[1] * value(key[2], own)
            elif key[0] != "scale":
                computed[p] = copied(target, key, {child: value(child) for child in children(key)})
            if p in labels:
                target.label(value(p), labels[p])
        outputs = [
            (name, [value(v.position) * v.sign if isinstance(v, Node) else v for v in values])
            for name, values in self.outputs
        ]
        return target, outputs
