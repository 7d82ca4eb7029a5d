"""What variants of an arm cost, without building their programs, and what factoring would save of each
without doing it: ``a x + b x`` becomes ``(a + b) x`` where the products serve nothing else, as in
:mod:`robodyn.passes.factor`.
"""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm, Motion, build_arm, build_motion
from robodyn.dynamics.modified_newton_euler import modified_newton_euler
from robodyn.dynamics.parallel import chain_turns
from robodyn.dynamics.regroup import lumps_of
from robodyn.optimize.base_parameters import BaseNewtonEuler
from robodyn.optimize.gauge import (
    AT_TIP,
    Handed,
    Unsuited,
    assembled,
    check_size,
    give,
    in_scalars,
    point_of,
    regrouped_as,
    with_displacements,
)  # fmt: skip
from robodyn.optimize.tally import ADD, MUL, OFFSET, PRIME, SCALE, Circle, Entry, Tally, in_field
from robodyn.optimize.variant import Variant
from robodyn.robot.model import Robot


def saved(entries: dict[int, Entry], wanted: Collection[int]) -> int:
    """Multiplications that factoring the sums of ``wanted`` saves, about."""
    uses: dict[int, int] = {}
    sums = []
    for position in wanted:
        kind, reads, _ = entries[position]
        for p in reads:
            uses[p] = uses.get(p, 0) + 1
        if kind <= OFFSET:
            sums.append(position)
    inner = {p for position in sums for p in entries[position][1] if entries[p][0] <= OFFSET and uses[p] == 1}
    total = 0
    for root in sums:
        if root in inner:
            continue
        products = []
        stack = list(entries[root][1])
        while stack:
            p = stack.pop()
            if p in inner:
                stack += entries[p][1]
            elif uses[p] == 1 and MUL <= entries[p][0] <= SCALE:
                products.append(p)
        if len(products) > 1:
            total += _saved(products, entries, uses)
    return total


def _saved(products: list[int], entries: dict[int, Entry], uses: dict[int, int]) -> int:
    """What factoring a sum of products saves, the commonest factor first."""
    total = 0
    while len(products) > 1:
        counts: dict[Any, int] = {}
        for p in products:
            for factor in _factors(entries[p]):
                counts[factor] = counts.get(factor, 0) + 1
        common = max(counts, key=counts.__getitem__)
        if counts[common] < 2:
            break
        total += counts[common] - 1
        cofactors, rest = [], []
        for p in products:
            factors = _factors(entries[p])
            if common not in factors:
                rest.append(p)
            elif len(factors) == 2:
                other = factors[1] if factors[0] == common else factors[0]
                if other > 0 and uses.get(other) == 1:
                    stack = [other]
                    while stack:
                        q = stack.pop()
                        kind = entries[q][0]
                        if MUL <= kind <= SCALE and uses[q] == 1:
                            cofactors.append(q)
                        elif kind <= ADD and uses[q] == 1:
                            stack += entries[q][1]
        if len(cofactors) > 1:
            total += _saved(cofactors, entries, uses)
        products = rest
    return total


def _factors(entry: Entry) -> tuple[int, ...]:
    """The factors of a product: positions, a constant negative (and the same for both of its signs)."""
    kind, reads, more = entry
    if kind == MUL:
        return reads if reads[0] != reads[1] else reads[:1]
    return (-min(more, PRIME - more), reads[0])


_MANY = 200_000


def exact(x: Fraction) -> Fraction | int:
    """``x``, as an integer where it is one: arithmetic among 0 and 1 is most of a recursion's."""
    return x.numerator if x.denominator == 1 else x


class Costing:
    """Tallies of variants of one robot's inverse dynamics. What links give to their parents is remembered by
    the rules of all links beyond (not where numbers are known only at run time)."""

    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.circle = Circle()
        self._handed: dict[Any, Handed | Unsuited] = {}
        self._plain = not robot.parameters
        tally = Tally(self.circle)
        self.arm: Arm = build_arm(robot, exact, tally.input)
        self._lumps = lumps_of(self.arm)
        self._field = build_arm(robot, in_field, tally.input)

    def total(self, variant: Variant) -> int:
        """Operations of ``variant``; :class:`Unsuited` where it does not suit the robot."""
        tally, outputs = self.run(variant)
        return operations(tally, tally.needed(outputs))

    def factored_total(self, variant: Variant | None) -> int:
        """About as many as are left after the passes; None is the recursion as in the book."""
        if variant is not None:
            tally, outputs = self.run(variant)
        else:
            tally = Tally(self.circle)
            arm = build_arm(self.robot, in_field, tally.input)
            outputs = modified_newton_euler(arm, self._motion(tally, arm))
        wanted = tally.needed(outputs)
        return operations(tally, wanted) - saved(tally.entries, wanted)

    def run(self, variant: Variant) -> tuple[Tally, list[Any]]:
        """The tally of ``variant``, and its outputs; :class:`Unsuited` where it does not suit the robot."""
        check_size(self.arm, variant)
        tally = Tally(self.circle)
        if self._plain:
            field = self._field
            links, unit = assembled(self.arm, variant, self._all_handed(variant))
        else:
            # Parameters are values of the tally that they are counted in.
            field = build_arm(self.robot, in_field, tally.input)
            links, unit = regrouped_as(build_arm(self.robot, exact, tally.input), variant)
        numbers = [in_scalars(link, in_field) for link in links]
        arm = with_displacements(field, numbers, in_field(unit))
        motion = self._motion(tally, arm)
        turns = chain_turns(arm, motion, tally.trigonometry, [link.chained for link in variant.links])
        per_unit = 1 if unit == 1 else in_field(1 / Fraction(unit))
        return tally, BaseNewtonEuler(arm, motion, turns, numbers, variant, per_unit).torques()

    def _motion(self, tally: Tally, arm: Arm) -> Motion:
        q, qd, qdd = ([tally.input(array, i) for i in range(self.robot.n)] for array in ("q", "qd", "qdd"))
        return build_motion(arm, q, qd, qdd, tally.trigonometry, in_field)

    def _all_handed(self, variant: Variant) -> list[Handed]:
        n = self.robot.n
        lumps: list[Handed] = [AT_TIP] * (n + 1)
        tail: tuple[Any, ...] = ()
        for i in reversed(range(n)):
            how = variant.links[i]
            tail = (how.mass, how.first, how.second, how.slide, tail)
            cached = self._handed.get(tail)
            if cached is None:
                if len(self._handed) > _MANY:
                    self._handed.clear()
                try:
                    cached = give(self.arm, self._lumps, i, how, lumps[i + 1])
                except Unsuited as error:
                    cached = error
                self._handed[tail] = cached
            if isinstance(cached, Unsuited):
                raise cached
            point_of(i, cached.own, how)  # a form that does not suit says so before the links below are made
            lumps[i] = cached
        return lumps


def operations(tally: Tally, wanted: Collection[int]) -> int:
    """How many of ``wanted`` are multiplications and additions."""
    entries = tally.entries
    return sum([entries[position][0] <= SCALE for position in wanted])
