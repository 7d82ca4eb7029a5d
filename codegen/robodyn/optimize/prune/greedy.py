"""Which edits to make: always the best bargain, by several notions of a bargain, of those that seem to fit
into what is left of the budgets; what each would save, and the error that it would make at some states.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from robodyn.ir.graph import Node, Scalar
from robodyn.ir.key import children
from robodyn.ir.lowering import needed
from robodyn.optimize.prune.editor import COSTLY, Edit, Editor, Edits

#: Values that are nearest to a position and may take its place.
_NEAREST = 3


class Candidate(NamedTuple):
    """``edit`` at ``position`` saves about ``gain`` operations and makes errors of about ``share`` of what is
    left of the budgets."""

    position: int
    edit: Edit
    gain: int
    share: float


class View:
    """The graph as it is with some edits: what reads what, and how much the outputs feel of it."""

    def __init__(
        self,
        editor: Editor,
        edits: Edits,
        copies: dict[int, Scalar],
        outputs: Sequence[Scalar],
        used: Sequence[float],
    ) -> None:
        import numpy as np

        self.editor, self.edits, self.nodes = editor, edits, copies
        keys = editor.graph.keys
        self.keys = keys
        order = needed(editor.graph, [("", outputs)])
        editor.sample(order)
        self.uses = dict.fromkeys(order, 0)
        self.users: dict[int, list[int]] = {p: [] for p in order}
        for p in order:
            for child in children(keys[p]):
                self.uses[child] += 1
                self.users[child].append(p)
        for v in outputs:
            if isinstance(v, Node):
                self.uses[v.position] += 1
        left = np.maximum(1 - np.array(used), 1e-9)[:, None]
        felt = editor.sensitivities(order, outputs)
        self.live: list[int] = []
        seen: set[int] = set()
        for p in editor.positions:
            v = copies[p]
            if not isinstance(v, Node) or v.position not in felt or v.position in seen:
                continue
            seen.add(v.position)
            if p not in editor.angular:
                self.live.append(p)
        nodes = [copies[p] for p in self.live]
        self.values = np.array([v.sign * editor.values[v.position] for v in nodes])  # type: ignore[union-attr]
        self.felt = np.array([np.abs(felt[v.position] / left).max(axis=0) for v in nodes])  # type: ignore[union-attr]

    def candidates(self, refused: set[tuple[int, Edit]]) -> list[Candidate]:
        """All edits that seem to fit into what is left of the budgets."""
        import numpy as np

        candidates: list[Candidate] = []
        for i, p in enumerate(self.live):
            if p in self.edits or p in self.editor.fixed:
                continue
            own, felt, here = self.values[i], self.felt[i], self.nodes[p]
            assert isinstance(here, Node)
            share = float((felt * np.abs(own)).max())
            if share <= 1 and (p, None) not in refused:
                candidates.append(Candidate(p, None, self._zero(here.position), share))
            few = slice(None, None, 8)
            for sign in (1, -1):
                near = np.abs(self.values[:i, few] - sign * own[few]) * felt[few]
                close = np.nonzero(near.max(axis=1, initial=0.0) <= 1)[0]
                if not len(close):
                    continue
                shares = (np.abs(self.values[close] - sign * own) * felt).max(axis=1)
                for k in np.argsort(shares, kind="stable")[:_NEAREST]:
                    q, share = self.live[close[k]], float(shares[k])
                    there = self.nodes[q]
                    assert isinstance(there, Node)
                    if share <= 1 and (p, (sign, q)) not in refused:
                        gain = self._merged(here.position, there.position)
                        candidates.append(Candidate(p, (sign, q), gain, share))
        return candidates

    def _merged(self, p: int, kept: int) -> int:
        """Operations that go when ``p`` is no longer read but ``kept`` is."""
        keys, uses = self.keys, self.uses
        gone: dict[int, int] = {}
        gain = 0
        stack = [p]
        while stack:
            x = stack.pop()
            if x == kept:
                continue
            gain += keys[x][0] in COSTLY
            for child in children(keys[x]):
                gone[child] = gone.get(child, 0) + 1
                if gone[child] == uses[child]:
                    stack.append(child)
        return gain

    def _zero(self, p: int) -> int:
        """Operations that go when ``p`` is zero: its products with it, and additions of it."""
        keys, uses, users = self.keys, self.uses, self.users
        gone: dict[int, int] = {}
        dead: set[int] = set()
        gain = 0
        zeros = [p]
        while zeros:
            zero = zeros.pop()
            if zero in dead:
                continue
            stack = [zero]
            while stack:
                x = stack.pop()
                if x in dead:
                    continue
                dead.add(x)
                gain += keys[x][0] in COSTLY
                for child in children(keys[x]):
                    gone[child] = gone.get(child, 0) + 1
                    if gone[child] >= uses[child]:
                        stack.append(child)
            for user in users[zero]:
                if user in dead:
                    continue
                if keys[user][0] == "add":
                    gain += 1
                else:
                    zeros.append(user)
        return gain


#: Exponents of the operations saved, set against the error made: each gives another program, the smallest is
#: taken.
_NOTIONS = (0.7, 1.0)
#: Share of a budget that costs next to nothing.
_CHEAP = 1e-3
#: Edits made before all are weighed anew, and the share of what was left that they may use up.
_AT_ONCE, _IN_ONE_GO = 8, 0.5


@dataclass(frozen=True, slots=True)
class State:
    """The program with ``edits``: its positions' values, its outputs, their operations and errors."""

    edits: dict[int, Edit]
    nodes: dict[int, Scalar]
    outputs: list[Scalar]
    cost: int
    shares: list[float]


