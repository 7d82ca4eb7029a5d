"""An arm's closed form in every sort of coordinates, as systems to be searched for common factors."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import build_arm
from robodyn.ir.graph import Graph, Node
from robodyn.ir.lowering import needed
from robodyn.optimize.closed_form.coordinates import Coordinates, Model, model, parallels, values
from robodyn.optimize.closed_form.extraction import Numbers, System
from robodyn.optimize.closed_form.polynomial import Terms
from robodyn.optimize.closed_form.search import Search
from robodyn.optimize.programs import exact
from robodyn.robot.model import Robot

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
