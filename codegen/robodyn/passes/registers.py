"""Order for registers: the same operations, such that few values wait in memory.

Results are computed one after another, each with what it needs and no other has computed, and of the
operands of an operation first the deep ones and those that little reads. In which order results come is found
by exchanging two of them as long as that lowers an estimate of loads and stores: what a compiler does that
gives a value one place for all its life, a register, or memory for those that live long and are read little.
The rounding is untouched: nothing is re-associated.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations

from robodyn.ir.program import Input, Operand, Program
from robodyn.passes.order import before_use, kept, needed, of_positions

#: How many operations all estimates of one program may look at, so that long arms stay fast.
_EFFORT = 16_000
#: How many levels of depth a reader outweighs.
_READER = 3
#: Inputs in whose place results may be written (:mod:`robodyn.emit.body`).
_IN_PLACE = ("q", "qd", "qdd", "tau")


def registers(program: Program, available: int = 16) -> Program:
    """``program`` in an order that ``available`` registers suffice for as nearly as may be."""
    results = list(dict.fromkeys(x for x in program.results() if isinstance(x, int)))
    if not results:
        return program
    orders = _Orders(program, available)
    order = results[::-1]
    best = orders.cost(orders.order(order))
    left = _EFFORT // (len(program.operations) + 1) - 1
    while True:
        tried = []
        for changed in _exchanged(order):
            if left <= 0:
                break
            left -= 1
            tried.append((orders.cost(orders.order(changed)), changed))
        lower = min(tried, default=(best, order))
        if lower[0] >= best:
            return kept(program, orders.whole(order))
        best, order = lower


def _exchanged(results: Sequence[int]) -> Iterator[list[int]]:
    """``results`` with two of them exchanged, neighbours first."""
    pairs = combinations(range(len(results)), 2)
    for i, j in sorted(pairs, key=lambda pair: (pair[1] - pair[0], pair)):
        changed = list(results)
        changed[i], changed[j] = changed[j], changed[i]
        yield changed


class _Orders:
    """Orders of a program's operations, and what they cost."""

    def __init__(self, program: Program, available: int) -> None:
        self.program, self.positions = program, of_positions(program)

        def reading(x: Operand) -> Operand:  # sines and cosines of positions are there before all else
            return Input("sc", x) if isinstance(x, int) and x in self.positions else x

        self.operations = [op._replace(args=tuple(map(reading, op.args))) for op in program.operations]
        self.results = program.results()
        self.available = available
        self.uses = program.uses()
        depth: list[int] = []
        for _, args, _ in self.operations:
            depth.append(1 + max((depth[x] for x in args if isinstance(x, int)), default=0))
        self.rank = [(depth[i] - _READER * uses, -i) for i, uses in enumerate(self.uses)]
        outputs = {x for x in self.results if isinstance(x, int)}
        self._inner = [uses == 1 and i not in outputs for i, uses in enumerate(self.uses)]
        self._trees: dict[int, list[int]] = {}
        self._read = [[x for x in op.args if isinstance(x, int)] for op in self.operations]
        for read in self._read:
            read.sort(key=self.rank.__getitem__, reverse=True)

    def order(self, results: Sequence[int]) -> list[int]:
        """The operations, result by result."""
        return before_use(results, self._read)

    def whole(self, results: Sequence[int]) -> list[int]:
        """:meth:`order` after the sines and cosines of positions, and what these need."""
        first = needed(self.program, self.positions)
        return [*sorted(first), *(i for i in self.order(results) if i not in first)]

    def cost(self, order: Sequence[int]) -> int:
        """Loads and stores of ``order``, estimated as x86 needs them: an operation reads one operand from
        memory at no cost, unless that is what is subtracted from."""
        order = self._merged(order)
        lives = _Lives(self, order)
        kept_in_memory = lives.spilled(self.available)
        cost = len(kept_in_memory) + lives.loads
        region = 0
        for t, i in enumerate(order):
            cost += self._loads(i, t, region, lives, kept_in_memory)
            region += t in lives.writes
        return cost

    def _loads(self, i: int, t: int, region: int, lives: _Lives, spilled: set[_Value]) -> int:
        op, args, _ = self.operations[i]
        free = 1
        cost = 0
        if any(isinstance(x, Fraction) for x in args):
            if op == "sub" and isinstance(args[0], Fraction):
                cost += 1
            else:
                free = 0
        for k, x in enumerate(dict.fromkeys(args)):
            if isinstance(x, Fraction):
                continue
            value: _Value = (x, region) if isinstance(x, Input) else x
            start, end, _ = lives.of[value]
            in_memory = start == end if isinstance(x, Input) else False
            if value in spilled and not (isinstance(x, Input) and start == t):
                in_memory = True
            if in_memory:
                folds = free and len(set(args)) == 2 and not (op == "sub" and k == 0)
                free, cost = (0, cost) if folds else (free, cost + 1)
        return cost

    def _merged(self, order: Sequence[int]) -> list[int]:
        """``order`` as compilers take it: what is read once moves to where it is read."""
        return [i for root in order if not self._inner[root] for i in self._tree(root)]

    def _tree(self, root: int) -> list[int]:
        """``root`` after what only it reads, from left to right."""
        if root not in self._trees:
            tree: list[int] = []
            stack: list[tuple[int, bool]] = [(root, False)]
            while stack:
                i, ready = stack.pop()
                if ready:
                    tree.append(i)
                    continue
                stack.append((i, True))
                args = [x for x in self.operations[i].args if isinstance(x, int) and self._inner[x]]
                stack.extend((x, False) for x in reversed(args))
            self._trees[root] = tree
        return self._trees[root]


