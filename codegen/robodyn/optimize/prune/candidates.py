"""Edits worth trying: what each would save, and the error that it would make at some states."""

from __future__ import annotations

from collections.abc import Sequence
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
