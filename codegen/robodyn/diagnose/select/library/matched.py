"""The same candidates along several logs, and pieces of logs.

What a log can show depends on it: a limit that it reaches, a deflection that is shorter than its travel
between samples, what springs resonate with its inertias. The first log says what is tried; along the others
it is made with the same values, or is zero there if it is local, or is left out.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.library import Candidate, Context, candidates
from robodyn.diagnose.select.library.prepared import prepared
from robodyn.diagnose.select.scope import Scope

Floats = NDArray[np.float64]


def matched(contexts: Sequence[Context], scope: Scope) -> Iterator[tuple[Candidate, Floats]]:
    """Candidates with their columns [N, rows, c], filtered and thinned, of all pieces one after the other."""
    first, *others = contexts
    if not others:
        yield from prepared(first, candidates(first, scope))
        return
    pairs = [(_light(one), part) for one, part in prepared(first, candidates(first, scope))]
    keys = _numbered([one for one, _ in pairs])
    parts: list[list[Floats | None]] = [[part] for _, part in pairs]
    fixed = frozenset(one.effect for one, _ in pairs if one.again is None)
    for c in others:
        again = (one.again(c, one.values) for one, _ in pairs if one.again is not None)
        along = (part for _, part in prepared(c, again))
        several = list(prepared(c, candidates(c, replace(scope, only=fixed))))
        own = dict(zip(_numbered([one for one, _ in several]), (part for _, part in several), strict=True))
        length = len(c.slow.thinned(c.slow.q))
        for k, (one, _) in enumerate(pairs):
            part = own.get(keys[k]) if one.again is None else next(along)
            if part is None and one.local:
                part = np.zeros((length, *one.columns.shape[1:]))
            parts[k].append(part)
    for (one, _), several_parts in zip(pairs, parts, strict=True):
        whole = [part for part in several_parts if part is not None]
        if len(whole) == len(several_parts):
            yield one, np.concatenate(whole)


def _light(one: Candidate) -> Candidate:
    """The candidate without its columns [0, rows, c] (no view, which would keep all of them)."""
    return replace(one, columns=one.columns[:0].copy())


def _numbered(several: Sequence[Candidate]) -> list[Any]:
    """What makes candidates of two logs the same, those that are alike numbered."""
    count = Counter[Any]()
    keys = []
    for one in several:
        key = (one.effect, one.joint, one.rows, one.stand_in, one.fixed, one.order, one.columns.shape[2])
        if one.again is None:
            count[key] += 1
        keys.append((key, count[key]))
    return keys