#: A value: an operation's, or an input's between two writes of results, after which it is read again.
_Value = int | tuple[Input, int]


class _Lives:
    """From when to when each value lives, and how often it is touched."""

    def __init__(self, of: _Orders, order: Sequence[int]) -> None:
        last: dict[int, int] = {}
        place = {i: t for t, i in enumerate(order)}
        for t, i in enumerate(order):
            for x in of.operations[i].args:
                if isinstance(x, Input) and x.index is not None and x.array in _IN_PLACE:
                    last[x.index] = t
        written = [
            (x, max(place[x], last.get(k, -1))) for k, x in enumerate(of.results) if isinstance(x, int)
        ]
        self.writes = {t for _, t in written}
        self.of: dict[_Value, tuple[int, int, int]] = {}
        region = 0
        for t, i in enumerate(order):
            for x in of.operations[i].args:
                if not isinstance(x, Fraction):
                    value: _Value = (x, region) if isinstance(x, Input) else x
                    start, _, touched = self.of.get(value, (t, t, 0))
                    self.of[value] = (start, t, touched + 1)
            self.of[i] = (t, t, 1)
            region += t in self.writes
        for x, t in written:
            start, end, touched = self.of[x]
            self.of[x] = (start, max(end, t), touched)
        self.loads = sum(
            not isinstance(value, int) and end > start for value, (start, end, _) in self.of.items()
        )

    def spilled(self, available: int) -> set[_Value]:
        """Values that go without a register: where too many live, the longest for how often it is touched."""
        begins: dict[int, list[_Value]] = {}
        for value, (start, end, _) in self.of.items():
            if end > start:
                begins.setdefault(start, []).append(value)
        spilled: set[_Value] = set()
        alive: list[_Value] = []
        for t in sorted(begins):
            alive = [value for value in alive if self.of[value][1] > t] + begins[t]
            while len(alive) > available:
                worst = max(alive, key=self._idle)
                alive.remove(worst)
                spilled.add(worst)
        return spilled

    def _idle(self, value: _Value) -> float:
        start, end, touched = self.of[value]
        return (end - start) / touched
