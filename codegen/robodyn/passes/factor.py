"""Factor: ``a x + b x`` becomes ``(a + b) x`` where the products serve nothing else."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.ir.copying import Copies
from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.ir.lowering import lower, needed
from robodyn.ir.program import Program
from robodyn.passes.replay import as_graph

#: Each round frees sums for the next; on long arms the later rounds gain little.
_ROUNDS = 8

#: What a round makes fewer of.
_COUNTED = frozenset(("add", "mul", "scale", "div"))
_PRODUCTS = ("mul", "scale")

Term = tuple[int, int]  # position and sign
Outputs = list[tuple[str, list[Any]]]


def factor(program: Program) -> Program:
    """``program`` with sums of products factored until that saves nothing more."""
    graph, outputs = as_graph(program, fold=True)
    first = best = _Factoring(graph, outputs)
    for _ in range(_ROUNDS):
        factored = best.factored()
        if factored is None:
            break
        better = _Factoring(*factored)
        if better.cost >= best.cost:
            break
        best = better
    return program if best is first else lower(best.graph, best.outputs)


class _Factoring:
    """One round over all sums of a graph."""

    def __init__(self, graph: Graph, outputs: Outputs) -> None:
        self.graph, self.outputs = graph, outputs
        keys, reads = graph.keys, graph.reads
        self.positions = needed(graph, outputs)
        uses = [0] * len(keys)
        self.cost = 0
        sums = []
        for p in self.positions:
            for child in reads[p]:
                uses[child] += 1
            op = keys[p][0]
            self.cost += op in _COUNTED
            if op == "add":
                sums.append(p)
        for _, values in outputs:
            for v in values:
                if isinstance(v, Node):
                    uses[v.position] += 1
        # Additions that serve one other addition only are part of that one's sum; products that serve one
        # thing only may be taken apart.
        self.inner = inner = bytearray(len(keys))
        self.single = single = bytearray(len(keys))
        for p in sums:
            for child in reads[p]:
                if uses[child] == 1:
                    inner[child] = keys[child][0] == "add"
                    single[child] = keys[child][0] in _PRODUCTS
        self.roots = []
        for p in sums:
            one, other = reads[p]
            if not inner[p] and (inner[one] or inner[other] or (single[one] and single[other])):
                self.roots.append(p)

    def factored(self) -> tuple[Graph, Outputs] | None:
        """The graph with every factorable sum factored, and its outputs; None if there is none."""
        sums: dict[int, tuple[list[Term], Any]] = {}
        dissolved: set[int] = set()
        for p in self.roots:
            if self._shares_a_factor(p):
                terms = self._terms(p, dissolved)
                sums[p] = (terms, self._common(terms))
        if not sums:
            return None
        target = Graph()
        copies = Copies(self.graph, target)
        unchanged: list[int] = []  # so far
        for p in self.positions:
            if p in sums:
                copies.copy(unchanged)
                copies.put(p, self._factored(*sums[p], copies))
                unchanged = []
            elif p not in dissolved:
                unchanged.append(p)
        copies.copy(unchanged)
        outputs = [
            (name, [copies[v.position] * v.sign if isinstance(v, Node) else v for v in values])
            for name, values in self.outputs
        ]
        return target, outputs

    def _shares_a_factor(self, root: int) -> bool:
        """Whether two products of the sum at ``root`` have a factor in common."""
        keys, inner, single = self.graph.keys, self.inner, self.single
        factors: list[Any] = []
        stack = list(self.graph.reads[root])
        while stack:
            p = stack.pop()
            if inner[p]:
                stack += self.graph.reads[p]
            elif single[p]:
                factors += set(_factors(keys[p]))
        return len(set(factors)) < len(factors)

    def _terms(self, root: int, inside: set[int]) -> list[Term]:
        """The terms of the sum at ``root``, left to right; additions inside it are put into ``inside``."""
        keys, inner = self.graph.keys, self.inner
        terms: list[Term] = []
        stack: list[Term] = [(root, 1)]
        while stack:
            p, sign = stack.pop()
            if p == root or inner[p]:
                if p != root:
                    inside.add(p)
                _, i, relative, j = keys[p]
                stack.append((j, sign * relative))
                stack.append((i, sign))
            else:
                terms.append((p, sign))
        return terms

    def _common(self, terms: list[Term]) -> Any:
        """The factor that most products of ``terms`` share."""
        counts: dict[Any, int] = {}
        for p, _ in terms:
            if self.single[p]:
                for factor in dict.fromkeys(_factors(self.graph.keys[p])):
                    counts[factor] = counts.get(factor, 0) + 1
        return max(counts, key=counts.__getitem__)

    def _factored(self, terms: list[Term], common: Any, copies: Copies) -> Any:
        def value(factor: Any) -> Any:
            return copies[factor] if isinstance(factor, int) else Fraction(*factor)

        group: Scalar = 0
        rest: Scalar = 0
        for p, sign in terms:
            factors = _factors(self.graph.keys[p])
            if self.single[p] and common in factors:
                cofactor = factors[1] if factors[0] == common else factors[0]
                group = group + sign * value(cofactor)
            else:
                rest = rest + sign * copies[p]
        return value(common) * group + rest


def _factors(key: tuple[Any, ...]) -> tuple[Any, ...]:
    """The two factors of a product: positions, or a constant as ``(numerator, denominator)``."""
    if key[0] == "mul":
        return key[1], key[2]
    if key[0] == "scale":
        return key[1].as_integer_ratio(), key[2]
    return ()
