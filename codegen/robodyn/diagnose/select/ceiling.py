"""What the whole library can explain of a log, and so what is noise to it: all linear candidates at once.

A real arm has more in it than any catalogue. What nothing explains counts as error like the noise of the
sensors: against sensor noise alone, everything would seem to matter.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.beside import Library
from robodyn.diagnose.select.fit import Problem
from robodyn.diagnose.select.limits import CEILING_RIDGE, STANDS_OUT, UNSEEN_NUISANCE

Floats = NDArray[np.float64]


def unexplained(p: Problem, library: Library) -> Floats:
    """The median [n] of what the library leaves in held-out parts of the log, in units of the noise (a
    median, since joints that stick at reversals make bursts); 1 where that is about the noise."""
    left = np.zeros_like(p.rest)
    for j in range(p.n):
        own = p.A[:, j, : p.nuisance] @ p.basis.T  # as the arm has them: each on its own
        own = own[:, np.sum(own**2, axis=0) > UNSEEN_NUISANCE]
        columns = [own, p.A[:, j, p.nuisance :]]
        seen: dict[tuple[str, int | None], int] = {}
        for k, candidate in enumerate(library.candidates):
            key = (candidate.effect, candidate.joint)
            is_plain = not candidate.fixed and not candidate.in_place
            if j in candidate.rows and is_plain and seen.get(key, 0) < 2:
                seen[key] = seen.get(key, 0) + 1
                x = library.of_candidate(k)
                columns.append(x[:, candidate.rows.index(j)] * (p.weight[:, j, None] / p.sigma[j]))
        X = np.concatenate(columns, axis=1)
        wide = np.sqrt(np.mean(X**2, axis=0))
        X = X[:, wide > 0] / wide[wide > 0]
        b = p.rest[:, j]
        grams = np.stack([X[part].T @ X[part] for part in p.parts])
        rights = np.stack([X[part].T @ b[part] for part in p.parts])
        G, g = grams.sum(axis=0), rights.sum(axis=0)
        ridge = CEILING_RIDGE * len(b) * np.eye(len(G))
        for k, part in enumerate(p.parts):
            x = np.linalg.solve(G - grams[k] + ridge, g - rights[k])
            left[part, j] = b[part] - X[part] @ x
    size = p.usual(left)
    return np.where(size > STANDS_OUT, size, 1.0)
