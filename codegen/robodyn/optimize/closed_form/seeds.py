"""Programs of an arm's inverse dynamics from its closed form: in every sort of coordinates a system of
polynomials, many extractions of factors from each, each a variation of the best before it.

Of the factors that the best extraction so far took, most are liked much in the next and some are not; what
then comes out no worse takes its place (large-neighbourhood search, Shaw 1998). Where nothing better comes
for long, the search starts again from nothing.
"""

from __future__ import annotations

import itertools
import random
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import build_arm
from robodyn.ir.graph import Graph, Node
from robodyn.ir.lowering import lower, needed
from robodyn.ir.program import Program
from robodyn.optimize.closed_form.coordinates import Coordinates, Model, model, parallels, values
from robodyn.optimize.closed_form.extraction import Extraction, Factor, Memory, Numbers, System, Taste
from robodyn.optimize.closed_form.scales import Scaling
from robodyn.optimize.polynomial import Terms
from robodyn.optimize.programs import exact
from robodyn.robot.model import Robot

#: How much the factors of the best are liked that are kept, and those that are dropped.
_LIKED, _DROPPED = 4.0, -1.0
#: What part is dropped.
_PARTS = (0.1, 0.2, 0.4)
#: How often a result may be worse by one operation.
_WORSE = 0.05
#: Extractions without gain before a fresh start.
_PATIENCE = 150


@dataclass(slots=True)
class Search:
    """A search over one system; ``systems`` are distinct results by what was taken, with their costs."""

    system: System
    numbers: Numbers
    chance: random.Random
    memory: Memory
    systems: dict[frozenset[Factor], tuple[int, System]]
    current: tuple[int, list[Factor]] | None = None
    idle: int = 0

    @classmethod
    def of(cls, system: System, numbers: Numbers, seed: int) -> Search:
        """A search that has not begun."""
        return cls(system, numbers, random.Random(seed), Memory(system, numbers), {})

    @property
    def cost(self) -> int:
        """Operations of the best found."""
        return min(cost for cost, _ in self.systems.values())

    def run(self, work: int) -> int:
        """At least one extraction, and more until so much ``work`` is done; the work done."""
        done = 0
        while done < work or not self.systems:
            done += self._extract()
        return done

    def _extract(self) -> int:
        chance, weights = self.chance, self.memory.weights
        weights.clear()
        if self.current is not None:
            part = chance.choice(_PARTS)
            for factor in self.current[1]:
                weights[factor] = _DROPPED if chance.random() < part else _LIKED
        taste = Taste(chance.choice((1, 2, 3)), chance.choice((0, 1, 2, 4, -1)), chance.choice((0, -1, -3)))
        extraction = Extraction(self.system.copy(), taste if self.systems else Taste(), chance, self.memory)
        system = extraction.run()
        cost = system.cost()
        self.systems.setdefault(frozenset(extraction.taken), (cost, system))
        self.idle += 1
        if self.current is None or cost <= self.current[0] + (chance.random() < _WORSE):
            if self.current is None or cost < self.current[0]:
                self.idle = 0
            self.current = (cost, extraction.taken)
        if self.idle > _PATIENCE:
            self.current, self.idle = None, 0
        return extraction.work


#: Closed forms with more terms are left to recursions.
MOST_TERMS = 320
#: Sorts of shifts that are tried.
_SHIFTS = 6


@dataclass(slots=True)
class Form:
    """An arm's closed form in some coordinates, and the search for its factors."""

    robot: Robot
    at: Coordinates
    model: Model
    search: Search
    #: Operations of the leaves: sums of angles and rates, shifts.
    leaves: int

    @property
    def cost(self) -> int:
        """Operations of the best found so far, constants not yet scaled."""
        return self.search.cost + self.leaves


