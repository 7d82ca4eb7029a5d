"""The cost of a variant by an objective."""

from __future__ import annotations

from heapq import nsmallest
from typing import Any

from robodyn.counts.objective import Objective, Operations
from robodyn.optimize.costing import Costing, operations
from robodyn.optimize.factoring import saved
from robodyn.optimize.gauge import Unsuited
from robodyn.optimize.tally import (
    ADD,
    CALL,
    COS,
    INPUT,
    MUL,
    NUMBER,
    OFFSET,
    PRIME,
    SCALE,
    SIN,
    Tally,
    Value,
)
from robodyn.optimize.variant import Variant
from robodyn.robot.model import Robot

_KINDS = {ADD: "add", OFFSET: "add", MUL: "mul", SCALE: "mul", COS: "cos", SIN: "sin", CALL: "call"}

#: So many of a variant's values are kept to tell variants apart.
_SKETCH = 32
_MANY = 200_000

#: The smallest of the values that a variant computes: alike of two variants that share most values.
Sketch = tuple[int, ...]


class Candidates:
    """Costs of variants of one robot."""

    def __init__(self, robot: Robot, objective: Objective | None = None) -> None:
        self.robot, self.objective = robot, objective or Objective()
        self._costing = Costing(robot)
        self._costs: dict[Variant, tuple[float, Sketch] | None] = {}

    def cost(self, variant: Variant) -> float | None:
        """The cost of ``variant``; None where it does not suit the robot."""
        cost = self.judged(variant)
        return None if cost is None else cost[0]

    def judged(self, variant: Variant) -> tuple[float, Sketch] | None:
        """The cost of ``variant`` and its sketch; None where it does not suit the robot."""
        if variant in self._costs:
            return self._costs[variant]
        if len(self._costs) > _MANY:
            self._costs.clear()
        cost = self._costs[variant] = self._judged(variant)
        return cost

    def _judged(self, variant: Variant) -> tuple[float, Sketch] | None:
        try:
            tally, outputs = self._costing.run(variant)
        except Unsuited:
            return None
        wanted = tally.needed(outputs)
        sketch = tuple(nsmallest(_SKETCH, wanted))
        if self.objective.name == "total":
            return float(operations(tally, wanted) - saved(tally.entries, wanted)), sketch
        return self.objective.cost(operations_in(tally, wanted, outputs)), sketch


def operations_in(tally: Tally, wanted: set[int], outputs: list[Any]) -> Operations:
    """What of ``tally`` is ``wanted``, in the order in which it was made."""
    place: dict[int, int] = {}
    kinds: list[str] = []
    reads: list[tuple[int, ...]] = []
    for position, (kind, read, _) in tally.entries.items():
        if position not in wanted or kind in (INPUT, NUMBER):
            continue
        place[position] = len(kinds)
        kinds.append(_KINDS[kind])
        reads.append(tuple(place[p] for p in read if p in place))
    values = (v.value for v in outputs if isinstance(v, Value))
    results = tuple(place[p] for p in (min(v, PRIME - v) for v in values) if p in place)
    return Operations(kinds, reads, results)