def pruned(editor: Editor, progress: Callable[[int], None]) -> State:
    """The smallest program found within the budgets; ``progress`` hears of every step how many operations are
    left."""
    nodes, outputs = editor.edited({})
    shares = [0.0] * len(outputs)
    start = State({}, nodes, outputs, editor.cost(outputs), shares)
    ends = [_Descent(editor, start, notion, progress).end() for notion in _NOTIONS]
    return min(ends, key=lambda state: state.cost)


class _Descent:
    """Edit after edit from ``state``, until none fits any more."""

    def __init__(self, editor: Editor, state: State, notion: float, progress: Callable[[int], None]) -> None:
        self.editor, self.state, self.notion, self.progress = editor, state, notion, progress
        self.refused: set[tuple[int, Edit]] = set()

    def end(self) -> State:
        """The last state."""
        while self._round():
            self.progress(self.state.cost)
        return self.state

    def _round(self) -> bool:
        """Make a few of the best edits; False if there is none."""
        state = self.state
        view = View(self.editor, state.edits, state.nodes, state.outputs, state.shares)
        candidates = [c for c in view.candidates(self.refused) if c.gain > 0]
        done, room = 0, 1.0
        for c in sorted(candidates, key=self._rank):
            if (done and c.share > room) or c.position in self.state.edits:
                continue
            if self._try_edit(c):
                done += 1
                room -= c.share
                if done == _AT_ONCE or room < _IN_ONE_GO:
                    break
        return done > 0

    def _rank(self, c: Candidate) -> tuple[float, int, tuple[int, int]]:
        # Six digits: the order must not hang on the last bit of a machine's sine.
        bargain = float(f"{c.gain**self.notion / (c.share + _CHEAP):.6g}")
        return -bargain, c.position, c.edit or (0, 0)

    def _try_edit(self, c: Candidate) -> bool:
        """Make the edit if it saves something and the errors stay within the budgets."""
        edits = {**self.state.edits, c.position: c.edit}
        nodes, outputs = self.editor.edited(edits)
        cost = self.editor.cost(outputs)
        shares = self.editor.shares(outputs) if cost < self.state.cost else None
        if shares is None:
            self.refused.add((c.position, c.edit))
            return False
        self.state = State(edits, nodes, outputs, cost, shares)
        return True