def forms_of(robot: Robot, seed: int) -> Iterator[Form]:
    """Closed forms in every sort of coordinates, equal ones once."""
    arm = build_arm(robot, exact, lambda _: 1)
    ways = parallels(arm)
    zeros = (Fraction(0),) * robot.n
    seen: set[Any] = set()
    for summed in itertools.product(*((True, False) if way else (False,) for way in ways)):
        for absolute in (True, False) if any(ways) else (False,):
            turning = [body.revolute for body in arm.bodies]
            first = Coordinates(summed, absolute, ("s",) * robot.n, zeros)
            plain = model(robot, first)
            if plain.size > MOST_TERMS:
                continue
            for shifts in itertools.islice(_shifts(robot, plain), _SHIFTS):
                for squares in itertools.product(*(("s", "c") if t else ("s",) for t in turning)):
                    at = Coordinates(summed, absolute, squares, shifts)
                    lagrangian = model(robot, at)
                    key = (summed, shifts, *(frozenset(t.items()) for t in lagrangian.torques))
                    if key not in seen and lagrangian.size <= MOST_TERMS:
                        seen.add(key)
                        numbers = Numbers()
                        search = Search.of(system_of(lagrangian, numbers), numbers, seed)
                        yield Form(robot, at, lagrangian, search, leaf_operations(robot, at, lagrangian))


def _shifts(robot: Robot, model: Model) -> Iterator[tuple[Fraction, ...]]:
    """Shifts of the displacements that make terms vanish: none, and those that complete squares or stand
    in the most places."""
    options: list[list[Fraction]] = [[Fraction(0)] for _ in range(robot.n)]
    for v, (kind, joint) in enumerate(model.leaves):
        if kind != "x" or not isinstance(joint, int):
            continue
        votes: Counter[Fraction] = Counter()
        for terms in model.torques:
            for m, k in terms.items():
                degree = m.count(v)
                if degree:
                    rest = list(m)
                    rest.remove(v)
                    below = terms.get(tuple(rest))
                    if below:
                        votes[Fraction(below) / (k * degree)] += 1
        options[joint] += [shift for shift, _ in votes.most_common(2)]
    choices = sorted(itertools.product(*options), key=lambda shifts: sum(map(bool, shifts)), reverse=True)
    yield from choices


def system_of(model: Model, numbers: Numbers) -> System:
    """The torques as a system: those of joints that turn about one axis add up from the tip."""
    first = len(model.leaves)
    polynomials: dict[int, dict[tuple[int, ...], int]] = {}

    def add(terms: Terms) -> int:
        v = first + len(polynomials)
        polynomials[v] = {m: numbers.number(k) for m, k in terms.items()}
        return v

    n = len(model.torques)
    outputs = [0] * n
    beyond = 0
    for i in reversed(range(n)):
        terms = dict(model.torques[i])
        if i + 1 < n and model.ways[i + 1]:
            terms[(beyond,)] = model.ways[i + 1]
        beyond = outputs[i] = add(terms)
        if model.extras[i]:
            outputs[i] = add({(beyond,): 1, **model.extras[i]})
    return System(first, polynomials, tuple(outputs))


def leaf_operations(robot: Robot, at: Coordinates, model: Model) -> int:
    """Operations that the variables of the closed form take."""
    graph = Graph()
    read = {v for terms in (*model.torques, *model.extras) for m in terms for v in m}
    nodes = values(graph, robot, at, model.leaves)
    wanted = [nodes[v] for v in sorted(read) if isinstance(nodes[v], Node)]
    return sum(graph.keys[p][0] in ("add", "scale", "mul") for p in needed(graph, [("leaves", wanted)]))


#: Arms with more joints are left to recursions.
MOST_JOINTS = 4
#: Forms that are looked at closely, and those that a whole search is spent on.
_FORMS, _BEST = 12, 4
#: Factorisations of a form whose constants are scaled, and programs handed back.
_TRIED, _KEPT = 150, 12
#: Work, of one to two microseconds: of the first extractions, in a form and in all; of all that follow.
_START, _LOOKING, _EXTRACTING = 30_000, 1_000_000, 4_000_000
#: Work of scaling, of a third of a microsecond.
_SCALING = 8_000_000


