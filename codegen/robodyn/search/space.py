"""The neighbourhood of a variant: the changes that one step of the search may make.

Some changes pay off only together: the form ``spin`` of a link also needs a certain gauge and frame.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from heapq import nsmallest
from typing import Any, Final

from robodyn.counts.objective import Objective, Operations
from robodyn.dynamics.arm import Arm, build_arm
from robodyn.dynamics.parallel import chained
from robodyn.effects.scalars import is_zero
from robodyn.optimize.costing import Costing, exact, operations, saved
from robodyn.optimize.gauge import Unsuited
from robodyn.optimize.tally import ADD, CALL, COS, INPUT, MUL, NUMBER, OFFSET, PRIME, SCALE, SIN, Tally, Value
from robodyn.optimize.variant import LINK_VALUES, Variant
from robodyn.robot.model import Robot

_KINDS = {ADD: "add", OFFSET: "add", MUL: "mul", SCALE: "mul", COS: "cos", SIN: "sin", CALL: "call"}

#: Number of values in a sketch.
_SKETCH_SIZE = 32
_MOST_COSTS = 200_000

#: The smallest values that a variant computes (MinHash): similar for two variants that share most values.
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
        if variant not in self._costs:
            if len(self._costs) > _MOST_COSTS:
                self._costs.clear()
            self._costs[variant] = self._evaluate(variant)
        return self._costs[variant]

    def _evaluate(self, variant: Variant) -> tuple[float, Sketch] | None:
        try:
            tally, outputs = self._costing.run(variant)
        except Unsuited:
            return None
        positions = tally.needed(outputs)
        sketch = tuple(nsmallest(_SKETCH_SIZE, positions))
        if self.objective.name == "total":
            return float(operations(tally, positions) - saved(tally.entries, positions)), sketch
        return self.objective.cost(operations_in(tally, positions, outputs)), sketch


def operations_in(tally: Tally, wanted: set[int], outputs: list[Any]) -> Operations:
    """The ``wanted`` operations of ``tally``, in an order of evaluation."""
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


Changes = dict[str, Any]

#: Fields of a link for its gauge and its moment: they often change together.
BODY: Final = ("mass", "first", "second", "form", "frame")
#: Fields of a link for how accelerations reach it, and for the place of its origin.
PATH: Final = ("row", "column", "alpha", "carry", "lever", "slide", "chained")

_SPIN: Final[tuple[Changes, ...]] = tuple(
    {"mass": "zero", "first": "zero", "second": "-xx", "form": "spin", "frame": frame}
    for frame in ("own", "start", "before")
)
_POINT: Final[tuple[Changes, ...]] = tuple(
    {"mass": mass, "first": "zero", "second": second, "form": f"point_{axis}", "frame": frame}
    for axis, second in (("x", "yy"), ("y", "xx"))
    for mass in ("zero", f"point_{axis}", "keep")
    for frame in ("own", "start")
)
_ISOTROPIC: Final[tuple[Changes, ...]] = tuple(
    {"second": second, "form": f"isotropic_{axis}", "frame": frame}
    for axis, second in (("x", "xx"), ("y", "yy"), ("x", "yy"), ("y", "xx"), ("z", "keep"))
    for frame in ("own", "start")
)


#: Fields of a link that are changed together.
_PAIRS: Final = (
    ("second", "form"), ("form", "frame"), ("mass", "form"), ("second", "mass"), ("second", "first"),
    ("row", "column"), ("alpha", "column"), ("slide", "carry"), ("carry", "frame"), ("column", "form"),
)  # fmt: skip


class Space:
    """The variants of one robot."""

    def __init__(self, robot: Robot) -> None:
        names = dict.fromkeys(robot.parameters, 1)
        self.arm: Arm = build_arm(robot, exact, names.__getitem__)
        self.n = robot.n
        self.values = [self._values(i) for i in range(self.n)]
        units = [(rule, i + 1) for i in range(self.n) for rule in ("point", "a", "d")]
        sliding = any(not body.revolute for body in self.arm.bodies)
        # Another unit of length would add multiplications at prismatic joints: position, rates, force.
        self.units: list[tuple[Any, int]] = [("metre", 0)] if sliding else [("metre", 0), *units]
        self.macros = [self._macros(i) for i in range(self.n)]

    def _values(self, i: int) -> dict[str, tuple[Any, ...]]:
        """The values of each field that are worth trying for link ``i``."""
        body, tip, parallel = self.arm.bodies[i], i + 1 == self.n, is_zero(self.arm.bodies[i].sin_alpha)
        values = dict(LINK_VALUES)
        if not body.revolute:
            values.update(mass=("zero",), first=("zero",), second=("zero", "keep"), frame=("own",))
        elif i == 0:
            values.update(mass=("zero",), first=("zero",), second=("zero",))
        elif not tip:
            values["frame"] = ("own", "start")
        if i == 0:
            values.update({name: values[name][:1] for name in (*PATH, "frame") if name != "lever"})
        if not chained(self.arm)[i]:
            values["chained"] = (True,)
        if tip:
            values["lever"] = ("own",)
        bans = {"form": ["wrist"] * (i != self.n - 2), "slide": ["next"] * tip + ["own"] * is_zero(body.d)}
        for name, rules in bans.items():
            values[name] = tuple(value for value in values[name] if value not in rules)
        for name, pointless in (
            ("mass", body.revolute and is_zero(body.a)), ("first", parallel), ("second", parallel)
        ):  # fmt: skip
            if i and pointless:
                values[name] = tuple(rule for rule in values[name] if not rule.startswith("parent"))
        return values

    def _macros(self, i: int) -> list[dict[int, Changes]]:
        """Changes of link ``i``, some with changes of the link before it, that pay off only together."""
        if i == 0 or not self.arm.bodies[i].revolute:
            return []
        macros: list[dict[int, Changes]] = [{i: change} for change in (*_POINT, *_ISOTROPIC)]
        if i + 1 == self.n:
            macros += [{i: change} for change in _SPIN]
            if i > 1:
                macros += [{i: spin, i - 1: point} for spin in _SPIN for point in _POINT]
                wrists = [
                    point for point in _POINT if (point["frame"], point["form"]) == ("start", "point_y")
                ]
                macros += [{i: _SPIN[0], i - 1: {**point, "form": "wrist"}} for point in wrists] * 3
        legal = self.values
        return [c for c in macros if all(v in legal[j][f] for j, fs in c.items() for f, v in fs.items())]

    # -- moves ------------------------------------------------------------------------------------
    def random_neighbour(self, variant: Variant, rng: random.Random) -> Variant:
        """``variant`` with one thing changed, or a few that belong together."""
        kind = rng.random()
        i = rng.randrange(self.n)
        if kind < 0.40:
            return self._change_fields(variant, i, 1, rng, (*BODY, *PATH))
        if kind < 0.62:
            return self._change_fields(variant, i, rng.randint(2, 3), rng, BODY)
        if kind < 0.72:
            other = max(0, i - 1) if rng.random() < 0.5 else min(self.n - 1, i + 1)
            variant = self._change_fields(variant, i, rng.randint(1, 2), rng, BODY)
            return self._change_fields(variant, other, rng.randint(1, 2), rng, BODY)
        if kind < 0.84:
            if not self.macros[i]:
                i = self.n - 1
            if not self.macros[i]:
                return self._change_fields(variant, i, 1, rng, (*BODY, *PATH))
            return self._apply(variant, rng.choice(self.macros[i]))
        if kind < 0.92:
            unit, link = rng.choice(self.units)
            return replace(variant, unit=unit, unit_link=link)
        name = rng.choice(("row", "column", "alpha", "carry", "lever", "chained"))
        value = rng.choice(LINK_VALUES[name])
        for j in range(self.n):
            if value in self.values[j][name] and rng.random() < 0.7:
                variant = variant.with_link(j, **{name: value})
        return variant

    def _change_fields(
        self, variant: Variant, i: int, count: int, rng: random.Random, names: tuple[str, ...]
    ) -> Variant:
        free = [name for name in names if len(self.values[i][name]) > 1]
        if not free:
            return variant
        changes = {}
        for name in rng.sample(free, min(count, len(free))):
            old = getattr(variant.links[i], name)
            changes[name] = rng.choice([value for value in self.values[i][name] if value != old])
        return variant.with_link(i, **changes)

    @staticmethod
    def _apply(variant: Variant, change: dict[int, Changes]) -> Variant:
        for j, fields in change.items():
            variant = variant.with_link(j, **fields)
        return variant

    def neighbours(self, variant: Variant) -> Iterator[Variant]:
        """All variants that differ in one field, a pair of ``_PAIRS``, a macro or the unit of length."""
        for i in range(self.n):
            values, link = self.values[i], variant.links[i]
            for name, allowed in values.items():
                for value in allowed:
                    if value != getattr(link, name):
                        yield variant.with_link(i, **{name: value})
            for change in self.macros[i]:
                yield self._apply(variant, change)
            for one, other in _PAIRS:
                for u in values[one]:
                    for v in values[other]:
                        if u != getattr(link, one) and v != getattr(link, other):
                            yield variant.with_link(i, **{one: u, other: v})
        for unit, unit_count in self.units:
            if (unit, unit_count) != (variant.unit, variant.unit_link):
                yield replace(variant, unit=unit, unit_link=unit_count)

    def fitted(self, variant: Variant) -> Variant:
        """``variant`` with each field that has only one allowed value set to it."""
        links = []
        for values, link in zip(self.values, variant.links, strict=True):
            fixed = {name: allowed[0] for name, allowed in values.items() if len(allowed) == 1}
            links.append(replace(link, **fixed))
        return replace(variant, links=tuple(links))
