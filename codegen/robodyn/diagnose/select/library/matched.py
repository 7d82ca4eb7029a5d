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

from robodyn.arrays import Singles
from robodyn.diagnose.select.library import Candidate, Context, candidates
from robodyn.diagnose.select.library.prepared import prepared
from robodyn.diagnose.select.scope import Scope


def along(c: Context, ones: Sequence[Candidate], scope: Scope) -> Iterator[Singles | None]:
    """Of each of the candidates of another log its columns [N, rows, c] along this one, filtered and thinned;
    None where this log has no such candidate."""
    keys = _numbered(ones)
    fixed = frozenset(one.effect for one in ones if one.again is None)
    again = (one.again(c, one.values) for one in ones if one.again is not None)
    anew = (part for _, part in prepared(c, again))
    several = [(light(one), part) for one, part in prepared(c, candidates(c, replace(scope, only=fixed)))]
    own = dict(zip(_numbered([one for one, _ in several]), (part for _, part in several), strict=True))
    length = len(c.slow.thinned(c.slow.q))
    for key, one in zip(keys, ones, strict=True):
        part = own.get(key) if one.again is None else next(anew)
        if part is None and one.local:
            part = np.zeros((length, *one.columns.shape[1:]), dtype=np.float32)
        yield part


def light(one: Candidate) -> Candidate:
    """The candidate without its columns [0, rows, c] (no view, which would keep all of them)."""
    return replace(one, columns=one.columns[:0].copy())


def _numbered(several: Sequence[Candidate]) -> list[Any]:
    """What makes candidates of two logs the same, those that are alike numbered."""
    count = Counter[Any]()
    keys = []
    for one in several:
        key = (one.effect, one.joint, one.rows, one.fixed, one.order, one.columns.shape[2])
        if one.again is None:
            count[key] += 1
        keys.append((key, count[key]))
    return keys