def closed_forms(robot: Robot, *, effort: float = 1.0, seed: int = 0) -> list[Program]:
    """Programs of ``inverse_dynamics`` of ``robot`` from its closed form, the smallest first.

    None for arms of more than four joints, or whose closed form is long. Equal arguments give equal
    programs; with ``effort`` 1 they take seconds.
    """
    if robot.n > MOST_JOINTS:
        return []
    forms = sorted(forms_of(robot, seed), key=lambda form: form.model.size)[:_FORMS]
    work = 0
    for form in forms:
        if work < _LOOKING * effort:
            work += form.search.run(int(_START * effort))
    forms = [form for form in forms if form.search.systems]
    for share in (0.3, 0.3, 0.4):
        forms.sort(key=lambda form: form.cost)
        forms = forms[: min(_BEST, max(2, len(forms) // 2))]
        for form in forms:
            form.search.run(int(_EXTRACTING * effort * share / len(forms)))
    return _scaled(forms, effort, seed)


def _scaled(forms: list[Form], effort: float, seed: int) -> list[Program]:
    """The programs of the best that was found, in several forms and factorisations."""
    chance = random.Random(seed)
    best: list[tuple[Form, Scaling]] = []
    for form in forms:
        ranked = sorted(form.search.systems.values(), key=lambda item: item[0])
        # Constants of a longer factorisation may scale better: some of those as well.
        close = [item for item in ranked[_TRIED:] if item[0] <= ranked[0][0] + 3]
        ranked = ranked[:_TRIED] + chance.sample(close, min(len(close), _TRIED))
        best += [(form, Scaling.of(system, form.search.numbers)) for _, system in ranked]
    for kept, share in ((len(best), 0.4), (100, 0.2), (36, 0.2), (_KEPT, 0.2)):
        best.sort(key=lambda item: item[0].leaves + item[1].cost)
        best = _mixed(best, kept) if kept < len(best) else best
        for _, scaling in best:
            scaling.improve(chance, int(_SCALING * effort * share / (kept * scaling.work)))
    programs = [written(form, scaling.system, scaling.scales()) for form, scaling in best]
    distinct = {program.operations: program for program in programs}
    return sorted(distinct.values(), key=operations)


def _mixed(best: list[tuple[Form, Scaling]], kept: int) -> list[tuple[Form, Scaling]]:
    """The first ``kept`` of ``best``, no form more often than in half of them."""
    taken: list[tuple[Form, Scaling]] = []
    of_form: Counter[int] = Counter()
    for item in best:
        of_form[id(item[0])] += 1
        if of_form[id(item[0])] <= max(kept // 2, 1):
            taken.append(item)
    return taken[:kept]


def operations(program: Program) -> int:
    """Operations of ``program`` beside sines, cosines and signs."""
    return sum(op in ("add", "sub", "mul", "div") for op, _, _ in program.operations)


def written(form: Form, system: System, scales: dict[int, Fraction]) -> Program:
    """The program of ``system`` with its variables so scaled."""
    graph = Graph()
    numbers = form.search.numbers
    one = Fraction(1)
    computed: dict[int, Any] = {}
    for v, node in enumerate(values(graph, form.robot, form.at, form.model.leaves)):
        computed[v] = node * scales.get(v, 1)

    def value(v: int) -> Any:
        if v not in computed:
            total: Any = 0
            for m, k in system.polynomials[v].items():
                factor = numbers.value(k) * scales.get(v, one)
                product: Any = 1
                for u in m:
                    product = product * value(u)
                    factor /= scales.get(u, one)
                total = total + exact(factor) * product
            computed[v] = total
        return computed[v]

    return lower(graph, [("tau", [value(v) / scales.get(v, one) for v in system.outputs])])
