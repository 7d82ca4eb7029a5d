"""Units of sums in which few values have to be multiplied by constants: a descent."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from robodyn.ir.field import Vanishes

#: Factors are compared modulo this prime. A description that is made against it gets a worse count, never
#: another function: programs are built of exact fractions, and counted before they are taken.
_PRIME = (1 << 61) - 1
#: A unit at most, and one over it at least: products of some sums must not leave the range of a float.
_LARGEST = 1000
#: Bits of a unit at most: those of arms whose numbers have 17 digits have some hundreds.
_MOST_BITS = 4096

#: Of the changes that make factors 1 so many are weighed at most.
_TRIED = 3

ONE = Fraction(1)
#: Exponents of the units of sums, by the position of the sum.
Powers = Mapping[int, int]
#: Values that a change of units changes, by their index, and to which power of it.
Touched = Sequence[tuple[int, int]]


@dataclass(frozen=True, slots=True)
class Multiple:
    """A value: what is computed at ``base``, times ``constant``, times ``powers`` of units. Where that factor
    is 1 or -1 nothing has to be multiplied."""

    base: int
    constant: Fraction
    powers: Powers

    def times(self, constant: Fraction) -> Multiple:
        """This value times ``constant``."""
        return Multiple(self.base, _product(self.constant, constant), self.powers)

    def in_unit_of(self, p: int) -> Multiple:
        """This value over the unit of the sum at ``p``."""
        return Multiple(self.base, self.constant, _joined(self.powers, {p: 1}, -1))

    def combined(self, other: Multiple, way: int, base: int) -> Multiple:
        """The product with ``other``, or the quotient if ``way`` is -1, which is computed at ``base`` from
        what is computed for both."""
        constant = _product(self.constant, other.constant if way > 0 else 1 / other.constant)
        return Multiple(base, constant, _joined(self.powers, other.powers, way))

    def factor(self, units: Mapping[int, Fraction]) -> Fraction:
        """What is computed is multiplied by this, where sums are in ``units``."""
        factor = self.constant
        for p, power in self.powers.items():
            if p in units:
                factor = factor * units[p] ** power
        return factor


class Descent:
    """Units for the sums ``free``, from ``units`` on, so that ``needs`` take few multiplications.

    Factors are known by their squares modulo the prime: a sign costs nothing. All who need the same multiple
    of the same base share it.

    Raises
    ------
    Vanishes: a constant is a multiple of the prime.
    """

    def __init__(self, needs: Sequence[Multiple], free: Sequence[int], units: Mapping[int, Fraction]) -> None:
        #: The units reached; of sums that are not in it 1.
        self.units = dict(units)
        self._needs, self._free = needs, free
        #: A need's base and factor as one number: its square plus this.
        self._shift = [need.base << 64 for need in needs]
        squares = [_square(need.factor(units)) for need in needs]
        self._squares, self._inverses = [s for s, _ in squares], [i for _, i in squares]
        self._often = Counter(self._squares)
        #: By base and factor how many need that multiple.
        self._users = Counter([s + t for s, t in zip(self._squares, self._shift, strict=True)])
        self._at: dict[int, list[tuple[int, int]]] = {p: [] for p in free}
        for i, need in enumerate(needs):
            for p, power in need.powers.items():
                if p in self._at:
                    self._at[p].append((i, power))
        self._one_by_one()
        while self._by_groups():
            self._one_by_one()

    def _one_by_one(self) -> None:
        """Another unit for a sum where that saves something, or once where it costs nothing; then again for
        those beside it."""
        queue = deque(reversed(self._free))
        waiting = set(queue)
        sidestepped: set[int] = set()
        while queue:
            p = queue.popleft()
            waiting.discard(p)
            change = self._best(self._at[p], int(p in sidestepped))
            if change is None or not self._changed((p,), self._at[p], change[1]):
                continue
            if not change[0]:
                sidestepped.add(p)
            for i, _ in self._at[p]:
                for q in self._needs[i].powers:
                    if q not in waiting and q in self._at:
                        waiting.add(q)
                        queue.append(q)

    def _by_groups(self) -> bool:
        """Another unit for all sums of a group where that saves something: whether it did."""
        saved = False
        seen: set[int] = set()
        for p in self._free:
            if p in seen:
                continue
            group = self._group(p)
            seen |= group
            if len(group) > 1:
                touched = self._touched(group)
                change = self._best(touched, 1)
                saved |= change is not None and self._changed(group, touched, change[1])
        return saved

    def _group(self, p: int) -> set[int]:
        """The sums that go with that at ``p``, without a multiplication between them."""
        group, stack = {p}, [p]
        while stack:
            for i, _ in self._at[stack.pop()]:
                if self._squares[i] == 1:
                    for q in self._needs[i].powers:
                        if q not in group and q in self._at:
                            group.add(q)
                            stack.append(q)
        return group

    def _touched(self, group: Iterable[int]) -> Touched:
        """What a change of the units of ``group`` changes."""
        total: dict[int, int] = {}
        for p in group:
            for i, power in self._at[p]:
                total[i] = total.get(i, 0) + power
        return [(i, power) for i, power in total.items() if power]

    def _best(self, touched: Touched, least: int) -> tuple[int, Fraction] | None:
        """What is gained at most by a change of units, ``least`` or more, and the change. Tried are those
        that make most factors 1; of equal ones that by which values were multiplied most often at first."""
        squares, inverses, shift, users = self._squares, self._inverses, self._shift, self._users
        own: dict[int, int] = {}
        votes: dict[int, int] = {}
        voter: dict[int, tuple[int, int]] = {}
        for i, power in touched:
            square = squares[i]
            if square != 1:
                key = square + shift[i]
                own[key] = own.get(key, 0) + 1
                if power == 1:
                    square = inverses[i]
                elif power != -1:
                    continue
                votes[square] = votes.get(square, 0) + 1
                voter[square] = i, power
        gone = sum([users[key] == mine for key, mine in own.items()])
        if gone < least:
            return None
        # What gains nothing should at least be by a factor that the program had.
        best, chosen = (least, -1 if least else 0), None
        for ratio in sorted(votes, key=votes.__getitem__, reverse=True)[:_TRIED]:
            i, power = voter[ratio]
            inverse = squares[i] if power == 1 else inverses[i]
            worth = gone - self._new(touched, ratio, inverse, own), self._often[ratio]
            if worth > best:
                best, chosen = worth, (i, power)
        if chosen is None:
            return None
        i, power = chosen
        return best[0], abs(self._needs[i].factor(self.units)) ** -power

    def _new(self, touched: Touched, ratio: int, inverse: int, own: Mapping[int, int]) -> int:
        """Multiplications that are there after a change and were not before, where ``own`` are gone."""
        squares, shift, users = self._squares, self._shift, self._users
        keys = set()
        for i, power in touched:
            factor = ratio if power == 1 else inverse if power == -1 else pow(ratio, power, _PRIME)
            factor = squares[i] * factor % _PRIME
            if factor != 1:
                keys.add(factor + shift[i])
        return sum([key not in users or users[key] == own.get(key, 0) for key in keys])

    def _changed(self, group: Iterable[int], touched: Touched, ratio: Fraction) -> bool:
        """Whether the units of ``group`` may be ``ratio`` times what they are, and are now."""
        units = {p: self.units.get(p, ONE) * ratio for p in group}
        if not all(map(allowed, units.values())):
            return False
        self.units.update(units)
        square, inverse = _square(ratio)
        for i, power in touched:
            key = self._squares[i] + self._shift[i]
            self._users[key] -= 1
            if not self._users[key]:
                del self._users[key]
            one, other = (square, inverse) if power > 0 else (inverse, square)
            self._squares[i] = self._squares[i] * pow(one, abs(power), _PRIME) % _PRIME
            self._inverses[i] = self._inverses[i] * pow(other, abs(power), _PRIME) % _PRIME
            self._users[self._squares[i] + self._shift[i]] += 1
        return True


def allowed(unit: Fraction) -> bool:
    """Whether ``unit`` is of a size and a length that computing in it does no harm."""
    numerator, denominator = unit.as_integer_ratio()
    short = numerator.bit_length() + denominator.bit_length() <= _MOST_BITS
    return short and numerator <= _LARGEST * denominator and denominator <= _LARGEST * numerator


def _square(factor: Fraction) -> tuple[int, int]:
    """The square of ``factor`` modulo the prime, and one over it."""
    numerator, denominator = factor.as_integer_ratio()
    if abs(numerator) == denominator:
        return 1, 1
    one, other = numerator * numerator % _PRIME, denominator * denominator % _PRIME
    if not one or not other:
        raise Vanishes
    return one * pow(other, -1, _PRIME) % _PRIME, other * pow(one, -1, _PRIME) % _PRIME


def _product(one: Fraction, other: Fraction) -> Fraction:
    """``one * other``; most are 1."""
    if one is ONE:
        return other
    return one if other is ONE else one * other


def _joined(powers: Powers, more: Powers, way: int) -> Powers:
    """The powers of a product, or of a quotient if ``way`` is -1."""
    if not more:
        return powers
    total = dict(powers)
    for p, power in more.items():
        total[p] = total.get(p, 0) + way * power
    return {p: power for p, power in total.items() if power}
