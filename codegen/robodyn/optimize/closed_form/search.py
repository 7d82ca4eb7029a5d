"""Many extractions from one system, each a variation of the best before it.

Of the factors that the best extraction so far took, most are liked much in the next and some are not; what
then comes out no worse takes its place (large-neighbourhood search, Shaw 1998). Where nothing better comes
for long, the search starts again from nothing.
"""

from __future__ import annotations

import random
from dataclasses import dataclass

from robodyn.optimize.closed_form.extraction import Extraction, Factor, Memory, Numbers, System, Taste

#: How much the factors of the best are liked that are kept, and those that are dropped.
_KEPT, _DROPPED = 4.0, -1.0
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
                weights[factor] = _DROPPED if chance.random() < part else _KEPT
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
