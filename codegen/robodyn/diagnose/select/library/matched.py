"""The same candidates along several logs, and pieces of logs.

What a log can show depends on it: a limit that it reaches, a deflection that is shorter than its travel
between samples. A candidate of one piece is made for the others too, or is zero there, or is left out.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.library import Candidate, Context, candidates
from robodyn.diagnose.select.scope import Scope

Floats = NDArray[np.float64]
Prepare = Callable[[Context, Candidate], Floats]


def matched(
    contexts: Sequence[Context], prepare: Prepare, scope: Scope
) -> Iterator[tuple[Candidate, Floats]]:
    """Candidates with their columns [N, rows, c], as ``prepare`` makes them, of all pieces one after the
    other."""
    if len(contexts) == 1:
        for one in candidates(contexts[0], scope):
            yield one, prepare(contexts[0], one)
        return
    known: dict[Any, Candidate] = {}
    columns: list[dict[Any, Floats]] = []
    lengths = []
    for c in contexts:
        own: dict[Any, Floats] = {}
        count = Counter[Any]()
        for one in candidates(c, scope):
            key = _key(one)
            count[key] += 1
            # No view, which would keep all of its columns.
            known.setdefault((key, count[key]), replace(one, columns=one.columns[:0].copy()))
            own[key, count[key]] = prepare(c, one)
        columns.append(own)
        lengths.append(len(c.slow.thinned(c.slow.q)))
    for key, one in known.items():
        parts = []
        for c, own, length in zip(contexts, columns, lengths, strict=True):
            part = own.pop(key, None)
            if part is None and one.again is not None:
                part = prepare(c, one.again(c, one.values))
            if part is None and one.local:
                part = np.zeros((length, len(one.rows), one.columns.shape[2]))
            if part is None or part.shape[2] != one.columns.shape[2]:
                break
            parts.append(part)
        else:
            yield one, np.concatenate(parts)


def _key(one: Candidate) -> Any:
    """What makes two candidates the same."""
    values = tuple(sorted(one.values.items()))
    return one.effect, one.joint, one.rows, values, one.stand_in, one.fixed, one.order, one.columns.shape[2]
