"""What factoring would save, without doing it: the estimate by which a search chooses.

``a x + b x`` becomes ``(a + b) x`` where the products serve nothing else, as in :mod:`robodyn.passes.factor`.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from robodyn.optimize.tally import ADD, MUL, OFFSET, PRIME, SCALE, Entry


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
