"""Which edits to make: always the best bargain, by several notions of a bargain."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from robodyn.ir.graph import Scalar
from robodyn.optimize.prune.candidates import Candidate, View
from robodyn.optimize.prune.editor import Edit, Editor

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
